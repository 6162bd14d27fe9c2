// SPDX-License-Identifier: BSD-3-Clause
#include "hidwa_local_planner/core/brake_manoeuvre.hpp"

#include <algorithm>
#include <cmath>

namespace hidwa_local_planner {
namespace {

class Integrator {
 public:
  Integrator(const VelocityLimits& limits, double radius, double spacing, std::vector<Pose2>& poses)
      : limits_(limits), radius_(radius), spacing_(spacing), poses_(poses) {}

  void start_at(const Pose2& pose, const Twist2& velocity) {
    pose_ = pose;
    u_ = velocity;
  }

  // One stretch of `duration` [s] in which both axes change evenly from the current velocity to `end`.
  void stretch(const Twist2& end, double duration) {
    if (duration <= 0.0) return;
    const double fastest = std::max(std::abs(u_.v), std::abs(end.v)) +
                           radius_ * std::max(std::abs(u_.omega), std::abs(end.omega));
    const Twist2 begin = u_;
    u_ = end;
    if (fastest * duration <= 1e-12) return;
    const int steps = static_cast<int>(std::ceil(fastest * duration / spacing_));
    const double dt = duration / steps;
    for (int k = 0; k < steps; ++k) {
      const double middle = (k + 0.5) / steps;
      const double v = begin.v + middle * (end.v - begin.v);
      const double omega = begin.omega + middle * (end.omega - begin.omega);
      const double heading = pose_.theta + 0.5 * omega * dt;
      pose_.x += v * std::cos(heading) * dt;
      pose_.y += v * std::sin(heading) * dt;
      pose_.theta += omega * dt;
      poses_.push_back(pose_);
    }
  }

  // Both axes to rest, each at its own limit: one of them may rest before the other.
  void brake() {
    const double first = std::min(limits_.x.time_to_rest(u_.v), limits_.theta.time_to_rest(u_.omega));
    stretch({limits_.x.ramp(u_.v, 0.0, first), limits_.theta.ramp(u_.omega, 0.0, first)}, first);
    const double rest = std::max(limits_.x.time_to_rest(u_.v), limits_.theta.time_to_rest(u_.omega));
    stretch({}, rest);
  }

 private:
  const VelocityLimits& limits_;
  double radius_, spacing_;
  std::vector<Pose2>& poses_;
  Pose2 pose_;
  Twist2 u_;
};

}  // namespace

void roll_out(const BrakeManoeuvre& manoeuvre, const VelocityLimits& limits, double radius, double spacing,
              std::vector<Pose2>& poses) {
  poses.clear();
  Integrator integrator(limits, radius, spacing, poses);
  integrator.start_at(manoeuvre.start, manoeuvre.reference);
  integrator.stretch(manoeuvre.reference, manoeuvre.latency);
  integrator.stretch(manoeuvre.command, manoeuvre.period);
  integrator.brake();
}

}  // namespace hidwa_local_planner
