// SPDX-License-Identifier: BSD-3-Clause
// What each critic says of one rollout, and nothing remembered from cycles before.
#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "support/naive_collision.hpp"
#include "support/naive_distance.hpp"
#include "support/naive_motion.hpp"
#include "support/scene.hpp"

namespace hidwa_local_planner::test {

inline Cell naive_cell(const GridView& grid, double x, double y) {
  return {static_cast<int>(std::floor((x - grid.origin_x) / grid.resolution)),
          static_cast<int>(std::floor((y - grid.origin_y) / grid.resolution))};
}
inline double naive_angle(double a) { return std::abs(std::atan2(std::sin(a), std::cos(a))); }

/// Distances [m] to the plan, to its end, or to its end moved ahead; -1 where there are none.
struct NaiveDistances {
  std::vector<int> units;
  double metres = 0.0;
};

class NaiveCritics {
 public:
  NaiveCritics(const Scene& scene, const NaiveBody& body) : scene_(scene), body_(body), grid_(scene.grid()) {
    const std::vector<Cell> path = cells(scene.situation.plan);
    on_map_ = !path.empty();
    if (!on_map_) return;
    path_ = distances(path);
    goal_ = distances({path.back()});
    std::vector<Pose2> ahead = scene.situation.plan;
    const Pose2 aim = scene.situation.turns_back ? scene.situation.plan.back() : scene.situation.goal;
    const double bearing = std::atan2(aim.y - scene.situation.pose.y, aim.x - scene.situation.pose.x);
    ahead.back().x += scene.parameters.forward_point_distance * std::cos(bearing);
    ahead.back().y += scene.parameters.forward_point_distance * std::sin(bearing);
    const std::vector<Cell> moved = cells(ahead);
    ahead_ = distances({moved.empty() ? path.back() : moved.back()});
  }
  bool on_map() const { return on_map_; }

  static double weight(const std::string& critic, const Parameters& p) {
    if (critic == "PathDist") return p.PathDist_scale / 2;
    if (critic == "PathAlign") return p.PathAlign_scale / 2;
    if (critic == "GoalDist") return p.GoalDist_scale / 2;
    if (critic == "GoalAlign") return p.GoalAlign_scale / 2;
    if (critic == "BaseObstacle") return p.BaseObstacle_scale;
    if (critic == "ObstacleFootprint") return p.ObstacleFootprint_scale;
    if (critic == "RotateToGoal") return p.RotateToGoal_scale;
    if (critic == "Twirling") return p.Twirling_scale;
    return 1.0;  // Oscillation, PreferForward
  }

  bool steered() const { return scene_.intent.influence != Influence::none; }
  /// Then no critic rejects for the sake of autonomy.
  bool operator_decides() const {
    return scene_.intent.influence == Influence::direct || (steered() && scene_.situation.goal_latched);
  }

  /// The raw score; sets `rejects` where the critic rejects.
  double raw(const std::string& critic, const NaiveCandidate& c, bool& rejects) const {
    const Parameters& p = scene_.parameters;
    if (critic == "PathDist") return map_grid(path_, 0.0, c, rejects);
    if (critic == "GoalDist") return map_grid(goal_, 0.0, c, rejects);
    if (critic == "GoalAlign") return map_grid(ahead_, p.forward_point_distance, c, rejects);
    if (critic == "PathAlign") {
      const double to_goal = std::hypot(scene_.situation.goal.x - scene_.situation.pose.x,
                                        scene_.situation.goal.y - scene_.situation.pose.y);
      if (on_map_ && to_goal <= p.forward_point_distance) return 0.0;
      return map_grid(path_, p.forward_point_distance, c, rejects);
    }
    if (critic == "BaseObstacle") return base_obstacle(c, rejects);
    if (critic == "ObstacleFootprint") return obstacle_footprint(c, rejects);
    if (critic == "RotateToGoal") return rotate_to_goal(c, rejects);
    if (critic == "PreferForward") {
      const bool creeps = c.u.v < 0.1 && std::abs(c.u.omega) < 0.2;
      return c.u.v < 0.0 || creeps ? p.PreferForward_penalty : std::abs(c.u.omega) * p.PreferForward_theta_scale;
    }
    return critic == "Twirling" ? std::abs(c.u.omega) : 0.0;
  }

 private:
  // The plan with points half a cell apart where a gap is wider than one cell.
  std::vector<Pose2> without_gaps(const std::vector<Pose2>& plan) const {
    std::vector<Pose2> dense;
    for (const Pose2& pose : plan) {
      if (!dense.empty()) {
        const Pose2 from = dense.back();
        const Cell a = naive_cell(grid_, from.x, from.y), b = naive_cell(grid_, pose.x, pose.y);
        const bool gap = std::abs(a.i - b.i) > 1 || std::abs(a.j - b.j) > 1;
        const double parts = std::ceil(distance(from, pose) / (grid_.resolution / 2));
        for (double part = 1.0; gap && part < parts; part += 1.0) {
          dense.push_back({from.x + part / parts * (pose.x - from.x), from.y + part / parts * (pose.y - from.y), 0.0});
        }
      }
      dense.push_back(pose);
    }
    return dense;
  }
  std::vector<Cell> cells(const std::vector<Pose2>& plan) const {
    const bool stops = scene_.parameters.method == Method::paper && scene_.parameters.unknown_is_obstacle;
    std::vector<Cell> found;
    for (const Pose2& pose : without_gaps(plan)) {
      const Cell cell = naive_cell(grid_, pose.x, pose.y);
      const bool usable = grid_.contains(cell) && !(stops && grid_.at(cell) == 255);
      if (usable) found.push_back(cell);
      if (!usable && !found.empty()) break;
    }
    return found;
  }
  NaiveDistances distances(const std::vector<Cell>& sources) const {
    if (scene_.parameters.method == Method::paper) return {naive_l1(grid_, sources), grid_.resolution};
    return {naive_geodesic(grid_, sources), grid_.resolution / 5};
  }
  double look_up(const NaiveDistances& d, double x, double y) const {
    const Cell cell = naive_cell(grid_, x, y);
    if (!grid_.contains(cell)) return -1.0;
    const int units = d.units[grid_.index(cell)];
    return units < 0 ? -1.0 : units * d.metres;
  }
  double map_grid(const NaiveDistances& d, double forward, const NaiveCandidate& c, bool& rejects) const {
    const Pose2 q = c.poses.back();
    if (!on_map_) {
      Pose2 nearest = scene_.situation.plan.front();
      for (const Pose2& pose : scene_.situation.plan) {
        if (distance(pose, scene_.situation.pose) < distance(nearest, scene_.situation.pose)) nearest = pose;
      }
      return naive_angle(std::atan2(nearest.y - q.y, nearest.x - q.x) - q.theta);
    }
    const double x = q.x + forward * std::cos(q.theta), y = q.y + forward * std::sin(q.theta);
    const double nose = look_up(d, x, y);
    if (scene_.parameters.method == Method::paper) {
      rejects = nose < 0.0 && !operator_decides();
      return nose < 0.0 ? unreached() : nose;
    }
    if (nose >= 0.0 && !naive_blocks(grid_.at(naive_cell(grid_, x, y)))) return nose;
    const double centre = look_up(d, q.x, q.y);
    return centre >= 0.0 ? centre : unreached();
  }

  double unreached() const { return grid_.resolution * (grid_.size_x + grid_.size_y); }

  bool bad_centre(double x, double y) const {
    const Cell cell = naive_cell(grid_, x, y);
    if (!grid_.contains(cell)) return true;
    const int value = grid_.at(cell);
    return value == 253 || value == 254 || (value == 255 && scene_.parameters.unknown_is_obstacle);
  }
  double base_obstacle(const NaiveCandidate& c, bool& rejects) const {
    const bool may_leave =
        scene_.parameters.method == Method::hidwa && bad_centre(scene_.situation.pose.x, scene_.situation.pose.y);
    double last = 0.0;
    for (const Pose2& q : c.poses) {
      if (!may_leave && bad_centre(q.x, q.y)) rejects = true;
      const Cell cell = naive_cell(grid_, q.x, q.y);
      last = grid_.contains(cell) ? grid_.at(cell) : 0.0;
    }
    return last;
  }

  // Points along the outline, at most half a cell apart.
  Polygon outline_points() const {
    Polygon points;
    const double spacing = grid_.resolution / 2;
    if (body_.radius > 0.0) {
      const int n = std::max(8, 4 * static_cast<int>(std::ceil(M_PI / 2 * body_.radius / spacing)));
      for (int k = 0; k < n; ++k) {
        points.emplace_back(body_.radius * std::cos(2 * M_PI * k / n), body_.radius * std::sin(2 * M_PI * k / n));
      }
      return points;
    }
    for (std::size_t i = 0; i < body_.corners.size(); ++i) {
      const Point a = body_.corners[i], b = body_.corners[(i + 1) % body_.corners.size()];
      const int n = std::max(1, static_cast<int>(std::ceil((b - a).norm() / spacing)));
      for (int k = 0; k < n; ++k) points.push_back(a + (b - a) * (static_cast<double>(k) / n));
    }
    return points;
  }
  double outline_cost(const Pose2& q, bool& hits) const {
    double largest = 0.0;
    for (const Point& p : naive_place(outline_points(), q)) {
      const Cell cell = naive_cell(grid_, p.x(), p.y());
      if (!grid_.contains(cell)) {
        hits = true;
        continue;
      }
      const int value = grid_.at(cell);
      if (value == 254 || (value == 255 && scene_.parameters.unknown_is_obstacle)) hits = true;
      if (value < 254) largest = std::max(largest, static_cast<double>(value));
    }
    return largest;
  }
  double obstacle_footprint(const NaiveCandidate& c, bool& rejects) const {
    bool stands_in_one = false;
    outline_cost(scene_.situation.pose, stands_in_one);
    const bool may_leave = scene_.parameters.method == Method::hidwa && stands_in_one;
    double last = 0.0;
    for (const Pose2& q : c.poses) {
      bool hits = false;
      last = outline_cost(q, hits);
      if (hits && !may_leave) rejects = true;
      if (hits) last = 254.0;
    }
    return last;
  }

  // `time` [s] after the start, evenly from pose to pose; at the end where that is negative or beyond it.
  double heading_at(const NaiveCandidate& c, double time) const {
    for (std::size_t k = 0; time >= 0.0 && k + 1 < c.poses.size(); ++k) {
      const double part = time / c.dt - static_cast<double>(k);
      if (part <= 1.0) return c.poses[k].theta + part * (c.poses[k + 1].theta - c.poses[k].theta);
    }
    return c.poses.back().theta;
  }
  // How much farther a turn goes that ends gently.
  double rest_of_turn(const NaiveCandidate& c, double time) const {
    const Parameters& p = scene_.parameters;
    if (steered() || !p.turns_gently()) return 0.0;
    double omega = c.omegas.back();
    for (std::size_t k = 0; time >= 0.0 && k + 1 < c.omegas.size(); ++k) {
      const double part = time / c.dt - static_cast<double>(k);
      if (part > 1.0) continue;
      omega = c.omegas[k] + part * (c.omegas[k + 1] - c.omegas[k]);
      break;
    }
    return omega * std::abs(omega) / 2.0 / p.comfort_acc_lim_theta;
  }
  double rotate_to_goal(const NaiveCandidate& c, bool& rejects) const {
    const Parameters& p = scene_.parameters;
    const Situation& s = scene_.situation;
    if (!s.goal_next) return 0.0;
    if (std::hypot(s.goal.x - s.pose.x, s.goal.y - s.pose.y) > p.xy_goal_tolerance) return 0.0;
    const double ahead = p.method == Method::paper ? -1.0 : 0.5;
    const double error = naive_angle(s.goal.theta - heading_at(c, ahead) - rest_of_turn(c, ahead));
    if (std::abs(s.velocity.v) <= p.trans_stopped_velocity) {
      rejects = !steered() && std::abs(c.u.v) > 1e-5;
      return error;
    }
    rejects = !steered() && c.u.v * c.u.v >= s.velocity.v * s.velocity.v;
    return c.u.v * c.u.v * 5.0 + error;
  }

  const Scene& scene_;
  NaiveBody body_;
  GridView grid_;
  bool on_map_ = false;
  NaiveDistances path_, goal_, ahead_;
};

}  // namespace hidwa_local_planner::test
