// SPDX-License-Identifier: BSD-3-Clause
#include "core/collision/admissibility.hpp"

#include <algorithm>
#include <cmath>

#include "core/collision/cell_classes.hpp"
#include "core/motion/late_cycles.hpp"

namespace hidwa_local_planner {
namespace {

constexpr const char* kHits = "rollout hits an obstacle";
constexpr const char* kDeeper = "would go deeper into collision, or not out of it";
constexpr const char* kTooFast = "too fast in collision: could not stop within half a cell";

// Poses that are looked at for depth, in cells: of a candidate, and of the one that is chosen.
constexpr double kDepthSpacing = 1.0 / 8.0;
constexpr double kSureDepthSpacing = 1.0 / 128.0;

// A pose that is free without room [m].
constexpr double kTouching = 1e-12;

// Columns of samples that room is made for at once.
constexpr std::size_t kUsualColumns = 128;

// The robot stands as near to something as it did, up to so much [m].
constexpr double kSameDistance = 1e-6;

// Poses need not lie nearer to each other [m].
constexpr double kFinest = 1e-4;

// In periods: a command to brake that may come so much later is as good as one that does not.
constexpr double kSoon = 0.1;

// In periods: so far apart are the times at which a late command to brake is looked at.
constexpr double kHoldsApart = 0.5;

// How much room around a pose is looked for, in cells: what is found saves looking at its neighbours.
constexpr double kRoom = 2.0;

}  // namespace

double AdmissibilityCheck::reach_of_manoeuvres(const Setup& setup, const VelocityLimits& limits, double fastest) {
  const double hold = latest_hold(setup.period, setup.longest_period);
  double reach = 0.0;
  for (std::size_t way = 0; way < setup.pending->all(); ++way) {
    const BrakeManoeuvre manoeuvre{setup.origin, (*setup.pending)[way], {fastest, 0.0}, setup.period, hold};
    reach = std::max(reach, manoeuvre.reach(limits));
  }
  return reach;
}

double AdmissibilityCheck::most_growth(const Setup& setup, const VelocityLimits& limits, double radius, double reach) {
  // One ramp and one tail: no way to them is farther off than half of what the limits allow in a period.
  const auto of_command = [&setup](const AxisLimits& axis) {
    return 0.75 * std::max(axis.acc, axis.braking) * setup.period * setup.period;
  };
  Twist2 spread;
  for (std::size_t way = 0; way < setup.pending->all(); ++way) {
    const Twist2 own = (*setup.pending)[way].spread();
    spread = {std::max(spread.v, own.v), std::max(spread.omega, own.omega)};
  }
  return spread.v + of_command(limits.x) + (radius + reach) * (spread.omega + of_command(limits.theta));
}

void AdmissibilityCheck::prepare(const Parameters& parameters, const VelocityLimits& limits,
                                 const CollisionChecker& checker, const Footprint& footprint, double resolution,
                                 const Setup& setup) {
  parameters_ = &parameters;
  limits_ = &limits;
  checker_ = &checker;
  footprint_ = &footprint;
  resolution_ = resolution;
  setup_ = setup;
  if (memo_.size() < kUsualColumns) memo_.resize(kUsualColumns);
  for (Memo& memo : memo_) memo.known = memo.v_known = false;
  omega_known_ = false;
  for (Arrival& arrival : arrivals_) arrival.roller.reset();
  for (Arrival& arrival : sure_arrivals_) arrival.roller.reset();
  for (Sinking& sinking : sinkings_) sinking.roller.reset();
  for (Sinking& sinking : sure_sinkings_) sinking.roller.reset();
  start_ = {setup.start, {std::cos(setup.start.theta), std::sin(setup.start.theta)}};
  margin_ = checker.margin();
  rooms_.clear(footprint.circumscribed_radius(), 0.5 * resolution);
  all_clear_ = nothing_in_reach();
  keep_ =
      all_clear_ ? 0.0 : std::max(0.0, checker.separation(setup.start, start_.heading, checker.room()) - kSameDistance);
}

Twist2 AdmissibilityCheck::command_for(const Twist2& sample) const {
  if (parameters_->command == CommandPolicy::target) return sample;
  return limits_->step(setup_.reference, sample, setup_.period);
}

void AdmissibilityCheck::check_rollouts(const Tile& tile, const char** reasons) {
  last_hit_ = 0;
  most_turn_ = std::max(std::abs(tile.omega), std::abs(setup_.reference.omega)) * tile.dt;
  Tile seen = tile;
  if (setup_.escape != nullptr) seen.classes = seen.touched = nullptr;  // they count what it may overlap, too
  for (std::size_t c = 0; c < tile.count; ++c) {
    if (const char* fault = fault_of_rollout(seen, c)) reasons[c] = fault;
  }
}

const char* AdmissibilityCheck::fault_of_rollout(const Tile& tile, std::size_t c) {
  if (escaping() && !setup_.escape->slow_enough(tile.sample(c))) return kTooFast;
  if (escaping() && !rollout_escapes(tile, c)) return kDeeper;
  return rollout_free(tile, c) ? nullptr : kHits;
}

bool AdmissibilityCheck::cells_decide(const Tile& tile, const char** reasons) const {
  if (setup_.escape != nullptr || tile.touched == nullptr) return false;
  if ((tile.touched_any & (cell_class::kHit | cell_class::kNear)) == 0) return true;
  unsigned undecided = 0;
  for (std::size_t c = 0; c < tile.count; ++c) {
    const bool hit = (tile.touched[c] & cell_class::kHit) != 0;
    if (hit) reasons[c] = kHits;
    undecided |= hit ? 0U : tile.touched[c] & cell_class::kNear;
  }
  return undecided == 0;
}

bool AdmissibilityCheck::rollout_free(const Tile& tile, std::size_t c) {
  if (tile.touched != nullptr) {
    if ((tile.touched[c] & cell_class::kHit) != 0) return false;
    if ((tile.touched[c] & cell_class::kNear) == 0) return true;
  }
  // Where its neighbour hit something, a candidate mostly does too.
  if (last_hit_ > 0 && room_at(tile, c, last_hit_) <= 0.0) return false;
  // No point of the robot moves farther in a step: its centre at the faster of two speeds, its rim by the turn.
  const double step = std::max(std::abs(tile.v[c]), std::abs(setup_.reference.v)) * tile.dt +
                      most_turn_ * footprint_->circumscribed_radius();
  double room = room_at(tile, c, 0);
  const std::uint8_t* classes = tile.classes != nullptr ? tile.classes + c : nullptr;
  for (std::size_t k = 0; k < tile.steps;) {
    if (classes != nullptr && ((classes[k * tile.stride] | classes[(k + 1) * tile.stride]) & cell_class::kNear) ==
                                  0) {  // so is what lies between, whatever the heading
      room = margin_;
      ++k;
      continue;
    }
    if (room >= step) {  // all poses within the room are free
      k = std::min(tile.steps, k + static_cast<std::size_t>(std::min(room / step, 1e6)));
      if (k < tile.steps) room = std::max(room_at(tile, c, k), kTouching);
      continue;
    }
    const double next = room_at(tile, c, k + 1);
    if (next <= 0.0 || (room + next < step && !between_free(tile, c, k + 1, room, next))) {
      last_hit_ = k + 1;
      return false;
    }
    room = next;
    ++k;
  }
  return true;
}

// How far every point of the robot may move from a pose of a rollout, at least [m]; 0 where it collides.
double AdmissibilityCheck::room_at(const Tile& tile, std::size_t c, std::size_t k) {
  if (tile.classes != nullptr && (tile.classes[k * tile.stride + c] & cell_class::kNear) == 0) return margin_;
  return look(tile.pose(k, c), {tile.cos_heading[k], tile.sin_heading[k]});
}

double AdmissibilityCheck::look(const Pose2& pose, const Rotation& heading, double needed) {
  const double left = rooms_.room_at(pose);
  if (left > needed) return left;
  const double room = checker_->separation(pose, heading, needed + kRoom * resolution_);
  if (room > 0.0) rooms_.note(pose, room);
  return room;
}

// The poses between step k - 1 and step k, at most half a cell apart, with the room that there is at both ends.
bool AdmissibilityCheck::between_free(const Tile& tile, std::size_t c, std::size_t k, double room_before,
                                      double room_after) {
  const Pose2 from = tile.pose(k - 1, c);
  const Pose2 to = tile.pose(k, c);
  const double dx = to.x - from.x, dy = to.y - from.y, turn = to.theta - from.theta;
  const double moved = std::sqrt(dx * dx + dy * dy) + std::abs(turn) * footprint_->circumscribed_radius();
  const int parts = static_cast<int>(std::ceil(moved / (0.5 * resolution_) - 1e-9));
  const Rotation heading{tile.cos_heading[k - 1], tile.sin_heading[k - 1]};
  for (int part = 1; part < parts; ++part) {
    const double t = static_cast<double>(part) / parts;
    if (t * moved <= room_before || (1.0 - t) * moved <= room_after) continue;
    const Pose2 pose{from.x + t * dx, from.y + t * dy, from.theta + t * turn};
    if (look(pose, heading.turned(Rotation::of(t * turn))) <= 0.0) return false;
  }
  return true;
}

bool AdmissibilityCheck::rollout_escapes(const Tile& tile, std::size_t c) const {
  EscapeRule& rule = *setup_.escape;
  EscapeRule::Descent descent = rule.start();
  if (!rule.descends(tile, c, descent)) return false;
  const bool drives_on = rule.grazes() && !(tile.sample(c) == Twist2{});
  return drives_on || may_stay(tile, c) || rule.ends_better(tile.last_pose(c), descent);
}

bool AdmissibilityCheck::may_stay(const Tile& tile, std::size_t c) const {
  if (tile.v[c] != 0.0) return false;
  return setup_.steered || (setup_.turn_out && tile.omega != 0.0 && setup_.reference.v == 0.0);
}

bool AdmissibilityCheck::can_brake(const Twist2& sample, std::size_t column) {
  if (all_can_brake()) return true;
  if (memo_.size() <= column) memo_.resize(column + 1);
  Memo& memo = memo_[column];
  const Twist2 command = brief_command_for(sample, column);
  const Memo* before = column > 0 ? &memo_[column - 1] : nullptr;
  if (memo.known && memo.command == command) return memo.free;
  if (before != nullptr && before->known && before->command == command) {
    memo.command = command;
    memo.known = true;
    memo.free = before->free;
    return memo.free;
  }
  memo.command = command;
  memo.known = true;
  memo.free =
      (all_clear_ || manoeuvre_free(command)) && !(escaping() && manoeuvre_deeper(command, kDepthSpacing, sinkings_));
  return memo.free;
}

// As command_for(): where no wheel couples the axes, a column shares its speed and a tile its turn.
Twist2 AdmissibilityCheck::brief_command_for(const Twist2& sample, std::size_t column) {
  if (limits_->wheel_speed > 0.0 || parameters_->command == CommandPolicy::target) return command_for(sample);
  Memo& memo = memo_[column];
  if (!memo.v_known || memo.sample_v != sample.v) {
    memo.v_known = true;
    memo.sample_v = sample.v;
    memo.command_v = limits_->x.ramp(setup_.reference.v, sample.v, setup_.period);
  }
  if (!omega_known_ || sample_omega_ != sample.omega) {
    omega_known_ = true;
    sample_omega_ = sample.omega;
    command_omega_ = limits_->theta.ramp(setup_.reference.omega, sample.omega, setup_.period);
  }
  return {memo.command_v, command_omega_};
}

bool AdmissibilityCheck::can_brake_surely(const Twist2& sample) {
  const Twist2 command = command_for(sample);
  return (all_clear_ || manoeuvre_surely_free(command)) &&
         !(escaping() && manoeuvre_deeper(command, kSureDepthSpacing, sure_sinkings_));
}

BrakeManoeuvre AdmissibilityCheck::manoeuvre(std::size_t way, const Twist2& command, double hold) const {
  return {setup_.origin, (*setup_.pending)[way], command, setup_.period, hold};
}

double AdmissibilityCheck::longest_hold() const { return latest_hold(setup_.period, setup_.longest_period); }

// No command reaches farther than the one that speeds up.
bool AdmissibilityCheck::nothing_in_reach() const {
  const double speed = std::abs(setup_.reference.v) + limits_->x.acc * setup_.period;
  double reach = reach_of_manoeuvres(setup_, *limits_, std::max(setup_.pending->fastest(), speed));
  reach += most_growth(setup_, *limits_, footprint_->circumscribed_radius(), reach);
  return checker_->clear_around(setup_.origin.x, setup_.origin.y, reach);
}

// A sixteenth of a cell; nearer where the robot hardly moves, since half of it is asked for as distance.
double AdmissibilityCheck::fine_spacing(double way) const { return std::clamp(way / 8.0, kFinest, resolution_ / 16.0); }

// `look` tells how much room a pose has, where more than a distance is asked for; what is left of it is enough for the
// next poses.
template <typename Look>
bool AdmissibilityCheck::free_all_along(const BrakeManoeuvre& manoeuvre, bool surely, Arrival& arrival,
                                        Look&& look) const {
  const double radius = footprint_->circumscribed_radius();
  const auto roll = [&](ManoeuvreRoller& roller, double spacing, double& room, auto&& roll_part) {
    const double gap = surely ? 0.5 * spacing : 0.0;  // half of what a point moves between two poses
    roller.set_spacing(spacing);
    return roll_part(roller, [&](const TurnedPose& at) {
      room -= spacing;  // nothing moved farther since the last pose
      const double needed = std::min(roller.growth() + gap, keep_);
      if (room <= needed) room = look(at, needed);
      return room > needed;
    });
  };
  if (!arrival.roller) {
    const Pose2& origin = manoeuvre.start;
    arrival.roller.emplace(*limits_, radius, resolution_,
                           TurnedPose{origin, {std::cos(origin.theta), std::sin(origin.theta)}});
    arrival.room = 0.0;
    const double spacing = surely ? fine_spacing(manoeuvre.pending.reach(radius)) : 0.5 * resolution_;
    arrival.free = roll(*arrival.roller, spacing, arrival.room, [&](ManoeuvreRoller& roller, auto&& visit) {
      return roller.roll_on(manoeuvre.pending, visit);
    });
  }
  if (!arrival.free) return false;
  double room = arrival.room;
  ManoeuvreRoller rest = *arrival.roller;
  const double spacing = surely ? fine_spacing(manoeuvre.reach(*limits_, radius)) : 0.5 * resolution_;
  return roll(rest, spacing, room,
              [&](ManoeuvreRoller& roller, auto&& visit) { return roller.roll_to_rest(manoeuvre, visit); });
}

// In every way that what is pending may go on, and whether the command to brake comes after a period or as late as it
// may.
template <typename Look>
bool AdmissibilityCheck::free_in_time(const Twist2& command, bool surely, Arrivals& arrivals, Look&& look) const {
  const double latest = longest_hold();
  const std::size_t ways = surely ? setup_.pending->all() : setup_.pending->likely();
  // In a turn, braking at another time leads elsewhere: the ends, and for a thorough look what lies between.
  const double apart = surely ? kHoldsApart * setup_.period : latest;
  const double parts = latest > kSoon * setup_.period ? std::ceil(latest / apart) : 0.0;
  for (std::size_t way = 0; way < ways; ++way) {
    for (double part = parts; part >= 0.0; part -= 1.0) {
      const double hold = parts > 0.0 ? latest * part / parts : latest;
      if (!free_all_along(manoeuvre(way, command, hold), surely, arrivals[way], look)) return false;
    }
  }
  return true;
}

bool AdmissibilityCheck::manoeuvre_free(const Twist2& command) {
  return free_in_time(command, false, arrivals_,
                      [this](const TurnedPose& at, double needed) { return look(at.pose, at.heading, needed); });
}

bool AdmissibilityCheck::manoeuvre_surely_free(const Twist2& command) {
  return free_in_time(command, true, sure_arrivals_, [this](const TurnedPose& at, double needed) {
    return checker_->separation(at.pose, at.heading, needed + kRoom * resolution_);
  });
}

bool AdmissibilityCheck::manoeuvre_deeper(const Twist2& command, double spacing, Sinkings& sinkings) const {
  for (std::size_t way = 0; way < setup_.pending->likely(); ++way) {
    if (goes_deeper(manoeuvre(way, command, longest_hold()), spacing, sinkings[way])) return true;
  }
  return false;
}

bool AdmissibilityCheck::goes_deeper(const BrakeManoeuvre& manoeuvre, double spacing, Sinking& sinking) const {
  const auto visit_into = [this](EscapeRule::Descent& descent) {
    return [this, &descent](const TurnedPose& at) {
      return setup_.escape->descends(at, EscapeRule::Ahead::next_cycle, descent);
    };
  };
  if (!sinking.roller) {
    const Pose2& origin = manoeuvre.start;
    sinking.descent = setup_.escape->start();
    sinking.roller.emplace(*limits_, footprint_->circumscribed_radius(), spacing * resolution_,
                           TurnedPose{origin, {std::cos(origin.theta), std::sin(origin.theta)}});
    sinking.deeper = !sinking.roller->roll_on(manoeuvre.pending, visit_into(sinking.descent));
  }
  if (sinking.deeper) return true;
  // However the base reaches the command: at its limits, or evenly.
  EscapeRule::Descent ramped = sinking.descent, even = sinking.descent;
  return !ManoeuvreRoller(*sinking.roller).roll_to_rest(manoeuvre, visit_into(ramped)) ||
         !ManoeuvreRoller(*sinking.roller).roll_evenly_to_rest(manoeuvre, visit_into(even));
}

}  // namespace hidwa_local_planner
