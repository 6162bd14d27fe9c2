// SPDX-License-Identifier: BSD-3-Clause
#include "core/autonomy/recovery.hpp"

#include <algorithm>
#include <limits>
#include <vector>

#include "core/autonomy/least_legal.hpp"
#include "core/util/elapsed.hpp"
#include "core/util/nearest_pose.hpp"

namespace hidwa_local_planner {
namespace {

// Times [s]. A search ends after some time, since its map grows old.
constexpr double kPromptSearch = 1.2;    // a search at rest that takes longer makes one cycle fail
constexpr double kLongestSearch = 8.0;   // a search at rest ends after this
constexpr double kLongestAhead = 5.0;    // a search ahead, while the robot drives on, ends after this
constexpr double kLongestRenewal = 1.0;  // a search for a better way, while the robot follows one, ends after this
constexpr double kSearchPause = 2.0;     // after a search found no way, or between two beginnings of a search ahead
constexpr double kRenewalPause = 0.2;    // between two beginnings of a search for a better way

// Distance ahead within which moving obstacles block the plan [m].
constexpr double kBlockingAhead = 2.5;

constexpr const char* kNoWay = "no way for this outline through the local map";
constexpr const char* kLate = "no way was found in time through the local map";
constexpr const char* kNoMemory = "no way was found through the local map, and the memory for more is used up";
constexpr const char* kBlocked = "what moves has blocked the only way for 30 s";
static_assert(Recovery::kLongestWait == 30.0, "the text says so");

int rest(Evaluation& evaluated) {
  return least_legal(evaluated, [](const Tile& tile, std::size_t c) {
    return tile.v[c] == 0.0 && tile.omega == 0.0 ? 0.0 : std::numeric_limits<double>::infinity();
  });
}

}  // namespace

void Recovery::reset() {
  enter(Phase::idle, 0.0);
  follower_.note_tight(false);
  back_.reset();
}

void Recovery::enter(Phase phase, double now) {
  phase_ = phase;
  since_ = now;
  if (phase == Phase::idle) to_goal_ = false;
  if (phase == Phase::idle || phase == Phase::follows) {
    holds_ = false;
    report_.clear();
    wait_.reset();
  }
  if (phase != Phase::searches && phase != Phase::looks_ahead) finder_.clear();
  if (phase != Phase::searches && phase != Phase::follows) goes_back_ = false;
  if (phase != Phase::follows) follower_.clear();
  report_.begin_search();
}

void Recovery::begin_at_goal(double now) {
  enter(Phase::stops, now);
  holds_ = to_goal_ = true;
}

void Recovery::interrupt(double now) {
  if (phase_ != Phase::idle) enter(Phase::idle, now);
}

bool Recovery::waiting() const {
  return report_.problem().empty() && wait_.holds() && (phase_ == Phase::waits || phase_ == Phase::searches);
}

bool Recovery::undecided() const {
  return phase_ == Phase::stops || waiting() || (report_.problem().empty() && phase_ == Phase::searches);
}

Recovery::Step Recovery::propose(const Cycle& cycle, Evaluation& evaluated) const {
  Step step;
  if (follows()) {
    step.way = follower_.propose(cycle, evaluated, !goes_back_ && !to_goal_);
    step.proposal = {step.way.candidate, ChoiceReport::Rule::way};
  }
  if (step.way.stalled || (holds_ && !waiting())) step.proposal = {rest(evaluated), ChoiceReport::Rule::rest};
  return step;
}

void Recovery::commit(const Step& step, StallWatch& stall, double now) {
  if (!follows()) return;
  if (step.way.ended) {
    enter(Phase::idle, now);
    stall.forget_poses();
  } else if (step.way.stalled) {
    enter(Phase::stops, now);
    holds_ = true;
  } else {
    follower_.commit(step.way);
  }
}

void Recovery::observe(const Cycle& cycle, bool stands, bool tight) {
  follower_.note_tight(tight);
  back_.observe(cycle.start.pose, blocked_by_movers(cycle, stands), cycle.situation.time);
}

void Recovery::advance(const Cycle& cycle, const StallWatch& stall, const Outlook& outlook) {
  const bool stands = stall.stands();
  change_phase(cycle, stall, outlook);
  step_back(cycle);
  if (phase_ == Phase::looks_ahead && searches_in_vain(cycle, stands)) enter(Phase::idle, cycle.situation.time);
  if (phase_ == Phase::follows) renew(cycle, stall, outlook.soon);
  if (phase_ == Phase::searches && goes_back_) {
    search_back(cycle, stands);
  } else if (phase_ == Phase::searches) {
    search(cycle, outlook.impatient || holds_);
  }
}

void Recovery::change_phase(const Cycle& cycle, const StallWatch& stall, const Outlook& outlook) {
  const double now = cycle.situation.time;
  const bool ordinary = phase_ == Phase::idle || phase_ == Phase::looks_ahead;
  const bool rests = phase_ == Phase::searches || phase_ == Phase::waits;
  if (rests && !stall.stands() && !holds_) enter(Phase::idle, now);
  if (ordinary && ((outlook.impatient && !stall.stands()) || stall.gets_nowhere(cycle))) {
    phase_ = Phase::stops;  // without enter(), which would end a search ahead that is under way
    holds_ = true;
  }
  const bool settled = stall.settled(cycle);
  const bool again = phase_ == Phase::waits && elapsed(since_, kSearchPause, now);
  const bool found_out = phase_ != Phase::follows && finder_.searching() && finder_.began_near(cycle.start.pose);
  if (settled && found_out && phase_ != Phase::searches) {
    phase_ = Phase::searches;  // without enter(): the time of this search counts from its beginning
  } else if (settled && (ordinary || phase_ == Phase::stops || again)) {
    begin_search(cycle, Phase::searches, cycle.start.pose);
  } else if (phase_ == Phase::idle && outlook.tight && elapsed(searched_ahead_, kSearchPause, now)) {
    searched_ahead_ = now;
    begin_search(cycle, Phase::looks_ahead, outlook.soon);
  }
}

// No way leads on, and a moving obstacle is at the plan ahead.
bool Recovery::blocked_by_movers(const Cycle& cycle, bool stands) const {
  if (!stands || goes_back_ || (phase_ != Phase::waits && phase_ != Phase::searches)) return false;
  if (wait_.holds()) return true;
  if (report_.problem().empty()) return false;
  const std::vector<Pose2>& plan = cycle.situation.plan;
  double along = 0.0;
  for (auto at = nearest_pose(plan, cycle.start.pose); at != plan.end(); ++at) {
    const Point position(at->x, at->y);
    for (const MovingObstacleEstimate& mover : cycle.situation.moving_obstacles) {
      if ((mover.position_now() - position).norm() < mover.radius + cycle.footprint.inscribed_radius()) return true;
    }
    if (at + 1 != plan.end()) along += distance(*at, *(at + 1));
    if (along > kBlockingAhead) return false;
  }
  return false;
}

// Not away from somebody who is at the robot already: a robot that turns would touch them.
void Recovery::step_back(const Cycle& cycle) {
  if (phase_ != Phase::waits || !back_.due(cycle.parameters.step_back_after, cycle.situation.time)) return;
  if (cycle.movers != nullptr && cycle.movers->leaving()) return;
  back_.begin(cycle.start.pose);
  goes_back_ = true;
  begin_search(cycle, Phase::searches, cycle.start.pose);
}

WayFinder::Target Recovery::target() const {
  if (goes_back_) return WayFinder::Target::back;
  return to_goal_ ? WayFinder::Target::goal : WayFinder::Target::plan;
}

void Recovery::begin_search(const Cycle& cycle, Phase phase, const Pose2& start) {
  enter(phase, cycle.situation.time);
  finder_.begin(cycle, start, target(), back_);
}

bool Recovery::late(double now) const {
  return elapsed(since_, phase_ == Phase::looks_ahead ? kLongestAhead : kLongestSearch, now);
}

// Continues a search whose way is followed at once. True where it has ended without one.
bool Recovery::searches_in_vain(const Cycle& cycle, bool stands) {
  const double now = cycle.situation.time;
  const WaySearch::State state = finder_.run(cycle, follower_.way());
  if (state != WaySearch::State::found) return state != WaySearch::State::searching || late(now);
  follow_way(now, phase_ == Phase::looks_ahead && !stands);
  return false;
}

void Recovery::follow_way(double now, bool while_driving) {
  enter(Phase::follows, now);
  follower_.begin(now, while_driving);
}

// Where no way leads back the robot waits on.
void Recovery::search_back(const Cycle& cycle, bool stands) {
  if (!searches_in_vain(cycle, stands)) return;
  back_.fail();
  enter(Phase::waits, cycle.situation.time);
}

void Recovery::search(const Cycle& cycle, bool may_follow) {
  const double now = cycle.situation.time;
  const bool found = !follower_.way().empty();
  const bool long_search = now - since_ >= kPromptSearch && !finder_.with_movers() && !wait_.holds();
  switch (found ? WaySearch::State::found : finder_.run(cycle, follower_.way())) {
    case WaySearch::State::found:
      follow_found_way(cycle, may_follow);
      break;
    case WaySearch::State::searching:
      if (late(now)) {
        fail(now, kLate);
      } else if (report_.tells_late(long_search, finder_.start(), now)) {
        report_.tell(kLate, finder_.end());
      }
      break;
    case WaySearch::State::cut_short:
      fail(now, kNoMemory);
      break;
    case WaySearch::State::no_way:
    case WaySearch::State::idle:
      if (finder_.repeat_without_movers(cycle, target(), back_)) {
        since_ = now;
      } else {
        fail(now, kNoWay);
      }
  }
}

// A way that leads through moving obstacles is not driven: the robot waits for them to go.
void Recovery::follow_found_way(const Cycle& cycle, bool may_follow) {
  const double now = cycle.situation.time;
  const double near = std::max({WayFinder::kSamePlace, 2.0 * cycle.grid.resolution, finder_.tolerance()});
  report_.clear();
  if (finder_.without_movers()) {
    wait_for_movers(now);
  } else if (!follower_.still_leads(cycle, near)) {
    begin_search(cycle, Phase::searches, cycle.start.pose);
  } else if (may_follow) {
    follow_way(now, false);
  }
}

// The way was found on a map that may have changed, or that did not show yet what lies farther on. While the robot
// drives, another is searched from where it will be. A robot that gets nowhere shall stop and search from there.
void Recovery::renew(const Cycle& cycle, const StallWatch& stall, const Pose2& start) {
  if (goes_back_) return;
  const double now = cycle.situation.time;
  if (!finder_.searching()) {
    if (!follower_.narrower() || stall.gets_nowhere(cycle) || !elapsed(renewed_, kRenewalPause, now)) return;
    renewed_ = now;
    finder_.begin(cycle, start, target(), back_);
  }
  const WaySearch::State state = finder_.run(cycle, other_);
  if (state == WaySearch::State::found) {
    if (follower_.gives_way_to(other_, finder_.start())) follower_.replace(other_, now);
    follower_.accept_room();
  }
  if (state != WaySearch::State::searching || elapsed(renewed_, kLongestRenewal, now)) finder_.clear();
}

void Recovery::fail(double now, const char* why) {
  report_.tell(why, finder_.end());
  wait_.reset();
  enter(Phase::waits, now);
}

void Recovery::wait_for_movers(double now) {
  wait_.observe(now, true);
  enter(Phase::waits, now);
  report_.tell(wait_.for_at_least(kLongestWait, now) ? kBlocked : "");
}

}  // namespace hidwa_local_planner
