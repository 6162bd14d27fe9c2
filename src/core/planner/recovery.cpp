// SPDX-License-Identifier: BSD-3-Clause
#include "core/planner/recovery.hpp"

#include <cmath>

namespace hidwa_local_planner {
namespace {

// A robot that is trapped in collision for longer needs the host's help [s].
constexpr double kLongTrapped = 1.0;

// A turn on the spot below this share of the fastest creeps.
constexpr double kCreeps = 0.25;

}  // namespace

void Recovery::reset() {
  motion_.reset();
  trapped_.reset();
  unturned_.reset();
}

void Recovery::interrupt() {
  motion_.reset();
  trapped_.reset();
}

int Recovery::choose(bool autonomous, const RecoveryMotion::Scene& scene) {
  if (autonomous) return motion_.choose(scene);
  motion_.reset();
  return -1;
}

Recovery::Review Recovery::review(const Cycle& cycle, const Course& course, Conclusion conclusion) {
  watch_collision(cycle, course.trapped, conclusion);
  const bool recovers = watch_rest(cycle, course, conclusion);
  const bool turns_anew = watch_last_turn(cycle, course.steered, conclusion);
  const bool waits = conclusion.outcome == Outcome::hold && yields(course, cycle.situation.time);
  return {conclusion, recovers || turns_anew, waits || motion_.waiting()};
}

void Recovery::watch_collision(const Cycle& cycle, bool trapped, Conclusion& conclusion) {
  const double now = cycle.situation.time;
  trapped_.observe(now, trapped);
  if (!trapped) return;
  if (!trapped_.for_at_least(kLongTrapped, now)) {
    if (conclusion.outcome == Outcome::fail) conclusion.outcome = Outcome::brake;
    return;
  }
  fail(cycle, Problem::rejected,
       unless_off_map(
           cycle,
           "no way out: the robot stands in collision and no motion leads out of it; the costmap must be cleared"),
       conclusion);
}

// Who stands for what moves is not stuck, for some time.
bool Recovery::yields(const Course& course, double now) const {
  return course.yields && motion_.standing_time(now) < MoverWait::kLongest;
}

// True when the critics must forget.
bool Recovery::watch_rest(const Cycle& cycle, const Course& known, Conclusion& conclusion) {
  const Parameters& p = cycle.parameters;
  const double now = cycle.situation.time;
  RecoveryMotion::Course course;
  course.autonomous = known.autonomous;
  course.tight = known.tight;
  course.soon = known.soon;
  course.trapped = trapped_.holds();
  course.yields = known.yields;
  course.stands = conclusion.outcome == Outcome::hold || conclusion.outcome == Outcome::fail || course.trapped;
  course.creeps = conclusion.outcome == Outcome::drive && conclusion.sample.v == 0.0 &&
                  std::abs(conclusion.sample.omega) < kCreeps * cycle.limits.theta.max;
  const bool forget = motion_.watch(cycle, course, p.turn_when_stuck ? 0.5 * p.blocked_time : -1.0);
  if (course.trapped || !known.autonomous) return forget;
  const bool about_to_drive = motion_.begins_way() && conclusion.outcome == Outcome::hold;
  if (*motion_.problem() != '\0' && !yields(known, now)) {
    fail(cycle, Problem::stuck, motion_.problem(), conclusion);
  } else if (!about_to_drive && !motion_.undecided() && !yields(known, now) &&
             motion_.standing_time(now) > p.blocked_time) {
    fail(cycle, Problem::stuck, "autonomy is stuck: standing still is its best legal candidate", conclusion);
  }
  return forget;
}

// True when the critics must forget.
bool Recovery::watch_last_turn(const Cycle& cycle, bool steered, Conclusion& conclusion) {
  const Parameters& p = cycle.parameters;
  const Situation& situation = cycle.situation;
  const double off = std::abs(wrap_angle(situation.goal.theta - situation.pose.theta));
  const bool stands = !steered && situation.goal_latched && conclusion.outcome == Outcome::hold;
  unturned_.observe(situation.time, stands && off > p.yaw_goal_tolerance);
  const bool long_enough = unturned_.for_at_least(0.5 * p.blocked_time, situation.time);
  const bool forget = long_enough && !unturned_reset_;
  unturned_reset_ = long_enough;
  if (unturned_.time(situation.time) <= p.blocked_time || motion_.leads_to_goal()) return forget;
  if (p.turn_when_stuck) {
    motion_.begin_at_goal(situation.time);
  } else {
    fail(cycle, Problem::stuck,
         "the last turn to the goal's heading is stuck: standing still is its best legal candidate", conclusion);
  }
  return forget;
}

}  // namespace hidwa_local_planner
