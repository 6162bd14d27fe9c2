// SPDX-License-Identifier: BSD-3-Clause
#include "core/planner/recovery_motion.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace hidwa_local_planner {
namespace {

// Off the plan's direction by less than this a robot faces it [rad].
constexpr double kFacesPlan = 0.5;

// How far along the plan its direction is taken [m]: beyond the cells around the robot, before the next corner.
constexpr double kDirectionAhead = 0.5;

// It is out when it has come so far [m], and gives up the attempt after so long [s].
constexpr double kOut = 0.4;
constexpr double kLongest = 15.0;

// Headings are tried in such steps [rad], and reached when so near.
constexpr double kHeadingStep = 0.1;
constexpr double kHeadingReached = 0.05;

// The short way straight on, in cells, and its parts.
constexpr double kShortWay = 2.0;
constexpr int kParts = 8;

// Depths in collision that count as one [m].
constexpr double kSameDepth = 0.001;

// A way leads nearer to the goal by at least so many cells.
constexpr double kNearer = 0.4;

double to_goal(const RecoveryMotion::Scene& scene, double x, double y) {
  return PlanGrids::at(scene.grids.to_goal(), scene.grid, x, y);
}

// How far to turn to face the plan [rad]; left positive.
double heading_off_plan(const Situation& situation) {
  std::size_t nearest = 0;
  for (std::size_t i = 1; i < situation.plan.size(); ++i) {
    if (distance(situation.plan[i], situation.pose) < distance(situation.plan[nearest], situation.pose)) nearest = i;
  }
  std::size_t ahead = nearest;
  while (ahead + 1 < situation.plan.size() && distance(situation.plan[ahead], situation.pose) < kDirectionAhead)
    ++ahead;
  const Pose2& target = situation.plan[ahead];
  if (distance(target, situation.pose) < 1e-6) return 0.0;
  return wrap_angle(std::atan2(target.y - situation.pose.y, target.x - situation.pose.x) - situation.pose.theta);
}

}  // namespace

bool RecoveryMotion::watch(const Situation& situation, const Rest& rest, double patience) {
  stands_.observe(situation.time, rest.stands);
  rests_.observe(situation.time, rest.stands || rest.creeps);
  if (active_ || patience < 0.0 || !rests_.for_at_least(patience, situation.time)) return false;
  active_ = true;
  stood_ = situation.pose;
  begun_ = situation.time;
  facing_plan_ = turning_to_plan_ = turning_ = false;
  return true;
}

int RecoveryMotion::choose(const Scene& scene) {
  const bool trapped = scene.escape.overlaps();
  const int out = trapped ? out_of_collision(scene) : -1;
  if (out >= 0 || !active_) return out;
  const double now = scene.situation.time;
  active_ = distance(scene.situation.pose, stood_) < kOut && now >= begun_ && now - begun_ < kLongest;
  if (!active_) return -1;
  int best = trapped ? -1 : towards_plan(scene);
  if (best < 0 && !trapped) best = towards_goal(scene);
  return best < 0 ? towards_free_heading(scene) : best;
}

int RecoveryMotion::towards_plan(const Scene& scene) {
  if (facing_plan_) return -1;
  const double off = heading_off_plan(scene.situation);
  // A small turn is not begun; what is begun is finished.
  facing_plan_ = std::abs(off) <= (turning_to_plan_ ? 0.5 * kFacesPlan : kFacesPlan);
  turning_to_plan_ = !facing_plan_;
  return facing_plan_ ? -1 : turn_by(scene, off);
}

// The legal candidate that drives and comes nearest to the local goal; between equals the cheapest.
int RecoveryMotion::towards_goal(const Scene& scene) const {
  const double here = to_goal(scene, scene.situation.pose.x, scene.situation.pose.y);
  if (here < 0.0) return -1;
  double least = here - kNearer * scene.grid.resolution;
  double cost = std::numeric_limits<double>::infinity();
  int best = -1;
  for (std::size_t t = 0; t < scene.rollout.tile_count(); ++t) {
    const Tile tile = scene.rollout.tile(t);
    for (std::size_t c = 0; c < tile.count; ++c) {
      const double total = scene.totals[tile.first + c];
      if (!std::isfinite(total)) continue;
      const Pose2 end = tile.last_pose(c);
      const double left = to_goal(scene, end.x, end.y);
      if (left < 0.0 || left > least || (left == least && total >= cost)) continue;
      if (!scene.admissibility.confirm_braking(tile.sample(c))) continue;
      least = left;
      cost = total;
      best = static_cast<int>(tile.first + c);
    }
  }
  return best;
}

// Of the legal ones that drive: what ends least deep, by whole millimetres, and of these the cheapest.
int RecoveryMotion::out_of_collision(const Scene& scene) const {
  double least = std::numeric_limits<double>::infinity(), cost = least;
  int best = -1;
  for (std::size_t t = 0; t < scene.rollout.tile_count(); ++t) {
    const Tile tile = scene.rollout.tile(t);
    for (std::size_t c = 0; c < tile.count; ++c) {
      const double total = scene.totals[tile.first + c];
      if (tile.v[c] == 0.0 || !std::isfinite(total)) continue;
      const double depth = std::floor(scene.escape.depth_at_end(tile, c) / kSameDepth);
      if (depth > least || (depth == least && total >= cost)) continue;
      if (!scene.admissibility.confirm_braking(tile.sample(c))) continue;
      least = depth;
      cost = total;
      best = static_cast<int>(tile.first + c);
    }
  }
  return best;
}

int RecoveryMotion::towards_free_heading(const Scene& scene) {
  const Pose2& pose = scene.situation.pose;
  if (turning_) {
    const double left = wrap_angle(heading_ - pose.theta);
    turning_ = std::abs(left) > kHeadingReached && leads_on(scene, heading_);
    if (turning_) return turn_by(scene, left);
  }
  // The turn itself must be free, to either side.
  const double first = heading_off_plan(scene.situation) < 0.0 ? -1.0 : 1.0;
  bool open[2] = {true, true};
  for (double angle = kHeadingStep; angle < M_PI; angle += kHeadingStep) {
    for (int side = 0; side < 2; ++side) {
      const double turn = (side == 0 ? first : -first) * angle;
      const double heading = pose.theta + turn;
      open[side] = open[side] && may_face(scene, heading);
      if (!open[side] || !leads_on(scene, heading)) continue;
      const int best = turn_by(scene, turn);
      if (best < 0) continue;
      turning_ = true;
      heading_ = wrap_angle(heading);
      return best;
    }
  }
  return -1;
}

// The legal turn on the spot that ends nearest to `angle` from here; -1 where there is none.
int RecoveryMotion::turn_by(const Scene& scene, double angle) const {
  int best = -1;
  double least = std::abs(angle);
  for (std::size_t t = 0; t < scene.rollout.tile_count(); ++t) {
    const Tile tile = scene.rollout.tile(t);
    const double left = std::abs(wrap_angle(angle - (tile.heading[tile.steps] - scene.situation.pose.theta)));
    for (std::size_t c = 0; c < tile.count; ++c) {
      if (tile.v[c] != 0.0 || tile.omega == 0.0 || left >= least) continue;
      if (!std::isfinite(scene.totals[tile.first + c])) continue;
      if (!scene.admissibility.confirm_braking(tile.sample(c))) continue;
      best = static_cast<int>(tile.first + c);
      least = left;
    }
  }
  return best;
}

bool RecoveryMotion::may_face(const Scene& scene, double heading) const {
  if (scene.escape.applies()) return scene.escape.may_face(heading);
  const Pose2& pose = scene.situation.pose;
  return !scene.collision.collides({pose.x, pose.y, heading});
}

// It asks for some clearance: where the robot just fits, a cell of the map that changes would block it.
bool RecoveryMotion::leads_on(const Scene& scene, double heading) const {
  const double length = kShortWay * scene.grid.resolution;
  if (scene.escape.overlaps()) return scene.escape.leads_out(heading, length);
  const Pose2& pose = scene.situation.pose;
  const double here = to_goal(scene, pose.x, pose.y);
  const Rotation rotation{std::cos(heading), std::sin(heading)};
  const Pose2 end{pose.x + length * rotation.c, pose.y + length * rotation.s, heading};
  const double there = to_goal(scene, end.x, end.y);
  if (here < 0.0 || there < 0.0 || there > here - kNearer * scene.grid.resolution) return false;
  for (int part = 1; part <= kParts; ++part) {
    const double way = length * part / kParts;
    const Pose2 on_way{pose.x + way * rotation.c, pose.y + way * rotation.s, heading};
    if (scene.collision.clearance(on_way, rotation, scene.grid.resolution) < scene.grid.resolution / 16.0) return false;
  }
  return true;
}

}  // namespace hidwa_local_planner
