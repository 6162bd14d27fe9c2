// SPDX-License-Identifier: BSD-3-Clause
#include "core/planner/planner_impl.hpp"

#include <algorithm>
#include <utility>

#include "core/cycle/input_fault.hpp"

namespace hidwa_local_planner {
namespace {

// What is near so far ahead counts as a tight place [s].
constexpr double kTightWithin = 1.5;

// More than any problem has characters.
constexpr std::size_t kLongestProblem = 200;

// Every cycle uses the decision again, so that its lists and texts allocate nothing: this allocates what one with these
// critics may need.
void reserve(Decision& decision, const CriticSet& critics) {
  decision.terms.reserve(critics.size() + 1);
  decision.rejections.reserve(critics.size() + kFirstCritic);
  decision.problem.reserve(kLongestProblem);
  for (const CriticSet::Entry& entry : critics) {
    decision.operator_rejected_by.reserve(std::max(kLongestProblem, entry.name.size()));
  }
}

// As a new one, but its lists and texts keep what is allocated.
void clear(Decision& decision) {
  Decision empty;
  const auto keep = [](auto& allocated, auto& list) {
    list.swap(allocated);
    list.clear();
  };
  keep(decision.trajectory, empty.trajectory);
  keep(decision.terms, empty.terms);
  keep(decision.rejections, empty.rejections);
  keep(decision.operator_rejected_by, empty.operator_rejected_by);
  keep(decision.problem, empty.problem);
  decision = std::move(empty);
}

// Whether the robot comes nearer than a cell to something soon on a rollout. `checker` is prepared for it.
bool tight_ahead(const CollisionChecker& checker, const Tile& tile, std::size_t c, double resolution) {
  for (std::size_t k = 0; k <= tile.steps && static_cast<double>(k) * tile.dt <= kTightWithin; ++k) {
    if (checker.clear_around(tile.x_at(k, c), tile.y_at(k, c), resolution)) continue;
    const Rotation heading{tile.cos_heading[k], tile.sin_heading[k]};
    if (checker.clearance(tile.pose(k, c), heading, resolution) < resolution) return true;
  }
  return false;
}

// The last pose of a rollout that the robot comes to within `time` [s].
Pose2 pose_within(const Tile& tile, std::size_t c, double time) {
  return tile.pose(std::min(static_cast<std::size_t>(time / tile.dt), tile.steps), c);
}

// What a cycle started from, and what it came to.
void write(const CycleStart& start, const Conclusion& conclusion, Decision& decision) {
  decision.outcome = conclusion.outcome;
  decision.command = conclusion.command;
  decision.sample = conclusion.sample;
  decision.problem_kind = conclusion.problem_kind;
  decision.problem = conclusion.problem;
  decision.reference = start.reference;
  decision.pose = start.pose;
  decision.velocity = start.velocity;
  decision.odometry_doubted = start.odometry_doubted;
  decision.odometry_fast = start.odometry_fast;
}

}  // namespace

Planner::Impl::Impl(CriticRegistry registry)
    : critics(std::move(registry)),
      evaluation(critics),
      arbiter(evaluation, autonomy),
      explanation(critics, evaluation) {}

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
  if (parameters.method == Method::hidwa) autonomy.reserve();
  limits = VelocityLimits::from(given);
  std::string none;
  declared_sectors = parse_sensor_sectors(given.sensor_sectors, none);
  set_footprint(outline);
  return {};
}

void Planner::Impl::set_footprint(const Polygon& given) {
  if (&outline != &given) outline = given;
  footprint = Footprint::from_outline(outline, parameters.footprint_padding);
  blind.forget();
}

const Decision& Planner::Impl::plan(const Situation& measured, const GridView& grid, const OperatorIntent& intent,
                                    const Sampling& sampling) {
  const double radius = footprint.fault() == nullptr ? footprint.circumscribed_radius() : 0.0;
  const SensorSectors& sectors = sectors_in_force(measured);
  blind.prepare(parameters, footprint, limits, sectors);
  const CycleStart& start = start_estimator.estimate(measured, parameters, limits, blind, radius);
  const bool use_movers = uses_movers(measured);
  const bool clear_mover_cells = use_movers && parameters.moving_obstacles_clear_cells && plausible(grid);
  const GridView seen = clear_mover_cells ? explained.without(grid, measured.moving_obstacles, parameters) : grid;
  const Cycle cycle{parameters,
                    footprint,
                    seen,
                    intent,
                    sampling,
                    measured,
                    start,
                    blind,
                    prepare_mover_check(measured, start, use_movers),
                    use_movers,
                    update_accelerations(measured, use_movers),
                    prepare_hidden(sectors, start, seen),
                    &hidden_places.all()};
  clear(decision);
  evaluation.clear();
  explanation.clear();
  write(start, conclude(cycle), decision);
  return decision;
}

// The parameter goes before the tracker: who says "all" or a list knows better.
const SensorSectors& Planner::Impl::sectors_in_force(const Situation& measured) const {
  return parameters.sensor_sectors.empty() ? measured.sensor_sectors : declared_sectors;
}

// Only where braking is checked: with the rollout alone a mover is what its cells are. What is no number is a fault of
// the input, and the cycle brakes.
bool Planner::Impl::uses_movers(const Situation& measured) const {
  const MovingObstacleEstimates& all = measured.moving_obstacles;
  return !all.empty() && parameters.admissibility == Admissibility::braking && footprint.fault() == nullptr &&
         std::all_of(all.begin(), all.end(), [](const auto& one) { return plausible(one); });
}

// Null where what moves counts as keeping its velocity.
const Accelerations* Planner::Impl::update_accelerations(const Situation& measured, bool use_movers) {
  if (!use_movers || parameters.evasion_time <= 0.0 || parameters.evasion_acceleration_time <= 0.0) {
    accelerations.forget();
    return nullptr;
  }
  accelerations.watch(measured.moving_obstacles, measured.time);
  return &accelerations;
}

// Null where nothing is near.
MoverCheck* Planner::Impl::prepare_mover_check(const Situation& measured, const CycleStart& start, bool use_movers) {
  if (!use_movers) {
    movers.forget();
    return nullptr;
  }
  movers.prepare(parameters, footprint, measured.moving_obstacles, start);
  return movers.none_near() ? nullptr : &movers;
}

// Null where nobody may come out who could touch the robot before it rests. What is no number is a fault of the input.
MoverCheck* Planner::Impl::prepare_hidden(const SensorSectors& sectors, const CycleStart& start, const GridView& grid) {
  hidden_places.clear();
  if (parameters.occlusion == Occlusion::off || sectors.empty() || footprint.fault() != nullptr || !plausible(grid) ||
      !plausible(start.pose) || !grid.holds({start.pose.x, start.pose.y})) {
    return nullptr;
  }
  hidden_places.find(grid, start.pose, sectors, MoverCheck::reach_of_hidden(parameters, footprint, start));
  if (parameters.occlusion != Occlusion::bound) return nullptr;
  hidden.prepare_hidden(parameters, footprint, hidden_places.all(), start);
  return hidden.none_near() ? nullptr : &hidden;
}

Conclusion Planner::Impl::conclude(const Cycle& cycle) {
  const bool stops = cycle.intent.influence == Influence::stop;  // whatever is known of the world
  const bool passes = cycle.intent.influence == Influence::direct && !cycle.intent.guarded;
  const char* fault = stops ? nullptr : input_fault(cycle);
  if (fault == nullptr && !stops && !passes) return drive(cycle);
  autonomy.interrupt();
  goalless.forget();
  if (fault != nullptr) return brake(cycle, Problem::input, fault);
  return stops ? stop(cycle) : pass_through(cycle);
}

Conclusion Planner::Impl::drive(const Cycle& cycle) {
  const Steering steering = find_steering(cycle);
  const bool autonomous = autonomy.drives(cycle, steering);
  const Arbiter::Choice choice = arbiter.choose(cycle, steering, autonomous);
  decision.candidates = evaluation.candidates().count();
  decision.escaping = evaluation.obstacles().in_collision();
  if (!choice.evaluated.scored) {
    evaluation.clear();
    autonomy.end_evasion();
    return brake(cycle, Problem::off_map, "no pose of the plan lies on the local map");
  }
  explanation.note_choice(choice.proposal, steering);
  const Conclusion chosen = follow_choice(cycle, choice.proposal);
  explanation.judge_operator(cycle, chosen.sample, decision);
  if (cycle.sampling.report == Report::full) explanation.ask_all_critics(choice.evaluated.view);

  const Autonomy::Verdict verdict = autonomy.commit(cycle, steering, driven(cycle, choice, chosen, autonomous));
  decision.recovering = autonomy.active();
  decision.waiting = verdict.waits;
  if (verdict.reset_critics) critics.reset();
  const Outcome outcome = verdict.conclusion.outcome;
  const bool why = outcome == Outcome::brake || outcome == Outcome::fail;
  if (why) evaluation.checks().check_all();
  explanation.count_rejections(why, decision);
  critics.debrief(choice.evaluated.view, chosen.command);
  return verdict.conclusion;
}

// With authority a between 0 and 1 the target is u_ref = (1 - a) u_nv + a u_h, where u_nv is what autonomy alone would
// choose: the reference is blended, never the weights, and u_ref itself is a candidate.
Steering Planner::Impl::find_steering(const Cycle& cycle) {
  if (cycle.situation.goalless) return goalless.update(cycle);
  const Influence influence = cycle.intent.influence;
  const Twist2& u_h = cycle.intent.u_h;
  const double a = influence == Influence::shared ? parameters.authority : 1.0;
  const bool active = influence != Influence::none && a > 0.0;
  if (!active || a >= 1.0) return {active, u_h, parameters.s_v, parameters.s_omega};
  const Twist2 u_nv = arbiter.cheapest_alone(cycle, u_h);
  const Twist2 u_ref{u_nv.v + a * (u_h.v - u_nv.v), u_nv.omega + a * (u_h.omega - u_nv.omega)};
  return {true, u_ref, parameters.s_v, parameters.s_omega};
}

Conclusion Planner::Impl::follow_choice(const Cycle& cycle, const Proposal& proposal) {
  if (proposal.candidate < 0) {
    return brake(cycle, Problem::rejected, unless_off_map(cycle, "every candidate was rejected"));
  }
  explanation.describe_choice(decision);
  const Twist2& sample = evaluation.candidates().sample(static_cast<std::size_t>(proposal.candidate));
  if (cycle.situation.goalless && against_operator(sample, cycle.start.reference, cycle.intent.u_h)) {
    return brake(cycle, Problem::rejected, "every candidate that the operator could mean was rejected");
  }
  return follow(sample, evaluation.obstacles().admissibility().command_for(sample));
}

// What autonomy has to know of what is driven. Standing in collision may be the operator's choice.
Autonomy::Driven Planner::Impl::driven(const Cycle& cycle, const Arbiter::Choice& choice, const Conclusion& conclusion,
                                       bool autonomous) {
  const Proposal& proposal = choice.proposal;
  Autonomy::Driven driven;
  driven.steps = choice.steps;
  driven.conclusion = conclusion;
  driven.soon = cycle.start.pose;
  const bool in_collision = evaluation.obstacles().in_collision();
  driven.trapped = in_collision && proposal.candidate < 0;
  if (proposal.candidate < 0) return driven;
  driven.yields = proposal.rule == ChoiceReport::Rule::evasion;
  const bool by_movers = cycle.movers != nullptr && !driven.yields;
  if (conclusion.sample == Twist2{} && (in_collision || by_movers)) {
    const bool must_rest = !evaluation.checks().any_motion_legal();
    driven.trapped = in_collision && must_rest;
    driven.yields = driven.yields || (by_movers && must_rest);
  }
  if (!autonomous || parameters.method == Method::paper) return driven;
  const Rollout& rollout = evaluation.candidates().rollout();
  const auto candidate = static_cast<std::size_t>(proposal.candidate);
  const Tile tile = rollout.tile(rollout.tile_of(candidate));
  const std::size_t c = candidate - tile.first;
  driven.tight = tight_ahead(evaluation.obstacles().collision(), tile, c, cycle.grid.resolution);
  driven.soon = pose_within(tile, c, parameters.control_latency + cycle.start.period);
  return driven;
}

}  // namespace hidwa_local_planner
