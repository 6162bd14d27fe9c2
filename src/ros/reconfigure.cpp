// SPDX-License-Identifier: BSD-3-Clause
#include "ros/reconfigure.hpp"

#include <utility>
#include <variant>

#include <dynamic_reconfigure/Config.h>
#include <dynamic_reconfigure/config_tools.h>
#include <ros/console.h>

namespace hidwa_local_planner {
namespace {

/// The name of an enumeration's value as people and tools send it.
std::string choice(const std::string& text) {
  // dynparam reads the bare word off as false and sends it as a text.
  return text == "False" || text == "false" ? "off" : text;
}

// The values of one kind in a message; their names are those of the parameters.
template <typename Value, typename Entries>
void take(Parameters& parameters, const Entries& entries) {
  for (const auto& entry : entries) set_parameter(parameters, entry.name, static_cast<Value>(entry.value));
}

void take_text(Parameters& parameters, const dynamic_reconfigure::StrParameter& entry,
               std::vector<std::string>& faults) {
  const bool chosen = parameter_info(entry.name).type == "enum";
  const std::string fault = set_parameter(parameters, entry.name, chosen ? choice(entry.value) : entry.value);
  if (!fault.empty()) faults.push_back(fault + ", found " + entry.value);
}

}  // namespace

HIDWAPlannerConfig to_config(const Parameters& parameters) {
  dynamic_reconfigure::Config message;
  for (const ParameterInfo& info : parameter_table()) {
    const auto append = [&](const auto& value) {
      dynamic_reconfigure::ConfigTools::appendParameter(message, info.name, value);
    };
    std::visit(append, info.get(parameters));
  }
  HIDWAPlannerConfig config = HIDWAPlannerConfig::__getDefault__();
  config.__fromMessage__(message);
  return config;
}

Parameters from_config(const HIDWAPlannerConfig& config, std::vector<std::string>& faults) {
  dynamic_reconfigure::Config message;
  config.__toMessage__(message);
  Parameters parameters;
  take<bool>(parameters, message.bools);
  take<int>(parameters, message.ints);
  take<double>(parameters, message.doubles);
  for (const dynamic_reconfigure::StrParameter& entry : message.strs) take_text(parameters, entry, faults);
  return parameters;
}

Reconfigure::Reconfigure(const ros::NodeHandle& handle, const Parameters& initial, Judge judge)
    : judge_(std::move(judge)), shown_(to_config(initial)) {
  // The server reads the namespace when it starts and puts its defaults in the place of what it cannot read,
  // such as lists: it must find every value as it writes them.
  shown_.__toServer__(handle);
  server_ = std::make_unique<dynamic_reconfigure::Server<StrictConfig>>(mutex_, handle);
  server_->setCallback([this](StrictConfig& wanted, std::uint32_t) { change(wanted); });
}

std::vector<std::string> Reconfigure::set(const std::string& name, const ParameterValue& value) {
  const boost::recursive_mutex::scoped_lock lock(mutex_);
  std::vector<std::string> faults;
  Parameters parameters = from_config(shown_, faults);
  const std::string fault = set_parameter(parameters, name, value);
  if (!fault.empty()) faults.push_back(fault);
  if (faults.empty()) faults = judge_(parameters);
  if (!faults.empty()) return faults;
  shown_ = StrictConfig(to_config(parameters));
  server_->updateConfig(shown_);
  return {};
}

void Reconfigure::change(StrictConfig& wanted) {
  if (!started_) {  // setting the callback calls it with what is in force already
    started_ = true;
    wanted = shown_;
    return;
  }
  std::vector<std::string> faults;
  const Parameters parameters = from_config(wanted, faults);
  if (faults.empty()) faults = judge_(parameters);
  if (faults.empty()) {
    shown_ = StrictConfig(to_config(parameters));
  } else {
    for (const std::string& fault : faults) ROS_ERROR("parameters refused: %s", fault.c_str());
    ROS_ERROR("the whole set was refused; the values before it stay in force");
  }
  wanted = shown_;
}

}  // namespace hidwa_local_planner
