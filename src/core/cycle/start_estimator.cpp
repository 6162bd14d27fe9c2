// SPDX-License-Identifier: BSD-3-Clause
#include "core/cycle/start_estimator.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/cycle/input_fault.hpp"
#include "core/motion/brake_manoeuvre.hpp"

namespace hidwa_local_planner {
namespace {

// An old pose is led on in steps of this length [m].
constexpr double kAdvanceSpacing = 0.01;

// Something holds the robot: commands fall to what could have started from the reading, in either direction.
void hold(AxisLimits& axis, double reading, double period) {
  const double most = std::abs(reading) + axis.acc * period;
  axis.max = std::max(axis.min, std::min(axis.max, most));
  axis.min = std::min(axis.max, std::max(axis.min, -most));
}

}  // namespace

CycleStart StartEstimator::estimate(const Situation& measured, const Parameters& parameters,
                                    const VelocityLimits& limits, double radius) {
  const double period = usable_period(measured), age = usable_age(measured);
  remember_command(measured, limits, parameters.control_latency + period + age);
  PendingMotion& as_commanded = pending_.first();
  commands_.play(limits, period, parameters.control_latency, age, as_commanded);
  as_commanded.mark_past(age);

  CycleStart start;
  limits_ = limits;
  likeliest_ = 0;
  judge_axis({&Twist2::v, limits_.x, odometry_.v}, measured, parameters, start);
  judge_axis({&Twist2::omega, limits_.theta, odometry_.omega}, measured, parameters, start);
  add_prompt_motions(measured, parameters, limits);
  for (const Lag& lag : kLags) {
    PendingMotion& lagging = pending_.add_lagging();
    commands_.play(limits, period, parameters.control_latency, age, lagging, lag);
    lagging.mark_past(age);
  }
  start.last_command = commands_.last();
  start.elapsed = commands_.elapsed();
  start.origin = measured.pose;
  start.limits = &limits_;
  start.pending = &pending_;
  start.situation = with_pose_of_now(measured, limits, radius);
  return start;
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

// A command starts from the last one; from a reading only where that agrees and is asked for.
void StartEstimator::judge_axis(const Axis& axis, const Situation& measured, const Parameters& parameters,
                                CycleStart& start) {
  const auto u = axis.member;
  const double last = commands_.last().*u;
  const double reading = plausible(measured.velocity) ? measured.velocity.*u : last;
  const double tolerance = reading_tolerance(parameters, commands_.last()).*u;
  const double now = usable_time(measured), heard = measured.velocity_time > 0.0 ? measured.velocity_time : now;
  const OdometryReading judged = axis.belief.judge(now, heard, reading, commands_.range(u), tolerance, axis.limits);
  const bool fast = judged == OdometryReading::faster, agrees = judged == OdometryReading::agrees;
  const bool doubted = judged == OdometryReading::doubted || judged == OdometryReading::maybe_slower;
  const bool from_reading = agrees && parameters.velocity_reference == VelocityReference::odometry;
  const double otherwise = fast ? axis.belief.believed() : reading;
  start.reference.*u = from_reading ? axis.limits.start_from(reading, last) : last;
  start.velocity.*u = doubted ? last : otherwise;
  start.odometry_doubted = start.odometry_doubted || doubted;
  start.odometry_fast = start.odometry_fast || fast;
  if (judged == OdometryReading::slower) hold(axis.limits, reading, usable_period(measured));
  const bool as_commanded = agrees && !from_reading;
  if (!as_commanded && judged != OdometryReading::doubted) add_alternative(u, otherwise, !doubted);
}

void StartEstimator::add_alternative(double Twist2::*axis, double velocity, bool likeliest) {
  if (likeliest) likeliest_ += pending_.likely();
  pending_.add_alternative(axis, velocity);
}

void StartEstimator::add_prompt_motions(const Situation& measured, const Parameters& parameters,
                                        const VelocityLimits& limits) {
  const double period = usable_period(measured), latency = parameters.control_latency;
  if (latency <= 0.0 || pending_[0].rests()) return;
  const auto count = std::min(std::ceil(latency / period), static_cast<double>(PendingMotionSet::kMostUnlikely));
  for (double part = 0.0; part < count; part += 1.0) {
    PendingMotion& prompt = pending_.add_unlikely();
    commands_.play(limits, period, latency * part / count, usable_age(measured), prompt);
    prompt.mark_past(usable_age(measured));
  }
}

// Where odometry is believed to say something else than the commands, as odometry says.
const Situation* StartEstimator::with_pose_of_now(const Situation& measured, const VelocityLimits& limits,
                                                  double radius) {
  if (usable_age(measured) <= 0.0 || !plausible(measured.pose)) return &measured;
  const Rotation heading{std::cos(measured.pose.theta), std::sin(measured.pose.theta)};
  ManoeuvreRoller roller(limits, radius, kAdvanceSpacing, {measured.pose, heading});
  roller.roll_past(pending_[likeliest_]);
  advanced_.plan.reserve(measured.plan.capacity());
  advanced_ = measured;
  advanced_.pose = roller.at().pose;
  return &advanced_;
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
