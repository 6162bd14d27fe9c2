// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <chrono>
#include <cmath>
#include <string_view>

#include <tf2/exceptions.h>

#include "hidwa_local_planner/core/velocity_limits.hpp"
#include "hidwa_local_planner/ros/shell.hpp"

namespace hidwa_local_planner {
namespace {

bool same_outline(const Polygon& outline, const std::vector<geometry_msgs::Point>& points) {
  if (outline.size() != points.size()) return false;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (outline[i].x() != points[i].x || outline[i].y() != points[i].y) return false;
  }
  return true;
}

// What a host asks for may lie beyond what a parameter may be.
double in_range(const char* parameter, double value) {
  for (const ParameterInfo& info : parameter_table()) {
    if (info.name == parameter) return std::isfinite(value) ? std::clamp(value, info.min, info.max) : info.max;
  }
  return value;
}

}  // namespace

void Shell::set_plan(const std::vector<geometry_msgs::PoseStamped>& plan) {
  const bool paused = goal_checker_.plan_arrives(ros::Time::now().toSec(), control_period());
  if (plan_.set(plan) || paused) begin_goal();
  situation_.plan.reserve(plan.size());  // what no window of it outgrows
}

void Shell::begin_goal() {
  planner_.reset();
  goal_checker_.reset();
  person_.new_goal();
}

// Where the robot was carried or driven away from the goal, what was latched there is true no more.
bool Shell::check_goal(const Observation& observation, const Pose2& goal) {
  const bool latched = goal_checker_.latched();
  const bool reached =
      goal_checker_.update(observation.pose, planner_.believed(*observation.velocity), goal, planner_.parameters());
  if (latched && !goal_checker_.latched()) begin_goal();
  return reached;
}

void Shell::set_goal_tolerances(double xy, double yaw) {
  const Tolerances wanted{in_range("xy_goal_tolerance", xy), in_range("yaw_goal_tolerance", yaw)};
  if (host_tolerances_ && host_tolerances_->xy == wanted.xy && host_tolerances_->yaw == wanted.yaw) return;
  host_tolerances_ = wanted;
  if (refused_.empty()) put_in_force(in_force_);
}

bool Shell::goal_reached(bool host_stops) {
  arriving_ = false;
  const double now = ros::Time::now().toSec();
  if (person_.status(now).manual) return false;
  const Observation observation = observe(now);
  if (!observation.fault.empty()) return false;
  if (!check_goal(observation, observation.from_plan.apply(plan_.goal()))) return false;
  arriving_ = !host_stops && !at_rest_;
  if (arriving_) return false;
  plan_.finish();
  last_command_ = {};  // the host stops the robot
  return true;
}

CycleResult Shell::cycle(bool stop) {
  const auto start = std::chrono::steady_clock::now();
  const ros::Time stamp = ros::Time::now();
  const double now = stamp.toSec();
  take_parameters();
  const bool paused = watch_time(now);
  goal_checker_.cycle(now);
  watch_hand(now);
  const bool recorded = planner_.parameters().record_cycles && publishing_.cycle_wanted();
  if (publishing_.new_cycle_subscriber()) recording_.demand_key();
  recording_.begin(now, recorded);
  OperatorIntent intent = person_.update(now, recording_.before());
  const bool host_stops = stop || arriving_;
  recording_.heard(intent, host_stops);
  if (host_stops) intent.influence = Influence::stop;
  CycleResult result = work(now, intent, paused);
  explain(now, result);

  feedback_.publish(stamp, planner_.parameters(), result, intent, person_.status(now));
  if (result.decision) {
    publishing_.publish_paths(stamp, situation_.plan, result.decision->trajectory);
    if (result.sampling.check_all) publishing_.publish_evaluation(stamp, planner_);
  }
  const std::chrono::duration<double> duration = std::chrono::steady_clock::now() - start;
  publishing_.publish_cycle(stamp, result, intent.state, duration.count(), recording_.finish(result, planner_));
  statistics_.add(duration.count(), control_period());
  keep_budget(duration.count(), result);
  return result;
}

CycleResult Shell::work(double now, const OperatorIntent& intent, bool paused) {
  // Most hosts hold this recursive mutex already.
  const boost::unique_lock<costmap_2d::Costmap2D::mutex_t> lock(*costmap_.getCostmap()->getMutex());
  const Observation observation = observe(now);
  if (paused) resume(now);
  Sampling sampling = budget_.in_force();
  sampling.check_all = publishing_.candidates_wanted();
  CycleResult result =
      observation.fault.empty() ? decide(now, observation, intent, sampling) : brake(now, observation, intent);
  result.sampling = sampling;
  remember(now, result, observation);
  return result;
}

// While the host was in control it sent commands of its own, or another node did. What odometry agrees on is where the
// next command starts from, within the limits.
void Shell::resume(double now) {
  const Parameters& p = planner_.parameters();
  resumed_ = true;
  last_command_ = VelocityLimits::from(p).clamp(odometry_.settled(now, p.odom_timeout, p).value_or(Twist2{}));
}

// Where the hand is a tf frame: what cannot be had is silence, and told as such.
void Shell::watch_hand(double now) {
  const Parameters& p = planner_.parameters();
  if (p.mode != OperatorMode::gesture || p.gesture_frame.empty()) return;
  try {
    person_.receive(tf_.lookupTransform(p.gesture_parent_frame, p.gesture_frame, ros::Time(0)), now);
  } catch (const tf2::TransformException&) {
  }
}

bool Shell::watch_time(double now) {
  const CycleClock::Tick tick = clock_.tick(now, control_period());
  interval_ = tick.paused ? 0.0 : tick.interval;
  if (tick.jumped_back) {
    // The person's machine notices by itself: a stop goes on, and whoever has control keeps it.
    ROS_WARN("%s: time jumped back; starting anew", name_.c_str());
    odometry_.forget();
    fault_brake_.clear();
    explanations_.end();
  }
  const std::string complaint = clock_.complaint();
  if (!complaint.empty()) ROS_WARN("%s: %s", name_.c_str(), complaint.c_str());
  return tick.paused;
}

Shell::Observation Shell::observe(double now) {
  Observation observation;
  OdometryInput::Reading odometry = odometry_.read(now, planner_.parameters().odom_timeout);
  observation.velocity = odometry.velocity;
  const auto lacks = [&observation](Missing what, std::string fault) {
    if (!fault.empty()) observation.missing = what;
    observation.fault = std::move(fault);
    return observation.missing != Missing::nothing;
  };
  if (lacks(Missing::parameters, refused_) || lacks(Missing::plan, plan_.fault())) return observation;
  if (!observation.velocity) {
    lacks(Missing::odometry, std::move(odometry.fault));
  } else if (!costmap_.isCurrent()) {
    lacks(Missing::costmap, "the local costmap is not current: a sensor that it waits for is silent");
  } else if (!lacks(Missing::transform, observe_pose(now, observation))) {
    lacks(Missing::footprint, update_footprint());
  }
  return observation;
}

std::string Shell::observe_pose(double now, Observation& observation) {
  const std::string& frame = costmap_.getGlobalFrameID();
  geometry_msgs::PoseStamped pose;
  if (!costmap_.getRobotPose(pose)) {
    return "the robot's pose in " + frame + " cannot be had: check the transform from " + costmap_.getBaseFrameID();
  }
  observation.pose = to_pose(pose.pose);
  if (!pose.header.stamp.isZero()) observation.pose_age = std::max(0.0, now - pose.header.stamp.toSec());
  if (!is_finite(observation.pose)) return "the robot's pose in " + frame + " is not a number";
  if (plan_.frame() == frame) return "";
  try {
    const geometry_msgs::TransformStamped transform = tf_.lookupTransform(frame, plan_.frame(), ros::Time(0));
    const double age = transform.header.stamp.isZero() ? 0.0 : now - transform.header.stamp.toSec();
    if (age > planner_.parameters().transform_tolerance) {
      return "the transform from the plan's frame " + plan_.frame() + " to " + frame + " is " + std::to_string(age) +
             " s old (transform_tolerance)";
    }
    observation.from_plan = to_transform(transform.transform);
    return is_finite(observation.from_plan.origin) ? "" : "the transform from " + plan_.frame() + " is not a number";
  } catch (const tf2::TransformException& error) {
    return "no transform from the plan's frame " + plan_.frame() + " to " + frame + ": " + error.what();
  }
}

std::string Shell::update_footprint() {
  // Others may set it meanwhile. In a cycle the lock is held already; at start it is not.
  const boost::unique_lock<costmap_2d::Costmap2D::mutex_t> lock(*costmap_.getCostmap()->getMutex());
  const auto& points = costmap_.getRobotFootprint();
  if (points.empty()) return "the local costmap has no footprint: set robot_radius or footprint";
  if (!same_outline(outline_, points)) {
    outline_ = to_polygon(points);
    recording_.demand_key();
    planner_.set_footprint(outline_);
    if (planner_.footprint().fault() == nullptr) check_horizon();
  }
  const char* fault = planner_.footprint().fault();
  return fault != nullptr ? fault : "";
}

CycleResult Shell::brake(double now, const Observation& observation, const OperatorIntent& intent) {
  CycleResult result;
  result.missing = observation.missing;
  result.fault = observation.fault;
  recording_.brakes(planner_, outline_, fault_brake_,
                    {{}, observation.velocity, last_command_, brake_period(), observation.fault});
  const FaultBrake::Answer answer =
      fault_brake_.answer(now, observation.velocity, last_command_, planner_.parameters(), brake_period());
  result.outcome = outcome_of(answer, intent);
  result.command = answer.command;
  return result;
}

CycleResult Shell::decide(double now, const Observation& observation, const OperatorIntent& intent,
                          const Sampling& sampling) {
  fault_brake_.clear();
  const Parameters& p = planner_.parameters();
  const double ahead = p.forward_prune_auto ? std::max(p.forward_prune_distance, 1.2 * p.max_vel_x * p.sim_time)
                                            : p.forward_prune_distance;
  situation_.pose = observation.pose;
  situation_.velocity = *observation.velocity;
  situation_.last_command = last_command_;
  situation_.goal = observation.from_plan.apply(plan_.goal());
  situation_.period = control_period();
  situation_.longest_period = clock_.longest_period(situation_.period);
  situation_.pose_age = observation.pose_age;
  situation_.resumed = resumed_;
  resumed_ = false;
  situation_.time = now;
  plan_.window(observation.from_plan, observation.pose, p.prune_distance, ahead, situation_.plan);
  check_goal(observation, situation_.goal);
  situation_.goal_latched = goal_checker_.latched();

  const GridView grid = view_of(*costmap_.getCostmap());
  recording_.plans(planner_, outline_, situation_, grid, sampling);
  CycleResult result;
  result.decision = &planner_.plan(situation_, grid, intent, sampling);
  result.outcome = result.decision->outcome;
  watch_odometry(observation, *result.decision);
  if (result.outcome != Outcome::fail) result.command = result.decision->command;
  return result;
}

void Shell::watch_odometry(const Observation& observation, const Decision& decision) {
  if (!decision.odometry_doubted && !decision.odometry_fast) return;
  if (decision.odometry_doubted) ++doubted_;
  const Twist2& u = *observation.velocity;
  ROS_WARN_THROTTLE(2.0,
                    "%s: odometry says %.2f m/s, %.2f rad/s, faster than the commands explain: %s (%lu readings were "
                    "doubted so far); look at the odometry, or at who pushes or drives the robot",
                    name_.c_str(), u.v, u.omega,
                    decision.odometry_fast ? "believed for collisions, since it lasts" : "not believed",
                    static_cast<unsigned long>(doubted_));
}

void Shell::remember(double now, const CycleResult& result, const Observation& observation) {
  last_command_ = result.command;  // zero on failure: so the host does
  const Parameters& p = planner_.parameters();
  input::CycleFeedback feedback;
  feedback.command = result.command;
  feedback.velocity = observation.velocity.value_or(Twist2{});
  feedback.at_rest = result.command == Twist2{} && std::abs(feedback.velocity.v) <= p.trans_stopped_velocity &&
                     std::abs(feedback.velocity.omega) <= p.rot_stopped_velocity;
  feedback.own_command_refused = result.decision && !result.decision->operator_refused_by.empty();
  feedback.goal_latched = goal_checker_.latched();
  at_rest_ = feedback.at_rest;
  person_.debrief(now, feedback);
}

void Shell::explain(double now, const CycleResult& result) {
  const bool refused = result.decision && (result.outcome == Outcome::brake || result.outcome == Outcome::fail);
  const bool escaping = result.decision && !refused && result.decision->escaping;
  const std::string_view what = refused    ? std::string_view(result.decision->problem)
                                : escaping ? kEscapes
                                           : std::string_view(result.fault);
  if (what.empty()) {
    if (explanations_.end()) ROS_INFO("%s: driving again", name_.c_str());
    return;
  }
  if (!explanations_.due(now, what)) return;
  const std::string message = refused ? refusals_in_words(*result.decision) : std::string(what);
  const char* consequence = result.outcome == Outcome::fail    ? "; the robot stands, the host replans or recovers"
                            : result.outcome == Outcome::brake ? "; braking"
                                                               : "";
  ROS_WARN("%s: %s%s", name_.c_str(), message.c_str(), consequence);
}

// Fewer samples rather than a missed rate. A cycle that weighed nothing says nothing about their cost.
void Shell::keep_budget(double duration, const CycleResult& result) {
  if (result.decision && result.decision->candidates > 0) {
    const SampleBudget::Event event = budget_.observe(duration, cycle_budget());
    if (event == SampleBudget::Event::thinning_began) {
      ROS_WARN("%s: %s", name_.c_str(), thinning_complaint(budget_.in_force(), budget_.full(), cycle_budget()).c_str());
    } else if (event == SampleBudget::Event::thinning_ended) {
      ROS_INFO("%s: all %d x %d samples are tried again", name_.c_str(), budget_.full().vx_samples,
               budget_.full().vth_samples);
    }
  }
  diagnostics_->set(result.fault, load());
}

}  // namespace hidwa_local_planner
