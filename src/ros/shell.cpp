// SPDX-License-Identifier: BSD-3-Clause
#include "hidwa_local_planner/ros/shell.hpp"

#include <utility>

#include "core/planner/safe_values.hpp"
#include "core/util/words.hpp"
#include "hidwa_local_planner/core/parameter_text.hpp"
#include "hidwa_local_planner/ros/critic_loading.hpp"
#include "hidwa_local_planner/ros/horizon_check.hpp"
#include "hidwa_local_planner/ros/parameter_loading.hpp"

namespace hidwa_local_planner {

Shell::Shell(const std::string& name, const tf2_ros::Buffer& tf, costmap_2d::Costmap2DROS& costmap)
    : name_(name),
      handle_("~/" + name),
      tf_(tf),
      costmap_(costmap),
      description_(handle_, costmap.getBaseFrameID()),
      registry_(registry_with_plugins()),
      loop_(registry_),
      publishing_(handle_, costmap.getGlobalFrameID()),
      feedback_(handle_, host_handle_, costmap.getGlobalFrameID(), costmap.getBaseFrameID()) {
  start_parameters();
  host_frequency_.follow(thread_.serve(ros::NodeHandle("~")));
  diagnostics_ =
      std::make_unique<Diagnostics>(thread_.serve(host_handle_), name_, statistics_, person_, moving_obstacles_);
  diagnostics_->set("", "", load());
  const std::string fault = control::fault_of_frames(costmap_.getGlobalFrameID(), costmap_.getBaseFrameID());
  if (!fault.empty()) ROS_ERROR("%s does not drive: %s", name_.c_str(), fault.c_str());
  description_.give_outline(costmap_, accepted_.footprint_from_urdf);
  update_footprint();
  odometry_thread_.start();
  thread_.start();
}

void start_shell(std::unique_ptr<Shell>& shell, const std::string& name, const tf2_ros::Buffer* tf,
                 costmap_2d::Costmap2DROS* costmap) {
  if (shell) {
    ROS_WARN("%s is initialized already; the second call is ignored", name.c_str());
  } else if (tf == nullptr || costmap == nullptr) {
    ROS_ERROR("%s needs a tf buffer and a costmap", name.c_str());
  } else {
    shell = std::make_unique<Shell>(name, *tf, *costmap);
  }
}

OperatorInput::Status Shell::operator_status() const { return person_.status(LoopTime::now().seconds); }

Shell::~Shell() {
  thread_.stop();
  odometry_thread_.stop();
}

void Shell::start_parameters() {
  const XmlRpc::XmlRpcValue content = read_namespace(handle_);
  const auto completed = [this](const Parameters& wanted) { return description_.limited(wanted); };
  LoadedParameters loaded = load_parameters(content, completed);
  const ParameterSet set{completed(loaded.parameters), content};
  if (loaded.faults.empty()) {
    const Trial trial = try_out(set, registry_);
    loaded.faults = trial.faults;
    loaded.warnings.insert(loaded.warnings.end(), trial.warnings.begin(), trial.warnings.end());
  }
  if (loaded.faults.empty()) loaded.faults = put_in_force(set);
  for (const std::string& warning : loaded.warnings) {
    ROS_WARN("%s: %s", handle_.getNamespace().c_str(), warning.c_str());
  }
  const std::vector<std::string> misplaced = misplaced_parameters(read_namespace(ros::NodeHandle("~")));
  if (!misplaced.empty()) {
    ROS_WARN(
        "%s holds parameters of the planner, which count only in %s: %s; in a YAML file they stand indented below %s:",
        ros::NodeHandle("~").getNamespace().c_str(), handle_.getNamespace().c_str(), joined(misplaced).c_str(),
        name_.c_str());
  }
  for (const std::string& fault : loaded.faults) {
    ROS_ERROR("%s: %s", handle_.getNamespace().c_str(), fault.c_str());
  }
  if (!loaded.faults.empty()) {
    loop_.configure(Parameters());
    person_.configure(Parameters());
    parameters_fault_ = "the parameters in " + handle_.getNamespace() + " are not valid (" + loaded.faults.front() +
                        "): correct them and restart, or set valid ones by dynamic_reconfigure";
  }
  budget_.configure(configured_samples(loop_.parameters()));
  report_start(loaded.found);

  const std::string fault = listen(loop_.parameters());
  if (!fault.empty()) {
    ROS_ERROR("%s: %s", handle_.getNamespace().c_str(), fault.c_str());
    parameters_fault_ = fault;
  }
  // A nested key was taken over into the flat one: left behind it would hide later changes from the next
  // start.
  for (const std::string& alias : loaded.aliases) handle_.deleteParam(alias);
  reconfigure_ = std::make_unique<Reconfigure>(thread_.serve(handle_), loaded.parameters,
                                               [this](const Parameters& wanted) { return judge(wanted); });
  commands_ = std::make_unique<OperatorCommands>(thread_.serve(handle_), person_, *reconfigure_);
  accepted_ = loop_.parameters();
  feedback_.show_mode(accepted_.mode);
}

void Shell::report_start(const std::vector<std::string>& found) const {
  std::vector<std::string> changed;
  for (const ParameterInfo& info : parameter_table()) {
    const ParameterValue value = info.get(loop_.parameters());
    if (value != info.value) changed.push_back(info.name + ": " + to_text(value));
  }
  ROS_INFO("%s: %zu values came from the parameter server; values other than the defaults: %s",
           handle_.getNamespace().c_str(), found.size(), changed.empty() ? "none" : joined(changed).c_str());
  ROS_INFO("%s: critics in order: %s; control period %.3f s", handle_.getNamespace().c_str(),
           joined(split_names(loop_.parameters().critics)).c_str(), control_period());
}

std::vector<std::string> Shell::judge(const Parameters& wanted) {
  ParameterSet set{description_.limited(wanted), read_namespace(handle_)};
  const Trial trial = try_out(set, registry_);
  if (!trial.faults.empty()) return trial.faults;
  if (set.parameters.critics != accepted_.critics) {  // those in force have been told of at the start
    for (const std::string& warning : trial.warnings) {
      ROS_WARN("%s: %s", handle_.getNamespace().c_str(), warning.c_str());
    }
  }
  const std::string fault = listen(set.parameters);
  if (!fault.empty()) {
    listen(accepted_);
    return {fault};
  }
  accepted_ = set.parameters;
  feedback_.show_mode(set.parameters.mode);
  pending_.put(std::move(set));
  return {};
}

std::string Shell::listen(const Parameters& parameters) {
  try {
    if (parameters.odom_topic != odom_topic_) {
      odom_topic_.clear();
      odometry_.subscribe(odometry_thread_.serve(host_handle_), parameters.odom_topic);
      odom_topic_ = parameters.odom_topic;
    }
    if (parameters.moving_obstacles_topic != moving_obstacles_topic_) {
      moving_obstacles_topic_.clear();
      moving_obstacles_.subscribe(odometry_thread_.serve(host_handle_), parameters.moving_obstacles_topic);
      moving_obstacles_topic_ = parameters.moving_obstacles_topic;
    }
    person_.listen(host_handle_, parameters);
  } catch (const ros::Exception& error) {
    return std::string("a topic cannot be listened to: ") + error.what();
  }
  return "";
}

void Shell::take_parameters() {
  const std::unique_ptr<ParameterSet> set = pending_.take();
  if (!set) return;
  const std::vector<std::string> faults = put_in_force(*set);
  for (const std::string& fault : faults) ROS_ERROR("parameters not taken: %s", fault.c_str());
  if (!faults.empty()) return;
  parameters_fault_.clear();
  budget_.configure(configured_samples(loop_.parameters()));
  check_horizon();
}

std::vector<std::string> Shell::put_in_force(const ParameterSet& set) {
  ParameterSet wanted = set;
  if (host_tolerances_) {
    wanted.parameters.xy_goal_tolerance = host_tolerances_->xy;
    wanted.parameters.yaw_goal_tolerance = host_tolerances_->yaw;
  }
  const std::vector<std::string> faults = configure(loop_, wanted);
  if (!faults.empty()) return faults;
  person_.configure(wanted.parameters);
  recorder_.take(foreign_content(wanted));
  for (const std::string& reason : make_safe(wanted.parameters)) ROS_WARN("%s: %s", name_.c_str(), reason.c_str());
  in_force_ = set;
  return {};
}

double Shell::control_period() const {
  const double own = loop_.parameters().controller_frequency;
  return 1.0 / (own > 0.0 ? own : host_frequency_.get());
}

Diagnostics::Load Shell::load() const {
  const double period = control_period();
  return {period,
          clock_.longest_period(period),
          doubted_,
          response_.latency(),
          loop_.parameters().control_latency,
          cycle_budget(loop_.parameters(), period),
          budget_.in_force(),
          budget_.full()};
}

void Shell::check_horizon() {
  const costmap_2d::Costmap2D& map = *costmap_.getCostmap();
  if (map.getSizeInCellsX() == 0 || map.getSizeInCellsY() == 0) return;  // it waits for its map
  std::vector<std::string> complaints = horizon_complaints(
      loop_.parameters(), map.getSizeInCellsX() * map.getResolution(), map.getSizeInCellsY() * map.getResolution(),
      loop_.planner().footprint().circumscribed_radius());
  if (complaints == horizon_said_) return;
  for (const std::string& complaint : complaints) ROS_WARN("%s: %s", name_.c_str(), complaint.c_str());
  horizon_said_ = std::move(complaints);
}

}  // namespace hidwa_local_planner
