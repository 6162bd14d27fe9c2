// SPDX-License-Identifier: BSD-3-Clause
// The table of all parameters, made once of parameter_list.inc, and what it serves: access by name and validation. The
// list is read by the compiler twice: parameters.hpp makes the struct of it, make_table() the table. Both use the same
// members, so that a default is written once.
#include "hidwa_local_planner/core/parameters.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>

#include "core/util/words.hpp"
#include "hidwa_local_planner/core/sensor_sector.hpp"

namespace hidwa_local_planner {
namespace {

std::string wrong_type(const ParameterInfo& info) {
  std::string wanted = info.type == "str" ? "a text" : info.type == "bool" ? "true or false" : "a number";
  if (info.type == "int") wanted = "a whole number";
  if (info.type == "enum") {
    wanted = "one of";
    for (const std::string& choice : info.choices) wanted += " " + choice;
  }
  if (info.type == "axis") {
    const std::string last = shortest(info.max);
    wanted = "an axis, " + shortest(info.min) + " to " + last + ", or such as " + last + " reversed";
  }
  return info.name + ": expected " + wanted;
}

bool assign(double& field, const ParameterValue& value) {
  const int* whole = std::get_if<int>(&value);
  const double* number = std::get_if<double>(&value);
  if (whole == nullptr && number == nullptr) return false;
  field = whole != nullptr ? *whole : *number;
  return true;
}

template <typename Value>
bool assign(Value& field, const ParameterValue& value) {
  const Value* same = std::get_if<Value>(&value);
  if (same != nullptr) field = *same;
  return same != nullptr;
}

template <typename Enum>
bool assign_choice(Enum& field, const ParameterValue& value, const std::vector<std::string>& choices) {
  const std::string* text = std::get_if<std::string>(&value);
  if (text == nullptr) return false;
  const auto found = std::find(choices.begin(), choices.end(), *text);
  if (found == choices.end()) return false;
  field = static_cast<Enum>(found - choices.begin());
  return true;
}

constexpr const char* kReversed = " reversed";

std::string text_of(const JoyAxis& axis) { return std::to_string(axis.index) + (axis.reversed ? kReversed : ""); }

std::optional<JoyAxis> axis_in(const ParameterValue& value) {
  if (const int* index = std::get_if<int>(&value)) return JoyAxis{*index};
  const std::string* text = std::get_if<std::string>(&value);
  if (text == nullptr) return std::nullopt;
  const std::size_t end = text->find(kReversed);
  const std::optional<double> index = number_in(text->substr(0, end));
  if (!index || std::abs(*index) > 1e9) return std::nullopt;
  const JoyAxis axis{static_cast<int>(*index), end != std::string::npos};
  return text_of(axis) == *text && !(axis.reversed && axis.index < 0) ? std::optional(axis) : std::nullopt;
}

struct Naming {
  const char *name, *type, *tab, *description;
};

ParameterInfo named(const Naming& naming) {
  ParameterInfo info;
  info.name = naming.name;
  info.type = naming.type;
  info.tab = naming.tab;
  info.description = naming.description;
  return info;
}

template <typename Value>
ParameterInfo plain(const Naming& naming, Value Parameters::*member) {
  ParameterInfo info = named(naming);
  info.get = [member](const Parameters& p) { return ParameterValue(p.*member); };
  info.set = [member](Parameters& p, const ParameterValue& value) { return assign(p.*member, value); };
  return info;
}

template <typename Value>
ParameterInfo number(const Naming& naming, Value Parameters::*member, double min, double max, const char* unit) {
  ParameterInfo info = plain(naming, member);
  info.min = min;
  info.max = max;
  info.unit = unit;
  return info;
}

// An enumerator's place among the names is its value: parameters.hpp keeps it so.
template <typename Enum>
ParameterInfo choice(const Naming& naming, Enum Parameters::*member, const std::string& names) {
  ParameterInfo info = named(naming);
  info.choices = split(names, '|');
  info.get = [member, choices = info.choices](const Parameters& p) {
    return ParameterValue(choices.at(static_cast<std::size_t>(p.*member)));
  };
  info.set = [member, choices = info.choices](Parameters& p, const ParameterValue& value) {
    return assign_choice(p.*member, value, choices);
  };
  return info;
}

ParameterInfo axis(const Naming& naming, JoyAxis Parameters::*member, int min, int max) {
  ParameterInfo info = named(naming);
  info.min = min;
  info.max = max;
  info.get = [member](const Parameters& p) { return ParameterValue(text_of(p.*member)); };
  info.set = [member, min, max](Parameters& p, const ParameterValue& value) {
    const std::optional<JoyAxis> wanted = axis_in(value);
    if (!wanted || wanted->index < min || wanted->index > max) return false;
    p.*member = *wanted;
    return true;
  };
  return info;
}

std::vector<ParameterInfo> make_table() {
  using P = Parameters;
  std::vector<ParameterInfo> table;
#define HIDWA_DOUBLE(name, value, min, max, unit, tab, text) \
  table.push_back(number({#name, "double", tab, text}, &P::name, min, max, unit));
#define HIDWA_INT(name, value, min, max, unit, tab, text) \
  table.push_back(number({#name, "int", tab, text}, &P::name, min, max, unit));
#define HIDWA_BOOL(name, value, tab, text) table.push_back(plain({#name, "bool", tab, text}, &P::name));
#define HIDWA_STRING(name, value, tab, text) table.push_back(plain({#name, "str", tab, text}, &P::name));
#define HIDWA_ENUM(Type, name, value, names, tab, text) \
  table.push_back(choice({#name, "enum", tab, text}, &P::name, names));
#define HIDWA_AXIS(name, value, min, max, tab, text) \
  table.push_back(axis({#name, "axis", tab, text}, &P::name, min, max));
#include "hidwa_local_planner/core/parameter_list.inc"
#undef HIDWA_DOUBLE
#undef HIDWA_INT
#undef HIDWA_BOOL
#undef HIDWA_STRING
#undef HIDWA_ENUM
#undef HIDWA_AXIS
  const Parameters defaults;
  for (ParameterInfo& info : table) info.value = info.get(defaults);
  return table;
}

double as_number(const ParameterValue& value) {
  const int* whole = std::get_if<int>(&value);
  return whole != nullptr ? *whole : std::get<double>(value);
}

void check_ranges(std::vector<std::string>& faults, const Parameters& p) {
  for (const ParameterInfo& info : parameter_table()) {
    if (info.is_in_range(p)) continue;
    faults.push_back(info.name + " = " + shortest(as_number(info.get(p))) + " " + info.unit + " is outside [" +
                     shortest(info.min) + ", " + shortest(info.max) + "]");
  }
}

void check_limits(std::vector<std::string>& faults, const Parameters& p) {
  if (p.min_vel_x > p.max_vel_x) {
    faults.push_back("min_vel_x = " + shortest(p.min_vel_x) + " m/s is above max_vel_x = " + shortest(p.max_vel_x) +
                     " m/s: lower min_vel_x (0, or negative for reverse)");
  }
  if (p.min_in_place_vel_theta > p.max_vel_theta) {
    faults.push_back(
        "min_in_place_vel_theta is above max_vel_theta: the robot could never turn on the spot; lower "
        "min_in_place_vel_theta");
  }
  if ((p.wheel_separation > 0.0) != (p.max_wheel_speed > 0.0)) {
    faults.push_back("wheel_separation and max_wheel_speed belong together: set both, or both to 0 for no wheel limit");
  }
  if (const std::size_t joints = split_names(p.wheel_joints).size(); joints != 0 && joints != 2) {
    faults.push_back("wheel_joints = " + p.wheel_joints +
                     ": name two joints, the left and the right one, or none to have them found");
  }
}

void check_operator(std::vector<std::string>& faults, const Parameters& p) {
  if (p.mode == OperatorMode::gesture && p.clutch_button < 0 && p.clutch_axis.index < 0) {
    faults.push_back("mode gesture needs a clutch: set clutch_button or clutch_axis");
  }
  if (p.mode == OperatorMode::gesture && p.gesture_frame.empty() && p.gesture_topic.empty()) {
    faults.push_back("mode gesture needs a hand: set gesture_topic, or gesture_frame and gesture_parent_frame");
  }
  if (p.gesture_frame.empty() != p.gesture_parent_frame.empty()) {
    faults.push_back("gesture_frame and gesture_parent_frame go together: set both or neither");
  }
}

// What a cycle rolls out at most: more takes longer than any control period, and memory that a robot does not have.
constexpr double kMostPoses = 2e4;
constexpr double kMostPosesOfAll = 2e7;

// Poses of the longest rollout (Rollout::Settings::steps).
double longest_rollout(const Parameters& p) {
  const double fastest = std::max(p.max_vel_x, -p.min_vel_x);
  return p.sim_time * std::max(fastest / p.linear_granularity, p.max_vel_theta / p.angular_granularity);
}

void check_rest(std::vector<std::string>& faults, const Parameters& p) {
  check_operator(faults, p);
  if (p.odom_topic.empty()) faults.push_back("odom_topic is empty: name the robot's nav_msgs/Odometry topic");
  if (p.occlusion == Occlusion::bound && p.admissibility != Admissibility::braking) {
    faults.push_back("occlusion: bound needs admissibility: braking: set that, or occlusion to cost or \"off\"");
  }
  if (split_names(p.critics).empty()) faults.push_back("critics is empty: name at least one, for example PathDist");
  const double samples = static_cast<double>(p.vx_samples) * static_cast<double>(p.vth_samples);
  if (samples > 200000.0) {
    faults.push_back("vx_samples * vth_samples = " + shortest(samples) + " is above 200000: lower either");
  }
  const double poses = longest_rollout(p);
  if (poses > kMostPoses || samples * poses > kMostPosesOfAll) {
    faults.push_back("a rollout has up to " + shortest(std::ceil(poses)) +
                     " poses, above 20000, or all samples' are above " +
                     "20000000: raise linear_granularity or angular_granularity, or lower sim_time or the samples");
  }
}

}  // namespace

bool ParameterInfo::is_in_range(const Parameters& parameters) const {
  if (!is_number()) return true;
  const double number = as_number(get(parameters));
  return number >= min && number <= max;
}

const std::vector<ParameterInfo>& parameter_table() {
  static const std::vector<ParameterInfo> table = make_table();
  return table;
}

const ParameterInfo* find_parameter(const std::string& name) {
  for (const ParameterInfo& info : parameter_table()) {
    if (info.name == name) return &info;
  }
  return nullptr;
}

const ParameterInfo& parameter_info(const std::string& name) {
  const ParameterInfo* info = find_parameter(name);
  if (info == nullptr) throw std::out_of_range("no parameter named " + name);
  return *info;
}

std::string set_parameter(Parameters& parameters, const std::string& name, const ParameterValue& value) {
  const ParameterInfo* info = find_parameter(name);
  if (info == nullptr) return name + ": no such parameter";
  return info->set(parameters, value) ? "" : wrong_type(*info);
}

ParameterValue get_parameter(const Parameters& parameters, const std::string& name) {
  return parameter_info(name).get(parameters);
}

std::vector<std::string> validate(const Parameters& parameters) {
  std::vector<std::string> faults;
  check_ranges(faults, parameters);
  check_limits(faults, parameters);
  check_rest(faults, parameters);
  std::string fault;
  parse_sensor_sectors(parameters.sensor_sectors, fault);
  if (!fault.empty()) faults.push_back(fault);
  return faults;
}

std::vector<std::string> split_names(const std::string& list) {
  std::vector<std::string> names;
  std::string name;
  const std::string separators = ", ;[]\"'\t\n";
  for (const char c : list + ",") {
    if (separators.find(c) == std::string::npos) {
      name += c;
    } else if (!name.empty()) {
      names.push_back(name);
      name.clear();
    }
  }
  return names;
}

}  // namespace hidwa_local_planner
