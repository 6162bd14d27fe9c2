// SPDX-License-Identifier: BSD-3-Clause
#include "hidwa_local_planner/core/planner.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "hidwa_local_planner/core/admissibility.hpp"
#include "hidwa_local_planner/core/cell_classes.hpp"
#include "hidwa_local_planner/core/choice.hpp"
#include "hidwa_local_planner/core/collision.hpp"
#include "hidwa_local_planner/core/lasting.hpp"
#include "hidwa_local_planner/core/plan_grids.hpp"
#include "hidwa_local_planner/core/rollout.hpp"
#include "hidwa_local_planner/core/samples.hpp"
#include "hidwa_local_planner/core/velocity_limits.hpp"
#include "hidwa_local_planner/core/way_out.hpp"

namespace hidwa_local_planner {
namespace {

// Who refused a candidate: nobody, the collision check, the braking check, or critic number (value - kFirstCritic).
constexpr std::uint8_t kLegal = 0;
constexpr std::uint8_t kCollision = 1;
constexpr std::uint8_t kBraking = 2;
constexpr std::uint8_t kFirstCritic = 3;
constexpr std::size_t kMaxCritics = 200;

constexpr const char* kCannotBrake = "cannot stop in free space";

// Slower than this the robot rests [m/s, rad/s].
constexpr double kAtRest = 1e-3;

bool at_rest(const Twist2& u) { return std::abs(u.v) < kAtRest && std::abs(u.omega) < kAtRest; }

// A turn on the spot below this share of the fastest creeps.
constexpr double kCreeps = 0.25;

// Beyond these a number is no measurement but a fault: no robot this planner serves is so fast or so far away.
constexpr double kFastest = 20.0;         // [m/s]
constexpr double kFastestTurn = 50.0;     // [rad/s]
constexpr double kFarthest = 1e6;         // [m, rad]

bool plausible(const Twist2& u) { return std::abs(u.v) <= kFastest && std::abs(u.omega) <= kFastestTurn; }
bool plausible(const Pose2& q) {
  return std::abs(q.x) <= kFarthest && std::abs(q.y) <= kFarthest && std::abs(q.theta) <= kFarthest;
}

// Parameters of critics of other packages where nobody supplies any: the fallbacks.
class NoParameters : public ParameterSource {
 public:
  double number(const std::string& /*key*/, double fallback) const override { return fallback; }
  bool flag(const std::string& /*key*/, bool fallback) const override { return fallback; }
};

// Makes room with some to spare: the number of candidates changes by a few from cycle to cycle.
template <typename T>
void fit(std::vector<T>& values, std::size_t count) {
  if (values.capacity() < count) values.reserve(count + count / 8 + 16);
  values.resize(count);
}

struct NamedCritic {
  std::string name;
  std::shared_ptr<Critic> critic;
  double weight = 0.0;
  std::unique_ptr<ParameterSource> source;
};

}  // namespace

const char* to_string(Outcome outcome) {
  switch (outcome) {
    case Outcome::drive: return "DRIVE";
    case Outcome::brake: return "BRAKE";
    case Outcome::fail: return "FAIL";
    case Outcome::hold: return "HOLD";
  }
  return "UNKNOWN";
}

struct Planner::Impl {
  CriticRegistry registry;
  Parameters parameters;
  VelocityLimits limits;
  std::vector<NamedCritic> critics;
  Polygon outline;
  Footprint footprint;

  // One cycle's work, kept for its memory and for evaluation().
  Sampler sampler;
  Rollout rollout;
  CollisionChecker collision;
  CellClasses classes;
  AdmissibilityCheck admissibility;
  PlanGrids grids;
  std::vector<double> totals;             // [candidates]; infinite where refused
  std::vector<std::uint8_t> refused_by;   // [candidates]
  std::vector<const char*> reasons;       // [candidates]
  std::vector<std::vector<double>> raw;   // [critics][candidates]
  std::vector<std::uint32_t> queue, equals;  // candidates, see choose_next()
  double row_omega = 0.0;                 // of the tiles being scored [rad/s]
  std::size_t row_first = 0;              // the first candidate of that omega
  double reach = 0.0;                     // of all rollouts and manoeuvres [m]
  std::vector<std::size_t> counts;        // of refusals, by refuser
  OperatorIntent intent;                  // of the last cycle
  bool steered = false;                   // in this pass the deviation from `wish` counts
  Twist2 wish;                            // u_h, or with authority below 1 what is blended of it and of autonomy
  Decision decision;
  Marked marked;
  WayOut way_out;
  Lasting unturned;                       // at the goal's position it stands at another heading
  bool unturned_reset = false;            // the critics were reset for that
  bool thorough = false;
  std::vector<CandidateVerdict> verdicts;  // of the last cycle, where thorough
  ChoiceReport report;

  const char* fault_of(const Situation& situation, const GridView& grid) const;
  void begin(const Situation& situation);
  void give_up(const Situation& situation, Problem kind, const char* problem);
  Twist2 bounded_reference(const Situation& situation) const;
  void make_candidates(const Situation& situation, const Sampling& sampling);
  void prepare_checks(const Situation& situation, const GridView& grid);
  void score_tile(const CycleView& cycle, Tile tile);
  void refuse_colliding(const Tile& tile);
  void ask_critics(const CycleView& cycle, const Tile& tile);
  void sum_up(const Tile& tile);
  double deviation_of(const Twist2& sample) const;
  std::uint8_t not_a_number(std::size_t candidate) const;
  int choose(const Situation& situation);
  int choose_next(const TieRule& tie, std::size_t refused);
  void refuse_braking(std::size_t candidate);
  void watch_rest(const Situation& situation, bool autonomous);
  void watch_last_turn(const Situation& situation);
  void reset_critics() {
    for (NamedCritic& named : critics) named.critic->reset();
  }
  void describe(int best);
  void count_refusals();
  void judge_operator();
  int find_operator_own() const;
  std::string_view name_of(std::uint8_t refuser) const;
  Twist2 sample_at(std::size_t candidate) const { return sampler.samples()[candidate].u; }
  void list_terms(std::size_t candidate, std::vector<CriticTerm>& terms) const;
  void clear_decision();
  const Decision& drive(const Situation& situation, const GridView& grid, const Sampling& sampling);
  void hear_everybody(const CycleView& cycle);
  void hear_critics(const CycleView& cycle, const Tile& tile);
  void aim(const Situation& situation, const GridView& grid, const Sampling& sampling);
  CycleView weigh(const Situation& situation, const GridView& grid, const Sampling& sampling);
  void pass_through(const Situation& situation);
};

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
    const bool twice = std::any_of(critics.begin(), critics.end(), [&](const NamedCritic& c) { return c.name == name; });
    NamedCritic named;
    named.name = name;
    named.critic = kept != impl_->critics.end() && !twice ? kept->critic : impl_->registry.make(name);
    if (!named.critic) return {"critics: " + name + " is known but could not be made: look at its package's library"};
    if (source_for) named.source = source_for(name);
    if (!named.source) named.source = std::make_unique<NoParameters>();
    named.weight = named.critic->configure(parameters, *named.source);
    critics.push_back(std::move(named));
  }
  impl_->critics = std::move(critics);
  impl_->raw.resize(impl_->critics.size());
  impl_->parameters = parameters;
  impl_->limits = VelocityLimits::from(parameters);
  set_footprint(impl_->outline);
  return {};
}

void Planner::set_footprint(const Polygon& outline) {
  if (&impl_->outline != &outline) impl_->outline = outline;
  impl_->footprint = Footprint::from_outline(outline, impl_->parameters.footprint_padding);
}

void Planner::reset() {
  impl_->reset_critics();
  impl_->way_out.reset();
  impl_->unturned.reset();
}

const Decision& Planner::plan(const Situation& situation, const GridView& grid, const OperatorIntent& intent,
                              const Sampling& sampling) {
  impl_->begin(situation);
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
  return impl_->decision;
}

const char* Planner::Impl::fault_of(const Situation& situation, const GridView& grid) const {
  if (!grid.valid()) return "the costmap is empty";
  if (footprint.empty()) return "no footprint is set: give the costmap footprint or robot_radius";
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

// A command that was never a number is none; a reference beyond the limits is brought back by the window.
Twist2 Planner::Impl::bounded_reference(const Situation& situation) const {
  const Twist2 last = plausible(situation.last_command) ? situation.last_command : Twist2{};
  const Twist2 measured = plausible(situation.velocity) ? situation.velocity : last;
  return velocity_reference(parameters, measured, last);
}

void Planner::Impl::begin(const Situation& situation) {
  clear_decision();
  decision.reference = bounded_reference(situation);
  marked = Marked{};
  totals.clear();
  verdicts.clear();
  report = ChoiceReport{};
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

// The brake command; at rest there is nothing left but to fail.
void Planner::Impl::give_up(const Situation& situation, Problem kind, const char* problem) {
  decision.problem_kind = kind;
  decision.problem = problem;
  decision.sample = {};
  const double period = situation.period > 0.0 ? situation.period : Situation().period;
  decision.command = limits.brake(decision.reference, period);
  const bool moving = !at_rest(decision.reference) || !at_rest(situation.velocity);
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
  int best = way_out.choose({situation, grid, rollout, totals, collision, admissibility, grids});
  report = {best >= 0 ? ChoiceReport::Rule::way_out : ChoiceReport::Rule::cheapest, wish, steered};
  // In a collision only the way out is worth turning for.
  if (best < 0 && !(admissibility.escaping() && turning_out)) best = choose(situation);
  if (best < 0) {
    report.rule = ChoiceReport::Rule::none;
    give_up(situation, Problem::refused, "every candidate was refused");
  } else {
    describe(best);
  }
  count_refusals();
  judge_operator();
  if (thorough) hear_everybody(cycle);
  watch_rest(situation, autonomous);
  watch_last_turn(situation);
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

// Makes, checks and scores all candidates.
CycleView Planner::Impl::weigh(const Situation& situation, const GridView& grid, const Sampling& sampling) {
  make_candidates(situation, sampling);
  prepare_checks(situation, grid);
  grids.prepare(grid, situation.plan, parameters.map_grid, parameters.unknown_is_obstacle);
  grids.expect(situation.pose, reach + std::max(parameters.PathAlign_forward_point_distance,
                                                parameters.GoalAlign_forward_point_distance));
  CycleView cycle;
  cycle.pose = situation.pose;
  cycle.velocity = situation.velocity;
  cycle.last_command = situation.last_command;
  cycle.goal = situation.goal;
  cycle.time = situation.time;
  cycle.steered = steered;
  cycle.plan = &situation.plan;
  cycle.grid = &grid;
  cycle.footprint = &footprint;
  cycle.grids = &grids;
  if (!grids.on_map() && !steered) return cycle;
  for (NamedCritic& named : critics) {
    if (named.weight != 0.0) named.critic->prepare(cycle);
  }
  for (std::size_t t = 0; t < rollout.tile_count(); ++t) score_tile(cycle, rollout.tile(t));
  return cycle;
}

void Planner::Impl::make_candidates(const Situation& situation, const Sampling& sampling) {
  SampleRequest request;
  request.reference = decision.reference;
  request.previous = situation.last_command;
  request.wanted = steered ? &intent.u_h : nullptr;
  request.blended = steered && !(wish == intent.u_h) ? &wish : nullptr;
  request.period = situation.period;
  request.vx_samples = sampling.vx_samples > 0 ? sampling.vx_samples : parameters.vx_samples;
  request.vth_samples = sampling.vth_samples > 0 ? sampling.vth_samples : parameters.vth_samples;
  sampler.make(parameters, limits, request);
  rollout.run(parameters, limits, situation.pose, decision.reference, sampler.samples());
  const std::size_t n = rollout.candidate_count();
  decision.candidates = n;
  fit(totals, n);  // what they hold is set tile by tile
  fit(refused_by, n);
  fit(reasons, n);
  fit(queue, n);
  fit(equals, n);
  for (std::vector<double>& scores : raw) fit(scores, n);
}

void Planner::Impl::prepare_checks(const Situation& situation, const GridView& grid) {
  double fastest = std::abs(decision.reference.v);
  for (const Sample& sample : sampler.samples()) fastest = std::max(fastest, std::abs(sample.u.v));
  const double longest = std::max(parameters.sim_time, parameters.control_latency + situation.period +
                                                           limits.x.time_to_rest(fastest));
  reach = fastest * longest;
  // Half a step: what lies between two clear poses is clear. And enough for an outline that is grown a little.
  const double margin = std::max(0.5 * rollout.longest_step(), grid.resolution / 16.0);
  collision.prepare(grid, footprint, parameters.unknown_is_obstacle, situation.pose, reach, margin);
  classes.prepare(collision, grid, parameters.unknown_is_obstacle, situation.pose, reach);
  admissibility.prepare(parameters, limits, collision, footprint, grid.resolution,
                        {situation.pose, decision.reference, situation.period, !steered && way_out.active()});
  decision.escaping = admissibility.escaping();
}

void Planner::Impl::score_tile(const CycleView& cycle, Tile tile) {
  classes.classify(tile);
  std::fill_n(refused_by.begin() + static_cast<std::ptrdiff_t>(tile.first), tile.count, kLegal);
  std::fill_n(reasons.begin() + static_cast<std::ptrdiff_t>(tile.first), tile.count, nullptr);
  refuse_colliding(tile);
  ask_critics(cycle, tile);
  sum_up(tile);
}

void Planner::Impl::refuse_colliding(const Tile& tile) {
  const char** reason = reasons.data() + tile.first;
  std::uint8_t* refuser = refused_by.data() + tile.first;
  admissibility.check_rollouts(tile, reason);
  if (tile.first == 0 || tile.omega != row_omega) {
    row_omega = tile.omega;
    row_first = tile.first;
  }
  const std::size_t column = tile.first - row_first;
  for (std::size_t c = 0; c < tile.count; ++c) {
    if (reason[c] != nullptr) {
      refuser[c] = kCollision;
    } else if (parameters.admissibility == Admissibility::braking && !admissibility.can_brake(tile.sample(c), column + c)) {
      refuser[c] = kBraking;
      reason[c] = kCannotBrake;
    }
  }
}

void Planner::Impl::ask_critics(const CycleView& cycle, const Tile& tile) {
  for (std::size_t i = 0; i < critics.size(); ++i) {
    std::fill_n(raw[i].begin() + static_cast<std::ptrdiff_t>(tile.first), tile.count, 0.0);
    if (critics[i].weight == 0.0) continue;
    TileScores scores(raw[i].data() + tile.first, reasons.data() + tile.first, tile.count);
    critics[i].critic->score(cycle, tile, scores);
    if (!scores.any_refused()) continue;
    for (std::size_t c = tile.first; c < tile.first + tile.count; ++c) {
      if (reasons[c] != nullptr && refused_by[c] == kLegal) refused_by[c] = static_cast<std::uint8_t>(kFirstCritic + i);
    }
  }
}

// Kalliokoski 2022, the cost J in section III: J = s_nv J_nv + gamma (s_v |v_h - v| + s_omega |omega_h - omega|).
void Planner::Impl::sum_up(const Tile& tile) {
  const std::size_t n = tile.count;
  double* total = totals.data() + tile.first;
  std::fill_n(total, n, 0.0);
  // Direct control takes the legal candidate nearest to what the person wants, by the same weights.
  if (intent.influence != Influence::direct) {
    for (std::size_t i = 0; i < critics.size(); ++i) {
      const double weight = critics[i].weight;
      const double* scores = raw[i].data() + tile.first;
      for (std::size_t c = 0; c < n; ++c) total[c] += weight * scores[c];
    }
    for (std::size_t c = 0; c < n; ++c) total[c] *= parameters.s_nv;
  }
  if (steered) {
    for (std::size_t c = 0; c < n; ++c) total[c] += deviation_of(tile.sample(c));
  }
  for (std::size_t c = 0; c < n; ++c) {
    const std::size_t at = tile.first + c;
    if (refused_by[at] == kLegal && !std::isfinite(total[c])) {
      // A critic of another package may say anything: what is not a number is no legal candidate.
      refused_by[at] = not_a_number(at);
      reasons[at] = "total is not a number";
    }
    if (refused_by[at] != kLegal) total[c] = std::numeric_limits<double>::infinity();
  }
}

// The paper's J_sh; nothing while the person's input does not count.
double Planner::Impl::deviation_of(const Twist2& u) const {
  if (!steered) return 0.0;
  return parameters.s_v * std::abs(wish.v - u.v) + parameters.s_omega * std::abs(wish.omega - u.omega);
}

// The critic that spoiled a total.
std::uint8_t Planner::Impl::not_a_number(std::size_t candidate) const {
  for (std::size_t i = 0; i < critics.size(); ++i) {
    if (!std::isfinite(critics[i].weight * raw[i][candidate])) return static_cast<std::uint8_t>(kFirstCritic + i);
  }
  return kFirstCritic;
}

int Planner::Impl::choose(const Situation& situation) {
  const TieRule tie(parameters, situation.last_command);
  const auto lowest = std::min_element(totals.begin(), totals.end());
  if (lowest == totals.end() || !std::isfinite(*lowest)) return -1;
  std::size_t best = static_cast<std::size_t>(lowest - totals.begin());
  const double equal = *lowest + kEqualTotals;
  for (std::size_t c = 0; c < totals.size(); ++c) {
    if (totals[c] <= equal && tie.prefers(sample_at(c), sample_at(best))) best = c;
  }
  if (parameters.admissibility != Admissibility::braking) return static_cast<int>(best);
  return admissibility.can_brake_surely(sample_at(best)) ? static_cast<int>(best) : choose_next(tie, best);
}

// The same rule for the rest, where the closer look refused the first: cheapest first, without searching all anew.
int Planner::Impl::choose_next(const TieRule& tie, std::size_t refused) {
  const auto later = [this](std::uint32_t a, std::uint32_t b) {
    return totals[a] != totals[b] ? totals[a] > totals[b] : a > b;
  };
  refuse_braking(refused);
  queue.clear();
  for (std::size_t c = 0; c < totals.size(); ++c) {
    if (std::isfinite(totals[c])) queue.push_back(static_cast<std::uint32_t>(c));
  }
  std::make_heap(queue.begin(), queue.end(), later);
  while (!queue.empty()) {
    equals.clear();
    const double equal = totals[queue.front()] + kEqualTotals;
    while (!queue.empty() && totals[queue.front()] <= equal) {
      equals.push_back(queue.front());
      std::pop_heap(queue.begin(), queue.end(), later);
      queue.pop_back();
    }
    std::uint32_t best = equals.front();
    std::sort(equals.begin(), equals.end());
    for (const std::uint32_t c : equals) {
      if (tie.prefers(sample_at(c), sample_at(best))) best = c;
    }
    if (admissibility.can_brake_surely(sample_at(best))) return static_cast<int>(best);
    refuse_braking(best);
    for (const std::uint32_t c : equals) {
      if (c == best) continue;
      queue.push_back(c);
      std::push_heap(queue.begin(), queue.end(), later);
    }
  }
  return -1;
}

void Planner::Impl::refuse_braking(std::size_t candidate) {
  totals[candidate] = std::numeric_limits<double>::infinity();
  refused_by[candidate] = kBraking;
  reasons[candidate] = kCannotBrake;
}

void Planner::Impl::describe(int best) {
  const auto index = static_cast<std::size_t>(best);
  marked.best = best;
  decision.sample = sample_at(index);
  decision.command = admissibility.command_for(decision.sample);
  decision.total = totals[index];
  list_terms(index, decision.terms);
  decision.outcome = at_rest(decision.command) && at_rest(decision.sample) ? Outcome::hold : Outcome::drive;
  const Tile tile = rollout.tile(rollout.tile_of(index));
  decision.step = tile.dt;
  for (std::size_t k = 0; k <= tile.steps; ++k) decision.trajectory.push_back(tile.pose(k, index - tile.first));
}

void Planner::Impl::count_refusals() {
  counts.assign(kFirstCritic + critics.size(), 0);
  const auto legal = static_cast<std::size_t>(std::count(refused_by.begin(), refused_by.end(), kLegal));
  if (legal == refused_by.size()) {
    counts[kLegal] = legal;
  } else {
    for (const std::uint8_t refuser : refused_by) ++counts[refuser];
  }
  decision.legal = counts[kLegal];
  for (std::size_t refuser = kCollision; refuser < counts.size(); ++refuser) {
    if (counts[refuser] > 0) decision.refusals.push_back({name_of(static_cast<std::uint8_t>(refuser)), counts[refuser]});
  }
  double worst = -std::numeric_limits<double>::infinity();
  for (std::size_t c = 0; c < totals.size(); ++c) {
    if (std::isfinite(totals[c]) && totals[c] > worst) {
      worst = totals[c];
      marked.worst = static_cast<int>(c);
    }
  }
}

// How near the choice comes to the operator's own command, and what became of that: of its own candidate, or of the
// sample nearest to it.
void Planner::Impl::judge_operator() {
  if (intent.influence == Influence::none) return;
  const double v_span = std::max(limits.x.max - limits.x.min, 1e-6);
  const double omega_span = std::max(limits.theta.max - limits.theta.min, 1e-6);
  decision.agreement = std::max(0.0, 1.0 - std::abs(intent.u_h.v - decision.sample.v) / v_span -
                                         std::abs(intent.u_h.omega - decision.sample.omega) / omega_span);
  marked.operator_own = find_operator_own();
  if (marked.operator_own < 0) return;
  const std::uint8_t refuser = refused_by[static_cast<std::size_t>(marked.operator_own)];
  if (refuser != kLegal) decision.operator_refused_by = name_of(refuser);
}

// The person's own candidate, one of the last, or the sample nearest to what the person wants.
int Planner::Impl::find_operator_own() const {
  const std::vector<Sample>& samples = sampler.samples();
  for (std::size_t c = samples.size(); c-- > 0 && samples[c].kind != SampleKind::grid;) {
    if (samples[c].kind == SampleKind::operator_own) return static_cast<int>(c);
  }
  int own = -1;
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t c = 0; c < samples.size(); ++c) {
    const double off = std::abs(samples[c].u.v - intent.u_h.v) + std::abs(samples[c].u.omega - intent.u_h.omega);
    if (off < nearest) {
      nearest = off;
      own = static_cast<int>(c);
    }
  }
  return own;
}

// Autonomy that prefers standing still to every legal move is stuck. It looks for a way out; where there is none it
// fails, so that the host replans or recovers.
void Planner::Impl::watch_rest(const Situation& situation, bool autonomous) {
  const bool trapped = decision.outcome == Outcome::fail && decision.escaping;
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

std::string_view Planner::Impl::name_of(std::uint8_t refuser) const {
  constexpr std::string_view kNames[] = {"", "Collision", "Braking"};
  if (refuser < kFirstCritic) return kNames[refuser];
  return critics[static_cast<std::size_t>(refuser - kFirstCritic)].name;
}

void Planner::Impl::list_terms(std::size_t candidate, std::vector<CriticTerm>& terms) const {
  for (std::size_t i = 0; i < critics.size(); ++i) {
    terms.push_back({critics[i].name, raw[i][candidate], parameters.s_nv * critics[i].weight});
  }
  terms.push_back({"OperatorDeviation", deviation_of(sample_at(candidate)), 1.0});
}

std::vector<CandidateRecord> Planner::evaluation() const {
  std::vector<CandidateRecord> records;
  if (impl_->totals.empty()) return records;
  for (std::size_t t = 0; t < impl_->rollout.tile_count(); ++t) {
    const Tile tile = impl_->rollout.tile(t);
    for (std::size_t c = 0; c < tile.count; ++c) {
      const std::size_t at = tile.first + c;
      CandidateRecord record;
      record.sample = tile.sample(c);
      record.step = tile.dt;
      for (std::size_t k = 0; k <= tile.steps; ++k) record.poses.push_back(tile.pose(k, c));
      impl_->list_terms(at, record.terms);
      if (std::isfinite(impl_->totals[at])) record.total = impl_->totals[at];
      record.refused_by = impl_->name_of(impl_->refused_by[at]);
      record.reason = impl_->reasons[at] != nullptr ? impl_->reasons[at] : "";
      records.push_back(std::move(record));
    }
  }
  return records;
}

Planner::Marked Planner::marked() const { return impl_->marked; }
const std::vector<double>& Planner::totals() const { return impl_->totals; }
const ChoiceReport& Planner::choice() const { return impl_->report; }
const std::vector<CandidateVerdict>& Planner::verdicts() const { return impl_->verdicts; }
void Planner::set_thorough(bool thorough) { impl_->thorough = thorough; }

// After the choice and before anybody is told of it: what the critics remember is still what they judged by.
void Planner::Impl::hear_everybody(const CycleView& cycle) {
  verdicts.assign(totals.size(), CandidateVerdict{});
  for (std::size_t t = 0; t < rollout.tile_count(); ++t) {
    Tile tile = rollout.tile(t);
    classes.classify(tile);
    std::vector<const char*> collides(tile.count, nullptr);
    admissibility.check_rollouts(tile, collides.data());
    for (std::size_t c = 0; c < tile.count; ++c) {
      CandidateVerdict& verdict = verdicts[tile.first + c];
      verdict.sample = tile.sample(c);
      verdict.end = tile.pose(tile.steps, c);
      verdict.collision = collides[c];
      verdict.can_brake = parameters.admissibility != Admissibility::braking ||
                          (refused_by[tile.first + c] != kBraking && admissibility.can_brake_surely(verdict.sample));
      verdict.total = totals[tile.first + c];
      verdict.operator_own = sampler.samples()[tile.first + c].kind == SampleKind::operator_own;
    }
    hear_critics(cycle, tile);
  }
}

void Planner::Impl::hear_critics(const CycleView& cycle, const Tile& tile) {
  for (const NamedCritic& named : critics) {
    std::vector<double> scores(tile.count, 0.0);
    std::vector<const char*> refusals(tile.count, nullptr);
    TileScores said(scores.data(), refusals.data(), tile.count);
    if (named.weight != 0.0) named.critic->score(cycle, tile, said);
    for (std::size_t c = 0; c < tile.count; ++c) {
      verdicts[tile.first + c].critics.push_back({named.name, scores[c], parameters.s_nv * named.weight, refusals[c]});
    }
  }
  for (std::size_t c = 0; c < tile.count; ++c) {
    CandidateVerdict& verdict = verdicts[tile.first + c];
    verdict.critics.push_back({"OperatorDeviation", deviation_of(verdict.sample), 1.0, nullptr});
    for (const CriticVerdict& critic : verdict.critics) verdict.sum += critic.raw * critic.weight;
  }
}

void Planner::save(Bytes& state) const {
  ArchiveWriter write(state);
  write(impl_->way_out, impl_->unturned, impl_->unturned_reset, static_cast<std::uint32_t>(impl_->critics.size()));
  for (const NamedCritic& named : impl_->critics) {
    Bytes own;
    ArchiveWriter write_own(own);
    named.critic->save(write_own);
    write(named.name, own);
  }
}

bool Planner::load(const Bytes& state) {
  ArchiveReader read(state);
  std::uint32_t count = 0;
  reset();
  read(impl_->way_out, impl_->unturned, impl_->unturned_reset, count);
  for (std::uint32_t i = 0; i < count && !read.failed(); ++i) {
    std::string name;
    Bytes own;
    read(name, own);
    for (NamedCritic& named : impl_->critics) {
      if (named.name != name) continue;
      ArchiveReader read_own(own);
      named.critic->load(read_own);
      break;
    }
  }
  return read.complete();
}

}  // namespace hidwa_local_planner
