// SPDX-License-Identifier: BSD-3-Clause
#include "core/autonomy/way_follower.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/autonomy/least_legal.hpp"

namespace hidwa_local_planner {
namespace {

// A candidate is followed for this time before it is braked [s].
constexpr double kFollowed = 0.4;

// Only this part of the way ahead counts [s].
constexpr double kWayAhead = 2.0;

// Tolerance of the pose where a way turns back [m]: within it the way leads on.
constexpr double kNearTurn = 0.02;

// A way has ended when so little of it is left [s].
constexpr double kEnds = 0.3;

// The remaining time must fall by this [s] within this time [s].
constexpr double kFall = 0.05;
constexpr double kFallWithin = 1.0;

// The way is much narrower below this share of its clearance.
constexpr double kNarrower = 0.5;

// The cheapest candidate leads on as well if it gains this share of what the best one gains, for this time [s].
constexpr double kAgreement = 0.6;
constexpr double kAgreementTime = 1.0;

// The other way may take this much longer; if the robot has to turn back for it, it must take less by this [s].
constexpr double kSimilarTime = 0.5;

// The ends of two ways are the same pose within this distance [m], and a robot is still where its way begins [m].
constexpr double kSameEnd = 0.1;
constexpr double kSameStart = 0.1;

// Where a candidate brings the robot that follows it for a while and then brakes: braking takes it half as far as
// driving on would.
Pose2 braked_end(const Tile& tile, std::size_t c, const VelocityLimits& limits) {
  const double braking = std::max(limits.x.time_to_rest(tile.v[c]), limits.theta.time_to_rest(tile.omega));
  const double steps = std::min((kFollowed + 0.5 * braking) / tile.dt, static_cast<double>(tile.steps));
  const auto k = std::min(static_cast<std::size_t>(steps), tile.steps - 1);
  const double share = steps - static_cast<double>(k);
  const Pose2 a = tile.pose(k, c), b = tile.pose(k + 1, c);
  return {a.x + share * (b.x - a.x), a.y + share * (b.y - a.y), a.theta + share * (b.theta - a.theta)};
}

// The legal candidate with the least total, of equals the first; -1 where there is none.
int cheapest_legal(Evaluation& evaluated) {
  const std::vector<double>& totals = evaluated.scores().totals();
  for (;;) {
    const auto least = std::min_element(totals.begin(), totals.end());
    if (least == totals.end() || !std::isfinite(*least)) return -1;
    const auto candidate = static_cast<std::size_t>(least - totals.begin());
    if (evaluated.checks().confirm(candidate)) return static_cast<int>(candidate);
  }
}

}  // namespace

void WayFollower::clear() {
  way_.clear();
  progress_ = {};
}

void WayFollower::begin(double now, bool while_driving) {
  progress_ = {};
  progress_.since = now;
  while_driving_ = while_driving;
}

bool WayFollower::begins() const { return std::isinf(progress_.least) && way_.duration() > kEnds; }

WayFollower::Step WayFollower::propose(const Cycle& cycle, Evaluation& evaluated, bool may_agree) const {
  const double now = cycle.situation.time;
  Step step{-1, false, false, progress_};
  step.ended = way_.empty();  // damaged, where it was loaded
  if (step.ended) return step;
  const PoseOnWay at = pose_on_way(cycle, evaluated.obstacles().collision());
  step.progress.part = static_cast<std::uint32_t>(at.here.part);
  step.ended = at.here.left <= kEnds || progress_.agrees.for_at_least(kAgreementTime, now);
  if (step.ended) return step;
  step.stalled = !gets_on(at.here, now, step.progress);
  if (step.stalled) return step;
  measure_room(at, step.progress);
  double least = std::numeric_limits<double>::infinity();
  step.candidate = least_legal(evaluated, [&](const Tile& tile, std::size_t c) {
    const double left = left_after(cycle, at, tile, c);
    least = std::min(least, left);
    return left;
  });
  const double most = at.here.remaining() - kAgreement * (at.here.remaining() - least);  // that may remain
  const int cheapest = least < at.here.remaining() ? cheapest_legal(evaluated) : -1;
  bool agrees = false;
  if (cheapest >= 0) {
    const Rollout& rollout = evaluated.candidates().rollout();
    const Tile tile = rollout.tile(rollout.tile_of(static_cast<std::size_t>(cheapest)));
    agrees =
        may_agree && !tight_ && left_after(cycle, at, tile, static_cast<std::size_t>(cheapest) - tile.first) <= most;
  }
  step.progress.agrees.observe(now, agrees);
  if (agrees) step.candidate = cheapest;
  return step;
}

WayFollower::PoseOnWay WayFollower::pose_on_way(const Cycle& cycle, const CollisionChecker& collision) const {
  const Pose2& pose = cycle.start.pose;
  const double room = way_.room_ahead(progress_.part, collision, cycle.grid.resolution);
  const std::size_t end = way_.end_of_parts(pose, progress_.part, kWayAhead, std::max(room, kNearTurn));
  return {way_.nearest(pose, progress_.part, end, room), end, room};
}

// The remaining time [s] after a candidate.
double WayFollower::left_after(const Cycle& cycle, const PoseOnWay& at, const Tile& tile, std::size_t c) const {
  return way_.nearest(braked_end(tile, c, cycle.start.limits), at.here.part, at.end, at.room).remaining();
}

// The remaining time falls, or has lately: from the robot, or from the nearest pose of the way.
bool WayFollower::gets_on(const Way::Projection& here, double now, Progress& progress) const {
  const double remaining = here.left + here.off / Way::kBackSpeed;  // whatever room the way has in this cycle
  const bool falls = remaining < progress.least - kFall || here.left < progress.least_left - kFall;
  if (falls || now < progress.since) {
    progress.least = std::min(progress.least, remaining);
    progress.least_left = std::min(progress.least_left, here.left);
    progress.since = now;
  }
  return now - progress.since < kFallWithin;
}

// Whether the way is narrower on the map of now, or the robot is farther from it than there is room.
void WayFollower::measure_room(const PoseOnWay& at, Progress& progress) const {
  if (progress.room < 0.0) progress.room = at.room;
  const double off = at.here.left < way_.duration() ? at.here.off : 0.0;  // a way that begins ahead is not left yet
  progress.blocked = at.room <= 0.0;
  progress.narrower = progress.blocked || at.room < std::max(kNarrower * progress.room, off);
}

// Two ways of much the same length take turns otherwise, and the robot turns to and fro between them. The other one may
// lead on beyond the end of this one: it was begun later.
bool WayFollower::gives_way_to(const Way& other, const Pose2& start) const {
  if (progress_.blocked) return true;
  const std::size_t end = way_.end_of_parts(start, progress_.part, kWayAhead, kUsualCell);
  const bool turns_back = way_.direction_from(progress_.part) * other.direction_from(0) < 0;
  const double more = other.time_until_near(way_.stations().back().pose, kSameEnd) -
                      way_.nearest(start, progress_.part, end, kUsualCell).remaining();
  return more < (turns_back ? -kSimilarTime : kSimilarTime);
}

void WayFollower::replace(Way& other, double now) {
  std::swap(way_, other);
  const ConditionTimer agrees = progress_.agrees;
  begin(now, while_driving_);
  progress_.agrees = agrees;
}

bool WayFollower::still_leads(const Cycle& cycle, double near) const {
  const Pose2& end = way_.stations().back().pose;
  const std::vector<Pose2>& plan = cycle.situation.plan;
  return distance(way_.stations().front().pose, cycle.start.pose) < kSameStart &&
         std::any_of(plan.begin(), plan.end(), [&](const Pose2& pose) { return distance(pose, end) < near; });
}

}  // namespace hidwa_local_planner
