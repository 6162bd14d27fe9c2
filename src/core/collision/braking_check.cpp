// SPDX-License-Identifier: BSD-3-Clause
#include "core/collision/braking_check.hpp"

#include <algorithm>
#include <cmath>

#include "core/motion/late_cycles.hpp"

namespace hidwa_local_planner {
namespace {

// Poses that are looked at for depth in collision, in cells: of a candidate, and of the one that is chosen.
constexpr double kDepthSpacing = 1.0 / 8.0;
constexpr double kFineDepthSpacing = 1.0 / 128.0;
// They are so many at most: a robot that spins, and takes a minute to stop, would be looked at without end.
constexpr double kMostDepthPoses = 2048.0;

// Two clearances that differ by less than this are the same [m].
constexpr double kSameDistance = 1e-6;

// Poses need not lie nearer to each other [m].
constexpr double kFinest = 1e-4;

}  // namespace

double BrakingCheck::reach_of_manoeuvres(const CycleStart& start, double fastest) {
  double reach = 0.0;
  for (std::size_t motion = 0; motion < start.pending->all(); ++motion) {
    reach = std::max(reach, start.manoeuvre(motion, {fastest, 0.0}, start.latest_hold()).reach(start.limits));
  }
  return reach;
}

void BrakingCheck::CheckPass::forget() {
  for (PendingEnd& pending_end : pending_ends) pending_end.roller.reset();
  for (EscapeEnd& pending_end : escape_ends) pending_end.roller.reset();
}

void BrakingCheck::prepare(const Parameters& parameters, const CheckSetup& setup, ClearanceLookup& clearances,
                           double radius, double resolution) {
  start_ = setup.start;
  setup_ = &setup;
  clearances_ = &clearances;
  commands_the_sample_ = parameters.commands_the_sample();
  radius_ = radius;
  resolution_ = resolution;
  coarse_results_.forget();
  coarse_.forget();
  coarse_.depth_spacing = kDepthSpacing;
  fine_.forget();
  fine_.fine = true;
  fine_.depth_spacing = kFineDepthSpacing;
  all_clear_ = nothing_in_reach();
  clearance_now_ = 0.0;
  if (all_clear_) return;
  const CollisionChecker& checker = clearances.checker();
  const double clearance =
      checker.clearance(start_->pose, Rotation::direction(start_->pose.theta), checker.largest_clearance());
  clearance_now_ = std::max(0.0, clearance - kSameDistance);
}

// The command that speeds up reaches farthest.
bool BrakingCheck::nothing_in_reach() const {
  const double speed = std::abs(start_->reference.v) + start_->limits.x.acc * start_->period;
  double reach = reach_of_manoeuvres(*start_, std::max(start_->pending->fastest().v, speed));
  reach += start_->most_drift(radius_, reach);
  return clearances_->checker().clear_around(start_->origin.x, start_->origin.y, reach);
}

Twist2 BrakingCheck::command_for(const Twist2& sample) const {
  if (commands_the_sample_) return sample;
  const Twist2& from = start_->reference;
  VelocityLimits limits = start_->limits;
  limits.theta = sample == Twist2{} ? setup_->comfort.to_rest(limits.theta, from.omega)
                                    : setup_->comfort.towards(limits.theta, from.omega, sample.omega);
  return limits.step(from, sample, start_->period);
}

bool BrakingCheck::can_brake(const Twist2& sample) {
  if (all_can_brake()) return true;
  const Twist2 command = command_for(sample);
  return coarse_results_.free(command, [&] { return brakes_freely(command, coarse_); });
}

bool BrakingCheck::confirm_braking(const Twist2& sample) { return brakes_freely(command_for(sample), fine_); }

bool BrakingCheck::brakes_freely(const Twist2& command, CheckPass& pass) {
  return (all_clear_ || stops_freely(command, pass)) && !(setup_->escaping() && goes_deeper(command, pass));
}

ManoeuvreRoller BrakingCheck::roller_at(const Pose2& start, double spacing) const {
  return ManoeuvreRoller(start_->limits, radius_, spacing, TurnedPose::of(start));
}

// For each pending motion, and whether the command to brake comes after a period or as late as it may. In a turn,
// braking at another time leads elsewhere: the ends, and to be sure what lies between. Where there is no room for the
// growth, a base that lags leads elsewhere, too.
bool BrakingCheck::stops_freely(const Twist2& command, CheckPass& pass) {
  const std::size_t motions = pass.fine ? start_->pending->all() : start_->pending->likely();
  const LateTimes times(start_->latest_hold(), start_->period, pass.fine);
  double growth = 0.0;
  const auto all_free = [&](std::size_t first, std::size_t end) {
    for (std::size_t motion = first; motion < end; ++motion) {
      const auto free = [&](double hold) {
        return free_all_along(start_->manoeuvre(motion, command, hold), pass, pass.pending_ends[motion], growth);
      };
      if (!times.all_of(free)) return false;
    }
    return true;
  };
  if (!all_free(0, motions)) return false;
  return !pass.fine || growth <= clearance_now_ || all_free(motions, start_->pending->with_lagging());
}

// `growth`: the largest of all that were asked for [m].
bool BrakingCheck::free_all_along(const BrakeManoeuvre& manoeuvre, const CheckPass& pass, PendingEnd& pending_end,
                                  double& growth) {
  if (!pending_end.roller) roll_pending(manoeuvre, pass, pending_end);
  if (!pending_end.free) return false;
  double clearance = pending_end.clearance;
  ManoeuvreRoller rest = *pending_end.roller;
  const bool free =
      free_along(pass, pass.fine ? manoeuvre.reach(start_->limits, radius_) : 0.0, clearance, rest,
                 [&](ManoeuvreRoller& roller, auto&& visit) { return roller.roll_to_rest(manoeuvre, visit); });
  growth = std::max(growth, rest.growth());
  return free;
}

void BrakingCheck::roll_pending(const BrakeManoeuvre& manoeuvre, const CheckPass& pass, PendingEnd& pending_end) {
  pending_end.roller = roller_at(manoeuvre.start, resolution_);
  pending_end.clearance = 0.0;
  pending_end.free =
      free_along(pass, pass.fine ? manoeuvre.pending.reach(radius_) : 0.0, pending_end.clearance, *pending_end.roller,
                 [&](ManoeuvreRoller& roller, auto&& visit) { return roller.roll_on(manoeuvre.pending, visit); });
}

// Rolls one part of a manoeuvre, `way` [m] long at most. `clearance` is what is left of that of a pose before: nothing
// moves farther than the spacing from pose to pose.
template <typename RollPart>
bool BrakingCheck::free_along(const CheckPass& pass, double way, double& clearance, ManoeuvreRoller& roller,
                              RollPart&& part) {
  // A sixteenth of a cell; nearer where the robot hardly moves, since half of it is asked for as clearance.
  const double spacing = pass.fine ? std::clamp(way / 8.0, kFinest, resolution_ / 16.0) : 0.5 * resolution_;
  const double gap = pass.fine ? 0.5 * spacing : 0.0;
  roller.set_spacing(spacing);
  return part(roller, [&](const TurnedPose& at) {
    clearance -= spacing;
    const double needed = std::min(roller.growth() + gap, clearance_now_);
    if (clearance <= needed) {
      clearance =
          pass.fine ? clearances_->measure(at.pose, at.heading, needed) : clearances_->at(at.pose, at.heading, needed);
    }
    return clearance > needed;
  });
}

bool BrakingCheck::goes_deeper(const Twist2& command, CheckPass& pass) const {
  for (std::size_t motion = 0; motion < start_->pending->likely(); ++motion) {
    if (goes_deeper(start_->manoeuvre(motion, command, start_->latest_hold()), pass.depth_spacing,
                    pass.escape_ends[motion])) {
      return true;
    }
  }
  return false;
}

// `spacing` is in cells, and wider where the manoeuvre is long. One that could not even be looked at as candidates are
// is taken to lead deeper.
bool BrakingCheck::goes_deeper(const BrakeManoeuvre& manoeuvre, double spacing, EscapeEnd& pending_end) const {
  const auto spacing_for = [&](double way) { return std::max(spacing * resolution_, way / kMostDepthPoses); };
  const double apart = spacing_for(manoeuvre.reach(start_->limits, radius_));
  if (!(apart <= kDepthSpacing * resolution_)) return true;
  const auto visit_into = [this](EscapeRule::Descent& descent) {
    return [this, &descent](const TurnedPose& at) {
      return setup_->escape->descends(at, EscapeRule::Ahead::next_cycle, descent);
    };
  };
  if (!pending_end.roller) {
    pending_end.descent = setup_->escape->start();
    pending_end.roller = roller_at(manoeuvre.start, spacing_for(manoeuvre.pending.reach(radius_)));
    pending_end.deeper = !pending_end.roller->roll_on(manoeuvre.pending, visit_into(pending_end.descent));
  }
  if (pending_end.deeper) return true;
  // However the base reaches the command: at its limits, or evenly.
  EscapeRule::Descent ramped = pending_end.descent, even = pending_end.descent;
  ManoeuvreRoller ramp = *pending_end.roller;
  ramp.set_spacing(apart);
  ManoeuvreRoller evenly = ramp;
  return !ramp.roll_to_rest(manoeuvre, visit_into(ramped)) || !evenly.roll_evenly_to_rest(manoeuvre, visit_into(even));
}

}  // namespace hidwa_local_planner
