// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <string>
#include <vector>

#include <dynamic_reconfigure/Reconfigure.h>
#include <ros/service.h>

#include "stage.hpp"

namespace hidwa_plugin_tests {

/// A change of parameters by dynamic_reconfigure.
class Change {
 public:
  Change& set(const std::string& name, double value) { return add(call_.request.config.doubles, name, value); }
  Change& set(const std::string& name, int value) { return add(call_.request.config.ints, name, value); }
  Change& set(const std::string& name, const std::string& value) { return add(call_.request.config.strs, name, value); }
  bool send(const Host& host) { return ros::service::call(ns(host.name()) + "set_parameters", call_); }
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
  template <typename Parameter, typename Value>
  Change& add(std::vector<Parameter>& all, const std::string& name, const Value& value) {
    Parameter parameter;
    parameter.name = name;
    parameter.value = value;
    all.push_back(parameter);
    return *this;
  }

  dynamic_reconfigure::Reconfigure call_;
};

}  // namespace hidwa_plugin_tests
