// SPDX-License-Identifier: BSD-3-Clause
#include "tracking/node_parameters.hpp"

#include <stdexcept>

#include "tracking/node_messages.hpp"

namespace hidwa_local_planner {
namespace tracking {
namespace {

const char* wanted(double) { return "a number (without quotation marks)"; }
const char* wanted(bool) { return "true or false"; }
const char* wanted(const std::string&) { return "a text"; }

template <typename Value>
void read_value(const ros::NodeHandle& node, const char* name, Value& value) {
  if (node.getParam(name, value) || !node.hasParam(name)) return;
  throw std::runtime_error("parameter " + node.resolveName(name) + " must be " + wanted(value));
}

void require_time(const ros::NodeHandle& node, const char* name, double value) {
  if (value >= 0.0 && value <= 10.0) return;
  throw std::runtime_error("parameter " + node.resolveName(name) + " must be from 0 to 10 s");
}

}  // namespace

NodeParameters read_node_parameters(const ros::NodeHandle& node) {
  NodeParameters p;
  TrackerSettings& t = p.tracker;
  for (const TrackerSetting& one : kTrackerSettings) read_value(node, one.name, t.*one.value);
  read_value(node, "no_return_is_free", t.no_return_is_free);
  read_value(node, "fixed_frame", p.fixed_frame);
  p.fixed_frame = without_slash(p.fixed_frame);
  read_value(node, "transform_timeout", p.transform_timeout);
  read_value(node, "lag_max", p.lag_max);
  const std::string fault = fault_of(t);
  if (!fault.empty()) throw std::runtime_error("parameter " + node.getNamespace() + "/" + fault);
  if (p.fixed_frame.empty()) throw std::runtime_error("parameter " + node.resolveName("fixed_frame") + " is empty");
  require_time(node, "transform_timeout", p.transform_timeout);
  require_time(node, "lag_max", p.lag_max);
  return p;
}

}  // namespace tracking
}  // namespace hidwa_local_planner
