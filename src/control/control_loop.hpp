// SPDX-License-Identifier: BSD-3-Clause
// The control cycle of a robot, without ROS: what the plugin, the drives without ROS, replay and the tests run.
//
// A cycle, with the operator's state machine beside the loop:
//
//   if (loop.goal_begins()) machine.new_goal();
//   const OperatorIntent intent = machine.update(now);
//   const Result result = loop.step(observation, intent, sampling);
//   machine.debrief(now, result.feedback);
//
// In step():
// 1. where an input is missing, the robot brakes (FaultBrake), and the planner hears what was sent until then;
// 2. else the window of the plan is taken, the goal's latch is judged, and the planner decides;
// 3. the command is remembered.
//
// A step depends on its arguments, the plan, the parameters, the footprint, and on what the loop remembers (save()).
// A record of all these repeats the cycle: record/cycle_record.hpp.
#pragma once

#include <exception>
#include <optional>
#include <string>
#include <vector>

#include "control/fault_brake.hpp"
#include "control/frame_transform.hpp"
#include "control/goal_checker.hpp"
#include "control/plan_choice.hpp"
#include "control/plan_window.hpp"
#include "control/twist_watch.hpp"
#include "hidwa_local_planner/core/operator_intent.hpp"
#include "hidwa_local_planner/core/planner.hpp"
#include "hidwa_local_planner/core/util/archive.hpp"
#include "input/control_state.hpp"

namespace hidwa_local_planner::control {

/// When a cycle runs [s].
struct Timing {
  double now = 0.0;
  double period = 0.05;         // nominal, of a control cycle
  double longest_period = 0.0;  // of the last seconds, see PeriodWatch; at least the period counts
  double interval = 0.0;        // since the cycle before; 0 where there is none
  bool jumped_back = false;     // time did

  template <typename Self, typename Archive>
  static void archive(Self& self, Archive& io) {
    io(self.now, self.period, self.longest_period, self.interval, self.jumped_back);
  }
};

/// What is known of the robot in a cycle.
struct Observation {
  Timing timing;
  std::string fault;               // the fault in words; empty where no input is missing
  std::optional<Twist2> velocity;  // measured; there where nothing is missing [m/s, rad/s]
  double velocity_time = 0.0;      // when that was heard [s]; 0: in this cycle
  Pose2 pose;                      // costmap frame
  double pose_age = 0.0;           // [s]
  FrameTransform from_plan;        // of the plan's frame, in the costmap's
  GridView costmap;
  MovingObstacleEstimates moving_obstacles;
  SensorSectors sensor_sectors;  // robot frame
  /// Set after a pause of the host: the robot's velocity, as far as it is known.
  std::optional<Twist2> resumed;
  bool host_stops = false;  // the robot is to brake to rest whatever the operator wants
  bool goalless = false;    // the host has no goal: the operator drives, with every check, or the robot rests

  /// All but the costmap, whose cells belong to another object.
  template <typename Self, typename Archive>
  static void archive(Self& self, Archive& io) {
    io(self.timing, self.fault, self.velocity, self.velocity_time, self.pose, self.pose_age, self.from_plan.origin,
       self.moving_obstacles, self.sensor_sectors, self.resumed, self.host_stops, self.goalless);
  }
};

/// What a cycle came to.
struct Result {
  Outcome outcome = Outcome::fail;
  Twist2 command;                      // sent, or zero on failure [m/s, rad/s]
  const Decision* decision = nullptr;  // null where something was missing; valid until the next cycle
  OperatorIntent intent;               // as given to step(), even while the host stops the robot
  bool goalless = false;               // as observed
  input::CycleFeedback feedback;       // for the operator's state machine
};

/// The fault of a set of parameters by which a critic cannot be configured, in words.
std::string critic_fault(const std::exception& thrown);

class ControlLoop {
 public:
  explicit ControlLoop(CriticRegistry registry) : planner_(std::move(registry)) {}

  /// Takes a set of parameters between two cycles. Returns the faults in words; with any, nothing changes. Where there
  /// are none, the caller gives the same set to the operator's state machine. What a critic throws is a fault.
  std::vector<std::string> configure(const Parameters& parameters, const Planner::SourceFor& sources = {});
  void set_footprint(const Polygon& outline) { planner_.set_footprint(outline); }

  /// A plan in `frame`, not empty; its last pose is the goal. A new goal, or a plan after a pause, begins afresh: `now`
  /// and the control period [s]. Another plan to the same goal may have to wait (PlanChoice). Where the last heading is
  /// not a number, any heading will do at the goal.
  void set_plan(std::vector<Pose2> plan, const std::string& frame, double now, double period);
  /// The plan that was followed before a recorded cycle; call load() after it. Nothing else changes.
  void restore_plan(const std::vector<Pose2>& plan) { plan_.set_plan(plan); }
  /// There is no plan to follow.
  void drop_plan(double now, double period);
  bool has_plan() const { return !plan_.empty(); }
  const std::vector<Pose2>& plan() const { return plan_.plan(); }   // the one that is followed, whole, in its frame
  std::size_t next_plan_pose() const { return plan_.next_pose(); }  // the first one from the robot on
  const std::string& plan_frame() const { return frame_; }
  const Pose2& goal() const { return goal_.pose; }  // in the plan's frame; any heading will do that is not a number

  /// One control cycle.
  Result step(const Observation& observation, const OperatorIntent& intent, const Sampling& sampling = {});
  /// Whether the goal is reached: never where something is missing, or where the operator has taken control (`manual`).
  bool goal_reached(const Observation& observation, bool manual);
  /// A goal began since the last step(), or the robot was carried away from one that it had reached. The operator's
  /// state machine must hear of it (new_goal()) before it says its intent.
  bool goal_begins() const { return goal_.begins; }
  /// The goal is over, and the host sends zero now: whatever plan comes next has a new goal.
  void finish_goal(const Timing& timing);

  /// What the loop and its planner remember from cycle to cycle. Call load() after restore_plan() with the plan of
  /// that cycle. It returns false for bytes that save() did not write; load the loop again then.
  void save(Bytes& state) const;
  bool load(const Bytes& state);

  const Planner& planner() const { return planner_; }
  const Parameters& parameters() const { return planner_.parameters(); }
  const Situation& situation() const { return situation_; }  // of the last cycle; its plan of the last that planned
  const Twist2& last_command() const { return last_command_; }
  /// When the last cycle was [s]; none before the first.
  const std::optional<double>& last_cycle() const { return goal_checker_.last_cycle(); }
  /// The measured velocity is not believed: the pose moves as commanded, and the velocity does not (TwistWatch).
  bool doubts_velocity() const { return twist_watch_.doubts(); }
  /// The last command asked for rest, and the robot is at rest.
  bool stands() const { return stands_; }

 private:
  // The plan's last pose, in the plan's frame.
  struct Goal {
    Pose2 first;          // when it was new
    Pose2 pose;           // now
    bool known = false;   // and not over
    bool begins = false;  // since the last cycle
  };
  // save() adds planner_ and twist_watch_. Replay needs none of the rest. A step sets autonomous_ and goal_.begins
  // before it reads them. No step reads stands_. Only set_plan() and callers read frame_ and goal_.known, and
  // replay calls restore_plan() instead.
  template <typename Self, typename Archive>
  static void archive(Self& self, Archive& io) {
    io(self.goal_checker_, self.fault_brake_, self.plan_, self.plan_choice_, self.goal_.first, self.goal_.pose,
       self.last_command_, self.resumed_, self.steered_);
  }
  static void follow_operator(OperatorIntent& intent);
  void begin_goal();
  Pose2 goal_of(const Observation& observation) const;
  PlanOrder order() const { return {parameters().xy_goal_tolerance, steered_}; }
  void follow_progress(const Observation& observation);
  bool check_goal(const Observation& observation);
  void watch_velocity(const Observation& observation);
  std::optional<Twist2> velocity_of(const Observation& observation) const;
  void brake(const Observation& observation, const OperatorIntent& intent, Result& result);
  void decide(const Observation& observation, const OperatorIntent& intent, const Sampling& sampling, Result& result);
  bool leads_the_same_way(const std::vector<Pose2>& plan) const;
  void choose_plan(const Observation& observation);
  void fill_timing_and_last_command(const Timing& timing);
  void take_situation(const Observation& observation);
  void take_no_goal(const Observation& observation);
  void take_plan_window(const Observation& observation);
  void fill_feedback(const Observation& observation, Result& result) const;
  void remember(const Observation& observation, const Result& result);

  Planner planner_;
  GoalChecker goal_checker_;
  FaultBrake fault_brake_;
  TwistWatch twist_watch_;
  PlanWindow plan_;         // the one that is followed, in its own frame
  PlanChoice plan_choice_;  // a plan that waits, in the same frame
  std::string frame_;       // the plan's
  Goal goal_;
  Situation situation_;  // reused, to avoid allocation
  Twist2 last_command_;  // [m/s, rad/s]
  bool stands_ = false;
  bool autonomous_ = true;  // nobody steered in the last cycle, and nobody stopped the robot
  bool steered_ = false;    // the operator did
  bool resumed_ = false;    // the planner has not heard of the last pause of the host
};

}  // namespace hidwa_local_planner::control
