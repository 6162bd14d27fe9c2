// SPDX-License-Identifier: BSD-3-Clause
#include "core/planner/planner_impl.hpp"

#include <algorithm>
#include <utility>

#include "core/motion/late_cycles.hpp"
#include "core/planner/safe_values.hpp"

namespace hidwa_local_planner {
namespace {

constexpr std::size_t kMaxCritics = 200;

// More than any problem has characters.
constexpr std::size_t kLongestProblem = 120;

// A robot in collision that no motion has led out of for longer is caught [s].
constexpr double kCaught = 1.0;

// A turn on the spot below this share of the fastest creeps.
constexpr double kCreeps = 0.25;

// Beyond these a number is no measurement but a fault: no robot this planner serves is so fast or so far away.
constexpr double kFastest = 20.0;      // [m/s]
constexpr double kFastestTurn = 50.0;  // [rad/s]
constexpr double kFarthest = 1e6;      // [m, rad]

constexpr double kOldestPose = 10.0;  // [s]

bool plausible(const Twist2& u) { return std::abs(u.v) <= kFastest && std::abs(u.omega) <= kFastestTurn; }
bool plausible(const Pose2& q) {
  return std::abs(q.x) <= kFarthest && std::abs(q.y) <= kFarthest && std::abs(q.theta) <= kFarthest;
}

double usable_period(const Situation& s) { return s.period > 0.0 ? s.period : Situation().period; }

// An old pose is led on in steps of so much [m].
constexpr double kAdvanceSpacing = 0.01;

}  // namespace

const char* to_string(Outcome outcome) {
  switch (outcome) {
    case Outcome::drive:
      return "DRIVE";
    case Outcome::brake:
      return "BRAKE";
    case Outcome::fail:
      return "FAIL";
    case Outcome::hold:
      return "HOLD";
  }
  return "UNKNOWN";
}

Planner::Planner(CriticRegistry registry) : impl_(std::make_unique<Impl>()) {
  impl_->registry = std::move(registry);
  configure(Parameters{});
}
Planner::~Planner() = default;
Planner::Planner(Planner&&) noexcept = default;
Planner& Planner::operator=(Planner&&) noexcept = default;

const Parameters& Planner::parameters() const { return impl_->parameters; }
const Footprint& Planner::footprint() const { return impl_->footprint; }

std::vector<std::string> Planner::configure(const Parameters& parameters, const SourceFor& source_for) {
  std::vector<std::string> faults = validate(parameters);
  const std::vector<std::string> names = split_names(parameters.critics);
  for (const std::string& name : names) {
    if (impl_->registry.knows(name)) continue;
    std::string known;
    for (const std::string& other : impl_->registry.names()) known += " " + other;
    faults.push_back("critics: no critic named " + name + "; there are" + known);
  }
  if (names.size() > kMaxCritics) faults.push_back("critics: more than 200; name fewer");
  if (!faults.empty()) return faults;

  // A critic that stays keeps what it latched.
  std::vector<NamedCritic> critics;
  for (const std::string& name : names) {
    const auto kept = std::find_if(impl_->critics.begin(), impl_->critics.end(),
                                   [&](const NamedCritic& c) { return c.name == name; });
    const bool twice =
        std::any_of(critics.begin(), critics.end(), [&](const NamedCritic& c) { return c.name == name; });
    NamedCritic named;
    named.name = name;
    named.critic = kept != impl_->critics.end() && !twice ? kept->critic : impl_->registry.make(name);
    if (!named.critic) return {"critics: " + name + " is known but could not be made: look at its package's library"};
    if (source_for) named.source = source_for(name);
    if (!named.source) named.source = std::make_unique<ParameterSource>();
    named.weight = named.critic->configure(parameters, *named.source);
    for (const std::string& fault : named.source->faults()) faults.push_back(fault);
    critics.push_back(std::move(named));
  }
  if (!faults.empty()) return faults;
  impl_->critics = std::move(critics);
  impl_->raw.resize(impl_->critics.size());
  impl_->make_room_for_words();
  impl_->parameters = parameters;
  make_safe(impl_->parameters);
  impl_->limits = VelocityLimits::from(parameters);
  set_footprint(impl_->outline);
  return {};
}

const Polygon& Planner::outline() const { return impl_->outline; }

void Planner::set_footprint(const Polygon& outline) {
  if (&impl_->outline != &outline) impl_->outline = outline;
  impl_->footprint = Footprint::from_outline(outline, impl_->parameters.footprint_padding);
}

void Planner::reset() {
  impl_->reset_critics();
  impl_->way_out.reset();
  impl_->caught.reset();
  impl_->unturned.reset();
}

Twist2 Planner::believed(const Twist2& measured) const {
  const auto axis = [&](double Twist2::*u, const AxisBelief& belief) {
    if (!std::isfinite(measured.*u)) return impl_->commands.last().*u;
    const bool fast = faster_than_explained(measured.*u, impl_->commands.range(u),
                                            reading_tolerance(impl_->parameters, impl_->commands.last()).*u);
    return !fast ? measured.*u : belief.sure() ? belief.believed() : impl_->commands.last().*u;
  };
  return {axis(&Twist2::v, impl_->odometry.v), axis(&Twist2::omega, impl_->odometry.omega)};
}

const Decision& Planner::plan(const Situation& measured, const GridView& grid, const OperatorIntent& intent,
                              const Sampling& sampling) {
  impl_->begin(measured);
  const Situation& situation = impl_->advance(measured);
  impl_->intent = intent;
  const char* fault = intent.influence != Influence::stop ? impl_->fault_of(situation, grid) : nullptr;
  if (fault != nullptr) {
    impl_->give_up(situation, Problem::input, fault);
  } else if (intent.influence == Influence::stop) {  // whatever is known of the world
    impl_->give_up(situation, Problem::none, "");
    impl_->decision.outcome = at_rest(impl_->decision.command) ? Outcome::hold : Outcome::brake;
  } else if (intent.influence == Influence::direct && !intent.guarded) {
    impl_->pass_through(situation);
  } else {
    return impl_->drive(situation, grid, sampling);
  }
  impl_->way_out.reset();  // autonomy did not choose to stand
  impl_->caught.reset();
  return impl_->decision;
}

const char* Planner::Impl::fault_of(const Situation& situation, const GridView& grid) const {
  if (!grid.valid()) return "the costmap is empty";
  if (!(situation.pose_age >= 0.0) || situation.pose_age > kOldestPose) return "the pose is too old: look at tf";
  if (const char* fault = footprint.fault()) return fault;
  if (footprint.circumscribed_radius() > grid.resolution * std::hypot(grid.size_x, grid.size_y)) {
    return "the footprint is larger than the local map: give it in metres, or a larger map";
  }
  if (!plausible(situation.pose) || !plausible(situation.velocity) || !plausible(situation.last_command)) {
    return "pose or velocity is not a number, or beyond all bounds: look at odometry and tf";
  }
  if (!(situation.period > 0.0) || !std::isfinite(situation.period)) return "the control period is not positive";
  if (situation.plan.empty()) return "the plan is empty";
  const auto bad = [](const Pose2& pose) { return !plausible(pose); };
  if (bad(situation.goal) || std::any_of(situation.plan.begin(), situation.plan.end(), bad)) {
    return "a pose of the plan is not a number, or beyond all bounds: look at the global planner";
  }
  if (intent.influence != Influence::none && !is_finite(intent.u_h)) return "what the person wants is not a number";
  return nullptr;
}

// Where this cycle starts from on one axis, what is believed of the reading, and what else the robot may do. A command
// starts from the last one, or from where odometry is slower; never from a reading that is faster.
void Planner::Impl::judge_axis(const Situation& situation, double Twist2::*axis, const AxisLimits& axis_limits,
                               AxisBelief& belief) {
  const double last = commands.last().*axis;
  const double measured = plausible(situation.velocity) ? situation.velocity.*axis : last;
  const double tolerance = reading_tolerance(parameters, commands.last()).*axis;
  const OdometryReading reading = belief.judge(situation.time, measured, commands.range(axis), tolerance, axis_limits);
  const bool fast = reading == OdometryReading::doubted || reading == OdometryReading::faster;
  const bool as_commanded =
      reading == OdometryReading::agrees && parameters.velocity_reference == VelocityReference::command;
  // What the base is taken to have reached lies between what was sent and what is measured.
  const double reached = std::clamp(decision.reference.*axis, std::min(last, measured), std::max(last, measured));
  const double start = fast ? last : as_commanded ? reached : measured;
  decision.reference.*axis = axis_limits.start_from(start, last);
  decision.velocity.*axis = reading == OdometryReading::doubted  ? last
                            : reading == OdometryReading::faster ? belief.believed()
                                                                 : measured;
  decision.odometry_doubted = decision.odometry_doubted || reading == OdometryReading::doubted;
  decision.odometry_fast = decision.odometry_fast || reading == OdometryReading::faster;
  const bool otherwise =
      reading == OdometryReading::slower || reading == OdometryReading::faster || (!fast && !as_commanded);
  if (otherwise) pending.or_else(axis, decision.velocity.*axis);
}

// A command that was never a number is none; a reference beyond the limits is brought back by the window.
void Planner::Impl::find_reference(const Situation& situation) {
  origin = situation.pose;
  const double period = usable_period(situation);
  const double latency = parameters.control_latency, age = situation.pose_age;
  const Twist2 last = plausible(situation.last_command) ? situation.last_command : Twist2{};
  if (situation.resumed) {
    commands.forget();
    odometry.forget();
  }
  commands.observe(situation.time, period, latency + period + age, last, limits);
  UnderWay& as_commanded = pending.first();
  commands.play(limits, period, latency, age, as_commanded);
  as_commanded.mark_past(age);
  decision.reference = commands.next_start(limits, period, as_commanded.end());
  judge_axis(situation, &Twist2::v, limits.x, odometry.v);
  judge_axis(situation, &Twist2::omega, limits.theta, odometry.omega);
  // A base may be quicker than control_latency says.
  if (latency <= 0.0 || as_commanded.at_rest()) return;
  const auto ways = std::min(std::ceil(latency / period), static_cast<double>(PendingMotion::kMostUnlikely));
  for (double way = 0.0; way < ways; way += 1.0) {
    UnderWay& prompt = pending.add_unlikely();
    commands.play(limits, period, latency * way / ways, age, prompt);
    prompt.mark_past(age);
  }
}

// The pose of now: from the measured one on as the commands since then say, where odometry is slower as that says.
const Situation& Planner::Impl::advance(const Situation& situation) {
  decision.pose = situation.pose;
  if (situation.pose_age <= 0.0 || !plausible(situation.pose)) return situation;
  const UnderWay& likely = pending[pending.size() - 1];
  const Rotation heading{std::cos(situation.pose.theta), std::sin(situation.pose.theta)};
  ManoeuvreRoller roller(limits, footprint.circumscribed_radius(), kAdvanceSpacing, {situation.pose, heading});
  roller.roll_past(likely);
  advanced.plan.reserve(situation.plan.capacity());
  advanced = situation;
  advanced.pose = decision.pose = roller.at().pose;
  return advanced;
}

void Planner::Impl::begin(const Situation& situation) {
  clear_decision();
  find_reference(situation);
  marked = Marked{};
  totals.clear();
  verdicts.clear();
  report = ChoiceReport{};
}

// For what a cycle may come to say, so that the first one that says it needs none.
void Planner::Impl::make_room_for_words() {
  scored.resize(critics.size());
  decision.terms.reserve(critics.size() + 1);
  decision.refusals.reserve(critics.size() + kFirstCritic);
  decision.problem.reserve(kLongestProblem);
  for (const NamedCritic& named : critics) {
    decision.operator_refused_by.reserve(std::max(kLongestProblem, named.name.size()));
  }
}

// Keeps the memory.
void Planner::Impl::clear_decision() {
  std::vector<Pose2> trajectory = std::move(decision.trajectory);
  std::vector<CriticTerm> terms = std::move(decision.terms);
  std::vector<RefusalCount> refusals = std::move(decision.refusals);
  std::string refused = std::move(decision.operator_refused_by), problem = std::move(decision.problem);
  trajectory.clear();
  terms.clear();
  refusals.clear();
  refused.clear();
  problem.clear();
  decision = Decision{};
  decision.trajectory = std::move(trajectory);
  decision.terms = std::move(terms);
  decision.refusals = std::move(refusals);
  decision.operator_refused_by = std::move(refused);
  decision.problem = std::move(problem);
}

// A late cycle brakes by what could have been braked since the one before: otherwise all late cycles would add way.
double Planner::Impl::brake_period(const Situation& situation) const {
  return late_brake_period(commands.elapsed(), usable_period(situation), longest_period(situation));
}

// What braking starts from: odometry may lag behind a command that brakes already, and must not take that back.
Twist2 Planner::Impl::brake_start() const {
  const auto slower = [](double reference, double last) {
    return reference * last > 0.0 && std::abs(reference) < std::abs(last) ? reference : last;
  };
  const Twist2 last = commands.last();
  return {limits.x.start_from(slower(decision.reference.v, last.v), last.v),
          limits.theta.start_from(slower(decision.reference.omega, last.omega), last.omega)};
}

// The brake command; at rest there is nothing left but to fail.
void Planner::Impl::give_up(const Situation& situation, Problem kind, const char* problem) {
  decision.problem_kind = kind;
  decision.problem = problem;
  decision.sample = {};
  decision.command = limits.brake(brake_start(), brake_period(situation));
  // A command that is still under way moves it, whatever odometry shows yet.
  const bool moving = !at_rest(decision.reference) || !at_rest(decision.velocity) || !at_rest(commands.last());
  decision.outcome = moving ? Outcome::brake : Outcome::fail;
}

void Planner::Impl::pass_through(const Situation& situation) {
  decision.sample = limits.clamp(intent.u_h);
  decision.command = limits.step(decision.reference, decision.sample, situation.period);
  decision.outcome = at_rest(decision.command) ? Outcome::hold : Outcome::drive;
}

const Decision& Planner::Impl::drive(const Situation& situation, const GridView& grid, const Sampling& sampling) {
  aim(situation, grid, sampling);
  const CycleView cycle = weigh(situation, grid, sampling);
  if (!grids.on_map() && !steered) {
    totals.clear();
    give_up(situation, Problem::off_map, "no pose of the plan lies on the local map");
    return decision;
  }
  const bool autonomous = !steered && !situation.goal_latched;
  if (!autonomous) way_out.reset();
  const bool turning_out = way_out.active();
  int best =
      !autonomous ? -1 : way_out.choose({situation, grid, rollout, totals, collision, admissibility, escape, grids});
  report = {best >= 0 ? ChoiceReport::Rule::way_out : ChoiceReport::Rule::cheapest, wish, steered};
  // In a collision only the way out is worth turning for.
  if (best < 0 && !(admissibility.escaping() && turning_out)) best = choose(situation);
  if (best < 0) {
    report.rule = ChoiceReport::Rule::none;
    give_up(situation, Problem::refused, "every candidate was refused");
  } else {
    describe(best);
  }
  judge_operator();
  if (thorough) hear_everybody(cycle);
  watch_collision(situation);
  watch_rest(situation, autonomous);
  watch_last_turn(situation);
  if (decision.outcome == Outcome::brake || decision.outcome == Outcome::fail) check_all_tiles();  // it is told why
  count_refusals();
  for (NamedCritic& named : critics) {
    if (named.weight != 0.0) named.critic->debrief(cycle, decision.command);
  }
  return decision;
}

// What the deviation is measured from. With authority a the wish is u_ref = (1 - a) u_nv + a u_h, where u_nv is what
// autonomy alone would choose: the reference is blended, never the weights, and u_ref itself is a candidate.
void Planner::Impl::aim(const Situation& situation, const GridView& grid, const Sampling& sampling) {
  const double a = intent.influence == Influence::shared ? parameters.authority : 1.0;
  steered = intent.influence != Influence::none && a > 0.0;
  wish = intent.u_h;
  if (!steered || a >= 1.0) return;
  steered = false;
  weigh(situation, grid, sampling);
  const int own = grids.on_map() ? choose(situation) : -1;
  const Twist2 u_nv = own >= 0 ? sample_at(static_cast<std::size_t>(own)) : Twist2{};
  wish = {u_nv.v + a * (intent.u_h.v - u_nv.v), u_nv.omega + a * (intent.u_h.omega - u_nv.omega)};
  steered = true;
}

// Whether a legal motion leads out of the collision that the robot stands in.
bool Planner::Impl::moves_out() {
  if (report.rule == ChoiceReport::Rule::none) return false;
  if (!(decision.sample == Twist2{})) return true;
  check_all_tiles();  // a person had it stand
  for (std::size_t c = 0; c < totals.size(); ++c) {
    if (std::isfinite(totals[c]) && !(sample_at(c) == Twist2{})) return true;
  }
  return false;
}

// A new scan may take away at once what one has put under the robot: it waits a little before the host is called.
void Planner::Impl::watch_collision(const Situation& situation) {
  caught.observe(situation.time, decision.escaping && !moves_out());
  if (!caught.holds()) return;
  const bool moving = !at_rest(decision.reference) || !at_rest(situation.velocity);
  if (moving || !caught.for_at_least(kCaught, situation.time)) {
    if (decision.outcome == Outcome::fail) decision.outcome = Outcome::brake;
    return;
  }
  decision.outcome = Outcome::fail;
  decision.problem_kind = Problem::refused;
  decision.problem =
      "no way out: the robot stands in collision and no motion leads out of it; the costmap must be cleared";
}

// Autonomy that prefers standing still to every legal move is stuck. It looks for a way out; where there is none it
// fails, so that the host replans or recovers.
void Planner::Impl::watch_rest(const Situation& situation, bool autonomous) {
  const bool trapped = caught.holds();
  WayOut::Rest rest;
  rest.stands = autonomous && (decision.outcome == Outcome::hold || trapped);
  rest.creeps = autonomous && decision.outcome == Outcome::drive && decision.sample.v == 0.0 &&
                std::abs(decision.sample.omega) < kCreeps * limits.theta.max;
  const double patience = parameters.turn_when_stuck ? 0.5 * parameters.blocked_time : -1.0;
  if (way_out.watch(situation, rest, patience)) {
    reset_critics();  // what they forbid may be the way out
  }
  if (!trapped && way_out.rest(situation.time) > parameters.blocked_time) {
    decision.outcome = Outcome::fail;
    decision.problem_kind = Problem::stuck;
    decision.problem = "autonomy is stuck: standing still is its best legal candidate";
  }
}

// At the goal's position only a turn is left. Where a critic forbids its direction (one that the person had the robot
// turn from, for example) the other one is longer and standing still is cheaper for ever.
void Planner::Impl::watch_last_turn(const Situation& situation) {
  const double off = std::abs(wrap_angle(situation.goal.theta - situation.pose.theta));
  const bool stands = !steered && situation.goal_latched && decision.outcome == Outcome::hold;
  unturned.observe(situation.time, stands && off > parameters.yaw_goal_tolerance);
  const bool long_enough = unturned.for_at_least(0.5 * parameters.blocked_time, situation.time);
  if (long_enough && !unturned_reset) reset_critics();
  unturned_reset = long_enough;
  if (unturned.time(situation.time) > parameters.blocked_time) {
    decision.outcome = Outcome::fail;
    decision.problem_kind = Problem::stuck;
    decision.problem = "the last turn to the goal's heading is stuck: standing still is its best legal candidate";
  }
}

}  // namespace hidwa_local_planner
