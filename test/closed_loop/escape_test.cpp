// SPDX-License-Identifier: BSD-3-Clause
// Drives that begin in collision: with a base that has a latency and ramps at its limits, seen every few millimetres by
// a contact check of their own (naive_escape.hpp).
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <deque>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "plan_drive.hpp"
#include "support/effort.hpp"
#include "support/naive_escape.hpp"
#include "support/naive_planner.hpp"
#include "support/random.hpp"
#include "support/round_outline.hpp"

namespace hidwa_local_planner::test {
namespace {

// Total depths that grow by less have not grown: what lies between two poses of the planner's check [m].
constexpr double kSameDepth = 1e-4;

// What the ordinary check leaves open of the other obstacles where the robot is too near to one for a margin [m].
constexpr double kTouches = 5e-4;

// As far as a cluster is followed: beyond it no rollout gets [cells].
constexpr int kClusterSteps = 8;

Polygon rectangle(double rear, double front, double half_width) {
  return {{front, half_width}, {rear, half_width}, {rear, -half_width}, {front, -half_width}};
}

// A base in a scene, both of which the planner knows as they are. It keeps to the limits and has the latency that the
// parameters say.
class Robot {
 public:
  explicit Robot(Scene scene)
      : scene_(std::move(scene)), body_(naive_body(scene_)), drive_(limits_of(scene_.parameters)), loop_(scene_) {}
  Scene& scene() { return scene_; }
  const Pose2& pose() const { return scene_.situation.pose; }
  NaiveEscape contact() const { return {scene_.grid(), body_, true, pose(), kClusterSteps}; }

  struct Cycle {
    Decision decision;
    std::vector<Pose2> poses;  // on the way, the last at its end
  };
  Cycle cycle() {
    Situation& now = scene_.situation;
    now.velocity = {drive_.velocity().v, drive_.velocity().omega};
    const control::Result result = loop_.cycle();
    Cycle cycle{*result.decision, {}};
    drive_on(now, drive_, result.command, 50, [&](int step) {
      if (step % 10 == 9) cycle.poses.push_back(now.pose);
    });
    return cycle;
  }

 private:
  Scene scene_;
  NaiveBody body_;
  sim::DiffDrive drive_;
  SceneLoop loop_;
};

// What the rule forbids. A command is judged from the pose at which it was sent, and so is the braking after it: what
// happens now was allowed in one of the last cycles.
struct Found {
  double entered = 0.0;   // deepest beyond what the rule allows in a cell [m]
  double deepened = 0.0;  // most that the total depth grew within a cycle [m]
  int fails = 0;
  bool out = false;  // free at the end
};

double least_excess(const std::deque<NaiveEscape>& contacts, const Pose2& pose) {
  double least = INFINITY;
  for (const NaiveEscape& contact : contacts) least = std::min(least, contact.excess(pose, true));
  return least;
}

Found watch(Robot& robot, int cycles) {
  Found found;
  const Parameters& p = robot.scene().parameters;
  const double lasts = p.control_latency + p.max_vel_x / p.braking_x();
  const auto judged = static_cast<std::size_t>(std::ceil(lasts / robot.scene().situation.period)) + 1;
  std::deque<NaiveEscape> contacts;
  for (int k = 0; k < cycles; ++k) {
    contacts.push_back(robot.contact());
    if (contacts.size() > judged) contacts.pop_front();
    const NaiveEscape& contact = contacts.back();
    const double before = contact.start_total();
    const Robot::Cycle cycle = robot.cycle();
    for (const Pose2& pose : cycle.poses) {
      const double excess = contact.excess(pose, true);
      found.entered = std::max(found.entered, excess > 0.0 ? least_excess(contacts, pose) : 0.0);
      found.deepened = std::max(found.deepened, contact.total(pose) - before);
    }
    found.fails += cycle.decision.problem.find("no way out") != std::string::npos;
    found.out = !contact.overlaps();
  }
  return found;
}

void aim_at(Scene& scene, double angle) {
  const Pose2& from = scene.situation.pose;
  scene.situation.plan = {from};
  go_to(scene.situation.plan, from.x + 2.0 * std::cos(angle), from.y + 2.0 * std::sin(angle));
  scene.situation.goal = scene.situation.plan.back();
}

// A random robot somewhere in a mess of posts, walls and noise, at rest, in collision.
Scene random_start(std::uint64_t seed) {
  Random random(seed);
  const int shape = random.integer(0, 3);
  Scene scene = Scene::empty(121);
  scene.outline = shape == 0   ? round_outline(0.3)
                  : shape == 1 ? round_outline(0.3, 8)
                  : shape == 2 ? rectangle(-0.25, 0.25, 0.2)
                               : rectangle(-0.2, 0.6, 0.2);
  Parameters& p = scene.parameters;
  p = Parameters();
  p.vx_samples = 12;
  p.vth_samples = 20;
  p.min_vel_x = random.chance(0.5) ? -0.3 : 0.0;
  p.control_latency = random.pick({0.0, 0.05, 0.1, 0.2});
  const int posts = random.integer(2, 12), noise = random.integer(0, 6), walls = random.integer(0, 2);
  for (int k = 0; k < posts; ++k) {
    const double x = random.uniform(-1.2, 1.2), y = random.uniform(-1.2, 1.2), side = random.uniform(0.03, 0.2);
    scene.fill(x, y, x + side, y + side);
  }
  for (int k = 0; k < noise; ++k) {
    const double y = random.uniform(-0.6, 0.6), x = random.uniform(-0.6, 0.6);
    scene.at(scene.grid().cell_at(x, y)) = cost::kLethal;
  }
  for (int k = 0; k < walls; ++k) {
    const double angle = random.uniform(-M_PI, M_PI), off = random.uniform(0.15, 0.8);
    for (double t = -3.0; t < 3.0; t += 0.01) {
      const Cell cell = scene.grid().cell_at(off * std::cos(angle) - t * std::sin(angle),
                                             off * std::sin(angle) + t * std::cos(angle));
      if (scene.grid().contains(cell)) scene.at(cell) = cost::kLethal;
    }
  }
  scene.situation.pose = {random.uniform(-0.2, 0.2), random.uniform(-0.2, 0.2), random.uniform(-M_PI, M_PI)};
  const double inner = shape == 0 ? 0.3 * std::cos(M_PI / 16.0) : shape == 1 ? 0.3 * std::cos(M_PI / 8.0) : 0.2;
  inflate(scene, inner, 0.5, 5.0);
  aim_at(scene, random.uniform(-M_PI, M_PI));
  if (random.chance(0.3)) scene.steer({0.5, random.uniform(-1.0, 1.0)});
  return scene;
}

// Whether it gets out straight on or backwards, as far as it may, from where it faces.
bool straight_out(const NaiveEscape& contact, const Pose2& from, bool reverse) {
  for (const double side : {1.0, -1.0}) {
    if (side < 0.0 && !reverse) continue;
    double before = contact.start_total() + 1e-6;
    for (double way = 0.01; way < 0.6; way += 0.01) {
      const Pose2 at{from.x + side * way * std::cos(from.theta), from.y + side * way * std::sin(from.theta),
                     from.theta};
      const double total = contact.total(at);
      if (total > before || contact.excess(at, false) > 1e-6) break;
      if (total <= 0.0) return true;
      before = total;
    }
  }
  return false;
}

// A way that everybody sees: a turn on the spot, then straight on.
bool way_exists(const Robot& robot, bool reverse) {
  const NaiveEscape contact = robot.contact();
  for (const double side : {1.0, -1.0}) {
    double before = contact.start_total() + 1e-6;
    for (double turn = 0.0; turn < M_PI; turn += 0.05) {
      const Pose2 at{robot.pose().x, robot.pose().y, robot.pose().theta + side * turn};
      const double total = contact.total(at);
      if (total > before || contact.excess(at, false) > 1e-6) break;
      if (straight_out(contact, at, reverse)) return true;
      before = total;
    }
  }
  return false;
}

TEST(Escape, FromRandomStartsNothingIsEnteredThatTheRuleForbids) {
  const int kStarts = effort(40, 300);
  int starts = 0, out = 0, said_so = 0, ways = 0, ways_found = 0;
  double deepest = 0.0, most = 0.0;
  for (std::uint64_t seed = 1; starts < kStarts; ++seed) {
    Robot robot(random_start(seed));
    if (!robot.contact().overlaps()) continue;
    ++starts;
    const bool autonomous = robot.scene().intent.influence == Influence::none;
    const bool way = autonomous && way_exists(robot, robot.scene().parameters.min_vel_x < 0.0);
    const Found found = watch(robot, 300);
    EXPECT_LE(found.entered, kTouches) << "seed " << seed;
    EXPECT_LE(found.deepened, 2.0 * kSameDepth) << "seed " << seed;
    deepest = std::max(deepest, found.entered);
    most = std::max(most, found.deepened);
    out += found.out;
    said_so += found.fails > 0;
    ways += way;
    ways_found += way && found.out;
  }
  std::printf(
      "%d starts: %d out, %d say that there is no way; %d of %d plain ways found; touched %.2f, deepened %.2f mm\n",
      starts, out, said_so, ways_found, ways, 1e3 * deepest, 1e3 * most);
  EXPECT_GT(ways, kStarts / 8);
  EXPECT_GE(ways_found, 0.9 * ways);
}

}  // namespace
}  // namespace hidwa_local_planner::test
