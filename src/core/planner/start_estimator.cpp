// SPDX-License-Identifier: BSD-3-Clause
#include "core/planner/start_estimator.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/motion/brake_manoeuvre.hpp"
#include "core/planner/input_fault.hpp"

namespace hidwa_local_planner {
namespace {

// An old pose is led on in steps of this length [m].
constexpr double kAdvanceSpacing = 0.01;

}  // namespace

CycleStart StartEstimator::estimate(const Situation& measured, const Parameters& parameters,
                                    const VelocityLimits& limits, double radius) {
  const double period = usable_period(measured), age = usable_age(measured);
  remember_command(measured, limits, parameters.control_latency + period + age);
  PendingMotion& as_commanded = pending_.first();
  commands_.play(limits, period, parameters.control_latency, age, as_commanded);
  as_commanded.mark_past(age);

  CycleStart start;
  start.reference = commands_.next_start(limits, period, as_commanded.end());
  judge_axis({&Twist2::v, limits.x, odometry_.v}, measured, parameters, start);
  judge_axis({&Twist2::omega, limits.theta, odometry_.omega}, measured, parameters, start);
  add_prompt_motions(measured, parameters, limits);
  start.last_command = commands_.last();
  start.elapsed = commands_.elapsed();
  start.origin = measured.pose;
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

// A command starts from the last one, or from where odometry is slower; never from a reading that is faster.
void StartEstimator::judge_axis(const Axis& axis, const Situation& measured, const Parameters& parameters,
                                CycleStart& start) {
  const auto u = axis.member;
  const double last = commands_.last().*u;
  const double reading = plausible(measured.velocity) ? measured.velocity.*u : last;
  const double tolerance = reading_tolerance(parameters, commands_.last()).*u;
  const OdometryReading judged =
      axis.belief.judge(usable_time(measured), reading, commands_.range(u), tolerance, axis.limits);
  const bool doubted = judged == OdometryReading::doubted, fast = judged == OdometryReading::faster;
  const bool as_commanded =
      judged == OdometryReading::agrees && parameters.velocity_reference == VelocityReference::command;
  // What the base is taken to have reached lies between what was sent and what is measured.
  const double reached = std::clamp(start.reference.*u, std::min(last, reading), std::max(last, reading));
  start.reference.*u = axis.limits.start_from(doubted || fast ? last : as_commanded ? reached : reading, last);
  start.velocity.*u = doubted ? last : fast ? axis.belief.believed() : reading;
  start.odometry_doubted = start.odometry_doubted || doubted;
  start.odometry_fast = start.odometry_fast || fast;
  if (!doubted && !as_commanded) pending_.add_alternative(u, start.velocity.*u);
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

// Where odometry is slower than the commands, as odometry says: that motion is the last of the likely ones.
const Situation* StartEstimator::with_pose_of_now(const Situation& measured, const VelocityLimits& limits,
                                                  double radius) {
  if (usable_age(measured) <= 0.0 || !plausible(measured.pose)) return &measured;
  const Rotation heading{std::cos(measured.pose.theta), std::sin(measured.pose.theta)};
  ManoeuvreRoller roller(limits, radius, kAdvanceSpacing, {measured.pose, heading});
  roller.roll_past(pending_[pending_.likely() - 1]);
  advanced_.plan.reserve(measured.plan.capacity());
  advanced_ = measured;
  advanced_.pose = roller.at().pose;
  return &advanced_;
}

Twist2 StartEstimator::believed(const Twist2& measured, const Parameters& parameters) const {
  const auto axis = [&](double Twist2::*u, const AxisBelief& belief) {
    if (!std::isfinite(measured.*u)) return commands_.last().*u;
    const bool fast =
        faster_than_explained(measured.*u, commands_.range(u), reading_tolerance(parameters, commands_.last()).*u);
    return !fast ? measured.*u : belief.sure() ? belief.believed() : commands_.last().*u;
  };
  return {axis(&Twist2::v, odometry_.v), axis(&Twist2::omega, odometry_.omega)};
}

}  // namespace hidwa_local_planner
