// SPDX-License-Identifier: BSD-3-Clause
// Slow twin of control::Prediction: the whole plan is looked at, in arc length, and every 0.1 s the robot is asked
// anew.
#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "control/prediction.hpp"
#include "core/motion/velocity_limits.hpp"
#include "hidwa_local_planner/core/rest.hpp"

namespace hidwa_local_planner::test {

class NaivePrediction {
 public:
  NaivePrediction(const control::ControlLoop& loop, const control::Observation& seen, const control::Result& result)
      : p_(loop.parameters()), limits_(VelocityLimits::from(p_)), result_(result), goal_(loop.situation().goal) {
    latched_ = loop.situation().goal_latched;
    for (std::size_t k = loop.next_plan_pose(); k < loop.plan().size(); ++k) {
      way_.push_back(seen.from_plan.apply(loop.plan()[k]));
    }
    find_end(seen.costmap, loop.planner().footprint().inscribed_radius());
    poses.push_back({seen.pose, 0.0});
    u_ = result.command;
    if (result.intent.influence == Influence::none && result.outcome == Outcome::drive) as_chosen();
    if (result.decision->recovering || result.decision->waiting || result.outcome == Outcome::fail) return;
    while (poses.size() < 31) {  // 3 s
      u_ = limits_.step(u_, wanted(), 0.1);
      rests = commands_rest(u_);
      const Pose2 q = poses.back().pose;
      const double heading = q.theta + 0.05 * u_.omega;  // half-way through the tenth of a second
      poses.push_back({{q.x + 0.1 * u_.v * std::cos(heading), q.y + 0.1 * u_.v * std::sin(heading),
                        wrap_angle(q.theta + 0.1 * u_.omega)},
                       0.1 * static_cast<double>(poses.size())});
    }
  }

  control::NextMove next() const {
    const double turn = wrap_angle(poses.back().pose.theta - poses.front().pose.theta);
    const bool turns = std::abs(turn) >= 0.35;
    if (result_.decision->waiting) return control::NextMove::stop;
    if (result_.decision->recovering) return control::NextMove::recover;
    if (result_.outcome == Outcome::fail || result_.outcome == Outcome::brake) return control::NextMove::stop;
    if (turns && (latched_ || !rests)) return turn > 0.0 ? control::NextMove::left : control::NextMove::right;
    return rests ? control::NextMove::stop : control::NextMove::straight;
  }

  std::vector<control::TimedPose> poses;
  bool rests = false;
  bool blocked = false;

 private:
  double arc(std::size_t k) const {
    double sum = 0.0;
    for (std::size_t i = 1; i <= k; ++i) sum += distance(way_[i - 1], way_[i]);
    return sum;
  }

  // A robot in the middle of which something is has an inscribed radius of room; what it stands in does not count.
  void find_end(const GridView& grid, double inscribed_radius) {
    end_ = way_.empty() ? 0.0 : arc(way_.size() - 1);
    for (std::size_t k = way_.size(); k-- > 0;) {
      const Point p(way_[k].x, way_[k].y);
      if (arc(k) < inscribed_radius || !grid.holds(p) || !cost::blocks(grid.at(grid.cell_at(p.x(), p.y())))) continue;
      blocked = true;
      end_ = arc(k);
    }
  }

  // The chosen rollout, for half a second or as long as it is.
  void as_chosen() {
    const Decision& d = *result_.decision;
    if (d.trajectory.size() < 2 || d.step <= 0.0) return;
    for (int tenth = 1; tenth <= 5; ++tenth) {
      const double t = 0.1 * tenth;
      if (t > p_.sim_time + 1e-9 || t > d.step * static_cast<double>(d.trajectory.size() - 1) + 1e-9) return;
      std::size_t k = 0;
      while (k + 2 < d.trajectory.size() && d.step * static_cast<double>(k + 1) <= t) ++k;
      const Pose2 a = d.trajectory[k], b = d.trajectory[k + 1];
      const double share = (t - d.step * static_cast<double>(k)) / d.step;
      poses.push_back({{(1.0 - share) * a.x + share * b.x, (1.0 - share) * a.y + share * b.y,
                        wrap_angle(a.theta + share * wrap_angle(b.theta - a.theta))},
                       t});
      u_ = d.sample;
    }
  }

  Twist2 wanted() {
    const Pose2 q = poses.back().pose;
    if (latched_) {
      const double left = wrap_angle(goal_.theta - q.theta);
      if (std::abs(left) <= p_.yaw_goal_tolerance) return {};
      return {0.0, std::clamp(left / 0.1, -p_.max_vel_theta, p_.max_vel_theta)};
    }
    if (way_.empty()) return {};
    while (at_ + 1 < way_.size() && distance(way_[at_ + 1], q) <= distance(way_[at_], q)) ++at_;
    std::size_t target = at_;
    while (target + 1 < way_.size() && arc(target) - arc(at_) < std::max(0.35, 0.8 * std::abs(u_.v))) ++target;
    const double away = distance(way_[target], q), left = end_ - arc(at_);
    if (left <= 0.0 || away < 0.02) return {};
    const double aside = wrap_angle(std::atan2(way_[target].y - q.y, way_[target].x - q.x) - q.theta);
    if (aside > 1.05) return {0.0, p_.max_vel_theta};
    if (aside < -1.05) return {0.0, -p_.max_vel_theta};
    // v^2 = 2 b s before the end; omega = v * curvature, and the arc through the target has curvature 2 sin(aside) /
    // away.
    const double curvature = 2.0 * std::sin(aside) / away;
    double v = std::min(p_.max_vel_x, std::sqrt(2.0 * limits_.x.braking * left));
    if (std::abs(v * curvature) > p_.max_vel_theta) v = p_.max_vel_theta / std::abs(curvature);
    return {v, v * curvature};
  }

  const Parameters& p_;
  VelocityLimits limits_;
  const control::Result& result_;
  Pose2 goal_;
  bool latched_ = false;
  std::vector<Pose2> way_;
  double end_ = 0.0;
  std::size_t at_ = 0;
  Twist2 u_;
};

}  // namespace hidwa_local_planner::test
