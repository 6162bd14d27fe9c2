// SPDX-License-Identifier: BSD-3-Clause
#include "core/intent/goalless_intent.hpp"

namespace hidwa_local_planner {
namespace {

// Weight of a deviation of the turn: 1 rad/s counts as much as this deviation of the speed [m/s].
constexpr double kTurnWeight = 20.0;

}  // namespace

Steering GoallessIntent::update(const Cycle& cycle) {
  IntentSearch::Request request;
  request.wanted = cycle.start.limits.clamp(cycle.intent.u_h);
  const double off =
      direction_.update(cycle.start.pose.theta, request.wanted, cycle.start.elapsed, cycle.start.limits.theta.max);
  const CommandStart from = cycle.start.command_start(cycle.footprint.circumscribed_radius());
  request.start = from.at.pose;
  const double turned = request.start.theta - cycle.start.pose.theta;
  request.off = wrap_angle(off + turned - request.wanted.omega * from.delay);
  request.side = side_;
  const IntentSearch::Result result = search_.run(cycle, request);
  side_ = result.side;
  return {true, result.motion, 1.0, kTurnWeight};
}

bool against_operator(const Twist2& motion, const Twist2& reference, const Twist2& wanted) {
  return motion.v != 0.0 && motion.v * wanted.v <= 0.0 && motion.v * reference.v <= 0.0;
}

}  // namespace hidwa_local_planner
