// SPDX-License-Identifier: BSD-3-Clause
#include "hidwa_local_planner/ros/parameter_set.hpp"

#include <ros/param.h>

#include "hidwa_local_planner/ros/critic_loading.hpp"
#include "hidwa_local_planner/ros/parameter_loading.hpp"

namespace hidwa_local_planner {

std::unique_ptr<ParameterSource> ParameterSet::source_for(const std::string& critic) const {
  const std::string name = short_name(critic);
  XmlRpc::XmlRpcValue own;
  if (content.valid() && content.getType() == XmlRpc::XmlRpcValue::TypeStruct && content.hasMember(name)) {
    own = content[name];
  }
  return std::make_unique<StoredParameters>(name, own);
}

XmlRpc::XmlRpcValue read_namespace(const ros::NodeHandle& handle) {
  XmlRpc::XmlRpcValue content;
  if (!ros::param::get(handle.getNamespace(), content)) content.clear();
  return content;
}

std::vector<std::string> configure(Planner& planner, const ParameterSet& set) {
  try {
    return planner.configure(set.parameters,
                             [&set](const std::string& critic) { return set.source_for(critic); });
  } catch (const std::exception& error) {
    return {std::string("critics: one of them does not take its parameters: ") + error.what()};
  }
}

std::vector<std::string> faults_of(const ParameterSet& set, const CriticRegistry& registry) {
  std::vector<std::string> faults;
  for (const std::string& critic : split_names(set.parameters.critics)) {
    if (registry.knows(critic) && registry.make(critic) == nullptr) {
      faults.push_back("critics: " + critic +
                       " is declared, but its library cannot be loaded; rebuild its package");
    }
  }
  if (!faults.empty()) return faults;
  Planner trial(registry);
  return configure(trial, set);
}

}  // namespace hidwa_local_planner
