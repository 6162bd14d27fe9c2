// SPDX-License-Identifier: BSD-3-Clause
// A robot without a goal in a world of wall pieces and posts: a laser with noise, the local costmap that its scans
// make, a base with limits, and an operator who holds one stick position. Contacts are judged with the true shapes.
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "control/control_loop.hpp"
#include "drive/local_costmap.hpp"
#include "drive_on.hpp"
#include "hidwa_local_planner/critics/built_in.hpp"
#include "sim/diff_drive.hpp"
#include "sim/laser.hpp"
#include "support/drive_limits.hpp"
#include "support/naive_gap.hpp"
#include "support/random.hpp"
#include "support/scan_world.hpp"

namespace hidwa_local_planner::test {

/// The true world; distances are exact.
struct TrueWorld {
  std::vector<Wall> walls;
  std::vector<Post> posts;

  /// From a point in a direction to the first surface [m]; infinite where there is none.
  double range(const Point& from, double angle) const {
    const Point beam(std::cos(angle), std::sin(angle));
    double least = std::numeric_limits<double>::infinity();
    for (const Wall& wall : walls) least = std::min(least, range_to(wall, from, beam));
    for (const Post& post : posts) least = std::min(least, range_to(post, from, beam));
    return least;
  }

  /// A robot with this outline (robot frame) overlaps something.
  bool touches(const Polygon& outline, const Pose2& pose) const {
    const Polygon placed = naive_place(outline, pose);
    for (std::size_t i = 0; i < placed.size(); ++i) {
      const Wall side{placed[i], placed[(i + 1) % placed.size()]};
      for (const Wall& wall : walls) {
        if (crosses(side, wall)) return true;
      }
      for (const Post& post : posts) {
        if (naive_to_segment(post.centre, side.a, side.b) < post.radius) return true;
      }
    }
    return false;
  }

  static bool crosses(const Wall& p, const Wall& q) {
    const auto turn = [](const Point& a, const Point& b, const Point& c) {
      return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
    };
    return turn(p.a, p.b, q.a) * turn(p.a, p.b, q.b) < 0.0 && turn(q.a, q.b, p.a) * turn(q.a, q.b, p.b) < 0.0;
  }
};

/// A world, a robot at the origin that heads along +x, and the stick that its operator holds.
struct GoallessScene {
  TrueWorld world;
  Polygon outline;      // robot frame [m]
  Twist2 stick;         // [m/s, rad/s]
  double noise = 0.0;   // of a range, standard deviation [m]
  double finish = 0.0;  // the way along +x after which the scene is passed [m]
  std::uint64_t seed = 1;
};

struct GoallessRun {
  bool passed = false;
  bool touched = false;
  bool stopped = false;     // it stood before that
  double most_off = 0.0;    // the largest angle between its heading and the operator's direction [rad]
  double off_at_end = 0.0;  // [rad]
  bool against = false;     // it drove backwards while the stick pointed forwards
};

inline Parameters goalless_parameters() {
  Parameters p;
  p.max_vel_x = 0.8;
  p.min_vel_x = -0.2;
  p.max_vel_theta = 1.2;
  p.acc_lim_x = 1.0;
  p.acc_lim_theta = 2.5;
  return p;
}

/// Gives the command of a cycle from what is seen.
using Commander = std::function<Twist2(const control::Observation&)>;

inline GoallessRun run_goalless(const GoallessScene& scene, const Parameters& p, const Commander& commander,
                                double longest = 40.0) {
  constexpr double kPeriod = 0.05;
  sim::DiffDrive base(limits_of(p));
  sim::Random random(scene.seed);
  sim::LaserSpec laser;
  laser.beams = 360;
  laser.noise = scene.noise;
  drive::CostmapSettings settings;
  settings.width = 6.0;
  sim::Polygon padded;
  for (const Point& corner : scene.outline) padded.push_back({corner.x(), corner.y()});
  drive::LocalCostmap costmap(settings, padded);
  Pose2 pose;
  GoallessRun run;
  std::vector<float> ranges;
  drive::Beams beams;
  int standing = 0;
  bool drove = false;
  for (double now = 1.0; now < longest && !run.passed && !run.stopped && !run.touched; now += kPeriod) {
    sim::scan(
        [&](double angle) {
          return scene.world.range({pose.x, pose.y}, angle);
        },
        laser, pose.theta, random, ranges);
    drive::project(ranges, laser, {pose.x, pose.y, pose.theta}, beams);
    costmap.update({pose.x, pose.y, pose.theta}, beams);
    control::Observation seen;
    seen.timing = {now, kPeriod, kPeriod, kPeriod, false};
    seen.pose = pose;
    seen.velocity = Twist2{base.velocity().v, base.velocity().omega};
    seen.costmap = costmap.view();
    seen.goalless = true;
    const Twist2 command = commander(seen);
    drive_on(pose, base, command, now, kPeriod, 5,
             [&](int) { run.touched = run.touched || scene.world.touches(scene.outline, pose); });
    const bool stands = std::abs(base.velocity().v) < 0.02;
    drove = drove || !stands;
    standing = stands ? standing + 1 : 0;
    run.stopped = standing > (drove ? 10 : 100);
    run.against = run.against || base.velocity().v < -1e-3;
    run.most_off = std::max(run.most_off, std::abs(wrap_angle(pose.theta)));
    run.off_at_end = std::abs(wrap_angle(pose.theta));
    run.passed = pose.x >= scene.finish;
  }
  return run;
}

/// With the planner.
class GoallessPlanner {
 public:
  GoallessPlanner(const GoallessScene& scene, const Parameters& p) : scene_(scene), loop_(critics::built_in()) {
    EXPECT_EQ(loop_.configure(p), std::vector<std::string>{});
    loop_.set_footprint(scene.outline);
  }
  Twist2 operator()(const control::Observation& seen) {
    OperatorIntent intent;
    const bool steers = !(scene_.stick == Twist2{});
    intent.state = steers ? OperatorStateId::manual : OperatorStateId::autonomy;
    intent.influence = steers ? Influence::direct : Influence::none;
    intent.u_h = scene_.stick;
    const control::Result result = loop_.step(seen, intent);
    rejected_by_ = result.decision != nullptr ? result.decision->operator_rejected_by : "no decision";
    return result.command;
  }
  /// What rejected the operator command in the last cycle.
  const std::string& rejected_by() const { return rejected_by_; }

 private:
  const GoallessScene& scene_;
  control::ControlLoop loop_;
  std::string rejected_by_;
};

}  // namespace hidwa_local_planner::test
