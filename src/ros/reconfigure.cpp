// SPDX-License-Identifier: BSD-3-Clause
#include "hidwa_local_planner/ros/reconfigure.hpp"

#include <utility>

#include <ros/console.h>

namespace hidwa_local_planner {
namespace {

/// The name of an enumeration's value as people and tools send it.
std::string choice(const std::string& text) {
  // dynparam reads the bare word off as false and sends it as a text.
  return text == "False" || text == "false" ? "off" : text;
}

}  // namespace

HIDWAPlannerConfig to_config(const Parameters& p) {
  HIDWAPlannerConfig config = HIDWAPlannerConfig::__getDefault__();
#define HIDWA_DOUBLE(name, value, min, max, unit, tab, text) config.name = p.name;
#define HIDWA_INT(name, value, min, max, unit, tab, text) config.name = p.name;
#define HIDWA_BOOL(name, value, tab, text) config.name = p.name;
#define HIDWA_STRING(name, value, tab, text) config.name = p.name;
#define HIDWA_ENUM(Type, name, value, names, tab, text) config.name = std::get<std::string>(get_parameter(p, #name));
#include "hidwa_local_planner/core/parameter_list.inc"
#undef HIDWA_DOUBLE
#undef HIDWA_INT
#undef HIDWA_BOOL
#undef HIDWA_STRING
#undef HIDWA_ENUM
  return config;
}

Parameters from_config(const HIDWAPlannerConfig& config, std::vector<std::string>& faults) {
  Parameters p;
  std::string fault;
#define HIDWA_DOUBLE(name, value, min, max, unit, tab, text) p.name = config.name;
#define HIDWA_INT(name, value, min, max, unit, tab, text) p.name = config.name;
#define HIDWA_BOOL(name, value, tab, text) p.name = config.name;
#define HIDWA_STRING(name, value, tab, text) p.name = config.name;
#define HIDWA_ENUM(Type, name, value, names, tab, text) \
  fault = set_parameter(p, #name, choice(config.name)); \
  if (!fault.empty()) faults.push_back(fault + ", found " + config.name);
#include "hidwa_local_planner/core/parameter_list.inc"
#undef HIDWA_DOUBLE
#undef HIDWA_INT
#undef HIDWA_BOOL
#undef HIDWA_STRING
#undef HIDWA_ENUM
  return p;
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
    ROS_ERROR("the whole set was refused; what was in force before stays");
  }
  wanted = shown_;
}

}  // namespace hidwa_local_planner
