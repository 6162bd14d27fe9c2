// SPDX-License-Identifier: BSD-3-Clause
#include "core/planner/planner_impl.hpp"

#include <algorithm>
#include <utility>

#include "core/planner/decision_memory.hpp"
#include "core/planner/input_fault.hpp"
#include "core/planner/safe_values.hpp"
#include "core/planner/tight_ahead.hpp"

namespace hidwa_local_planner {
namespace {

// How far ahead candidates are rolled out that follow a way [s].
constexpr double kFollowingTime = 1.0;

// What is near so far ahead counts as a tight place [s].
constexpr double kTightWithin = 1.5;

}  // namespace

Planner::Impl::Impl(CriticRegistry registry)
    : critics(std::move(registry)),
      evaluation(critics),
      selection(evaluation.candidates(), evaluation.scores(), evaluation.checks()),
      explanation({parameters, critics, evaluation.candidates(), evaluation.scores(), evaluation.obstacles(),
                   evaluation.tiles(), evaluation.checks()}) {}

std::vector<std::string> Planner::Impl::configure(const Parameters& given, const SourceFor& source_for) {
  std::vector<std::string> faults = validate(given);
  const std::vector<std::string> names = split_names(given.critics);
  for (std::string& fault : critics.faults_of(names)) faults.push_back(std::move(fault));
  if (faults.empty()) faults = critics.configure(names, given, source_for);
  if (!faults.empty()) return faults;
  evaluation.clear();  // its numbers were the former critics'
  explanation.clear();
  reserve(decision, critics);
  parameters = given;
  make_safe(parameters);
  if (parameters.turn_when_stuck) recovery.reserve();
  limits = VelocityLimits::from(given);
  set_footprint(outline);
  return {};
}

void Planner::Impl::set_footprint(const Polygon& given) {
  if (&outline != &given) outline = given;
  footprint = Footprint::from_outline(outline, parameters.footprint_padding);
}

const Decision& Planner::Impl::plan(const Situation& measured, const GridView& grid, const OperatorIntent& intent,
                                    const Sampling& sampling) {
  const double radius = footprint.fault() == nullptr ? footprint.circumscribed_radius() : 0.0;
  const CycleStart start = start_estimator.estimate(measured, parameters, limits, radius);
  const bool count = movers_count(start);
  const bool once = count && parameters.moving_obstacles_clear_cells && plausible(grid);
  const GridView seen = once ? explained.without(grid, measured.moving_obstacles, parameters) : grid;
  const Cycle cycle{parameters,
                    *start.limits,
                    footprint,
                    seen,
                    intent,
                    sampling,
                    *start.situation,
                    start,
                    look_at_movers(start, count),
                    count,
                    watch_movers(start, count)};
  clear(decision);
  evaluation.clear();
  explanation.clear();
  write(start, conclude(cycle), decision);
  return decision;
}

// Only where braking is checked: with the rollout alone a mover is what its cells are. What is no number is a fault of
// the input, and the cycle brakes.
bool Planner::Impl::movers_count(const CycleStart& start) const {
  const MovingObstacleEstimates& all = start.situation->moving_obstacles;
  return !all.empty() && parameters.admissibility == Admissibility::braking && footprint.fault() == nullptr &&
         std::all_of(all.begin(), all.end(), [](const auto& one) { return plausible(one); });
}

// What is remembered of them.
void Planner::Impl::forget_movers() {
  movers.forget();
  accelerations.forget();
  evasion.note(false);
}

// Null where what moves counts as keeping its velocity.
const Accelerations* Planner::Impl::watch_movers(const CycleStart& start, bool count) {
  if (!count || parameters.evasion_time <= 0.0 || parameters.evasion_acceleration_time <= 0.0) {
    accelerations.forget();
    return nullptr;
  }
  accelerations.watch(start.situation->moving_obstacles, start.situation->time);
  return &accelerations;
}

// Null where nothing is near.
MoverCheck* Planner::Impl::look_at_movers(const CycleStart& start, bool count) {
  if (!count) {
    movers.forget();
    return nullptr;
  }
  const Situation& situation = *start.situation;
  const PendingMotionSet& pending = *start.pending;
  const bool rests = pending[0].rests() && !start.odometry_fast && at_rest(start.velocity, parameters);
  movers.prepare(parameters, *start.limits, footprint, situation.moving_obstacles,
                 {situation.pose, start.origin, start.reference, &pending, usable_period(situation),
                  longest_period(situation), rests});
  return movers.none_near() ? nullptr : &movers;
}

Conclusion Planner::Impl::conclude(const Cycle& cycle) {
  const bool stops = cycle.intent.influence == Influence::stop;  // whatever is known of the world
  const bool passes = cycle.intent.influence == Influence::direct && !cycle.intent.guarded;
  const char* fault = stops ? nullptr : input_fault(cycle);
  if (fault == nullptr && !stops && !passes) return drive(cycle);
  recovery.interrupt();
  evasion.note(false);
  if (fault != nullptr) return brake(cycle, Problem::input, fault);
  return stops ? stop(cycle) : pass_through(cycle);
}

Conclusion Planner::Impl::drive(const Cycle& cycle) {
  const Steering steering = find_steering(cycle);
  const bool autonomous = drives_itself(cycle, steering);
  Evaluation::Result evaluated =
      evaluation.evaluate(cycle, steering, mode(cycle, autonomous, comfort_of(cycle, steering)));
  Choice choice = evaluated.scored ? choose(cycle, autonomous) : Choice{};
  if (evaluated.gentle && evaluated.scored && gives_way(cycle, choice)) {
    evaluated = evaluation.evaluate(cycle, steering, mode(cycle, autonomous, {}));
    choice = choose(cycle, autonomous);
    evaluated.gentle = false;
  }
  if (evades(cycle, choice, autonomous)) evade(cycle, steering, evaluated, choice);
  evasion.note(choice.rule == ChoiceReport::Rule::evasion);
  decision.candidates = evaluation.candidates().count();
  decision.escaping = evaluation.obstacles().in_collision();
  if (!evaluated.scored) {
    evaluation.clear();
    return brake(cycle, Problem::off_map, "no pose of the plan lies on the local map");
  }
  explanation.note_choice(choice.candidate, choice.rule, steering);
  const Conclusion chosen = follow_choice(cycle, choice);
  explanation.judge_operator(cycle, chosen.sample, decision);
  if (cycle.sampling.report == Report::full) explanation.ask_all_critics(evaluated.view);

  const Recovery::Course course = course_of(cycle, choice, chosen, steering);
  const Recovery::Review review = recovery.review(cycle, course, chosen);
  decision.recovering = recovery.active();
  decision.waiting = review.waits;
  if (review.reset_critics) critics.reset();
  const Outcome outcome = review.conclusion.outcome;
  const bool why = outcome == Outcome::brake || outcome == Outcome::fail;
  if (why) evaluation.checks().check_all();
  explanation.count_rejections(why, decision);
  critics.debrief(evaluated.view, chosen.command);
  return review.conclusion;
}

// With authority a between 0 and 1 the target is u_ref = (1 - a) u_nv + a u_h, where u_nv is what autonomy alone would
// choose: the reference is blended, never the weights, and u_ref itself is a candidate.
Steering Planner::Impl::find_steering(const Cycle& cycle) {
  const Influence influence = cycle.intent.influence;
  const Twist2& u_h = cycle.intent.u_h;
  const double a = influence == Influence::shared ? parameters.authority : 1.0;
  const bool active = influence != Influence::none && a > 0.0;
  if (!active || a >= 1.0) return {active, u_h};
  const bool scored =
      evaluation.evaluate(cycle, {false, u_h}, {parameters.sim_time, recovery.active(), {}, false}).scored;
  const int own = scored ? cheapest(cycle) : -1;
  const Twist2 u_nv = own >= 0 ? evaluation.candidates().sample(static_cast<std::size_t>(own)) : Twist2{};
  return {true, {u_nv.v + a * (u_h.v - u_nv.v), u_nv.omega + a * (u_h.omega - u_nv.omega)}};
}

// Nobody steers, and more is left than to turn at the goal.
bool Planner::Impl::drives_itself(const Cycle& cycle, const Steering& steering) const {
  return !steering.active && (!cycle.situation.goal_latched || recovery.leads_to_goal());
}

// On a way that recovery has found the way looks ahead: rollouts need not, so that close to things more is legal. Only
// while braking is checked, or they would be all that keeps the robot from collisions.
Evaluation::Mode Planner::Impl::mode(const Cycle& cycle, bool autonomous, const ComfortTurn& comfort) const {
  double sim_time = parameters.sim_time;
  if (autonomous && parameters.admissibility == Admissibility::braking) {
    if (recovery.follows()) sim_time = std::min(kFollowingTime, sim_time);
    sim_time = std::min(sim_time, time_to_goal(cycle));
  }
  return {sim_time, recovery.active(), comfort, autonomous && recovery.leads_to_goal()};
}

// How long the slowest drive to the goal takes [s]. Rolled out for longer, no candidate would end near the goal, and
// rest would seem the best.
double Planner::Impl::time_to_goal(const Cycle& cycle) const {
  const bool coarse = parameters.generator == Generator::standard;
  const double step = coarse ? parameters.max_vel_x / (parameters.vx_samples - 1) : 0.0;
  const double slowest = std::max(parameters.min_vel_x, step);
  if (slowest <= 0.0) return std::numeric_limits<double>::infinity();
  return std::max(distance(cycle.situation.pose, cycle.situation.goal) / slowest, usable_period(cycle.situation));
}

// Autonomy turns gently, also along a way that it has found while it drove. The operator, and a robot that has stood,
// turn as fast as the limits allow.
ComfortTurn Planner::Impl::comfort_of(const Cycle& cycle, const Steering& steering) const {
  const bool gentle = !steering.active && (!recovery.active() || recovery.drives_on());
  return gentle ? ComfortTurn::from(parameters, cycle.situation.goal_latched) : ComfortTurn{};
}

// Gentleness gives way where nothing is left but to brake to rest: then all that the limits allow is tried. At the goal
// rest is what it wants.
bool Planner::Impl::gives_way(const Cycle& cycle, const Choice& choice) const {
  if (choice.candidate < 0) return true;
  return !cycle.situation.goal_latched &&
         evaluation.candidates().sample(static_cast<std::size_t>(choice.candidate)) == Twist2{};
}

Planner::Impl::Choice Planner::Impl::choose(const Cycle& cycle, bool autonomous) {
  Obstacles& around = evaluation.obstacles();
  // In collision only what leads out is worth turning for.
  const bool only_recovery = autonomous && recovery.active() && around.in_collision();
  const int recovering =
      recovery.choose(autonomous, {cycle, evaluation.candidates().rollout(), evaluation.scores().totals(),
                                   around.collision(), around.admissibility(), around.escape()});
  if (recovering >= 0) return {recovering, ChoiceReport::Rule::recovery};
  const int best = only_recovery ? -1 : cheapest(cycle);
  return {best, best >= 0 ? ChoiceReport::Rule::cheapest : ChoiceReport::Rule::none};
}

// Only autonomy does, and only where its choice is none of its ways out of a collision.
bool Planner::Impl::evades(const Cycle& cycle, const Choice& choice, bool autonomous) {
  if (!cycle.among_movers || !autonomous || choice.candidate < 0 || parameters.evasion_time <= 0.0) return false;
  if (evaluation.obstacles().in_collision()) return false;
  return evasion.wanted(cycle, evaluation.obstacles().collision(),
                        evaluation.candidates().sample(static_cast<std::size_t>(choice.candidate)),
                        ComfortTurn::from(parameters), recovery.goes_back());
}

// Gentleness gives way where it would be touched.
void Planner::Impl::evade(const Cycle& cycle, const Steering& steering, Evaluation::Result& evaluated, Choice& choice) {
  if (evaluated.gentle != evasion.gently()) {
    evaluated = evaluation.evaluate(
        cycle, steering, mode(cycle, true, evasion.gently() ? ComfortTurn::from(parameters) : ComfortTurn{}));
    choice = choose(cycle, true);
  }
  const int candidate = evasion.choose(cycle, evaluation.candidates(), evaluation.checks());
  if (candidate >= 0) choice = {candidate, ChoiceReport::Rule::evasion};
}

int Planner::Impl::cheapest(const Cycle& cycle) {
  return selection.cheapest(TieRule(parameters, cycle.situation.last_command));
}

Conclusion Planner::Impl::follow_choice(const Cycle& cycle, const Choice& choice) {
  if (choice.candidate < 0) {
    return brake(cycle, Problem::rejected, unless_off_map(cycle, "every candidate was rejected"));
  }
  explanation.describe_choice(decision);
  const Twist2& sample = evaluation.candidates().sample(static_cast<std::size_t>(choice.candidate));
  return follow(sample, evaluation.obstacles().admissibility().command_for(sample));
}

Recovery::Course Planner::Impl::course_of(const Cycle& cycle, const Choice& choice, const Conclusion& chosen,
                                          const Steering& steering) {
  const Situation& situation = cycle.situation;
  Recovery::Course course;
  course.autonomous = drives_itself(cycle, steering);
  course.steered = steering.active;
  course.trapped = trapped(choice, chosen.sample);
  course.yields = yields(cycle, choice, chosen.sample);
  if (!course.autonomous || !parameters.turn_when_stuck) return course;
  course.soon = situation.pose;
  if (choice.candidate < 0) return course;
  const Rollout& rollout = evaluation.candidates().rollout();
  const auto candidate = static_cast<std::size_t>(choice.candidate);
  const Tile tile = rollout.tile(rollout.tile_of(candidate));
  const std::size_t c = candidate - tile.first;
  course.tight = tight_ahead(evaluation.obstacles().collision(), tile, c, kTightWithin, cycle.grid.resolution);
  course.soon = pose_within(tile, c, parameters.control_latency + situation.period);
  return course;
}

// What moves decides: evasion has chosen, or the robot stands since no motion is legal near it.
bool Planner::Impl::yields(const Cycle& cycle, const Choice& choice, const Twist2& sample) {
  if (choice.candidate < 0) return false;
  if (choice.rule == ChoiceReport::Rule::evasion) return true;
  if (!(sample == Twist2{})) return false;
  return cycle.movers != nullptr && !evaluation.checks().any_motion_legal();
}

// The robot stands in collision and no legal motion leads out. Standing may be the operator's choice.
bool Planner::Impl::trapped(const Choice& choice, const Twist2& sample) {
  if (!evaluation.obstacles().in_collision()) return false;
  if (choice.candidate < 0) return true;
  return sample == Twist2{} && !evaluation.checks().any_motion_legal();
}

}  // namespace hidwa_local_planner
