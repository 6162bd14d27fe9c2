// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <string>

#include <dynamic_reconfigure/Reconfigure.h>
#include <ros/service.h>
#include <ros/this_node.h>

#include "stage.hpp"

namespace hidwa_plugin_tests {

/// A change of parameters by dynamic_reconfigure.
class Change {
 public:
  Change& set(const std::string& name, double value) {
    dynamic_reconfigure::DoubleParameter parameter;
    parameter.name = name;
    parameter.value = value;
    call_.request.config.doubles.push_back(parameter);
    return *this;
  }
  Change& set(const std::string& name, int value) {
    dynamic_reconfigure::IntParameter parameter;
    parameter.name = name;
    parameter.value = value;
    call_.request.config.ints.push_back(parameter);
    return *this;
  }
  Change& set(const std::string& name, const std::string& value) {
    dynamic_reconfigure::StrParameter parameter;
    parameter.name = name;
    parameter.value = value;
    call_.request.config.strs.push_back(parameter);
    return *this;
  }
  bool send(const Host& host) {
    return ros::service::call(ros::this_node::getName() + "/" + host.name() + "/set_parameters", call_);
  }
  /// What the answer says is in force.
  double number(const std::string& name) const {
    for (const auto& parameter : call_.response.config.doubles) {
      if (parameter.name == name) return parameter.value;
    }
    return std::nan("");
  }
  std::string text(const std::string& name) const {
    for (const auto& parameter : call_.response.config.strs) {
      if (parameter.name == name) return parameter.value;
    }
    return "?";
  }

 private:
  dynamic_reconfigure::Reconfigure call_;
};

}  // namespace hidwa_plugin_tests
