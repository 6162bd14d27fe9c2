// SPDX-License-Identifier: BSD-3-Clause
#include "hidwa_local_planner/ros/parameter_set.hpp"

#include <array>
#include <utility>

#include <ros/names.h>
#include <ros/param.h>

#include "hidwa_local_planner/critics/built_in.hpp"
#include "hidwa_local_planner/ros/critic_loading.hpp"
#include "hidwa_local_planner/ros/parameter_loading.hpp"

namespace hidwa_local_planner {
namespace {

// What roscpp would throw at later, out of whatever callback or cycle.
void check_topics(std::vector<std::string>& faults, const Parameters& p) {
  using Named = std::pair<const char*, const std::string*>;
  const std::array<Named, 5> topics{{{"odom_topic", &p.odom_topic},
                                     {"joy_topic", &p.joy_topic},
                                     {"twist_topic", &p.twist_topic},
                                     {"gesture_topic", &p.gesture_topic},
                                     {"rumble_topic", &p.rumble_topic}}};
  for (std::size_t i = 0; i < topics.size(); ++i) {
    const auto& [name, topic] = topics[i];
    std::string why;
    if (topic->empty()) continue;
    if (!ros::names::validate(*topic, why)) {
      faults.push_back(std::string(name) + " = " + *topic + " is no name of a topic: " + why);
    } else if (topic->front() == '~') {
      faults.push_back(std::string(name) + " = " + *topic + ": private names are not resolved here, write it in full");
    }
    for (std::size_t j = 0; j < i; ++j) {
      if (*topics[j].second != *topic) continue;
      faults.push_back(std::string(topics[j].first) + " and " + name + " are both " + *topic +
                       ", but carry different messages: change one");
    }
  }
}

template <typename Configurable>
std::vector<std::string> configure_any(Configurable& one, const ParameterSet& set) {
  try {
    return one.configure(set.parameters, [&set](const std::string& critic) { return set.source_for(critic); });
  } catch (const std::exception& error) {
    return {std::string("critics: one of them does not take its parameters: ") + error.what()};
  }
}

}  // namespace

std::unique_ptr<ParameterSource> ParameterSet::source_for(const std::string& critic) const {
  const std::string name = short_name(critic);
  XmlRpc::XmlRpcValue own;
  if (content.valid() && content.getType() == XmlRpc::XmlRpcValue::TypeStruct && content.hasMember(name)) {
    own = content[name];
  }
  return std::make_unique<StoredParameters>(name, own);
}

std::string foreign_content(const ParameterSet& set) {
  using XmlRpc::XmlRpcValue;
  if (!set.content.valid() || set.content.getType() != XmlRpcValue::TypeStruct) return "";
  const CriticRegistry own = critics::built_in();
  XmlRpcValue content = set.content, foreign;
  for (const std::string& critic : split_names(set.parameters.critics)) {
    const std::string name = short_name(critic);
    if (!own.knows(critic) && content.hasMember(name)) foreign[name] = content[name];
  }
  return foreign.valid() ? foreign.toXml() : "";
}

ParameterSet with_foreign_content(const std::string& text) {
  ParameterSet set;
  int at = 0;
  if (!text.empty()) set.content.fromXml(text, &at);
  return set;
}

XmlRpc::XmlRpcValue read_namespace(const ros::NodeHandle& handle) {
  XmlRpc::XmlRpcValue content;
  if (!ros::param::get(handle.getNamespace(), content)) content.clear();
  return content;
}

std::vector<std::string> configure(Planner& planner, const ParameterSet& set) { return configure_any(planner, set); }
std::vector<std::string> configure(control::ControlLoop& loop, const ParameterSet& set) {
  return configure_any(loop, set);
}

std::vector<std::string> faults_of(const ParameterSet& set, const CriticRegistry& registry) {
  std::vector<std::string> faults;
  for (const std::string& critic : split_names(set.parameters.critics)) {
    if (registry.knows(critic) && registry.make(critic) == nullptr) {
      faults.push_back("critics: " + critic + " is declared, but its library cannot be loaded; rebuild its package");
    }
  }
  check_topics(faults, set.parameters);
  if (!faults.empty()) return faults;
  Planner trial(registry);
  return configure(trial, set);
}

}  // namespace hidwa_local_planner
