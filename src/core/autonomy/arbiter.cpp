// SPDX-License-Identifier: BSD-3-Clause
#include "core/autonomy/arbiter.hpp"

#include <algorithm>
#include <limits>

namespace hidwa_local_planner {
namespace {

using Rule = ChoiceReport::Rule;

// How far ahead candidates are rolled out that follow a way [s].
constexpr double kFollowingTime = 1.0;

// How long the slowest drive to the goal takes [s]. Rolled out for longer, no candidate would end near the goal, and
// rest would seem the best.
double time_to_goal(const Cycle& cycle) {
  const Parameters& p = cycle.parameters;
  const bool coarse = p.generator == Generator::standard;
  const double step = coarse ? p.max_vel_x / (p.vx_samples - 1) : 0.0;
  const double slowest = std::max(p.min_vel_x, step);
  if (slowest <= 0.0) return std::numeric_limits<double>::infinity();
  return std::max(distance(cycle.start.pose, cycle.situation.goal) / slowest, cycle.start.period);
}

}  // namespace

Arbiter::Choice Arbiter::choose(const Cycle& cycle, const Steering& steering, bool autonomous) {
  Choice choice;
  propose(cycle, steering, autonomous, comfort_of(cycle, steering), choice);
  if (choice.evaluated.gentle && choice.evaluated.scored && gives_way(cycle, choice)) {
    propose(cycle, steering, autonomous, {}, choice);
  }
  Evasion& evasion = autonomy_.evasion();
  if (!evades(cycle, choice, autonomous)) return choice;
  if (choice.evaluated.gentle != evasion.gently()) {
    propose(cycle, steering, true, evasion.gently() ? ComfortTurn::from(cycle.parameters) : ComfortTurn{}, choice);
  }
  choice.steps.evasion = evasion.propose(cycle, evaluation_);
  if (choice.steps.evasion.candidate >= 0) choice.proposal = {choice.steps.evasion.candidate, Rule::evasion};
  return choice;
}

// Evaluates the candidates and asks all rules but evasion.
void Arbiter::propose(const Cycle& cycle, const Steering& steering, bool autonomous, const ComfortTurn& comfort,
                      Choice& choice) {
  choice.evaluated = evaluation_.evaluate(cycle, steering, mode(cycle, autonomous, comfort));
  choice.proposal = {};
  if (!choice.evaluated.scored) return;
  Autonomy::Steps& steps = choice.steps;
  steps = {};
  steps.asked = autonomous;
  const bool active = autonomy_.active();
  const bool in_collision = evaluation_.obstacles().in_collision();
  if (autonomous) {
    steps.escapes = in_collision && (!autonomy_.recovery().follows() || autonomy_.escape().active());
    if (steps.escapes) {
      steps.escape = autonomy_.escape().propose(cycle, evaluation_);
      choice.proposal = {steps.escape.candidate, Rule::escape};
    } else {
      steps.recovery = autonomy_.recovery().propose(cycle, evaluation_);
      choice.proposal = steps.recovery.proposal;
    }
  }
  if (choice.proposal.candidate >= 0) return;
  choice.proposal = autonomous && active && in_collision ? Proposal{} : cheapest(cycle);
}

// On a way that recovery has found the way looks ahead: rollouts need not, so that close to things more is legal. Only
// while braking is checked, or they would be all that keeps the robot from collisions.
Evaluation::Mode Arbiter::mode(const Cycle& cycle, bool autonomous, const ComfortTurn& comfort) const {
  const Parameters& p = cycle.parameters;
  double sim_time = p.sim_time;
  if (autonomous && p.admissibility == Admissibility::braking) {
    if (autonomy_.recovery().follows()) sim_time = std::min(kFollowingTime, sim_time);
    sim_time = std::min(sim_time, time_to_goal(cycle));
  }
  return {sim_time, autonomy_.active(), comfort, autonomous && autonomy_.recovery().leads_to_goal()};
}

// Autonomy turns gently, also along a way that it has found while it drove. The operator, and a robot that has stood,
// turn as fast as the limits allow.
ComfortTurn Arbiter::comfort_of(const Cycle& cycle, const Steering& steering) const {
  const bool gentle = !steering.active && (!autonomy_.active() || autonomy_.recovery().drives_on());
  return gentle ? ComfortTurn::from(cycle.parameters, cycle.situation.goal_latched) : ComfortTurn{};
}

// Nothing is left but to brake to rest. At the goal rest is wanted.
bool Arbiter::gives_way(const Cycle& cycle, const Choice& choice) const {
  if (choice.proposal.candidate < 0) return true;
  return !cycle.situation.goal_latched && sample(choice.proposal) == Twist2{};
}

bool Arbiter::evades(const Cycle& cycle, const Choice& choice, bool autonomous) {
  const Parameters& p = cycle.parameters;
  if (!cycle.among_movers || !autonomous || choice.proposal.candidate < 0 || p.evasion_time <= 0.0) return false;
  if (evaluation_.obstacles().in_collision()) return false;
  const bool goes_back = choice.steps.recovery.way.candidate >= 0 && autonomy_.recovery().goes_back();
  return autonomy_.evasion().wanted(cycle, evaluation_.obstacles().collision(), sample(choice.proposal),
                                    ComfortTurn::from(p), goes_back);
}

Proposal Arbiter::cheapest(const Cycle& cycle) {
  const int candidate = selection_.cheapest(TieRule(cycle.parameters, cycle.situation.last_command));
  return {candidate, candidate >= 0 ? Rule::cheapest : Rule::none};
}

Twist2 Arbiter::cheapest_alone(const Cycle& cycle, const Twist2& u_h) {
  const Evaluation::Mode mode{cycle.parameters.sim_time, autonomy_.active(), {}, false};
  if (!evaluation_.evaluate(cycle, {false, u_h}, mode).scored) return {};
  const Proposal proposal = cheapest(cycle);
  return proposal.candidate >= 0 ? sample(proposal) : Twist2{};
}

const Twist2& Arbiter::sample(const Proposal& proposal) const {
  return evaluation_.candidates().sample(static_cast<std::size_t>(proposal.candidate));
}

}  // namespace hidwa_local_planner
