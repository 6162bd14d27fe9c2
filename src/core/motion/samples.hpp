// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "core/motion/cycle_start.hpp"
#include "hidwa_local_planner/core/parameters.hpp"
#include "hidwa_local_planner/core/types.hpp"

namespace hidwa_local_planner {

/// Where a candidate comes from.
enum class SampleKind { grid, brake, operator_command, blended, previous };

struct Sample {
  Twist2 u;  // [m/s, rad/s]
  SampleKind kind = SampleKind::grid;
};

/// The reachable velocities of one cycle.
struct DynamicWindow {
  Interval v;      // [m/s]
  Interval omega;  // [rad/s]
};

/// `standard`: reachable in sim_time, or in one period where that is longer; `dwa`: reachable in one period. So what a
/// command may reach is always in it, also a limit that was lowered.
DynamicWindow dynamic_window(const Parameters& parameters, const VelocityLimits& limits, const Twist2& reference,
                             double period);

/// `count` >= 2 values evenly spaced over an interval, both ends included, and an exact 0 where it straddles 0.
/// Ascending; the values of a symmetric interval are symmetric to the last bit. One value for an empty width.
void spread(const Interval& interval, int count, std::vector<double>& values);

/// Brings a velocity into the window: each axis to its end; where the wheels cut it, omega is kept and v
/// reduced; out of the motors' dead bands, of which a min_vel_x above 0 is one.
Twist2 into_window(const Parameters& parameters, const VelocityLimits& limits, const DynamicWindow& window,
                   const Twist2& velocity);

struct SampleRequest {
  Twist2 previous;                           // the last command [m/s, rad/s]
  const Twist2* operator_command = nullptr;  // u_h where it counts
  const Twist2* blended = nullptr;           // u_ref where it differs from that (authority below 1)
  int vx_samples = 20;
  int vth_samples = 20;
  double creep = 0.0;  // above 0: this speed is among the samples, forwards and backwards [m/s]
};

/// The samples of one cycle, grouped by omega in ascending order, v ascending within: the grid over the window without
/// (0, 0) and without what the wheels or dead bands exclude, a min_vel_x above 0 too; then the extra ones that the
/// parameters ask for. `creep` is a row of the grid where the window holds it.
class Sampler {
 public:
  /// `limits`: of the window.
  void make(const Parameters& parameters, const VelocityLimits& limits, const CycleStart& start,
            const SampleRequest& request);
  const std::vector<Sample>& samples() const { return samples_; }

 private:
  void add_speed(double v);
  void add_grid(const Parameters& parameters, const VelocityLimits& limits);
  void add_extra(const Parameters& parameters, const VelocityLimits& limits, const SampleRequest& request);

  DynamicWindow window_;
  std::vector<double> v_, omega_;
  std::vector<Sample> samples_;
};

}  // namespace hidwa_local_planner
