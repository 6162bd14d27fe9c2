// SPDX-License-Identifier: BSD-3-Clause
#include "control/prediction.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "core/motion/velocity_limits.hpp"
#include "core/util/words.hpp"
#include "hidwa_local_planner/core/rest.hpp"

namespace hidwa_local_planner::control {
namespace {

constexpr double kOwnChoice = 0.5;    // [s], for so long the chosen rollout is followed
constexpr double kLookAhead = 0.8;    // [s], the pursued point is so far ahead at the robot's speed ...
constexpr double kLeastAhead = 0.35;  // [m], and at least so far
constexpr double kTurn = 0.35;        // [rad], from here on a change of heading is a turn (20 degrees)
constexpr double kMoves = 0.02;       // [m], a point that is nearer is reached
constexpr double kTurnsFirst = 1.05;  // [rad], a point farther aside is turned to on the spot (60 degrees)

bool blocks(const GridView& grid, const Point& p) {
  return grid.holds(p) && cost::blocks(grid.at(grid.cell_at(p.x(), p.y())));
}

// Of a unicycle: midpoint rule.
Pose2 moved(const Pose2& q, const Twist2& u, double dt) {
  const double middle = q.theta + 0.5 * u.omega * dt;
  return {q.x + u.v * dt * std::cos(middle), q.y + u.v * dt * std::sin(middle), wrap_angle(q.theta + u.omega * dt)};
}

}  // namespace

const char* to_string(NextMove move) {
  switch (move) {
    case NextMove::straight:
      return "straight";
    case NextMove::left:
      return "left";
    case NextMove::right:
      return "right";
    case NextMove::stop:
      return "stop";
    case NextMove::recover:
      return "recover";
  }
  return "";
}

void Prediction::update(const ControlLoop& loop, const Observation& observation, const Result& result) {
  poses_.clear();
  reason_.clear();
  next_ = NextMove::stop;
  rests_ = false;
  if (result.decision == nullptr || !observation.velocity) {
    reason_ = observation.fault;
    return;
  }
  if (observation.goalless) {
    reason_ = "there is no goal";
    return;
  }
  // A robot that stops does so wherever it is, and where it is may be no number.
  if (result.decision->problem_kind == Problem::input || !is_finite(observation.pose)) {
    reason_ = result.decision->problem;
    return;
  }
  lay_out(loop, observation);
  find_end(observation, loop.planner().footprint().inscribed_radius());
  roll_out(loop, observation, result);
  name_next(loop, result);
}

// As far as the robot gets within the horizon, and what it looks ahead.
void Prediction::lay_out(const ControlLoop& loop, const Observation& observation) {
  const double reach = loop.parameters().max_vel_x * (kHorizon + kLookAhead) + kLeastAhead;
  ahead_.clear();
  arc_.clear();
  at_ = 0;
  for (std::size_t k = loop.next_plan_pose(); k < loop.plan().size(); ++k) {
    const Pose2 pose = observation.from_plan.apply(loop.plan()[k]);
    if (!is_finite(pose)) break;
    const Point point(pose.x, pose.y);
    arc_.push_back(ahead_.empty() ? 0.0 : arc_.back() + (point - ahead_.back()).norm());
    ahead_.push_back(point);
    if (arc_.back() > reach) break;
  }
}

// Where the plan ends, or where a robot in its middle would touch something.
void Prediction::find_end(const Observation& observation, double inscribed_radius) {
  end_ = arc_.empty() ? 0.0 : arc_.back();
  blocked_ = false;
  for (std::size_t k = 0; k < ahead_.size() && !blocked_; ++k) {
    if (arc_[k] < inscribed_radius || !blocks(observation.costmap, ahead_[k])) continue;
    blocked_ = true;
    end_ = arc_[k];
  }
}

void Prediction::roll_out(const ControlLoop& loop, const Observation& observation, const Result& result) {
  const Decision& decision = *result.decision;
  const Parameters& p = loop.parameters();
  const VelocityLimits& limits = loop.planner().limits();
  braking_ = limits.x.braking;
  Robot robot{observation.pose, result.command, 0.0};
  poses_.push_back({robot.pose, 0.0});
  const bool own = result.intent.influence == Influence::none && result.outcome == Outcome::drive;
  if (own) follow_choice(decision, p.sim_time, robot);
  // A robot that is stuck does what its way wants, which nobody can foresee from the plan.
  if (decision.recovering || decision.waiting || result.outcome == Outcome::fail) return;
  const auto steps = static_cast<std::size_t>(std::lround(kHorizon / kStep));
  while (poses_.size() <= steps) {
    const bool turns = loop.situation().goal_latched;
    robot.velocity = limits.step(robot.velocity, turns ? turn_to_goal(robot, loop) : pursue(robot, p), kStep);
    robot.pose = moved(robot.pose, robot.velocity, kStep);
    robot.time += kStep;
    poses_.push_back({robot.pose, robot.time});
  }
  rests_ = commands_rest(robot.velocity);
}

// The rollout's poses are `step` apart in time.
void Prediction::follow_choice(const Decision& decision, double longest, Robot& robot) {
  if (decision.trajectory.size() < 2 || !(decision.step > 0.0)) return;
  const double last =
      std::min({kOwnChoice, longest, decision.step * static_cast<double>(decision.trajectory.size() - 1)});
  for (double t = kStep; t <= last + 1e-9; t += kStep) {
    const double at = t / decision.step;
    const auto k = std::min(static_cast<std::size_t>(at), decision.trajectory.size() - 2);
    const Pose2& a = decision.trajectory[k];
    const Pose2& b = decision.trajectory[k + 1];
    const double share = at - static_cast<double>(k);
    robot.pose = {a.x + share * (b.x - a.x), a.y + share * (b.y - a.y),
                  wrap_angle(a.theta + share * wrap_angle(b.theta - a.theta))};
    robot.velocity = decision.sample;
    robot.time = t;
    poses_.push_back({robot.pose, t});
  }
}

// At the goal's position the heading is left.
Twist2 Prediction::turn_to_goal(const Robot& robot, const ControlLoop& loop) const {
  const double left = wrap_angle(loop.situation().goal.theta - robot.pose.theta);
  const Parameters& p = loop.parameters();
  if (!(std::abs(left) > p.yaw_goal_tolerance)) return {};
  return {0.0, std::copysign(std::min(p.max_vel_theta, std::abs(left) / kStep), left)};
}

Twist2 Prediction::pursue(const Robot& robot, const Parameters& p) {
  if (ahead_.empty()) return {};
  const Point here(robot.pose.x, robot.pose.y);
  while (at_ + 1 < ahead_.size() && (ahead_[at_ + 1] - here).norm() <= (ahead_[at_] - here).norm()) ++at_;
  const double look = std::max(kLeastAhead, kLookAhead * std::abs(robot.velocity.v));
  std::size_t target = at_;
  while (target + 1 < ahead_.size() && arc_[target] < arc_[at_] + look) ++target;
  const Point to = ahead_[target] - here;
  const double left = end_ - arc_[at_];
  if (left <= 0.0 || to.norm() < kMoves) return {};
  const double bearing = wrap_angle(std::atan2(to.y(), to.x()) - robot.pose.theta);
  // The plan leads back: it turns first.
  if (std::abs(bearing) > kTurnsFirst) return {0.0, std::copysign(p.max_vel_theta, bearing)};
  const double curvature = 2.0 * std::sin(bearing) / to.norm();
  double v = std::min(p.max_vel_x, std::sqrt(2.0 * braking_ * left));
  if (std::abs(curvature) * v > p.max_vel_theta) v = p.max_vel_theta / std::abs(curvature);
  return {v, curvature * v};
}

void Prediction::name_next(const ControlLoop& loop, const Result& result) {
  const Decision& decision = *result.decision;
  const bool latched = loop.situation().goal_latched;
  const double turn = wrap_angle(poses_.back().pose.theta - poses_.front().pose.theta);
  if (decision.waiting) {
    reason_ = "it waits for what moves to go";
  } else if (decision.recovering) {
    next_ = NextMove::recover;
    reason_ = "autonomy is stuck: it searches a way for its outline, or follows one";
  } else if (result.outcome == Outcome::fail || result.outcome == Outcome::brake) {
    reason_ = decision.problem;
  } else if (rests_ && !(latched && std::abs(turn) >= kTurn)) {
    reason_ = blocked_ ? "an obstacle is on the plan" : "it comes to the goal";
  } else if (std::abs(turn) >= kTurn) {
    next_ = turn > 0.0 ? NextMove::left : NextMove::right;
    if (latched) reason_ = "it turns to the goal's heading";
  } else {
    next_ = NextMove::straight;
  }
}

}  // namespace hidwa_local_planner::control
