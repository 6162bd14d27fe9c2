// SPDX-License-Identifier: BSD-3-Clause
#include "ros/parameter_updates.hpp"

#include <utility>

#include <ros/console.h>

#include "core/util/words.hpp"

namespace hidwa_local_planner {

ParameterUpdates::ParameterUpdates(std::string name, const ros::NodeHandle& handle, const std::string& base,
                                   CriticRegistry registry)
    : name_(std::move(name)), handle_(handle), description_(handle, base), registry_(std::move(registry)) {}

std::size_t ParameterUpdates::start(Targets targets) {
  targets_ = std::move(targets);
  const LoadedParameters loaded = load();
  const std::string fault = targets_.listen(accepted_->parameters);
  if (!fault.empty()) {
    ROS_ERROR("%s: %s", handle_.getNamespace().c_str(), fault.c_str());
    fault_ = fault;
  }
  // A nested key was taken over into the flat one: left behind it would hide later changes from the next start.
  for (const std::string& alias : loaded.aliases) handle_.deleteParam(alias);
  reconfigure_ = std::make_unique<Reconfigure>(handle_, loaded.parameters,
                                               [this](const Parameters& wanted) { return judge(wanted); });
  targets_.accepted(accepted_->parameters);
  set_mode_ = handle_.subscribe<std_msgs::String>(
      "set_mode", 1, [this](const std_msgs::String::ConstPtr& message) { set_mode(message->data); });
  return loaded.found.size();
}

void ParameterUpdates::set_mode(const std::string& mode) {
  for (const std::string& fault : reconfigure_->set("mode", ParameterValue(mode))) {
    ROS_ERROR("set_mode: %s", fault.c_str());
  }
}

LoadedParameters ParameterUpdates::load() {
  const XmlRpc::XmlRpcValue content = read_namespace(handle_);
  const auto completed = [this](const Parameters& wanted) { return description_.limited(wanted); };
  LoadedParameters loaded = load_parameters(content, completed);
  accepted_ = std::make_shared<const ParameterSet>(ParameterSet{completed(loaded.parameters), content});
  if (loaded.faults.empty()) {
    const Trial trial = try_out(*accepted_, registry_);
    loaded.faults = trial.faults;
    loaded.warnings.insert(loaded.warnings.end(), trial.warnings.begin(), trial.warnings.end());
  }
  if (loaded.faults.empty()) loaded.faults = targets_.configure(*accepted_);
  warn(loaded.warnings);
  warn_of_misplaced();
  for (const std::string& fault : loaded.faults) {
    ROS_ERROR("%s: %s", handle_.getNamespace().c_str(), fault.c_str());
  }
  if (!loaded.faults.empty()) {
    fault_ = "the parameters in " + handle_.getNamespace() + " are not valid (" + loaded.faults.front() +
             "): correct them and restart, or set valid ones by dynamic_reconfigure";
    accepted_ = std::make_shared<const ParameterSet>();
    targets_.configure(*accepted_);
  }
  in_force_ = accepted_;
  return loaded;
}

std::vector<std::string> ParameterUpdates::judge(const Parameters& wanted) {
  const auto set =
      std::make_shared<const ParameterSet>(ParameterSet{description_.limited(wanted), read_namespace(handle_)});
  const Trial trial = try_out(*set, registry_);
  if (!trial.faults.empty()) return trial.faults;
  // Those in force have been told of at the start.
  if (set->parameters.critics != accepted_->parameters.critics) warn(trial.warnings);
  const std::string fault = targets_.listen(set->parameters);
  if (!fault.empty()) {
    targets_.listen(accepted_->parameters);
    return {fault};
  }
  std::atomic_store(&accepted_, set);
  targets_.accepted(set->parameters);
  std::atomic_store(&pending_, set);
  return {};
}

bool ParameterUpdates::take() {
  const SharedSet set = std::atomic_exchange(&pending_, SharedSet());
  if (!set) return false;
  const std::vector<std::string> faults = targets_.configure(*set);
  for (const std::string& fault : faults) ROS_ERROR("parameters not taken: %s", fault.c_str());
  if (!faults.empty()) return false;
  in_force_ = set;
  fault_.clear();
  return true;
}

void ParameterUpdates::repeat() {
  if (fault_.empty()) targets_.configure(*in_force_);
}

void ParameterUpdates::warn(const std::vector<std::string>& warnings) const {
  for (const std::string& warning : warnings) {
    ROS_WARN("%s: %s", handle_.getNamespace().c_str(), warning.c_str());
  }
}

void ParameterUpdates::warn_of_misplaced() const {
  const ros::NodeHandle host("~");
  const std::vector<std::string> misplaced = misplaced_parameters(read_namespace(host));
  if (misplaced.empty()) return;
  ROS_WARN(
      "%s holds parameters of the planner, which count only in %s: %s; in a YAML file they stand indented below %s:",
      host.getNamespace().c_str(), handle_.getNamespace().c_str(), joined(misplaced).c_str(), name_.c_str());
}

}  // namespace hidwa_local_planner
