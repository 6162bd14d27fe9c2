// SPDX-License-Identifier: BSD-3-Clause
#include "core/autonomy/autonomy.hpp"

#include <cmath>

namespace hidwa_local_planner {
namespace {

// A robot that is trapped in collision for longer needs the host's help [s].
constexpr double kLongTrapped = 1.0;

// A turn on the spot creeps below this share of the fastest one.
constexpr double kCreeping = 0.25;

constexpr const char* kTrapped =
    "no way out: the robot stands in collision and no motion leads out of it; the costmap must be cleared";
constexpr const char* kStuck = "autonomy is stuck: standing still is its best legal candidate";
constexpr const char* kTurnStuck =
    "the last turn to the goal's heading is stuck: standing still is its best legal candidate";

}  // namespace

void Autonomy::reset() {
  interrupt();
  unturned_.reset();
}

void Autonomy::interrupt() {
  forget();
  trapped_.reset();
  end_evasion();
}

void Autonomy::forget() {
  stall_.reset();
  escape_.reset();
  recovery_.reset();
}

bool Autonomy::drives(const Cycle& cycle, const Steering& steering) const {
  return !steering.active && (!cycle.situation.goal_latched || recovery_.leads_to_goal());
}

void Autonomy::remember(const Cycle& cycle, const Steps& steps) {
  evasion_.commit(steps.evasion);
  if (!steps.asked) return forget();
  if (steps.escapes) {
    recovery_.interrupt(cycle.situation.time);
    escape_.commit(steps.escape);
  } else {
    escape_.reset();
    recovery_.commit(steps.recovery, stall_, cycle.situation.time);
  }
}

Autonomy::Verdict Autonomy::commit(const Cycle& cycle, const Steering& steering, const Driven& driven) {
  remember(cycle, driven.steps);
  Verdict verdict;
  verdict.conclusion = driven.conclusion;
  judge_collision(cycle, driven.trapped, verdict.conclusion);
  const bool autonomous = drives(cycle, steering);
  const bool recovers = observe(cycle, autonomous, driven, verdict.conclusion);
  if (autonomous && !driven.trapped) judge_rest(cycle, driven, verdict.conclusion);
  const bool turns_anew = judge_last_turn(cycle, steering.active, verdict.conclusion);
  verdict.reset_critics = recovers || turns_anew;
  verdict.waits =
      recovery_.waiting() || (verdict.conclusion.outcome == Outcome::hold && yields(driven, cycle.situation.time));
  return verdict;
}

void Autonomy::judge_collision(const Cycle& cycle, bool trapped, Conclusion& conclusion) {
  const double now = cycle.situation.time;
  trapped_.observe(now, trapped);
  if (trapped_.for_at_least(kLongTrapped, now)) {
    fail_if_stopped(cycle, Problem::rejected, unless_off_map(cycle, kTrapped), conclusion);
  } else if (trapped && conclusion.outcome == Outcome::fail) {
    conclusion.outcome = Outcome::brake;
  }
}

// Who stands for moving obstacles is not stuck, for some time.
bool Autonomy::yields(const Driven& driven, double now) const {
  return driven.yields && stall_.standing_time(now) < Recovery::kLongestWait;
}

// True when the critics must forget.
bool Autonomy::observe(const Cycle& cycle, bool autonomous, const Driven& driven, const Conclusion& conclusion) {
  const Parameters& p = cycle.parameters;
  const double now = cycle.situation.time, patience = 0.5 * p.stall_time;
  StallWatch::Motion motion;
  motion.stands = conclusion.outcome == Outcome::hold || conclusion.outcome == Outcome::fail || driven.trapped;
  motion.creeps = conclusion.outcome == Outcome::drive && conclusion.sample.v == 0.0 &&
                  std::abs(conclusion.sample.omega) < kCreeping * cycle.start.limits.theta.max;
  motion.yields = driven.yields;
  if (!autonomous || p.method == Method::paper) {
    stall_.observe_rest(autonomous && motion.stands, now);
    escape_.reset();
    recovery_.reset();
    return false;
  }
  stall_.observe(motion, cycle.start.pose, now);
  const Recovery::Outlook outlook{stall_.impatient(patience, now), driven.tight, driven.soon};
  recovery_.observe(cycle, motion.stands, driven.tight);
  if (driven.trapped) {
    if (!outlook.impatient || escape_.active()) return false;
    escape_.begin(now);
    return true;
  }
  recovery_.advance(cycle, stall_, outlook);
  return recovery_.follows();
}

void Autonomy::judge_rest(const Cycle& cycle, const Driven& driven, Conclusion& conclusion) const {
  const double now = cycle.situation.time;
  if (yields(driven, now)) return;
  const bool about_to_drive = recovery_.begins_way() && conclusion.outcome == Outcome::hold;
  if (*recovery_.problem() != '\0') {
    fail_if_stopped(cycle, Problem::stuck, recovery_.problem(), conclusion);
  } else if (!about_to_drive && !recovery_.undecided() && stall_.standing_time(now) > cycle.parameters.stall_time) {
    fail_if_stopped(cycle, Problem::stuck, kStuck, conclusion);
  }
}

// True when the critics must forget.
bool Autonomy::judge_last_turn(const Cycle& cycle, bool steered, Conclusion& conclusion) {
  const Parameters& p = cycle.parameters;
  const Situation& situation = cycle.situation;
  const double off = std::abs(wrap_angle(situation.goal.theta - cycle.start.pose.theta));
  const bool stands = !steered && situation.goal_latched && conclusion.outcome == Outcome::hold;
  unturned_.observe(situation.time, stands && off > p.yaw_goal_tolerance);
  const bool long_enough = unturned_.for_at_least(0.5 * p.stall_time, situation.time);
  const bool forget = long_enough && !unturned_reset_;
  unturned_reset_ = long_enough;
  if (unturned_.time(situation.time) <= p.stall_time || recovery_.leads_to_goal()) return forget;
  if (p.method == Method::hidwa) {
    recovery_.begin_at_goal(situation.time);
  } else {
    fail_if_stopped(cycle, Problem::stuck, kTurnStuck, conclusion);
  }
  return forget;
}

}  // namespace hidwa_local_planner
