// SPDX-License-Identifier: BSD-3-Clause
#include "core/cycle/start_estimator.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/cycle/input_fault.hpp"
#include "core/motion/brake_manoeuvre.hpp"

namespace hidwa_local_planner {
namespace {

// The control period, or the default one where it cannot be one; the time and the pose's age, or 0 where they cannot be
// any [s]. The cycle brakes there, since its input has a fault.
double usable_period(const Situation& s) { return plausible_period(s.period) ? s.period : Situation().period; }
double usable_time(const Situation& s) { return plausible_time(s.time) ? s.time : 0.0; }
double usable_age(const Situation& s) { return plausible_age(s.pose_age) ? s.pose_age : 0.0; }
double longest_period(const Situation& s) {
  return s.longest_period > s.period && plausible_period(s.longest_period) ? s.longest_period : s.period;
}

// An old pose is led on in steps of this length [m].
constexpr double kAdvanceSpacing = 0.01;

// Something holds the robot: commands fall to what could have started from the reading, in either direction.
void hold(AxisLimits& axis, double reading, double period) {
  const double most = std::abs(reading) + axis.acc * period;
  axis.max = std::max(axis.min, std::min(axis.max, most));
  axis.min = std::min(axis.max, std::max(axis.min, -most));
}

}  // namespace

const CycleStart& StartEstimator::estimate(const Situation& measured, const Parameters& parameters,
                                           const VelocityLimits& limits, const BlindMotion& blind, double radius) {
  const double period = usable_period(measured), age = usable_age(measured), latency = parameters.control_latency;
  remember_command(measured, limits, latency + period + age);
  PendingMotion& as_commanded = pending_.first();
  commands_.play(limits, period, latency, age, as_commanded);
  as_commanded.mark_past(age);

  start_ = {};
  start_.origin = measured.pose;
  start_.last_command = commands_.last();
  start_.limits = limits;
  start_.pending = &pending_;
  start_.period = period;
  start_.longest_period = longest_period(measured);
  start_.elapsed = commands_.elapsed();
  likeliest_ = 0;
  judge_axis({&Twist2::v, start_.limits.x, odometry_.v}, measured, parameters);
  judge_axis({&Twist2::omega, start_.limits.theta, odometry_.omega}, measured, parameters);
  add_prompt_motions(age, latency, limits);
  for (const Lag& lag : kLags) {
    PendingMotion& lagging = pending_.add_lagging();
    commands_.play(limits, period, latency, age, lagging, lag);
    lagging.mark_past(age);
  }
  start_.limits = blind.narrowed(start_.limits);
  start_.pose = pose_of_now(age, limits, radius);
  return start_;
}

// A command that was never a number counts as none; what lies beyond the limits is brought back by the window.
void StartEstimator::remember_command(const Situation& measured, const VelocityLimits& limits, double span) {
  const Twist2 last = plausible(measured.last_command) ? measured.last_command : Twist2{};
  if (measured.resumed) {
    commands_.forget();
    odometry_.forget();
  }
  commands_.observe(usable_time(measured), usable_period(measured), span, last, limits);
}

// How old the next pose will be, and so how much of the past matters then, is not known.
void StartEstimator::skip(const Situation& measured, const VelocityLimits& limits) {
  remember_command(measured, limits, std::numeric_limits<double>::infinity());
}

// A command starts from the last one; in the paper's method from a reading that agrees.
void StartEstimator::judge_axis(const Axis& axis, const Situation& measured, const Parameters& parameters) {
  const auto u = axis.member;
  const double last = start_.last_command.*u;
  const double reading = plausible(measured.velocity) ? measured.velocity.*u : last;
  const double tolerance = reading_tolerance(parameters, start_.last_command).*u;
  const double now = usable_time(measured), heard = measured.velocity_time > 0.0 ? measured.velocity_time : now;
  const OdometryReading judged = axis.belief.judge(now, heard, reading, commands_.range(u), tolerance, axis.limits);
  const bool fast = judged == OdometryReading::faster, agrees = judged == OdometryReading::agrees;
  const bool doubted = judged == OdometryReading::doubted || judged == OdometryReading::maybe_slower;
  const bool from_reading = agrees && parameters.method == Method::paper;
  const double otherwise = fast ? axis.belief.believed() : reading;
  start_.reference.*u = from_reading ? axis.limits.start_from(reading, last) : last;
  start_.velocity.*u = doubted ? last : otherwise;
  start_.odometry_doubted = start_.odometry_doubted || doubted;
  start_.odometry_fast = start_.odometry_fast || fast;
  if (judged == OdometryReading::slower) hold(axis.limits, reading, start_.period);
  const bool as_commanded = agrees && !from_reading;
  if (!as_commanded && judged != OdometryReading::doubted) add_alternative(u, otherwise, !doubted);
}

void StartEstimator::add_alternative(double Twist2::*axis, double velocity, bool likeliest) {
  if (likeliest) likeliest_ += pending_.likely();
  pending_.add_alternative(axis, velocity);
}

void StartEstimator::add_prompt_motions(double age, double latency, const VelocityLimits& limits) {
  if (latency <= 0.0 || pending_[0].rests()) return;
  const auto count = std::min(std::ceil(latency / start_.period), static_cast<double>(PendingMotionSet::kMostUnlikely));
  for (double part = 0.0; part < count; part += 1.0) {
    PendingMotion& prompt = pending_.add_unlikely();
    commands_.play(limits, start_.period, latency * part / count, age, prompt);
    prompt.mark_past(age);
  }
}

// Where odometry is believed to say something else than the commands, as odometry says.
Pose2 StartEstimator::pose_of_now(double age, const VelocityLimits& limits, double radius) const {
  const Pose2& measured = start_.origin;
  if (age <= 0.0 || !plausible(measured)) return measured;
  const Rotation heading = Rotation::direction(measured.theta);
  ManoeuvreRoller roller(limits, radius, kAdvanceSpacing, {measured, heading});
  roller.roll_past(pending_[likeliest_]);
  return roller.at().pose;
}

Twist2 StartEstimator::believed(const Twist2& measured, const Parameters& parameters) const {
  const auto axis = [&](double Twist2::*u, const AxisBelief& belief) {
    const double last = commands_.last().*u;
    if (!std::isfinite(measured.*u)) return last;
    return belief.believed(measured.*u, commands_.range(u), reading_tolerance(parameters, commands_.last()).*u, last);
  };
  return {axis(&Twist2::v, odometry_.v), axis(&Twist2::omega, odometry_.omega)};
}

}  // namespace hidwa_local_planner
