// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <dynamic_reconfigure/server.h>
#include <ros/node_handle.h>
#include <boost/thread/recursive_mutex.hpp>

#include "hidwa_local_planner/HIDWAPlannerConfig.h"
#include "hidwa_local_planner/core/parameters.hpp"

namespace hidwa_local_planner {

/// The generated configuration, made strict: a value out of range reaches the validation, which refuses it by name.
/// dynamic_reconfigure would clamp it silently.
struct StrictConfig : HIDWAPlannerConfig {
  StrictConfig() : HIDWAPlannerConfig() {}
  StrictConfig(const HIDWAPlannerConfig& config) : HIDWAPlannerConfig(config) {}  // NOLINT: the server assigns
  void __clamp__() {}
};

/// Between the generated configuration and the parameters, by name. Faults name enumerations with unknown
/// names.
HIDWAPlannerConfig to_config(const Parameters& parameters);
Parameters from_config(const HIDWAPlannerConfig& config, std::vector<std::string>& faults);

/// dynamic_reconfigure in the planner's namespace.
class Reconfigure {
 public:
  /// Judges a set; an empty answer accepts it. Called from the handle's callback thread.
  using Judge = std::function<std::vector<std::string>(const Parameters& wanted)>;

  /// Shows `initial`, which need not be valid, and writes it to the parameter server.
  Reconfigure(const ros::NodeHandle& handle, const Parameters& initial, Judge judge);

  /// Changes one parameter as a client would, and shows it to all clients. Returns the faults where it was
  /// refused.
  std::vector<std::string> set(const std::string& name, const ParameterValue& value);

 private:
  void change(StrictConfig& wanted);

  boost::recursive_mutex mutex_;
  Judge judge_;
  bool started_ = false;
  StrictConfig shown_;  // the last set that was accepted, or the initial one
  std::unique_ptr<dynamic_reconfigure::Server<StrictConfig>> server_;
};

}  // namespace hidwa_local_planner
