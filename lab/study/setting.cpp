// SPDX-License-Identifier: BSD-3-Clause
#include "study/setting.hpp"

#include <optional>
#include <set>

#include <yaml-cpp/yaml.h>

#include "core/util/words.hpp"
#include "hidwa_local_planner/core/parameter_text.hpp"
#include "study/error.hpp"

namespace hidwa_local_planner {
namespace study {
namespace {

const std::string kTrait = "participant.";

double to_number(const std::string& name, const std::string& text) {
  const std::optional<double> value = number_in(text);
  if (!value) throw UsageError(name + " needs a number, not '" + text + "'");
  return *value;
}

void assign_parameter(Parameters& parameters, const Assignment& assignment) {
  const std::string fault = set_parameter_text(parameters, assignment.name, assignment.value);
  if (fault.empty()) return;
  throw UsageError(fault + (find_parameter(assignment.name) == nullptr
                                ? ": docs/use/parameters.md lists the planner's; besides there are participant.TRAIT "
                                  "(docs/use/study.md) and link_delay"
                                : ""));
}

std::string text_of(const YAML::Node& node) {
  if (node.IsScalar()) return node.Scalar();
  std::string joined;
  for (const YAML::Node& item : node) joined += (joined.empty() ? "" : ", ") + item.as<std::string>();
  return joined;
}

}  // namespace

std::string to_string(const Setting& setting) {
  std::string text;
  for (const Assignment& assignment : setting) {
    text += (text.empty() ? "" : ";") + assignment.name + "=" + assignment.value;
  }
  return text.empty() ? "default" : text;
}

Assignment parse_assignment(const std::string& text) {
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos || equals == 0 || text.find_first_of("\n\r") != std::string::npos) {
    throw UsageError("'" + text + "' is not of the form name=value");
  }
  return {text.substr(0, equals), text.substr(equals + 1)};
}

double number_within(const std::string& name, const std::string& text, double least, double greatest) {
  const std::optional<double> value = number_in(text);
  if (value && *value >= least && *value <= greatest) return *value;
  throw UsageError(name + " needs a number from " + shortest(least) + " to " + shortest(greatest) + ", not '" + text +
                   "'");
}

void assign(Subject& subject, const Assignment& assignment) {
  const std::string& name = assignment.name;
  if (name == "mode") throw UsageError("mode is what the condition says: choose with --conditions");
  if (name == "guard") throw UsageError("guard counts in SW only: choose with --guard");
  if (name == "link_delay") {
    subject.link_delay = number_within(name, assignment.value, 0.0, 60.0);
  } else if (name.compare(0, kTrait.size(), kTrait) == 0) {
    const std::string fault =
        set_trait(subject.participant, name.substr(kTrait.size()), to_number(name, assignment.value));
    if (!fault.empty()) throw UsageError(fault);
  } else {
    assign_parameter(subject.parameters, assignment);
  }
}

std::vector<Setting> combinations(const std::vector<std::string>& grid) {
  std::vector<Setting> settings(1);
  std::set<std::string> names;
  for (const std::string& text : grid) {
    const Assignment axis = parse_assignment(text);
    if (!names.insert(axis.name).second) {
      throw UsageError("--grid " + axis.name + " is there twice: give all of its values at once");
    }
    std::vector<Setting> next;
    for (const Setting& before : settings) {
      std::set<std::string> values;
      for (const std::string& value : split(axis.value, ',')) {
        if (value.empty() || value.find_first_of(";\"\\") != std::string::npos) {
          throw UsageError("'" + text + "' is not of the form name=value,value,...");
        }
        if (!values.insert(value).second) throw UsageError("'" + text + "' has a value twice");
        next.push_back(before);
        next.back().push_back({axis.name, value});
      }
    }
    settings = next;
  }
  return settings;
}

std::vector<Setting> variations(const std::vector<std::string>& varied) {
  combinations(varied);  // for its faults
  std::vector<Setting> settings(1);
  for (const std::string& text : varied) {
    for (const Setting& setting : combinations({text})) settings.push_back(setting);
  }
  return settings;
}

void check(const Setting& setting, const Parameters& parameters) {
  const std::vector<std::string> faults = validate(parameters);
  if (!faults.empty()) throw UsageError("setting " + to_string(setting) + ": " + faults.front());
}

void assign_file(Parameters& parameters, const std::string& path) {
  YAML::Node root;
  try {
    root = YAML::LoadFile(path)["HIDWAPlannerROS"];
    if (!root || !root.IsMap()) throw UsageError("'" + path + "' has no HIDWAPlannerROS");
    for (const auto& entry : root) {
      assign_parameter(parameters, {entry.first.as<std::string>(), text_of(entry.second)});
    }
  } catch (const YAML::Exception& e) {
    throw UsageError("'" + path + "' cannot be read: " + e.what());
  }
}

}  // namespace study
}  // namespace hidwa_local_planner
