// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <functional>
#include <string>
#include <variant>
#include <vector>

namespace hidwa_local_planner {

// The order of the enumerators is the order of the names in parameter_list.inc.
enum class Method { hidwa, paper };
enum class Generator { standard, dwa };
enum class Admissibility { braking, horizon };
enum class Occlusion { off, cost, bound };
enum class OperatorMode { off, joystick, gesture, switching };
enum class Guard { nearest, none };
enum class LinearPolicy { v_max, axis, current };
enum class HandAxis { x, y, z, minus_x, minus_y, minus_z };
enum class OnInputLost { hold, stop, autonomy };

/// An axis of sensor_msgs/Joy. Its text is `3`, or `3 reversed` where its signs are turned round: `-3` would not do,
/// since YAML reads -0 as 0.
struct JoyAxis {
  int index = 0;  // negative: none
  bool reversed = false;
  float turned(float value) const { return reversed ? -value : value; }
  bool operator==(const JoyAxis& other) const { return index == other.index && reversed == other.reversed; }
};

/// Every tunable parameter with its default; see parameter_list.inc for units, ranges and meaning.
struct Parameters {
#define HIDWA_DOUBLE(name, value, min, max, unit, tab, text) double name = value;
#define HIDWA_INT(name, value, min, max, unit, tab, text) int name = value;
#define HIDWA_BOOL(name, value, tab, text) bool name = value;
#define HIDWA_STRING(name, value, tab, text) std::string name = value;
#define HIDWA_ENUM(Type, name, value, names, tab, text) Type name = Type::value;
#define HIDWA_AXIS(name, value, min, max, tab, text) JoyAxis name{value};
#include "hidwa_local_planner/core/parameter_list.inc"
#undef HIDWA_DOUBLE
#undef HIDWA_INT
#undef HIDWA_BOOL
#undef HIDWA_STRING
#undef HIDWA_ENUM
#undef HIDWA_AXIS

  /// Braking limits as positive numbers: their sign is the user's choice, 0 stands for the acceleration limit.
  double braking_x() const { return decel_lim_x == 0.0 ? acc_lim_x : std::abs(decel_lim_x); }  // [m/s^2]
  double braking_theta() const {                                                               // [rad/s^2]
    return decel_lim_theta == 0.0 ? acc_lim_theta : std::abs(decel_lim_theta);
  }
  /// The command is the chosen sample itself, not the first step towards it: as Nav2 did in 2022. The base then speeds
  /// up at limits of its own, which the braking check cannot know.
  bool commands_the_sample() const { return method == Method::paper && admissibility == Admissibility::horizon; }
  /// Autonomy turns gently. That takes rollouts whose velocities ramp, and commands that are their first step.
  bool turns_gently() const {
    return comfort_acc_lim_theta > 0.0 && generator == Generator::standard && !commands_the_sample();
  }
  bool has_wheel_limit() const { return wheel_separation > 0.0 && max_wheel_speed > 0.0; }
};

/// A value as the outside world writes it: enumerations as their names.
using ParameterValue = std::variant<bool, int, double, std::string>;

/// What the list says of one parameter, and how it is read and set. Whatever goes through all parameters (validation,
/// text, dynamic_reconfigure, the parameter server) goes through these.
struct ParameterInfo {
  std::string name;
  std::string type;             // "double", "int", "bool", "str", "enum" or "axis"
  ParameterValue value;         // the default
  double min = 0.0, max = 0.0;  // numbers and axes only
  std::string unit;             // empty where it has none
  std::string tab;
  std::string description;
  std::vector<std::string> choices;  // enumerations only
  std::function<ParameterValue(const Parameters&)> get;
  /// Returns false, and changes nothing, where the value has the wrong type or names no choice or axis. A double and an
  /// axis take an integer too.
  std::function<bool(Parameters&, const ParameterValue&)> set;

  bool is_number() const { return type == "double" || type == "int"; }
  /// Whether its value lies within [min, max]. NaN does not. A value that is no number at all (a word, a flag) always
  /// does.
  bool is_in_range(const Parameters& parameters) const;
};

/// All parameters in the order of their declaration.
const std::vector<ParameterInfo>& parameter_table();

/// The parameter of that name; nullptr where there is none.
const ParameterInfo* find_parameter(const std::string& name);

/// The parameter of that name; throws std::out_of_range where there is none.
const ParameterInfo& parameter_info(const std::string& name);

/// Sets one parameter by name. A double takes an integer too. Returns the fault in words, empty when it was set.
std::string set_parameter(Parameters& parameters, const std::string& name, const ParameterValue& value);

/// Reads one parameter by name; throws std::out_of_range for an unknown name.
ParameterValue get_parameter(const Parameters& parameters, const std::string& name);

/// Every fault of a set, each naming the parameter and the remedy; empty when the set is valid.
std::vector<std::string> validate(const Parameters& parameters);

/// The names in a list like "PathDist, GoalDist"; brackets and quotes are ignored.
std::vector<std::string> split_names(const std::string& list);

}  // namespace hidwa_local_planner
