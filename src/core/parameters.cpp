// SPDX-License-Identifier: BSD-3-Clause
#include "hidwa_local_planner/core/parameters.hpp"

#include <stdexcept>

namespace hidwa_local_planner {
namespace {

std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> parts(1);
  for (const char c : text) {
    if (c == separator) {
      parts.emplace_back();
    } else {
      parts.back() += c;
    }
  }
  return parts;
}

const ParameterInfo* find_info(const std::string& name) {
  for (const ParameterInfo& info : parameter_table()) {
    if (info.name == name) return &info;
  }
  return nullptr;
}

std::string describe(double value) {
  std::string text = std::to_string(value);
  text.erase(text.find_last_not_of('0') + 1);
  if (!text.empty() && text.back() == '.') text.pop_back();
  return text;
}

std::string wrong_type(const ParameterInfo& info) {
  std::string wanted = info.type == "str" ? "a text" : info.type == "bool" ? "true or false" : "a number";
  if (info.type == "int") wanted = "a whole number";
  if (info.type == "enum") {
    wanted = "one of";
    for (const std::string& choice : info.choices) wanted += " " + choice;
  }
  return info.name + ": expected " + wanted;
}

bool assign(double& field, const ParameterValue& value) {
  if (const double* number = std::get_if<double>(&value)) {
    field = *number;
  } else if (const int* whole = std::get_if<int>(&value)) {
    field = *whole;
  } else {
    return false;
  }
  return true;
}

bool assign(int& field, const ParameterValue& value) {
  const int* whole = std::get_if<int>(&value);
  if (whole != nullptr) field = *whole;
  return whole != nullptr;
}

bool assign(bool& field, const ParameterValue& value) {
  const bool* flag = std::get_if<bool>(&value);
  if (flag != nullptr) field = *flag;
  return flag != nullptr;
}

bool assign(std::string& field, const ParameterValue& value) {
  const std::string* text = std::get_if<std::string>(&value);
  if (text != nullptr) field = *text;
  return text != nullptr;
}

template <typename Enum>
bool assign_enum(Enum& field, const ParameterValue& value, const std::string& names) {
  const std::string* text = std::get_if<std::string>(&value);
  if (text == nullptr) return false;
  const std::vector<std::string> choices = split(names, '|');
  for (std::size_t i = 0; i < choices.size(); ++i) {
    if (choices[i] == *text) {
      field = static_cast<Enum>(i);
      return true;
    }
  }
  return false;
}

std::string enum_name(std::size_t value, const std::string& names) { return split(names, '|').at(value); }

std::vector<ParameterInfo> make_table() {
  std::vector<ParameterInfo> table;
#define HIDWA_DOUBLE(name, value, min, max, unit, tab, text) \
  table.push_back({#name, "double", double{value}, min, max, unit, tab, text, {}});
#define HIDWA_INT(name, value, min, max, unit, tab, text) \
  table.push_back({#name, "int", int{value}, min, max, unit, tab, text, {}});
#define HIDWA_BOOL(name, value, tab, text) table.push_back({#name, "bool", bool{value}, 0, 0, "", tab, text, {}});
#define HIDWA_STRING(name, value, tab, text) \
  table.push_back({#name, "str", std::string(value), 0, 0, "", tab, text, {}});
#define HIDWA_ENUM(Type, name, value, names, tab, text)                                                         \
  table.push_back({#name, "enum", enum_name(static_cast<std::size_t>(Type::value), names), 0, 0, "", tab, text, \
                   split(names, '|')});
#include "hidwa_local_planner/core/parameter_list.inc"
#undef HIDWA_DOUBLE
#undef HIDWA_INT
#undef HIDWA_BOOL
#undef HIDWA_STRING
#undef HIDWA_ENUM
  return table;
}

void check_range(std::vector<std::string>& faults, const std::string& name, double value, double min, double max,
                 const std::string& unit) {
  if (std::isfinite(value) && value >= min && value <= max) return;
  faults.push_back(name + " = " + describe(value) + " " + unit + " is outside [" + describe(min) + ", " +
                   describe(max) + "]");
}

void check_ranges(std::vector<std::string>& faults, const Parameters& p) {
#define HIDWA_DOUBLE(name, value, min, max, unit, tab, text) check_range(faults, #name, p.name, min, max, unit);
#define HIDWA_INT(name, value, min, max, unit, tab, text) check_range(faults, #name, p.name, min, max, unit);
#define HIDWA_BOOL(name, value, tab, text)
#define HIDWA_STRING(name, value, tab, text)
#define HIDWA_ENUM(Type, name, value, names, tab, text)
#include "hidwa_local_planner/core/parameter_list.inc"
#undef HIDWA_DOUBLE
#undef HIDWA_INT
#undef HIDWA_BOOL
#undef HIDWA_STRING
#undef HIDWA_ENUM
}

void check_limits(std::vector<std::string>& faults, const Parameters& p) {
  if (p.min_vel_x > p.max_vel_x) {
    faults.push_back("min_vel_x = " + describe(p.min_vel_x) + " m/s is above max_vel_x = " + describe(p.max_vel_x) +
                     " m/s: lower min_vel_x (0, or negative for reverse)");
  }
  if (p.min_vel_theta > p.max_vel_theta) {
    faults.push_back("min_vel_theta is above max_vel_theta: the robot could never turn; lower min_vel_theta");
  }
  if (p.min_in_place_vel_theta > p.max_vel_theta) {
    faults.push_back(
        "min_in_place_vel_theta is above max_vel_theta: the robot could never turn on the spot; lower "
        "min_in_place_vel_theta");
  }
  const int wheel_values = (p.wheel_radius > 0.0) + (p.wheel_separation > 0.0) + (p.max_wheel_velocity > 0.0);
  if (wheel_values != 0 && wheel_values != 3) {
    faults.push_back(
        "wheel_radius, wheel_separation and max_wheel_velocity belong together: set all three, or all to 0 for no "
        "wheel limit");
  }
}

void check_operator(std::vector<std::string>& faults, const Parameters& p) {
  if (p.axis_angular_sign == 0) faults.push_back("axis_angular_sign = 0: set 1 (left is +1) or -1 (right is +1)");
  if (p.axis_linear_sign == 0) faults.push_back("axis_linear_sign = 0: set 1 (up is +1) or -1 (down is +1)");
  if (p.clutch_axis_sign == 0) faults.push_back("clutch_axis_sign = 0: set 1 or -1 (a pressed axis is negative)");
  if (p.gesture_axis_sign == 0) faults.push_back("gesture_axis_sign = 0: set 1 (left is positive) or -1 (right is)");
  if (p.gesture_linear_sign == 0) faults.push_back("gesture_linear_sign = 0: set 1 or -1 (forward is negative)");
  if (p.mode == OperatorMode::gesture && p.clutch_button < 0 && p.clutch_axis < 0) {
    faults.push_back("mode gesture needs a clutch: set clutch_button or clutch_axis");
  }
  if (p.mode == OperatorMode::gesture && p.gesture_frame.empty() && p.gesture_topic.empty()) {
    faults.push_back("mode gesture needs a hand: set gesture_topic, or gesture_frame and gesture_parent_frame");
  }
  if (p.gesture_frame.empty() != p.gesture_parent_frame.empty()) {
    faults.push_back("gesture_frame and gesture_parent_frame go together: set both or neither");
  }
}

void check_rest(std::vector<std::string>& faults, const Parameters& p) {
  check_operator(faults, p);
  if (p.odom_topic.empty()) faults.push_back("odom_topic is empty: name the robot's nav_msgs/Odometry topic");
  if (split_names(p.critics).empty()) faults.push_back("critics is empty: name at least one, for example PathDist");
  const double samples = static_cast<double>(p.vx_samples) * static_cast<double>(p.vth_samples);
  if (samples > 200000.0) {
    faults.push_back("vx_samples * vth_samples = " + describe(samples) + " is above 200000: lower either");
  }
}

}  // namespace

const std::vector<ParameterInfo>& parameter_table() {
  static const std::vector<ParameterInfo> table = make_table();
  return table;
}

std::string set_parameter(Parameters& p, const std::string& wanted, const ParameterValue& value) {
  const ParameterInfo* info = find_info(wanted);
  if (info == nullptr) return wanted + ": no such parameter";
  bool done = false;
#define HIDWA_DOUBLE(name, value_, min, max, unit, tab, text) \
  if (wanted == #name) done = assign(p.name, value);
#define HIDWA_INT(name, value_, min, max, unit, tab, text) \
  if (wanted == #name) done = assign(p.name, value);
#define HIDWA_BOOL(name, value_, tab, text) \
  if (wanted == #name) done = assign(p.name, value);
#define HIDWA_STRING(name, value_, tab, text) \
  if (wanted == #name) done = assign(p.name, value);
#define HIDWA_ENUM(Type, name, value_, names, tab, text) \
  if (wanted == #name) done = assign_enum(p.name, value, names);
#include "hidwa_local_planner/core/parameter_list.inc"
#undef HIDWA_DOUBLE
#undef HIDWA_INT
#undef HIDWA_BOOL
#undef HIDWA_STRING
#undef HIDWA_ENUM
  return done ? std::string() : wrong_type(*info);
}

ParameterValue get_parameter(const Parameters& p, const std::string& wanted) {
#define HIDWA_DOUBLE(name, value, min, max, unit, tab, text) \
  if (wanted == #name) return p.name;
#define HIDWA_INT(name, value, min, max, unit, tab, text) \
  if (wanted == #name) return p.name;
#define HIDWA_BOOL(name, value, tab, text) \
  if (wanted == #name) return p.name;
#define HIDWA_STRING(name, value, tab, text) \
  if (wanted == #name) return p.name;
#define HIDWA_ENUM(Type, name, value, names, tab, text) \
  if (wanted == #name) return enum_name(static_cast<std::size_t>(p.name), names);
#include "hidwa_local_planner/core/parameter_list.inc"
#undef HIDWA_DOUBLE
#undef HIDWA_INT
#undef HIDWA_BOOL
#undef HIDWA_STRING
#undef HIDWA_ENUM
  throw std::out_of_range("no parameter named " + wanted);
}

std::vector<std::string> validate(const Parameters& parameters) {
  std::vector<std::string> faults;
  check_ranges(faults, parameters);
  check_limits(faults, parameters);
  check_rest(faults, parameters);
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
