// SPDX-License-Identifier: BSD-3-Clause
// Drives along plans of any shape, in the default profile: the control loop, a base that ramps, and a local costmap of
// 8 m that goes with the robot.
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <vector>

#include "drive_on.hpp"
#include "support/drive_limits.hpp"
#include "support/naive_inflation.hpp"
#include "support/scene_loop.hpp"

namespace hidwa_local_planner::test {

using PlanShape = std::vector<Pose2>;

/// Goes on from the last pose in a straight line, poses `spacing` [m] apart.
inline void go_to(PlanShape& plan, double x, double y, double spacing = 0.05) {
  const Pose2 from = plan.back();
  const double dx = x - from.x, dy = y - from.y;
  const double heading = std::atan2(dy, dx);
  const int parts = std::max(1, static_cast<int>(std::lround(std::hypot(dx, dy) / spacing)));
  plan.back().theta = heading;
  for (int k = 1; k <= parts; ++k) plan.push_back({from.x + dx * k / parts, from.y + dy * k / parts, heading});
}

/// Goes on in an arc to the left (a negative angle: to the right) that begins in the last pose's heading.
inline void go_round(PlanShape& plan, double radius, double angle, double spacing = 0.05) {
  const Pose2 from = plan.back();
  const double side = angle > 0.0 ? 1.0 : -1.0;
  const double x = from.x - side * radius * std::sin(from.theta), y = from.y + side * radius * std::cos(from.theta);
  const int parts = std::max(1, static_cast<int>(std::lround(radius * std::abs(angle) / spacing)));
  for (int k = 1; k <= parts; ++k) {
    const double heading = from.theta + angle * k / parts;
    plan.push_back({x + side * radius * std::sin(heading), y - side * radius * std::cos(heading), heading});
  }
}

/// How far apart two persons have to be at least who go along one way each, neither of them ever back: the discrete
/// Frechet distance [m]. A drive that leaves a part of its plan out is as far from it as that part leads.
inline double farthest_apart(const PlanShape& a, const PlanShape& b) {
  std::vector<double> row(b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    double diagonal = 0.0;
    for (std::size_t j = 0; j < b.size(); ++j) {
      const double up = row[j];
      double before = i > 0 ? up : std::numeric_limits<double>::infinity();
      if (j > 0) before = std::min({before, row[j - 1], i > 0 ? diagonal : row[j - 1]});
      if (i == 0 && j == 0) before = 0.0;
      row[j] = std::max(before, distance(a[i], b[j]));
      diagonal = up;
    }
  }
  return row.back();
}

/// What a drive came to.
struct PlanCourse {
  bool arrived = false;
  double duration = 0.0;  // until the goal is reached [s]
  PlanShape track;
  int failures = 0;   // cycles
  int new_goals = 0;  // how often the loop began afresh
  double nearest_to(const Pose2& place) const {
    double least = std::numeric_limits<double>::infinity();
    for (const Pose2& pose : track) least = std::min(least, distance(pose, place));
    return least;
  }
};

class PlanDrive {
 public:
  explicit PlanDrive(const Parameters& parameters = {}) : scene_(begin(parameters)), base_(limits_of(parameters)) {}

  /// The host plans, whenever it likes. Called before each cycle.
  std::function<void(PlanDrive&)> host;
  /// What the operator wants in a cycle.
  std::function<OperatorIntent(const PlanDrive&)> wants;
  /// Whether a cell is lethal [m].
  std::function<bool(double, double)> obstacle;

  void plan(PlanShape shape) {
    scene_.situation.goal = shape.back();
    scene_.situation.plan = std::move(shape);
    loop_.plan();
  }
  const Pose2& pose() const { return scene_.situation.pose; }
  double time() const { return scene_.situation.time - 1.0; }
  void put(const Pose2& pose) { scene_.situation.pose = pose; }

  PlanCourse run(double longest) {
    PlanCourse course;
    while (time() < longest) {
      course.track.push_back(pose());
      if (host) host(*this);
      surround();
      course.arrived = loop_.goal_reached();
      course.duration = time();
      if (course.arrived) break;
      if (loop_.goal_begins()) ++course.new_goals;
      scene_.intent = wants ? wants(*this) : OperatorIntent();
      const control::Result result = loop_.cycle();
      if (result.feedback.new_goal) ++course.new_goals;
      course.failures += result.outcome == Outcome::fail ? 1 : 0;
      drive_on(scene_.situation, base_, result.command, 5, [](int) {});
      scene_.situation.velocity = {base_.velocity().v, base_.velocity().omega};
    }
    return course;
  }

 private:
  static Scene begin(const Parameters& parameters) {
    Scene scene = Scene::empty(160);
    scene.parameters = parameters;
    scene.situation.plan.clear();
    scene.situation.time = 1.0;
    return scene;
  }

  void surround() {
    follow_robot(scene_);
    if (!obstacle) return;
    scene_.costs.assign(scene_.costs.size(), cost::kFree);
    for (int j = 0; j < scene_.size_y; ++j) {
      for (int i = 0; i < scene_.size_x; ++i) {
        const Point centre = scene_.grid().centre({i, j});
        if (obstacle(centre.x(), centre.y())) scene_.at({i, j}) = cost::kLethal;
      }
    }
    inflate(scene_, 0.2, 0.2, 0.0);
  }

  Scene scene_;
  SceneLoop loop_{scene_};
  sim::DiffDrive base_;
};

}  // namespace hidwa_local_planner::test
