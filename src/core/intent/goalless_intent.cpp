// SPDX-License-Identifier: BSD-3-Clause
#include "core/intent/goalless_intent.hpp"

#include "core/motion/brake_manoeuvre.hpp"

namespace hidwa_local_planner {
namespace {

// A turn of 1 rad/s off the target weighs as much as a speed so far off it [m/s].
constexpr double kTurnWeight = 20.0;

constexpr double kPendingStep = 0.05;  // [s]
constexpr double kAnyDistance = 1e3;   // [m]

}  // namespace

Steering GoallessIntent::update(const Cycle& cycle) {
  IntentSearch::Request request;
  request.wanted = cycle.start.limits.clamp(cycle.intent.u_h);
  const double off =
      direction_.update(cycle.start.pose.theta, request.wanted, cycle.start.elapsed, cycle.start.limits.theta.max);
  const PendingMotionSet& all = *cycle.start.pending;
  ManoeuvreRoller roller(cycle.start.limits, cycle.footprint.circumscribed_radius(), kAnyDistance,
                         {cycle.start.origin, Rotation::of(cycle.start.origin.theta)}, kPendingStep);
  roller.roll_on(all[all.likely() - 1], [](const TurnedPose&) { return true; });
  request.start = roller.at().pose;
  const double turned = request.start.theta - cycle.start.pose.theta;
  request.off = wrap_angle(off + turned - request.wanted.omega * std::max(0.0, roller.time()));
  request.side = side_;
  const IntentSearch::Result result = search_.run(cycle, request);
  side_ = result.side;
  return {true, result.motion, 1.0, kTurnWeight};
}

bool against_operator(const Twist2& motion, const Twist2& reference, const Twist2& wanted) {
  return motion.v != 0.0 && motion.v * wanted.v <= 0.0 && motion.v * reference.v <= 0.0;
}

}  // namespace hidwa_local_planner
