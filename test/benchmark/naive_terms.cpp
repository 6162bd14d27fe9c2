// SPDX-License-Identifier: BSD-3-Clause
#include "benchmark/naive_terms.hpp"

#include <cmath>

#include "benchmark/naive_grids.hpp"

namespace hidwa_local_planner::test {
namespace {

// The cells of the plan's first stretch on the map; its poses are a cell apart.
std::vector<Cell> cells_on_map(const GridView& grid, const std::vector<Pose2>& plan) {
  std::vector<Cell> cells;
  for (const Pose2& pose : plan) {
    const Cell cell = grid.cell_at(pose.x, pose.y);
    if (grid.contains(cell)) {
      cells.push_back(cell);
    } else if (!cells.empty()) {
      break;
    }
  }
  return cells;
}

// The last cell of the plan with its end moved: a straight line to it, half a cell at a time.
Cell moved_end(const GridView& grid, const std::vector<Pose2>& plan, const Point& by) {
  std::vector<Pose2> longer(plan.begin(), plan.end() - 1);
  const Pose2 from = longer.empty() ? plan.back() : longer.back();
  const Point to = Point(plan.back().x, plan.back().y) + by;
  const double length = std::hypot(to.x() - from.x, to.y() - from.y);
  const double parts = std::max(1.0, std::ceil(length / (grid.resolution / 2)));
  for (double part = 1.0; part <= parts; part += 1.0) {
    longer.push_back({from.x + part / parts * (to.x() - from.x), from.y + part / parts * (to.y() - from.y), 0.0});
  }
  return cells_on_map(grid, longer).back();
}

double turn_between(double a, double b) { return std::abs(std::remainder(a - b, 2.0 * M_PI)); }

}  // namespace

NaiveTerms::NaiveTerms(const Scene& scene) : scene_(scene), grid_(scene.grid()) {
  const Parameters& p = scene.parameters;
  const Situation& s = scene.situation;
  const std::vector<Cell> path = cells_on_map(grid_, s.plan);
  const double bearing = std::atan2(s.goal.y - s.pose.y, s.goal.x - s.pose.x);
  const Point ahead = p.forward_point_distance * Point(std::cos(bearing), std::sin(bearing));
  path_ = naive_grid(grid_, path);
  goal_ = naive_grid(grid_, {path.back()});
  ahead_ = naive_grid(grid_, {moved_end(grid_, s.plan, ahead)});
  aligns_ = distance(s.goal, s.pose) > p.forward_point_distance;
}

std::optional<double> NaiveTerms::total(const Twist2& sample, const std::vector<Pose2>& poses) const {
  const Parameters& p = scene_.parameters;
  const Pose2& last = poses.back();
  const std::optional<double> rotate = rotate_to_goal(sample, last);
  const std::optional<double> obstacle = base_obstacle(poses);
  if (!rotate || !obstacle) return std::nullopt;
  double autonomy = p.RotateToGoal_scale * *rotate + p.BaseObstacle_scale * *obstacle;
  autonomy += p.GoalAlign_scale / 2 * map_grid(ahead_, p.forward_point_distance, last);
  if (aligns_) autonomy += p.PathAlign_scale / 2 * map_grid(path_, p.forward_point_distance, last);
  autonomy += p.PathDist_scale / 2 * map_grid(path_, 0.0, last);
  autonomy += p.GoalDist_scale / 2 * map_grid(goal_, 0.0, last);
  const Twist2& wanted = scene_.intent.u_h;
  return autonomy + p.s_v * std::abs(wanted.v - sample.v) + p.s_omega * std::abs(wanted.omega - sample.omega);
}

double NaiveTerms::distance_at(const std::vector<int>& distances, double x, double y) const {
  const Cell cell = grid_.cell_at(x, y);
  if (!grid_.contains(cell)) return -1.0;
  const int units = distances[grid_.index(cell)];
  return units < 0 ? -1.0 : units * grid_.resolution / 5;
}

// At the nose, or at the centre where the nose lies in an obstacle or nowhere.
double NaiveTerms::map_grid(const std::vector<int>& distances, double forward, const Pose2& last) const {
  const double x = last.x + forward * std::cos(last.theta), y = last.y + forward * std::sin(last.theta);
  const double nose = distance_at(distances, x, y);
  if (nose >= 0.0 && !naive_grid_blocks(grid_.at(grid_.cell_at(x, y)))) return nose;
  const double centre = distance_at(distances, last.x, last.y);
  return centre >= 0.0 ? centre : grid_.resolution * (grid_.size_x + grid_.size_y);
}

std::optional<double> NaiveTerms::base_obstacle(const std::vector<Pose2>& poses) const {
  double value = 0.0;
  for (const Pose2& q : poses) {
    const Cell cell = grid_.cell_at(q.x, q.y);
    if (!grid_.contains(cell) || grid_.at(cell) >= cost::kInscribed) return std::nullopt;
    value = grid_.at(cell);
  }
  return value;
}

std::optional<double> NaiveTerms::rotate_to_goal(const Twist2& sample, const Pose2& last) const {
  const Parameters& p = scene_.parameters;
  const Situation& s = scene_.situation;
  if (distance(s.goal, s.pose) > p.xy_goal_tolerance) return 0.0;
  const double error = turn_between(s.goal.theta, last.theta);
  if (std::abs(s.velocity.v) <= p.trans_stopped_velocity) {
    if (std::abs(sample.v) > 1e-5) return std::nullopt;
    return error;
  }
  if (sample.v * sample.v >= s.velocity.v * s.velocity.v) return std::nullopt;
  return sample.v * sample.v * 5.0 + error;
}

}  // namespace hidwa_local_planner::test
