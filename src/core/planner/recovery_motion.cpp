// SPDX-License-Identifier: BSD-3-Clause
#include "core/planner/recovery_motion.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>

#include "core/planner/least_legal.hpp"
#include "core/planner/way_room.hpp"

namespace hidwa_local_planner {
namespace {

// A search may take so long until the robot says so, once in so long at one place; so long in all, since its map grows
// old, and so long while the robot drives on; where there is no way the next one begins so long after it [s].
constexpr double kPromptSearch = 1.2;
constexpr double kSaysAgain = 20.0;
constexpr double kLongestSearch = 8.0;
constexpr double kLongestAhead = 5.0;
constexpr double kSearchAgain = 2.0;

// Ways that come so near to one place are compared there [m].
constexpr double kSameEnd = 0.1;

// A way is followed by a robot that has come no farther from where its search began [m].
constexpr double kSameStart = 0.1;

// For so long a robot may get nowhere [s], and for three times what its limits take to get somewhere.
constexpr double kNowhere = 1.5;

// A candidate is followed for so long before it is braked [s].
constexpr double kFollowed = 0.4;

// A place on the way up to so much later counts [s].
constexpr double kPlaceAhead = 2.0;

// Where a way turns back it leads on from so near [m].
constexpr double kNearTurn = 0.02;

// The way ends so long before its end [s].
constexpr double kEndsBefore = 0.3;

// The remaining time falls if it falls by so much [s] in the time after which the robot searches anew [s].
constexpr double kFalls = 0.05;
constexpr double kFallsWithin = 1.0;

// A way is renewed where the clearance ahead is below this share of what it was when the way was found; at most so
// often, and by a search of at most so long [s].
constexpr double kNarrower = 0.5;
constexpr double kRenewAgain = 0.2;
constexpr double kLongestRenewal = 1.0;

// It is renewed by one that takes no more than this longer; if the robot has to turn back for it, by one that takes
// less by this [s].
constexpr double kAboutAsLong = 0.5;

// Ordinary scoring leads on as well if it gains that share of what the way gains, for so long [s].
constexpr double kAgreement = 0.6;
constexpr double kAgreesFor = 1.0;

// A search goes on, and what it has found out holds, so near to where it began [m]: the robot has come from there.
constexpr double kSamePlace = 0.3;

// What moves is in the way as far as this along the plan [m].
constexpr double kBlocksWithin = 2.5;

constexpr std::size_t kLongestText = 200;
constexpr const char* kNoWay = "no way for this outline through the local map";
constexpr const char* kLate = "no way was found in time through the local map";
constexpr const char* kBlocked = "what moves has blocked the only way for 30 s";
static_assert(MoverWait::kLongest == 30.0, "the text says so");

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

}  // namespace

void RecoveryMotion::reset() {
  enter(Phase::idle, 0.0);
  stands_.reset();
  rests_.reset();
  novelty_.reset();
  escape_.reset();
  hopeless_.clear();
  tight_ = false;
  back_.reset();
}

void RecoveryMotion::enter(Phase phase, double now) {
  phase_ = phase;
  since_ = now;
  if (phase == Phase::idle) to_goal_ = false;
  if (phase == Phase::idle || phase == Phase::follows) {
    holds_ = false;
    problem_.clear();
    wait_.reset();
  }
  if (phase != Phase::searches && phase != Phase::looks_ahead) search_.clear();
  if (phase != Phase::follows) way_.clear();
  if (phase != Phase::searches && phase != Phase::follows) goes_back_ = false;
  start_way();
  agrees_.reset();
  told_ = false;
}

void RecoveryMotion::begin_at_goal(double now) {
  enter(Phase::stops, now);
  holds_ = to_goal_ = true;
}

// At the beginning of the way that there is.
void RecoveryMotion::start_way() {
  part_ = 0;
  least_ = least_left_ = std::numeric_limits<double>::infinity();
  room_ = -1.0;
  narrower_ = blocked_ = false;
}

// One that ends where the robot stands leads nowhere.
bool RecoveryMotion::begins_way() const {
  return phase_ == Phase::follows && std::isinf(least_) && way_.duration() > kEndsBefore;
}

bool RecoveryMotion::watch(const Cycle& cycle, const Course& course, double patience) {
  const double now = cycle.situation.time;
  stands_.observe(now, course.autonomous && course.stands);
  if (!course.autonomous || patience < 0.0) {
    const ConditionTimer stands = stands_;
    reset();
    stands_ = stands;
    return false;
  }
  rests_.observe(now, (course.stands || course.creeps) && !course.yields);
  if (course.yields) novelty_.reset();
  novelty_.observe(cycle.situation.pose, now);
  tight_ = course.tight;
  back_.observe(cycle.situation.pose, blocked_by_movers(cycle, course.stands), now);
  if (distance(hopeless_at_, cycle.situation.pose) >= kSamePlace) hopeless_.clear();
  impatient_ = rests_.for_at_least(patience, now);
  if (course.trapped) {
    if (!impatient_ || escape_.active()) return false;
    escape_.begin(now);
    return true;
  }
  advance(cycle, course);
  return phase_ == Phase::follows;
}

// From phase to phase.
void RecoveryMotion::advance(const Cycle& cycle, const Course& course) {
  const double now = cycle.situation.time;
  const bool ordinary = phase_ == Phase::idle || phase_ == Phase::looks_ahead;
  if ((phase_ == Phase::searches || phase_ == Phase::waits) && !course.stands && !holds_) enter(Phase::idle, now);
  if (ordinary && ((impatient_ && !course.stands) || gets_nowhere(cycle))) {
    phase_ = Phase::stops;
    holds_ = true;
  }
  const bool settled = stands_.for_at_least(cycle.parameters.control_latency + 2.0 * cycle.situation.period, now);
  const bool again = phase_ == Phase::waits && (now - since_ >= kSearchAgain || now < since_);
  const bool goes_on = phase_ != Phase::follows && search_.state() == WaySearch::State::searching &&
                       distance(search_.task().start, cycle.situation.pose) < kSamePlace;
  if (settled && goes_on && phase_ != Phase::searches) {
    phase_ = Phase::searches;
    recall();
  } else if (settled && (ordinary || phase_ == Phase::stops || again)) {
    begin_search(cycle, Phase::searches, cycle.situation.pose);
  } else if (phase_ == Phase::idle && tight_ && !(now >= looked_ && now - looked_ < kSearchAgain)) {
    looked_ = now;
    begin_search(cycle, Phase::looks_ahead, course.soon);
  }
  step_back(cycle);
  if (phase_ == Phase::looks_ahead) look_ahead(cycle);
  if (phase_ == Phase::follows) renew(cycle, course.soon);
  if (phase_ == Phase::searches && goes_back_) {
    search_back(cycle);
  } else if (phase_ == Phase::searches) {
    search(cycle, impatient_ || holds_);
  }
}

// It is known that no way leads on, and something that moves is at the plan ahead.
bool RecoveryMotion::blocked_by_movers(const Cycle& cycle, bool stands) const {
  if (!stands || goes_back_ || (phase_ != Phase::waits && phase_ != Phase::searches)) return false;
  if (wait_.waits()) return true;
  if (problem_.empty()) return false;
  const std::vector<Pose2>& plan = cycle.situation.plan;
  const auto nearer = [&](const Pose2& a, const Pose2& b) {
    return distance(a, cycle.situation.pose) < distance(b, cycle.situation.pose);
  };
  double along = 0.0;
  for (auto at = std::min_element(plan.begin(), plan.end(), nearer); at != plan.end(); ++at) {
    const Point place(at->x, at->y);
    for (const MovingObstacleEstimate& mover : cycle.situation.moving_obstacles) {
      if ((mover.position_now() - place).norm() < mover.radius + cycle.footprint.inscribed_radius()) return true;
    }
    if (at + 1 != plan.end()) along += distance(*at, *(at + 1));
    if (along > kBlocksWithin) return false;
  }
  return false;
}

// Not away from somebody who is at the robot already: who comes nearer then would be touched by a robot that turns.
void RecoveryMotion::step_back(const Cycle& cycle) {
  if (phase_ != Phase::waits || !back_.due(cycle.parameters.step_back_after, cycle.situation.time)) return;
  if (cycle.movers != nullptr && cycle.movers->leaving()) return;
  back_.begin(cycle.situation.pose);
  goes_back_ = true;
  begin_search(cycle, Phase::searches, cycle.situation.pose);
}

// Where no way leads back it waits on.
void RecoveryMotion::search_back(const Cycle& cycle) {
  if (!searches_in_vain(cycle)) return;
  back_.fail();
  enter(Phase::waits, cycle.situation.time);
}

bool RecoveryMotion::gets_nowhere(const Cycle& cycle) const {
  const VelocityLimits& limits = cycle.limits;
  const double somewhere =
      Novelty::kApart / std::max(limits.x.max, 1e-3) + Novelty::kTurnedApart / std::max(limits.theta.max, 1e-3);
  return novelty_.time_without(cycle.situation.time) >= std::max(kNowhere, 3.0 * somewhere);
}

void RecoveryMotion::begin_search(const Cycle& cycle, Phase phase, const Pose2& start) {
  enter(phase, cycle.situation.time);
  if (phase == Phase::searches) recall();
  set_task(cycle, start);
}

// What is known already of the place where the robot stands is said at once; the map may have changed since.
void RecoveryMotion::recall() {
  if (problem_.empty()) problem_ = hopeless_;
  hopeless_.clear();
}

void RecoveryMotion::set_task(const Cycle& cycle, const Pose2& start) {
  if (goes_back_) back_.write_way_back(start, way_back_);
  make_search_task(start, goes_back_ ? way_back_ : cycle.situation.plan, cycle.grid, cycle.footprint, cycle.parameters,
                   cycle.limits, task_);
  if (to_goal_ && !goes_back_) aim_at_goal(cycle.situation.goal, cycle.parameters, task_);
  const MovingObstacleEstimates& movers = cycle.situation.moving_obstacles;
  if (wait_.counts_movers(cycle)) add_movers(movers, cycle.footprint, task_);
  if (wait_.alone()) remove_movers(movers, task_);
  search_.begin(task_);
}

// A portion of the search. The way that it finds is written.
WaySearch::State RecoveryMotion::run(const Cycle& cycle, Way& way) {
  const int poses = cycle.sampling.search_poses > 0 ? cycle.sampling.search_poses : cycle.parameters.search_poses;
  const WaySearch::State state = search_.run(poses);
  if (state == WaySearch::State::found) search_.write(way);
  return state;
}

// A portion of a search whose way is followed at once. True where it has ended without one.
bool RecoveryMotion::searches_in_vain(const Cycle& cycle) {
  const double now = cycle.situation.time;
  const WaySearch::State state = run(cycle, way_);
  if (state != WaySearch::State::found) return state != WaySearch::State::searching || late(now);
  follow_way(now);
  return false;
}

void RecoveryMotion::look_ahead(const Cycle& cycle) {
  if (!searches_in_vain(cycle)) return;
  if (search_.state() == WaySearch::State::no_way && !wait_.with_movers()) {
    describe_end(kNoWay, hopeless_);
    hopeless_at_ = search_.task().start;
  }
  enter(Phase::idle, cycle.situation.time);
}

// The way was found on a map that may have changed, or that did not show yet what lies farther on. While the robot goes
// on, another is searched from where it will be. One that gets nowhere shall stop and search from there.
void RecoveryMotion::renew(const Cycle& cycle, const Pose2& start) {
  if (goes_back_) return;
  const double now = cycle.situation.time;
  if (search_.state() != WaySearch::State::searching) {
    if (!narrower_ || gets_nowhere(cycle) || (now >= renewed_ && now - renewed_ < kRenewAgain)) return;
    renewed_ = now;
    set_task(cycle, start);
  }
  const WaySearch::State state = run(cycle, renewal_);
  if (state == WaySearch::State::found) {
    if (leads_better(search_.task().start)) {
      std::swap(way_, renewal_);
      start_way();
      since_ = now;
    }
    room_ = -1.0;  // what there is of it now was found good
  }
  if (state != WaySearch::State::searching || now < renewed_ || now - renewed_ >= kLongestRenewal) search_.clear();
}

// Two ways of much the same length take turns otherwise, and the robot turns to and fro between them. The other one may
// lead on beyond the end of this one: it was begun later.
bool RecoveryMotion::leads_better(const Pose2& start) const {
  if (blocked_) return true;
  const std::size_t end = way_.end_of_parts(start, part_, kPlaceAhead, kUsualCell);
  const bool turns_back = way_.direction_from(part_) * renewal_.direction_from(0) < 0;
  const double more = renewal_.time_until_near(way_.stations().back().pose, kSameEnd) -
                      way_.nearest(start, part_, end, kUsualCell).remaining();
  return more < (turns_back ? -kAboutAsLong : kAboutAsLong);
}

// Whether the way has become narrower on the map of now, or the robot is farther from it than there is room.
void RecoveryMotion::watch_room(const Way::Place& here, double room) {
  if (room_ < 0.0) room_ = room;
  const double off = here.left < way_.duration() ? here.off : 0.0;  // a way that begins ahead is not left yet
  blocked_ = room <= 0.0;
  narrower_ = blocked_ || room < std::max(kNarrower * room_, off);
}

// The way that is found waits until the robot may take it.
void RecoveryMotion::search(const Cycle& cycle, bool may_follow) {
  const double now = cycle.situation.time;
  const WaySearch::State state = way_.empty() ? run(cycle, way_) : WaySearch::State::found;
  switch (state) {
    case WaySearch::State::found:
      problem_.clear();
      if (wait_.alone()) {
        wait_for_movers(now);
      } else if (!still_leads(cycle)) {
        begin_search(cycle, Phase::searches, cycle.situation.pose);
      } else if (may_follow) {
        follow_way(now);
      }
      break;
    case WaySearch::State::searching:
      if (late(now)) {
        fail(now, kLate);
      } else {
        say_that_it_takes_long(cycle);
      }
      break;
    case WaySearch::State::cut_short:
      fail(now, "no way was found through the local map, and the memory for more is used up");
      break;
    case WaySearch::State::no_way:
    case WaySearch::State::idle:
      conclude_no_way(cycle);
  }
}

// From where the robot is, to where the plan leads now.
bool RecoveryMotion::still_leads(const Cycle& cycle) const {
  const Pose2& end = way_.stations().back().pose;
  const std::vector<Pose2>& plan = cycle.situation.plan;
  const double near = std::max({kSamePlace, 2.0 * cycle.grid.resolution, search_.task().near_target});
  return distance(way_.stations().front().pose, cycle.situation.pose) < kSameStart &&
         std::any_of(plan.begin(), plan.end(), [&](const Pose2& pose) { return distance(pose, end) < near; });
}

// One cycle fails. A host that takes its time for another plan, and begins afresh then, is not told again and again.
void RecoveryMotion::say_that_it_takes_long(const Cycle& cycle) {
  const double now = cycle.situation.time;
  if (told_) problem_.clear();
  const bool long_ago =
      now < told_time_ || now - told_time_ >= kSaysAgain || distance(told_at_, search_.task().start) >= kSamePlace;
  told_ = now - since_ >= kPromptSearch && problem_.empty() && long_ago && !wait_.with_movers() && !wait_.waits();
  if (!told_) return;
  describe_end(kLate, problem_);
  told_time_ = now;
  told_at_ = search_.task().start;
}

void RecoveryMotion::conclude_no_way(const Cycle& cycle) {
  const double now = cycle.situation.time;
  if (!wait_.try_without()) return fail(now, kNoWay);
  since_ = now;
  set_task(cycle, search_.task().start);
}

// The way that there would be is not driven.
void RecoveryMotion::wait_for_movers(double now) {
  problem_.reserve(kLongestText);
  wait_.begin(now);
  enter(Phase::waits, now);
  problem_ = wait_.over(now) ? kBlocked : "";
}

bool RecoveryMotion::late(double now) const {
  const double longest = phase_ == Phase::looks_ahead ? kLongestAhead : kLongestSearch;
  return now < since_ || now - since_ >= longest;
}

void RecoveryMotion::follow_way(double now) {
  ahead_ = phase_ == Phase::looks_ahead && !stands_.holds();
  hopeless_.clear();
  enter(Phase::follows, now);
}

void RecoveryMotion::fail(double now, const char* how) {
  describe_end(how, problem_);
  wait_.reset();
  enter(Phase::waits, now);
}

void RecoveryMotion::describe_end(const char* how, std::string& text) {
  const WaySearch::End end = search_.end();
  std::array<char, kLongestText> said{};
  if (end.obstacle_known) {
    std::snprintf(said.data(), said.size(),
                  "%s: no farther than (%.2f, %.2f); nearest %s there %.3f m away, at (%.2f, %.2f)", how, end.pose.x,
                  end.pose.y, end.unknown ? "unknown cell" : "obstacle", end.gap, end.obstacle.x(), end.obstacle.y());
  } else {
    std::snprintf(said.data(), said.size(), "%s: no farther than (%.2f, %.2f)", how, end.pose.x, end.pose.y);
  }
  text.reserve(kLongestText);
  text = said.data();
}

int RecoveryMotion::choose(const Scene& scene) {
  const Cycle& cycle = scene.cycle;
  if (scene.escape.overlaps() && (phase_ != Phase::follows || escape_.active())) {
    if (phase_ != Phase::idle) enter(Phase::idle, cycle.situation.time);
    return escape_.choose(
        {cycle.situation, cycle.grid, scene.rollout, scene.totals, scene.admissibility, scene.escape});
  }
  escape_.reset();
  if (phase_ == Phase::follows) return follow(scene);
  return holds_ && !waiting() ? stand(scene) : -1;
}

int RecoveryMotion::stand(const Scene& scene) const {
  return least_legal(scene.rollout, scene.totals, scene.admissibility, [](const Tile& tile, std::size_t c) {
    return tile.v[c] == 0.0 && tile.omega == 0.0 ? 0.0 : std::numeric_limits<double>::infinity();
  });
}

int RecoveryMotion::follow(const Scene& scene) {
  const double now = scene.cycle.situation.time;
  if (way_.empty()) {  // damaged, where it was loaded
    enter(Phase::idle, now);
    return -1;
  }
  const double room = room_ahead(way_, part_, scene.collision, scene.cycle.grid.resolution);
  const Pose2& pose = scene.cycle.situation.pose;
  const std::size_t end = way_.end_of_parts(pose, part_, kPlaceAhead, std::max(room, kNearTurn));
  const Way::Place here = way_.nearest(pose, part_, end, room);
  part_ = static_cast<std::uint32_t>(here.part);
  if (here.left <= kEndsBefore || agrees_.for_at_least(kAgreesFor, now)) {
    enter(Phase::idle, now);
    novelty_.reset();
    return -1;
  }
  if (!gets_on(here, now)) {
    enter(Phase::stops, now);
    holds_ = true;
    return stand(scene);
  }
  watch_room(here, room);
  const auto left_after = [&](const Tile& tile, std::size_t c) {
    return way_.nearest(braked_end(tile, c, scene.cycle.limits), part_, end, room).remaining();
  };
  double least = std::numeric_limits<double>::infinity();
  const int best = least_legal(scene.rollout, scene.totals, scene.admissibility, [&](const Tile& tile, std::size_t c) {
    const double left = left_after(tile, c);
    least = std::min(least, left);
    return left;
  });
  // What the cheapest may leave of it.
  const double enough = here.remaining() - kAgreement * (here.remaining() - least);
  const int cheapest = least < here.remaining() ? cheapest_legal(scene) : -1;
  bool agrees = false;
  if (cheapest >= 0) {
    const Tile tile = scene.rollout.tile(scene.rollout.tile_of(static_cast<std::size_t>(cheapest)));
    agrees = left_after(tile, static_cast<std::size_t>(cheapest) - tile.first) <= enough;
  }
  agrees = agrees && !tight_ && !goes_back_ && !to_goal_;
  agrees_.observe(now, agrees);
  return agrees ? cheapest : best;
}

// Ordinary scoring's choice; -1 where it cannot brake.
int RecoveryMotion::cheapest_legal(const Scene& scene) const {
  const auto least = std::min_element(scene.totals.begin(), scene.totals.end());
  if (least == scene.totals.end() || !std::isfinite(*least)) return -1;
  const auto candidate = static_cast<std::size_t>(least - scene.totals.begin());
  const Tile tile = scene.rollout.tile(scene.rollout.tile_of(candidate));
  const Twist2 sample = tile.sample(candidate - tile.first);
  return scene.admissibility.confirm(sample) ? static_cast<int>(candidate) : -1;
}

// The remaining time falls, or has lately: from the robot, or from the nearest place on the way.
bool RecoveryMotion::gets_on(const Way::Place& here, double now) {
  const double remaining = here.left + here.off / Way::kBackSpeed;  // whatever room the way has in this cycle
  const bool falls = remaining < least_ - kFalls || here.left < least_left_ - kFalls;
  if (falls || now < since_) {
    least_ = std::min(least_, remaining);
    least_left_ = std::min(least_left_, here.left);
    since_ = now;
  }
  return now - since_ < kFallsWithin;
}

}  // namespace hidwa_local_planner
