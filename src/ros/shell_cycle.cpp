// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <chrono>
#include <cmath>
#include <string>
#include <string_view>
#include <utility>

#include <tf2/exceptions.h>

#include "core/util/words.hpp"
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

// A host may ask for a value beyond the parameter's range.
double in_range(const std::string& parameter, double value) {
  const ParameterInfo& info = parameter_info(parameter);
  return std::isfinite(value) ? std::clamp(value, info.min, info.max) : info.max;
}

}  // namespace

void Shell::set_plan(const std::vector<geometry_msgs::PoseStamped>& plan) {
  PlanMessage read = read_plan(plan);
  plan_fault_ = read.fault;
  const double now = LoopTime::now().seconds;
  if (!read.fault.empty()) return loop_.drop_plan(now, control_period());
  if (std::isnan(read.poses.back().theta)) {
    ROS_WARN_ONCE("%s: the plan's last orientation is all zeros, which is no heading: at the goal any heading will do",
                  name_.c_str());
  }
  loop_.set_plan(std::move(read.poses), read.frame, now, control_period());
}

void Shell::set_goal_tolerances(double xy, double yaw) {
  const Tolerances wanted{in_range("xy_goal_tolerance", xy), in_range("yaw_goal_tolerance", yaw)};
  if (host_tolerances_ && host_tolerances_->xy == wanted.xy && host_tolerances_->yaw == wanted.yaw) return;
  host_tolerances_ = wanted;
  if (parameters_fault_.empty()) put_in_force(in_force_);
}

bool Shell::goal_reached(bool host_stops) {
  arriving_ = false;
  CycleClock::Tick none;
  none.period = control_period();
  const LoopTime now = LoopTime::now();
  const Observation observation = observe(now, timing(now.seconds, none));
  if (!loop_.goal_reached(observation, person_.manual())) return false;
  arriving_ = !host_stops && !loop_.stands();
  if (arriving_) return false;
  loop_.finish_goal(observation.timing);
  return true;
}

CycleResult Shell::cycle(bool stop) {
  const auto start = std::chrono::steady_clock::now();
  const LoopTime time = LoopTime::now();
  const double now = time.seconds;
  silence_ = std::chrono::duration<double>(start - called_).count();
  called_ = start;
  take_parameters();
  const CycleClock::Tick tick = watch_time(now);
  watch_hand(time);
  recorded_ = loop_.parameters().record_cycles && publishing_.cycle_wanted();
  if (publishing_.new_cycle_subscriber() || !recorded_) recorder_.demand_key();
  const CycleResult result = work(time, tick, stop || arriving_);
  explain(now, result);

  feedback_.publish(time.stamp, loop_.parameters(), result, watched_ ? &prediction_ : nullptr, person_.status(now));
  if (watched_) publishing_.publish_prediction(time.stamp, prediction_.poses());
  if (result.decision) {
    publishing_.publish_paths(time.stamp, loop_.situation().plan, result.decision->trajectory);
    if (result.sampling.report != Report::chosen) publishing_.publish_evaluation(time.stamp, loop_.planner());
  }
  const std::chrono::duration<double> duration = std::chrono::steady_clock::now() - start;
  publishing_.publish_cycle(time.stamp, result, result.intent.state, duration.count(),
                            recorded_ ? &recorder_.finish(result, loop_.planner()) : nullptr);
  statistics_.add(duration.count(), tick.period);
  watch_sender();
  keep_budget(duration.count(), tick.period, result);
  return result;
}

CycleResult Shell::work(const LoopTime& now, const CycleClock::Tick& tick, bool host_stops) {
  // Most hosts hold this recursive mutex already.
  const boost::unique_lock<costmap_2d::Costmap2D::mutex_t> lock(*costmap_.getCostmap()->getMutex());
  Observation observation = observe(now, timing(now.seconds, tick));
  if (host_was_away(tick, silence_)) observation.resumed = velocity_after_pause(now.seconds);
  observation.host_stops = host_stops;
  observation.costmap = view_of(*costmap_.getCostmap());
  CycleResult result;
  result.sampling = sampling();
  if (loop_.goal_begins()) person_.new_goal();
  const OperatorIntent intent = person_.update(now.seconds, recorded_ ? &recorder_.operator_state() : nullptr);
  if (recorded_) recorder_.begin(loop_, observation, result.sampling);
  static_cast<control::Result&>(result) = loop_.step(observation, intent, result.sampling);
  person_.debrief(now.seconds, result.feedback);
  watched_ = publishing_.prediction_wanted() || feedback_.state_wanted();
  if (watched_) prediction_.update(loop_, observation, result);
  result.missing = observation.missing;
  result.fault = observation.fault;
  if (result.decision) watch_odometry(observation, *result.decision);
  if (observation.velocity) {
    response_.add(observation.timing.now, tick.period, loop_.last_command(), observation.velocity_time,
                  *observation.velocity);
  }
  return result;
}

// During a pause the host or another node may have sent commands.
Twist2 Shell::velocity_after_pause(double now) const {
  const Parameters& p = loop_.parameters();
  return odometry_.settled(now, p.odom_timeout, p).value_or(Twist2{});
}

Sampling Shell::sampling() const {
  Sampling sampling = budget_.in_force();
  if (publishing_.candidates_wanted()) sampling.report = Report::legality;
  return sampling;
}

// The hand as a tf frame. A transform that cannot be looked up counts as silence of the device.
void Shell::watch_hand(const LoopTime& now) {
  const Parameters& p = loop_.parameters();
  if (p.mode != OperatorMode::gesture || p.gesture_frame.empty()) return;
  try {
    person_.receive(tf_.lookupTransform(p.gesture_parent_frame, p.gesture_frame, ros::Time(0)), now);
  } catch (const tf2::TransformException&) {
  }
}

CycleClock::Tick Shell::watch_time(double now) {
  const CycleClock::Tick tick = clock_.tick(now, control_period(), loop_.last_cycle());
  if (tick.jumped_back) {
    // The operator's state machine notices that itself: a stop goes on, and an operator who has control keeps it.
    ROS_WARN("%s: time jumped back: odometry from before is forgotten", name_.c_str());
    odometry_.forget();
    moving_obstacles_.forget();
    explanations_.end();
  }
  const std::string complaint = clock_.complaint();
  if (!complaint.empty()) ROS_WARN("%s: %s", name_.c_str(), complaint.c_str());
  return tick;
}

// The host's frequency may change meanwhile: a cycle asks for the period once.
control::Timing Shell::timing(double now, const CycleClock::Tick& tick) const {
  return {now, tick.period, clock_.longest_period(tick.period), tick.paused ? 0.0 : tick.interval, tick.jumped_back};
}

Shell::Observation Shell::observe(const LoopTime& now, const control::Timing& timing) {
  Observation observation;
  observation.timing = timing;
  OdometryInput::Reading odometry = odometry_.read(timing.now, loop_.parameters().odom_timeout);
  observation.velocity = odometry.velocity;
  observation.velocity_time = odometry.received;
  const auto lacks = [&observation](Missing what, std::string fault) {
    if (!fault.empty()) observation.missing = what;
    observation.fault = std::move(fault);
    return observation.missing != Missing::nothing;
  };
  if (lacks(Missing::parameters, parameters_fault_) || lacks(Missing::plan, plan_fault_)) return observation;
  if (!observation.velocity) {
    lacks(Missing::odometry, std::move(odometry.fault));
  } else if (!costmap_.isCurrent()) {
    lacks(Missing::costmap, "the local costmap is not current: a sensor that it waits for is silent");
  } else if (!lacks(Missing::transform, observe_pose(now, timing, observation))) {
    lacks(Missing::footprint, update_footprint());
  }
  if (observation.missing == Missing::nothing) {
    moving_obstacles_.read(timing.now, loop_.parameters().moving_obstacle_timeout, tf_, costmap_.getGlobalFrameID(),
                           observation.moving_obstacles);
  }
  return observation;
}

std::string Shell::observe_pose(const LoopTime& now, const control::Timing& timing, Observation& observation) {
  const std::string& frame = costmap_.getGlobalFrameID();
  if (std::string fault = control::fault_of_frames(frame, costmap_.getBaseFrameID()); !fault.empty()) return fault;
  geometry_msgs::PoseStamped pose;
  if (!costmap_.getRobotPose(pose)) {
    return "there is no pose of the robot in " + frame + ": check the transform from " + costmap_.getBaseFrameID();
  }
  if (const double ahead = pose_ahead_of(now, pose.header.stamp); ahead > loop_.parameters().transform_tolerance) {
    return "the transform from " + costmap_.getBaseFrameID() + " to " + frame + " is " + worded(ahead) +
           " s ahead of the clock, so the present pose is not known: set the clocks of its sender and of this machine "
           "alike (transform_tolerance); if it stays, restart the host";
  }
  observation.pose = to_pose(pose.pose);
  if (!pose.header.stamp.isZero()) observation.pose_age = std::max(0.0, now.seconds - now.of(pose.header.stamp));
  if (!is_finite(observation.pose)) return "the robot's pose in " + frame + " is not a number";
  frame_watch_.observe(observation.pose, *observation.velocity, timing.interval);
  if (frame_watch_.stands_still()) {
    return "the robot's pose in " + frame + " stays the same while odometry says that it drives: " + frame +
           " moves with the robot (set the local costmap's global_frame to odom), or the transform from " +
           costmap_.getBaseFrameID() + " is not renewed";
  }
  if (loop_.plan_frame() == frame) return "";
  try {
    const geometry_msgs::TransformStamped transform = tf_.lookupTransform(frame, loop_.plan_frame(), ros::Time(0));
    const double age = transform.header.stamp.isZero() ? 0.0 : now.seconds - now.of(transform.header.stamp);
    if (age > loop_.parameters().transform_tolerance) {
      return "the transform from the plan's frame " + loop_.plan_frame() + " to " + frame + " is " + worded(age) +
             " s old (transform_tolerance)";
    }
    observation.from_plan = to_transform(transform.transform);
    return is_finite(observation.from_plan.origin) ? ""
                                                   : "the transform from " + loop_.plan_frame() + " is not a number";
  } catch (const tf2::TransformException& error) {
    return "no transform from the plan's frame " + loop_.plan_frame() + " to " + frame + ": " + error.what();
  }
}

// By how much the newest transform is ahead of `now` [s]. A pose for `now` is then made of what was sent long before,
// or of nothing newer. A pose with a stamp of before shows that there is no newer transform: then tf is not asked.
double Shell::pose_ahead_of(const LoopTime& now, const ros::Time& stamp) const {
  if (stamp < now.stamp) return 0.0;
  try {
    const ros::Time newest =
        tf_.lookupTransform(costmap_.getGlobalFrameID(), costmap_.getBaseFrameID(), ros::Time(0)).header.stamp;
    return now.of(newest) - now.seconds;
  } catch (const tf2::TransformException&) {
    return 0.0;
  }
}

std::string Shell::update_footprint() {
  // Others may set it meanwhile. In a cycle the lock is held already; at start it is not.
  const boost::unique_lock<costmap_2d::Costmap2D::mutex_t> lock(*costmap_.getCostmap()->getMutex());
  const auto& points = costmap_.getRobotFootprint();
  if (points.empty()) return "the local costmap has no footprint: set robot_radius or footprint";
  if (!same_outline(loop_.planner().outline(), points)) {
    recorder_.demand_key();
    loop_.set_footprint(to_polygon(points));
    if (loop_.planner().footprint().fault() == nullptr) check_horizon();
  }
  const char* fault = loop_.planner().footprint().fault();
  return fault != nullptr ? fault : "";
}

void Shell::watch_odometry(const Observation& observation, const Decision& decision) {
  if (!decision.odometry_doubted && !decision.odometry_fast) return;
  if (decision.odometry_doubted) ++doubted_;
  const Twist2& u = *observation.velocity;
  ROS_WARN_THROTTLE(2.0,
                    "%s: odometry says %.2f m/s, %.2f rad/s, which the commands do not explain: %s (%lu readings were "
                    "doubted so far); check the odometry, and whether something else pushes, holds or drives the robot",
                    name_.c_str(), u.v, u.omega,
                    decision.odometry_fast ? "it lasts, so the collision check believes it" : "it is not believed",
                    static_cast<unsigned long>(doubted_));
}

// Once a second, and where the velocity comes to be doubted: what changes is told.
void Shell::watch_sender() {
  const bool doubts = loop_.doubts_velocity();
  if (called_ - sender_watched_ < std::chrono::seconds(1) && doubts == doubted_velocity_) return;
  sender_watched_ = called_;
  doubted_velocity_ = doubts;
  const std::string& base = costmap_.getBaseFrameID();
  std::string text =
      odometry_.advice(base, [&](const std::string& frame) { return tf_.canTransform(base, frame, ros::Time(0)); });
  if (doubts) {
    text += (text.empty() ? "The velocity of " : " The velocity of ") + odom_topic_ +
            " is not believed: the pose moves as commanded, and the velocity (twist) says something else. It is taken "
            "from the pose. The twist must be the robot's own velocity, in m/s and rad/s, in the frame " +
            base + ": correct its sender.";
  }
  if (text == odometry_said_) return;
  odometry_said_ = std::move(text);
  if (odometry_said_.empty()) {
    ROS_INFO("%s: the odometry is as it should be", name_.c_str());
  } else {
    ROS_WARN("%s: %s", name_.c_str(), odometry_said_.c_str());
  }
}

void Shell::explain(double now, const CycleResult& result) {
  const bool rejected = result.decision && (result.outcome == Outcome::brake || result.outcome == Outcome::fail);
  const bool escaping = result.decision && !rejected && result.decision->escaping;
  const std::string_view what = rejected   ? std::string_view(result.decision->problem)
                                : escaping ? kEscapes
                                           : std::string_view(result.fault);
  if (what.empty()) {
    if (explanations_.end()) ROS_INFO("%s: driving again", name_.c_str());
    return;
  }
  if (!explanations_.due(now, what)) return;
  const std::string message = rejected ? rejections_in_words(*result.decision) : std::string(what);
  const char* consequence = result.outcome == Outcome::fail    ? "; the robot stands, the host replans or recovers"
                            : result.outcome == Outcome::brake ? "; braking"
                                                               : "";
  ROS_WARN("%s: %s%s", name_.c_str(), message.c_str(), consequence);
}

// Tries fewer samples rather than miss the rate. A cycle without candidates says nothing about their cost.
void Shell::keep_budget(double duration, double period, const CycleResult& result) {
  if (result.decision && result.decision->candidates > 0) {
    const double limit = cycle_budget(loop_.parameters(), period);  // [s]
    const SampleBudget::Event event = budget_.observe(duration, limit);
    if (event == SampleBudget::Event::thinning_began) {
      ROS_WARN("%s: %s", name_.c_str(), thinning_complaint(budget_.in_force(), budget_.full(), limit).c_str());
    } else if (event == SampleBudget::Event::thinning_ended) {
      ROS_INFO("%s: the cycle is fast enough again: all %d x %d samples are tried", name_.c_str(),
               budget_.full().vx_samples, budget_.full().vth_samples);
    }
  }
  diagnostics_->set(result.fault, odometry_said_, load());
}

}  // namespace hidwa_local_planner
