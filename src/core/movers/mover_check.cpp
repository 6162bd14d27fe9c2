// SPDX-License-Identifier: BSD-3-Clause
#include "core/movers/mover_check.hpp"

#include <algorithm>
#include <cmath>

#include "core/movers/hidden_places.hpp"
#include "core/util/outline.hpp"
#include "hidwa_local_planner/core/rest.hpp"

namespace hidwa_local_planner {
namespace {

// Poses are no farther apart in time [s]: of a candidate, and of the one that is chosen.
constexpr double kLongStep = 0.05;
constexpr double kShortStep = 0.01;

// Poses need not be nearer than that by way [m]: time decides.
constexpr double kAnySpacing = 1e3;

// Moments that differ by less are one [s].
constexpr double kSameMoment = 1e-9;

// What is slower stands, and may be left [m/s]; the robot's outermost point is no faster then [m/s].
constexpr double kStands = 0.3;
constexpr double kLeavesAt = 0.15;

// No place of its outline that may be touched then moves outwards faster [m/s].
constexpr double kAdvances = 0.02;

// The tracker finds somebody who steps out within this time after half of him is in view [s].
constexpr double kSightAge = 0.4;

// Memory is kept for so many at once.
constexpr std::size_t kUsualMovers = 512;

// The robot stands, and no pending command moves it.
bool rests(const CycleStart& start, const Parameters& parameters) {
  return (*start.pending)[0].rests() && !start.odometry_fast && at_rest(start.velocity, parameters);
}

VelocityRange velocities_of(const PendingMotion& pending) {
  VelocityRange range;
  range.include(pending.begin());
  for (const PendingMotion::Leg& leg : pending.legs()) range.include(leg.end);
  return range;
}

}  // namespace

MoverCheck::MoverCheck() {
  near_.reserve(kUsualMovers);
  progress_.clear_until.reserve(kUsualMovers);
  for (CheckPass* pass : {&coarse_, &fine_}) {
    for (PendingEnd& pending_end : pass->pending_ends) pending_end.progress.clear_until.reserve(kUsualMovers);
  }
  coarse_.step = kLongStep;
  fine_.fine = true;
  fine_.step = kShortStep;
}

void MoverCheck::prepare(const Parameters& parameters, const Footprint& footprint,
                         const MovingObstacleEstimates& movers, const CycleStart& start) {
  near_.clear();
  departures_.begin(start.period);
  if (movers.empty()) return;
  begin(footprint, start, -1.0);
  for (const MovingObstacleEstimate& mover : movers) {
    const ReachableSet set(mover, parameters);
    if (!in_reach(set)) continue;
    add_near(set,
             around(set) && set.velocity().norm() <= kStands && departures_.admit(mover.id, rests(start, parameters)));
  }
}

void MoverCheck::prepare_hidden(const Parameters& parameters, const Footprint& footprint,
                                const std::vector<Point>& places, const CycleStart& start) {
  near_.clear();
  if (places.empty()) return;
  begin(footprint, start, parameters.blind_speed + kCommandRounding);
  for (const Point& place : places) {
    const ReachableSet set =
        ReachableSet::of_hidden(place, HiddenPlaces::kRadius, parameters.occlusion_speed, kSightAge);
    if (in_reach(set)) add_near(set, false);
  }
}

double MoverCheck::reach_of_hidden(const Parameters& parameters, const Footprint& footprint, const CycleStart& start) {
  const double radius = footprint.circumscribed_radius();
  const ManoeuvreBounds most = ManoeuvreBounds::of(start, radius, kLongStep, kLeavesAt);
  return radius + most.reach + most.grown + parameters.occlusion_speed * (most.duration + kLongStep + kSightAge) +
         HiddenPlaces::kRadius;
}

void MoverCheck::begin(const Footprint& footprint, const CycleStart& start, double creep) {
  creep_ = creep;
  footprint_ = &footprint;
  start_ = &start;
  radius_ = footprint.circumscribed_radius();
  most_ = ManoeuvreBounds::of(start, radius_, kLongStep, kLeavesAt);
  for (CheckPass* pass : {&coarse_, &fine_}) {
    pass->results.forget();
    for (PendingEnd& pending_end : pass->pending_ends) pending_end.roller.reset();
  }
}

// What is too far away to be met until rest, whatever it and the robot do, is left out.
bool MoverCheck::in_reach(const ReachableSet& set) const {
  const Point here(start_->pose.x, start_->pose.y);
  const double own = radius_ + most_.reach + most_.grown + 0.5 * kLongStep * set.fastest();
  const double until_rest = most_.duration;
  const Point expected = set.centre(0.0), goes_to = expected + until_rest * set.velocity();
  return (set.position() - here).norm() <= own + set.speed_radius(until_rest) &&
         std::sqrt(squared_distance_to_segment(here, expected, goes_to)) <= own + set.radius(until_rest);
}

void MoverCheck::add_near(const ReachableSet& set, bool leaves) {
  Near near;
  near.set = set;
  near.leaves = leaves;
  near.closing_speed = most_.fastest + set.fastest();
  near.closing_acc = most_.fastest + set.velocity().norm() + set.growth(most_.duration);
  near_.push_back(near);
}

// The robot is where it may be before even a robot that creeps can rest, or within the allowance of one short step.
bool MoverCheck::around(const ReachableSet& set) const {
  const TurnedPose here = TurnedPose::of(start_->pose);
  const double allowance = most_.drift + 0.5 * kShortStep * (set.fastest() + most_.fastest);
  const double t = most_.creeps_for;
  return footprint_->distance_to(here.seen(set.centre(t))) <= set.radius(t) + allowance &&
         footprint_->distance_to(here.seen(set.position())) <= set.speed_radius(t) + allowance;
}

// For each pending motion, and for commands to brake that come after a period or as late as they may: see
// BrakingCheck.
bool MoverCheck::rests_untouched(const Twist2& command, CheckPass& pass) {
  const std::size_t motions = pass.fine ? start_->pending->all() : start_->pending->likely();
  const LateTimes times(start_->latest_hold(), start_->period, pass.fine);
  // Who brakes between two of these times is elsewhere by half of what the robot does between them.
  const double between = pass.fine ? 0.5 * times.apart() : 0.0;
  const double elsewhere = between * (speed_at(command, radius_) + std::abs(command.omega) * most_.reach);
  for (std::size_t motion = 0; motion < motions; ++motion) {
    const bool free = times.all_of([&](double hold) {
      return rolls_free(start_->manoeuvre(motion, command, hold), pass, elsewhere, pass.pending_ends[motion]);
    });
    if (!free) return false;
  }
  return true;
}

// Up to when the command takes effect: once for all commands.
bool MoverCheck::pending_free(const BrakeManoeuvre& manoeuvre, const CheckPass& pass, PendingEnd& pending_end) {
  if (pending_end.roller) return pending_end.free;
  pending_end.roller.emplace(start_->limits, radius_, kAnySpacing, TurnedPose::of(manoeuvre.start), pass.step);
  ManoeuvreRoller& roller = *pending_end.roller;
  ManoeuvreRoller past = roller;
  past.roll_past(manoeuvre.pending);
  pending_end.progress.clear_until.assign(near_.size(), -1.0);
  pending_end.progress.pose = past.at();
  pending_end.progress.time = -1.0;
  pending_end.progress.velocities = velocities_of(manoeuvre.pending);
  pending_end.free =
      roller.roll_on(manoeuvre.pending, [&](const TurnedPose&) { return free_at(roller, 0.0, pending_end.progress); });
  return pending_end.free;
}

bool MoverCheck::rolls_free(const BrakeManoeuvre& manoeuvre, const CheckPass& pass, double elsewhere,
                            PendingEnd& pending_end) {
  if (!pending_free(manoeuvre, pass, pending_end)) return false;
  ManoeuvreRoller roller = *pending_end.roller;
  progress_ = pending_end.progress;
  progress_.velocities.include(manoeuvre.command);
  return roller.roll_to_rest(manoeuvre, [&](const TurnedPose&) { return free_at(roller, elsewhere, progress_); });
}

// What lies between two poses [s].
double MoverCheck::allowance(const ManoeuvreRoller& roller) {
  return std::min(0.5 * roller.step().duration, 0.5 * kShortStep);
}

// The pose that the roller has come to, and where it stood before, the one that it has left.
bool MoverCheck::free_at(const ManoeuvreRoller& roller, double elsewhere, Progress& progress) const {
  const double begin = roller.time() - roller.step().duration;
  const bool stood = progress.time < 0.0 || begin > progress.time + kSameMoment;
  if (stood && !free_at(progress.pose, begin, roller, elsewhere, progress)) return false;
  if (!free_at(roller.at(), roller.time(), roller, elsewhere, progress)) return false;
  for (const Near& near : near_) {
    if (!near.leaves) continue;
    const bool creeps = roller.step().fastest <= kLeavesAt;
    if (!creeps || !leads_away(near, progress.pose, roller.at(), roller.time(), roller.step().duration)) return false;
    const double grown = roller.drift() + elsewhere + allowance(roller) * (roller.step().fastest + near.set.fastest());
    if (meets(near, roller.at(), roller.time(), grown, kAdvances, progress.velocities)) return false;
  }
  progress.pose = roller.at();
  progress.time = roller.time();
  return true;
}

bool MoverCheck::free_at(const TurnedPose& at, double time, const ManoeuvreRoller& roller, double elsewhere,
                         Progress& progress) const {
  const double half = 0.5 * roller.step().duration, allowed = allowance(roller);
  const double robot = roller.drift() + elsewhere + allowed * roller.step().fastest;
  for (std::size_t i = 0; i < near_.size(); ++i) {
    const Near& near = near_[i];
    if (near.leaves || time + half <= progress.clear_until[i]) continue;
    const double grown = robot + allowed * near.set.fastest();
    if (clear(near, at, time, grown, progress.clear_until[i])) continue;
    if (creep_ < 0.0 || meets(near, at, time, grown, creep_, progress.velocities)) return false;
  }
  return true;
}

// Whether the outline stays out of one of the two discs, both larger by `grown` [m]. `clear_until`: as long as what is
// left cannot be used up.
bool MoverCheck::clear(const Near& near, const TurnedPose& at, double time, double grown, double& clear_until) const {
  const ReachableSet& set = near.set;
  const double most = most_.grown + 0.5 * kLongStep * set.fastest();
  const auto apart = [&](const Point& centre, double radius, double closing) {
    const Point seen = at.seen(centre);
    double gap = seen.norm() - radius_;
    if (gap <= radius + most) gap = footprint_->distance_to(seen);
    const double left = gap - radius - most;
    if (left > 0.0) clear_until = std::max(clear_until, time + left / closing);
    return gap > radius + grown;
  };
  return apart(set.centre(time), set.radius(time), near.closing_acc) ||
         apart(set.position(), set.speed_radius(time), near.closing_speed);
}

// In a step the outline gets farther from where the obstacle is expected.
bool MoverCheck::leads_away(const Near& near, const TurnedPose& from, const TurnedPose& to, double time,
                            double step) const {
  const double before = footprint_->distance_to(from.seen(near.set.centre(time - step)));
  return footprint_->distance_to(to.seen(near.set.centre(time))) > before;
}

// Whether a place of the outline that may move outwards faster than `speed` [m/s] is in both discs, both larger by
// `grown` [m].
bool MoverCheck::meets(const Near& near, const TurnedPose& at, double time, double grown, double speed,
                       const VelocityRange& velocities) const {
  const auto within = [&](const Point& centre, double radius) {
    return advances_near(*footprint_, velocities, speed, at.seen(centre), radius + grown);
  };
  return within(near.set.centre(time), near.set.radius(time)) &&
         within(near.set.position(), near.set.speed_radius(time));
}

}  // namespace hidwa_local_planner
