// SPDX-License-Identifier: BSD-3-Clause
// Drives along plans of any shape, in the default profile: the control loop, a base that ramps, and a local costmap of
// 8 m that goes with the robot.
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "control/control_loop.hpp"
#include "hidwa_local_planner/critics/built_in.hpp"
#include "support/drive_limits.hpp"
#include "support/scene.hpp"

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
  static constexpr double kPeriod = 0.05;  // [s]

  explicit PlanDrive(const Parameters& parameters = {})
      : parameters_(parameters), loop_(critics::built_in()), base_(limits_of(parameters)) {
    EXPECT_EQ(loop_.configure(parameters_), std::vector<std::string>{});
    loop_.set_footprint({{0.2, 0.2}, {-0.2, 0.2}, {-0.2, -0.2}, {0.2, -0.2}});
  }

  /// The host plans, whenever it likes. Called before each cycle.
  std::function<void(PlanDrive&)> host;
  /// What the operator wants in a cycle.
  std::function<OperatorIntent(const PlanDrive&)> wants;
  /// Whether a cell is lethal [m].
  std::function<bool(double, double)> obstacle;

  void plan(PlanShape shape) { loop_.set_plan(std::move(shape), "map", now_, kPeriod); }
  const Pose2& pose() const { return pose_; }
  double time() const { return now_ - 1.0; }
  control::ControlLoop& loop() { return loop_; }
  void put(const Pose2& pose) { pose_ = pose; }

  PlanCourse run(double longest) {
    PlanCourse course;
    while (time() < longest) {
      course.track.push_back(pose_);
      if (host) host(*this);
      const control::Observation seen = observe();
      course.arrived = loop_.goal_reached(seen, false);
      course.duration = time();
      if (course.arrived) break;
      if (loop_.goal_begins()) ++course.new_goals;
      const control::Result result = loop_.step(seen, wants ? wants(*this) : OperatorIntent());
      if (result.feedback.new_goal) ++course.new_goals;
      course.failures += result.outcome == Outcome::fail ? 1 : 0;
      base_.command({result.command.v, result.command.omega}, now_);
      for (int k = 0; k < 5; ++k) {
        const sim::Pose next = sim::moved({pose_.x, pose_.y, pose_.theta}, base_.step(now_ + 0.01 * k, 0.01));
        pose_ = {next.x, next.y, next.theta};
      }
      now_ += kPeriod;
    }
    return course;
  }

 private:
  static constexpr int kCells = 160;

  control::Observation observe() {
    control::Observation seen;
    seen.timing = {now_, kPeriod, kPeriod, kPeriod, false};
    seen.pose = pose_;
    seen.velocity = Twist2{base_.velocity().v, base_.velocity().omega};
    const double x = (std::floor(pose_.x / 0.05) - kCells / 2) * 0.05,
                 y = (std::floor(pose_.y / 0.05) - kCells / 2) * 0.05;
    costs_.assign(static_cast<std::size_t>(kCells) * kCells, cost::kFree);
    seen.costmap = {costs_.data(), kCells, kCells, 0.05, x, y};
    if (!obstacle) return seen;
    for (int j = 0; j < kCells; ++j) {
      for (int i = 0; i < kCells; ++i) {
        const Point centre = seen.costmap.centre({i, j});
        if (obstacle(centre.x(), centre.y())) {
          mark(i, j);
        }
      }
    }
    return seen;
  }
  // With the cells in which the robot's centre would collide.
  void mark(int i, int j) {
    constexpr int kInscribed = 4;
    for (int y = std::max(0, j - kInscribed); y <= std::min(kCells - 1, j + kInscribed); ++y) {
      for (int x = std::max(0, i - kInscribed); x <= std::min(kCells - 1, i + kInscribed); ++x) {
        std::uint8_t& at = costs_[static_cast<std::size_t>(y * kCells + x)];
        if ((x - i) * (x - i) + (y - j) * (y - j) <= kInscribed * kInscribed) at = std::max(at, cost::kInscribed);
      }
    }
    costs_[static_cast<std::size_t>(j * kCells + i)] = cost::kLethal;
  }

  Parameters parameters_;
  control::ControlLoop loop_;
  sim::DiffDrive base_;
  Pose2 pose_;
  double now_ = 1.0;  // [s]
  std::vector<std::uint8_t> costs_;
};

}  // namespace hidwa_local_planner::test
