// SPDX-License-Identifier: BSD-3-Clause
#include "ros/planner_node.hpp"

#include <cmath>
#include <utility>

#include "core/motion/velocity_limits.hpp"
#include "core/util/words.hpp"
#include "hidwa_local_planner/core/parameter_text.hpp"
#include "ros/conversions.hpp"
#include "ros/critic_loading.hpp"
#include "ros/horizon_check.hpp"
#include "ros/plan_message.hpp"

namespace hidwa_local_planner {
namespace {

ros::NodeHandle handle_of(const std::string& name) { return ros::NodeHandle("~/" + name); }

bool same_outline(const Polygon& outline, const std::vector<geometry_msgs::Point>& points) {
  if (outline.size() != points.size()) return false;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (outline[i].x() != points[i].x || outline[i].y() != points[i].y) return false;
  }
  return true;
}

}  // namespace

PlannerNode::PlannerNode(const std::string& name, const tf2_ros::Buffer& tf, costmap_2d::Costmap2DROS& costmap)
    : name_(name),
      costmap_(costmap),
      host_(thread_.serve(ros::NodeHandle("~"))),
      inputs_(name, tf, costmap),
      operator_(tf),
      outputs_({name, costmap.getGlobalFrameID(), costmap.getBaseFrameID()}, handle_of(name),
               thread_.serve(ros::NodeHandle()), operator_, inputs_.moving_obstacles()),
      parameters_(name, thread_.serve(handle_of(name)), costmap.getBaseFrameID(), registry_with_plugins()),
      loop_(parameters_.registry()) {
  start_parameters();
  outputs_.diagnostics().set("", "", load());
  const std::string fault = control::fault_of_frames(costmap_.getGlobalFrameID(), costmap_.getBaseFrameID());
  if (!fault.empty()) ROS_ERROR("%s does not drive: %s", name_.c_str(), fault.c_str());
  parameters_.give_outline(costmap_);
  update_footprint();
  thread_.start();
}

PlannerNode::~PlannerNode() { thread_.stop(); }

void start_planner(std::unique_ptr<PlannerNode>& planner, const std::string& name, const tf2_ros::Buffer* tf,
                   costmap_2d::Costmap2DROS* costmap) {
  if (planner) {
    ROS_WARN("%s is initialized already; the second call is ignored", name.c_str());
  } else if (tf == nullptr || costmap == nullptr) {
    ROS_ERROR("%s needs a tf buffer and a costmap", name.c_str());
  } else {
    planner = std::make_unique<PlannerNode>(name, *tf, *costmap);
  }
}

OperatorInput::Status PlannerNode::operator_status() const { return operator_.status(LoopTime::now().seconds); }

// The host may hold the costmap's recursive mutex already.
PlannerNode::Entry PlannerNode::enter() const {
  Entry entry{boost::unique_lock<costmap_2d::Costmap2D::mutex_t>(*costmap_.getCostmap()->getMutex()), {}};
  entry.planner = std::unique_lock<std::mutex>(mutex_);
  return entry;
}

PlannerNode::Entry PlannerNode::enter_from_host() {
  host_called_ = ros::SteadyTime::now().toSec();
  return enter();
}

bool PlannerNode::stands() const {
  const Entry entry = enter();
  return loop_.stands();
}

double PlannerNode::period() const {
  const Entry entry = enter();
  return nominal_period();
}

void PlannerNode::set_plan(const std::vector<geometry_msgs::PoseStamped>& plan) {
  const Entry entry = enter_from_host();
  PlanMessage read = read_plan(plan);
  plan_fault_ = read.fault;
  const double now = LoopTime::now().seconds;
  if (!read.fault.empty()) return loop_.drop_plan(now, nominal_period());
  if (std::isnan(read.poses.back().theta)) {
    ROS_WARN_ONCE("%s: the plan's last orientation is all zeros, which is no heading: at the goal any heading will do",
                  name_.c_str());
  }
  loop_.set_plan(std::move(read.poses), read.frame, now, nominal_period());
}

bool PlannerNode::goal_reached(bool host_stops) {
  const Entry entry = enter_from_host();
  const LoopTime now = LoopTime::now();
  const RobotObservation seen = observe(now, host_.between_cycles(now.seconds, loop_.parameters()), false);
  const bool reached = loop_.goal_reached(seen, operator_.status(now.seconds).manual);
  if (!host_.tell_goal_reached(reached, host_stops, loop_.stands())) return false;
  loop_.finish_goal(seen.timing);
  return true;
}

void PlannerNode::set_goal_tolerances(double xy, double yaw) {
  const Entry entry = enter_from_host();
  if (host_.set_tolerances(xy, yaw)) parameters_.repeat();
}

CycleResult PlannerNode::cycle(bool stop) {
  const Entry entry = enter_from_host();
  return run_cycle(stop || host_.arriving(), false);
}

CycleResult PlannerNode::cycle_without_goal(bool stop) {
  const Entry entry = enter();
  return run_cycle(stop, true);
}

void PlannerNode::take_parameters() {
  if (!parameters_.waits()) return;
  const Entry entry = enter();
  if (parameters_.take()) check_horizon();
}

CycleResult PlannerNode::run_cycle(bool stop, bool goalless) {
  host_.cycle_called();
  operator_.set_goalless(goalless);
  const LoopTime now = LoopTime::now();
  if (parameters_.take()) check_horizon();
  const control::Timing timing = begin_cycle(now.seconds);
  operator_.look_for_hand(loop_.parameters(), now);
  const bool recorded = loop_.parameters().record_cycles && outputs_.cycle_wanted();
  if (outputs_.new_cycle_subscriber() || !recorded) recorder_.demand_key();
  RobotObservation observation = observe(now, timing, goalless);
  observation.host_stops = stop;
  const CycleResult result = decide(now, observation, recorded);
  outputs_.tell(now, loop_, result, operator_.status(now.seconds));
  const double duration = host_.time_in_cycle();
  outputs_.publish_cycle(now.stamp, result, duration, recorded ? &recorder_.finish(result, loop_.planner()) : nullptr);
  outputs_.diagnostics().add(duration, timing.period);
  inputs_.watch_sender(loop_);
  adapt_sample_count(duration, timing.period, result);
  outputs_.diagnostics().set(result.fault, inputs_.odometry_advice(), load());
  return result;
}

control::Timing PlannerNode::begin_cycle(double now) {
  const control::Timing timing = host_.begin_cycle(now, loop_.parameters(), loop_.last_cycle());
  if (timing.jumped_back) {
    // The operator's state machine notices that itself: a stop goes on, and an operator who has control keeps it.
    ROS_WARN("%s: time jumped back: odometry from before is forgotten", name_.c_str());
    inputs_.forget();
    outputs_.forget();
  }
  return timing;
}

CycleResult PlannerNode::decide(const LoopTime& now, RobotObservation& observation, bool recorded) {
  if (host_.was_away()) observation.resumed = inputs_.velocity_after_pause(now.seconds, loop_.planner());
  observation.costmap = view_of(*costmap_.getCostmap());
  CycleResult result;
  result.sampling = budget_.in_force();
  if (outputs_.candidates_wanted()) result.sampling.report = Report::legality;
  if (loop_.goal_begins() && !observation.goalless) operator_.new_goal();
  const OperatorIntent intent = operator_.update(now.seconds, recorded ? &recorder_.operator_state() : nullptr);
  if (recorded) recorder_.begin(loop_, observation, result.sampling);
  static_cast<control::Result&>(result) = loop_.step(observation, intent, result.sampling);
  operator_.debrief(now.seconds, result.feedback);
  outputs_.predict(loop_, observation, result);
  inputs_.watch(observation, result);
  result.missing = observation.missing;
  result.fault = observation.fault;
  return result;
}

RobotObservation PlannerNode::observe(const LoopTime& now, const control::Timing& timing, bool goalless) {
  RobotObservation seen;
  seen.timing = timing;
  seen.goalless = goalless;
  const Parameters& parameters = loop_.parameters();
  if (!seen.lacks(Missing::parameters, parameters_.fault()) && !goalless) seen.lacks(Missing::plan, plan_fault_);
  inputs_.observe(now, goalless ? costmap_.getGlobalFrameID() : loop_.plan_frame(), parameters, seen);
  if (seen.missing == Missing::nothing && !seen.lacks(Missing::footprint, update_footprint())) {
    inputs_.observe_moving_obstacles(now.seconds, parameters, seen);
    if (parameters.sensor_sectors.empty() && seen.sensor_sectors.empty()) {
      ROS_INFO_ONCE(
          "%s: what the robot's sensors look at is not known: it may drive fast to where nobody sees, until the "
          "tracker tells it; or set sensor_sectors",
          name_.c_str());
      if (parameters.occlusion == Occlusion::bound) {
        ROS_WARN_THROTTLE(
            30.0,
            "%s: occlusion: bound has no effect, since nobody tells what the robot's sensors look at: start "
            "the tracker, or set sensor_sectors",
            name_.c_str());
      }
    }
  }
  return seen;
}

std::string PlannerNode::update_footprint() {
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

void PlannerNode::check_horizon() {
  const costmap_2d::Costmap2D& map = *costmap_.getCostmap();
  if (map.getSizeInCellsX() == 0 || map.getSizeInCellsY() == 0) return;  // it waits for its map
  std::vector<std::string> complaints = horizon_complaints(
      loop_.parameters(), loop_.planner().limits().x, map.getSizeInCellsX() * map.getResolution(),
      map.getSizeInCellsY() * map.getResolution(), loop_.planner().footprint().circumscribed_radius());
  if (complaints == horizon_said_) return;
  for (const std::string& complaint : complaints) ROS_WARN("%s: %s", name_.c_str(), complaint.c_str());
  horizon_said_ = std::move(complaints);
}

// Tries fewer samples rather than miss the rate. A cycle without candidates says nothing about their cost.
void PlannerNode::adapt_sample_count(double duration, double period, const CycleResult& result) {
  if (result.decision == nullptr || result.decision->candidates == 0) return;
  const double limit = cycle_budget(loop_.parameters(), period);  // [s]
  const SampleBudget::Event event = budget_.observe(duration, limit);
  if (event == SampleBudget::Event::thinning_began) {
    ROS_WARN("%s: %s", name_.c_str(), thinning_complaint(budget_.in_force(), budget_.full(), limit).c_str());
  } else if (event == SampleBudget::Event::thinning_ended) {
    ROS_INFO("%s: the cycle is fast enough again: all %d x %d samples are tried", name_.c_str(),
             budget_.full().vx_samples, budget_.full().vth_samples);
  }
}

void PlannerNode::start_parameters() {
  ParameterUpdates::Targets targets;
  targets.listen = [this](const Parameters& parameters) { return listen(parameters); };
  targets.configure = [this](const ParameterSet& set) { return configure(set); };
  targets.accepted = [this](const Parameters& parameters) { outputs_.feedback().show_mode(parameters.mode); };
  report_start(parameters_.start(std::move(targets)));
  operator_.listen_to_commands(handle_of(name_));
}

std::string PlannerNode::listen(const Parameters& parameters) {
  try {
    inputs_.listen(parameters);
    operator_.listen(ros::NodeHandle(), parameters);
  } catch (const ros::Exception& error) {
    return std::string("a topic cannot be listened to: ") + error.what();
  }
  return "";
}

std::vector<std::string> PlannerNode::configure(const ParameterSet& set) {
  Parameters wanted = set.parameters;
  host_.apply_tolerances(wanted);
  const std::vector<std::string> faults =
      loop_.configure(wanted, [&set](const std::string& critic) { return set.source_for(critic); });
  if (!faults.empty()) return faults;
  operator_.configure(wanted);
  recorder_.take(foreign_content(set));
  budget_.configure(configured_samples(loop_.parameters()));
  return {};
}

void PlannerNode::report_start(std::size_t found) const {
  std::vector<std::string> changed;
  for (const ParameterInfo& info : parameter_table()) {
    const ParameterValue value = info.get(loop_.parameters());
    if (value != info.value) changed.push_back(info.name + ": " + to_text(value));
  }
  const std::string where = handle_of(name_).getNamespace();
  ROS_INFO("%s: %zu values came from the parameter server; values other than the defaults: %s", where.c_str(), found,
           changed.empty() ? "none" : joined(changed).c_str());
  ROS_INFO("%s: critics in order: %s; control period %.3f s", where.c_str(),
           joined(split_names(loop_.parameters().critics)).c_str(), nominal_period());
}

Diagnostics::Load PlannerNode::load() const {
  const double nominal = nominal_period();
  return {nominal,
          host_.longest_period(nominal),
          inputs_.doubted_readings(),
          inputs_.base_latency(),
          loop_.parameters().control_latency,
          cycle_budget(loop_.parameters(), nominal),
          budget_.in_force(),
          budget_.full()};
}

}  // namespace hidwa_local_planner
