// SPDX-License-Identifier: BSD-3-Clause
// What the parts of the planner share in one cycle.
#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

#include "core/collision/blind_motion.hpp"
#include "core/motion/cycle_start.hpp"
#include "core/movers/accelerations.hpp"
#include "core/movers/mover_check.hpp"
#include "hidwa_local_planner/core/footprint.hpp"
#include "hidwa_local_planner/core/grid_view.hpp"
#include "hidwa_local_planner/core/operator_intent.hpp"
#include "hidwa_local_planner/core/parameters.hpp"
#include "hidwa_local_planner/core/situation.hpp"

namespace hidwa_local_planner {

/// The input of one cycle. Everything is in the costmap frame and lives as long as the cycle.
struct Cycle {
  const Parameters& parameters;
  const Footprint& footprint;
  const GridView& grid;
  const OperatorIntent& intent;
  const Sampling& sampling;
  const Situation& situation;                         // as it was given
  const CycleStart& start;                            // what follows from it, as the pose of now
  const BlindMotion& blind;                           // where nobody sees
  MoverCheck* movers;                                 // null where nothing that moves is near
  bool among_movers;                                  // there are some, and they count
  const Accelerations* accelerations = nullptr;       // theirs; null: they keep their velocities
  MoverCheck* hidden = nullptr;                       // null where nobody may come out, or `occlusion` is not `bound`
  const std::vector<Point>* hidden_places = nullptr;  // see HiddenPlaces; null: there are none
};

/// What the deviation from the operator command is measured against.
struct Steering {
  bool active = false;  // the deviation counts: gamma = 1
  /// u_h; with an authority below 1 its blend with what autonomy would choose; without a goal what does as the operator
  /// means (GoallessIntent) [m/s, rad/s].
  Twist2 target;
  double s_v = 1.0;  // weights of the deviation
  double s_omega = 1.0;
};

/// The paper's J_sh: Kalliokoski 2022, section III; 0 where nobody steers.
inline double deviation_cost(const Steering& steering, const Twist2& u) {
  if (!steering.active) return 0.0;
  return steering.s_v * std::abs(steering.target.v - u.v) +
         steering.s_omega * std::abs(steering.target.omega - u.omega);
}

// Reserves some more than `count`: the number of candidates changes by a few from cycle to cycle.
template <typename T>
void reserve_with_spare(std::vector<T>& values, std::size_t count) {
  if (values.capacity() < count) values.reserve(count + count / 8 + 16);
}
template <typename T>
void resize_with_spare(std::vector<T>& values, std::size_t count) {
  reserve_with_spare(values, count);
  values.resize(count);
}

}  // namespace hidwa_local_planner
