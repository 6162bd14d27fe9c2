// SPDX-License-Identifier: BSD-3-Clause
#include "ros/parameter_set.hpp"

#include <algorithm>
#include <set>
#include <utility>

#include <ros/names.h>
#include <ros/param.h>

#include "control/control_loop.hpp"
#include "core/evaluation/critic_set.hpp"
#include "hidwa_local_planner/critics/built_in.hpp"
#include "ros/critic_loading.hpp"
#include "ros/parameter_loading.hpp"

namespace hidwa_local_planner {
namespace {

// Names that roscpp would throw at later, in a callback or a cycle.
void check_topics(std::vector<std::string>& faults, const Parameters& p) {
  std::vector<std::pair<std::string, std::string>> topics;  // name and value of each parameter *_topic
  const std::string ending = "_topic";
  for (const ParameterInfo& info : parameter_table()) {
    const std::size_t size = info.name.size();
    if (size < ending.size() || info.name.compare(size - ending.size(), ending.size(), ending) != 0) continue;
    topics.emplace_back(info.name, std::get<std::string>(get_parameter(p, info.name)));
  }
  for (std::size_t i = 0; i < topics.size(); ++i) {
    const auto& [name, topic] = topics[i];
    std::string why;
    if (topic.empty()) continue;
    if (!ros::names::validate(topic, why)) {
      faults.push_back(name + " = " + topic + " is no name of a topic: " + why);
    } else if (topic.front() == '~') {
      faults.push_back(name + " = " + topic + ": private names are not resolved here, write it in full");
    }
    for (std::size_t j = 0; j < i; ++j) {
      if (topics[j].second != topic) continue;
      faults.push_back(topics[j].first + " and " + name + " are both " + topic +
                       ", but carry different messages: change one");
    }
  }
}

// A critic, and what it asked for.
struct Asked {
  std::string critic;
  const StoredParameters* source;
};

std::string unknown(const Asked& asked, const std::string& key) {
  const std::set<std::string>& known = asked.source->asked();
  const std::string near = nearest_name(key, {known.begin(), known.end()});
  std::string text = "unknown parameter " + asked.source->name_space() + "/" + key + " of the critic " + asked.critic +
                     ": it has no effect";
  if (!near.empty()) return text + "; do you mean " + asked.source->name_space() + "/" + near + "?";
  text += "; it knows";
  for (const std::string& name : known) text += " " + name;
  return known.empty() ? text + " none" : text;
}

// Two critics of the same short name share their namespace: a key is unknown that neither asked for.
std::vector<std::string> unknown_keys(const std::vector<Asked>& all) {
  const CriticRegistry own = critics::built_in();  // parameter_list.inc has theirs
  std::set<std::string> seen;
  std::vector<std::string> warnings;
  for (const Asked& asked : all) {
    if (own.knows(asked.critic)) continue;
    for (const std::string& key : asked.source->unasked()) {
      const std::string& name_space = asked.source->name_space();
      const bool known = std::any_of(all.begin(), all.end(), [&](const Asked& other) {
        return other.source->name_space() == name_space && other.source->asked().count(key) != 0;
      });
      if (!known && seen.insert(name_space + "/" + key).second) warnings.push_back(unknown(asked, key));
    }
  }
  return warnings;
}

}  // namespace

std::unique_ptr<StoredParameters> ParameterSet::source_for(const std::string& critic) const {
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

Trial try_out(const ParameterSet& set, const CriticRegistry& registry) {
  Trial trial;
  std::vector<std::string>& faults = trial.faults;
  const std::vector<std::string> names = split_names(set.parameters.critics);
  for (const std::string& critic : names) {
    if (registry.knows(critic) && registry.make(critic) == nullptr) {
      faults.push_back("critics: " + critic + " is declared, but its library cannot be loaded; rebuild its package");
    }
  }
  check_topics(faults, set.parameters);
  if (!faults.empty()) return trial;
  CriticSet critics(registry);
  faults = validate(set.parameters);
  for (const std::string& fault : critics.faults_of(names)) faults.push_back(fault);
  if (!faults.empty()) return trial;
  std::vector<Asked> asked;  // the critics keep the sources, unless there are faults
  try {
    faults = critics.configure(names, set.parameters, [&](const std::string& critic) {
      std::unique_ptr<StoredParameters> source = set.source_for(critic);
      asked.push_back({critic, source.get()});
      return source;
    });
  } catch (const std::exception& error) {
    faults = {control::critic_fault(error)};
  }
  if (faults.empty()) trial.warnings = unknown_keys(asked);
  return trial;
}

}  // namespace hidwa_local_planner
