// SPDX-License-Identifier: BSD-3-Clause
#include "sim/drive_prediction.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace hidwa_local_planner {
namespace sim {

double asked_omega(double left, const RobotHabits& habits) {
  if (std::abs(left) <= habits.dead_zone) return 0.0;
  return std::copysign(left * left, left) * habits.max_vel_theta;
}

DrivePrediction::DrivePrediction(const RobotHabits& habits, const OccupancyMap& map, const std::vector<Region>& regions)
    : habits_(habits),
      regions_(DistanceField::to_regions(map, regions)),
      walls_(DistanceField::to_obstacles(map)),
      half_cell_(0.5 * map.resolution) {}

DrivePrediction::State DrivePrediction::steered(const State& state, double omega) const {
  const double change = habits_.acc_lim_theta * kStep;
  const double next = std::clamp(omega, state.omega - change, state.omega + change);
  return {moved(state.pose, {habits_.max_vel_x * kStep, 0.5 * (state.omega + next) * kStep}), next};
}

DrivePrediction::State DrivePrediction::following(const State& state, const Route& plan, std::size_t& nearest) const {
  if (plan.empty()) return steered(state, 0.0);
  nearest = nearest_index(plan, nearest, 1.0, state.pose.x, state.pose.y);
  std::size_t aim = nearest;
  const auto distance = [&](std::size_t i) {
    return std::hypot(plan[i].x() - state.pose.x, plan[i].y() - state.pose.y);
  };
  while (aim + 1 < plan.size() && distance(aim) < habits_.pursuit) ++aim;
  const double bearing = std::atan2(plan[aim].y() - state.pose.y, plan[aim].x() - state.pose.x);
  const double turn = normalized(bearing - state.pose.theta);
  // Pure pursuit: the arc through the point aimed at (Coulter 1992).
  const double wanted = 2.0 * habits_.max_vel_x * std::sin(turn) / std::max(distance(aim), 0.1);
  return steered(state, std::clamp(wanted, -habits_.max_vel_theta, habits_.max_vel_theta));
}

bool DrivePrediction::refuses(State state, double omega) const {
  const int steps = static_cast<int>(std::lround(habits_.refusal_time / kStep));
  for (int i = 0; i < steps; ++i) {
    state = steered(state, omega);
    if (wall_gap(state.pose) < 0.0) return true;
  }
  return false;
}

double DrivePrediction::region_gap(const Pose& pose) const {
  return regions_.at(pose.x, pose.y) - half_cell_ - habits_.radius;
}

double DrivePrediction::wall_gap(const Pose& pose) const {
  return walls_.at(pose.x, pose.y) - half_cell_ - habits_.radius;
}

std::size_t nearest_index(const Route& plan, std::size_t first, double reach, double x, double y) {
  std::size_t best = first;
  double nearest = std::numeric_limits<double>::infinity();  // [m^2]
  double along = 0.0;                                        // [m]
  for (std::size_t i = first; i < plan.size() && along <= reach; ++i) {
    const double distance = (plan[i] - Eigen::Vector2d(x, y)).squaredNorm();
    if (distance < nearest) {
      nearest = distance;
      best = i;
    }
    if (i + 1 < plan.size()) along += (plan[i + 1] - plan[i]).norm();
  }
  return best;
}

}  // namespace sim
}  // namespace hidwa_local_planner
