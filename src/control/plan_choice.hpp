// SPDX-License-Identifier: BSD-3-Clause
// Which of two plans to the same goal is followed.
//
// A host plans anew about once a second. Where two ways round an obstacle cost about the same, its plans may change
// sides each time, and a robot that follows every one of them turns to and fro before the obstacle. So a plan that
// leads round the other side waits. It is followed as soon as one of these holds:
//
// - it costs less than going on, by a fifth;
// - the followed plan crosses an obstacle: a cell of the local costmap where the robot's centre would collide;
// - it, or others on its side, have waited for plan_hysteresis_time;
// - the operator steers, or the last cycle failed: a new plan is what the robot needs then.
//
// A plan on the same side is followed at once. With `method: paper` every plan is followed at once. Two plans are on
// two sides of an obstacle if a lethal cell of the local costmap lies between them. Two plans that run close together
// have room for nothing between them; then the map is not asked (same_way()). Most plans of a robot are close to the
// plan before.
//
// The cost of a plan is its length from the robot to the goal; a metre on the local costmap counts 1 + 0.8 c/50, with
// the cell's cost c. So does navfn, the host's usual planner, weigh them.
#pragma once

#include <cstddef>
#include <vector>

#include "control/frame_transform.hpp"
#include "hidwa_local_planner/core/grid_view.hpp"
#include "hidwa_local_planner/core/parameters.hpp"
#include "hidwa_local_planner/core/types.hpp"
#include "hidwa_local_planner/core/util/condition_timer.hpp"

namespace hidwa_local_planner::control {

/// Whether two plans in one frame lead the same way, as far as it matters now: `fresh` stays within `apart` [m] of
/// `followed`, which counts from its pose `from` on, for the first metres.
bool same_way(const std::vector<Pose2>& followed, std::size_t from, const std::vector<Pose2>& fresh, double apart);

class PlanChoice {
 public:
  /// A new plan to the goal of the followed one, in its frame. It takes the place of one that waits.
  void offer(std::vector<Pose2> plan) { offered_ = std::move(plan); }
  /// No plan waits.
  void clear();
  bool offers() const { return !offered_.empty(); }
  /// The last cycle failed: the plan that waits is followed next.
  void give_way() { gives_way_ = offers(); }

  struct Context {
    Pose2 robot;                         // costmap frame
    FrameTransform from_plan;            // of the plans' frame, in the costmap's
    const GridView& costmap;             // local
    const std::vector<Pose2>& followed;  // plans' frame
    double now = 0.0;                    // [s]
    bool autonomous = false;             // the operator does not steer
  };
  /// Whether the plan that waits is to be followed now; once per cycle in which one waits.
  bool prefers_offer(const Context& context, const Parameters& parameters);
  /// The plan that waits, which is taken away.
  std::vector<Pose2> take();

  template <typename Self, typename Archive>
  static void archive(Self& self, Archive& io) {
    io(self.offered_, self.waits_, self.gives_way_);
  }

 private:
  std::vector<Pose2> offered_;  // empty: none
  ConditionTimer waits_;        // a plan on the other side does
  bool gives_way_ = false;
  std::vector<Point> old_way_, new_way_, outline_;  // costmap frame, for their memory
};

}  // namespace hidwa_local_planner::control
