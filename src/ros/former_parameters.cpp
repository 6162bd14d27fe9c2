// SPDX-License-Identifier: BSD-3-Clause
#include "ros/former_parameters.hpp"

#include <algorithm>
#include <iterator>

#include "core/util/words.hpp"
#include "hidwa_local_planner/core/parameter_text.hpp"
#include "ros/parameter_loading.hpp"

namespace hidwa_local_planner {
namespace {

using XmlRpc::XmlRpcValue;

class Words {
 public:
  explicit Words(const XmlRpcValue& content) { present_.content = content; }

  /// The value of a key, in DWB's layout before the flat one; nullptr where there is none.
  XmlRpcValue* find(const std::string& name) {
    XmlRpcValue& all = present_.content;
    if (const auto [group, member] = parts(name); has(group, member)) return &all[group][member];
    return all.hasMember(name) ? &all[name] : nullptr;
  }
  std::string text(const std::string& name, const std::string& fallback) {
    const XmlRpcValue* value = find(name);
    return value != nullptr ? as_text(*value) : fallback;
  }
  void put(const std::string& name, const XmlRpcValue& value) {
    forget(name);
    present_.former.erase(name);
    present_.content[name] = value;
  }
  void forget(const std::string& name) {
    const auto [group, member] = parts(name);
    if (present_.content.hasMember(name)) present_.former.insert(name);
    if (has(group, member)) present_.former.insert(group + "/" + member);
  }
  double number(const std::string& name, double fallback) {
    const XmlRpcValue* value = find(name);
    if (value == nullptr) return fallback;
    if (value->getType() == XmlRpcValue::TypeInt) return static_cast<const int&>(*value);
    return value->getType() == XmlRpcValue::TypeDouble ? static_cast<const double&>(*value) : fallback;
  }
  void refuse(const std::string& fault) { present_.faults.push_back(fault); }
  void say(const std::string& line) { present_.warnings.push_back(line); }
  const PresentContent& present() const { return present_; }

 private:
  static std::pair<std::string, std::string> parts(const std::string& name) {
    const std::size_t end = name.find('_');
    return {name.substr(0, end), end == std::string::npos ? "" : name.substr(end + 1)};
  }
  bool has(const std::string& group, const std::string& member) {
    XmlRpcValue& all = present_.content;
    return all.hasMember(group) && all[group].getType() == XmlRpcValue::TypeStruct && all[group].hasMember(member);
  }
  PresentContent present_;
};

/// A parameter that went. `was` is what it was where nobody set it; what `now` is depends on `take`.
struct Former {
  const char *name, *was;
  void (*take)(Words& words, const Former& former);
  const char* now;
  bool chose_method = false;  // files set these, all together, before there was a `method`

  std::string set(Words& words) const { return std::string(name) + ": " + words.text(name, was); }
};

/// Says `now`, which is what to do without it.
void drop(Words& words, const Former& former) {
  words.say("unknown parameter " + former.set(words) + " has no effect: " + former.now);
}

/// Another name, or one of several that are one now.
void rename(Words& words, const Former& former) {
  const XmlRpcValue value = *words.find(former.name);
  if (const XmlRpcValue* now = words.find(former.now); now != nullptr) {
    if (as_text(*now) == as_text(value)) return;
    return words.say("unknown parameter " + former.set(words) + " has no effect: " + former.now + ": " + as_text(*now) +
                     " holds");
  }
  words.put(former.now, value);
  words.say(former.set(words) + " is taken as " + former.now + ": " + as_text(value) + ": write that instead");
}

/// A weight of the critic `now`, which scores nothing: 0 switched it off.
void leave_out(Words& words, const Former& former) {
  if (words.number(former.name, 1.0) != 0.0) {
    return words.say("unknown parameter " + former.set(words) + " has no effect: " + former.now +
                     " only rejects: remove it");
  }
  std::string all, rest;
  XmlRpcValue* listed = words.find("critics");
  for (int i = 0; listed != nullptr && listed->getType() == XmlRpcValue::TypeArray && i < listed->size(); ++i) {
    all += as_text((*listed)[i]) + " ";
  }
  if (all.empty()) all = words.text("critics", Parameters().critics);
  for (const std::string& critic : split_names(all)) {
    if (short_name(critic) != former.now) rest += (rest.empty() ? "" : ", ") + critic;
  }
  words.put("critics", rest);
  words.say(former.set(words) + " is taken as critics: " + rest + ": write that instead");
}

/// The weight of a critic whose terms have weights of their own.
void distribute(Words& words, const Former& former) {
  std::string terms;
  for (const char* name : {"PreferForward_penalty", "PreferForward_theta_scale"}) {
    const double value =
        words.number(former.name, 1.0) * words.number(name, std::get<double>(parameter_info(name).value));
    words.put(name, value);
    terms += (terms.empty() ? "" : " and ") + std::string(name) + ": " + shortest(value);
  }
  words.say(former.set(words) + " is taken as " + terms + ": write those instead");
}

/// A weight of everything else, of which only the ratio to those of the operator counts.
void divide(Words& words, const Former& former) {
  const double weight = words.number(former.name, 1.0);
  if (weight <= 0.0) {
    return words.refuse(former.set(words) +
                        " is no weight now: raise s_v and s_omega, or leave critics out of critics");
  }
  std::string terms;
  for (const char* name : {"s_v", "s_omega"}) {
    const double value = words.number(name, std::get<double>(parameter_info(name).value)) / weight;
    words.put(name, value);
    terms += (terms.empty() ? "" : " and ") + std::string(name) + ": " + shortest(value);
  }
  words.say(former.set(words) + " is taken as " + terms + ": write those instead");
}

/// One of two names of joints, which `now` lists.
void pair_up(Words& words, const Former& former) {
  if (words.find(former.now) != nullptr) return;
  const std::string joints = words.text("left_wheel_joint", "") + ", " + words.text("right_wheel_joint", "");
  words.put(former.now, joints);
  words.say("left_wheel_joint and right_wheel_joint are taken as " + std::string(former.now) + ": [" + joints +
            "]: write that instead");
}

/// A sign of the axis `now`.
void turn_round(Words& words, const Former& former) {
  const ParameterInfo& info = parameter_info(former.now);
  const bool joy = info.type == "axis";
  std::string axis = words.text(former.now, to_text(info.value));
  if (words.text(former.name, "") != "-1" || axis == "-1") {
    return words.say("unknown parameter " + former.set(words) + " has no effect; " + former.now + " says it: " + axis +
                     (joy ? ", or such as 3 reversed" : ", or -" + axis));
  }
  const bool reversed_already = joy ? axis.find(' ') != std::string::npos : axis.front() == '-';
  if (!reversed_already) axis = joy ? axis + " reversed" : "-" + axis;
  words.put(former.now, axis);
  words.say(former.set(words) + " is taken as " + former.now + ": " + axis + ": write that instead");
}

/// One of two numbers that counted only as their product, which `now` is.
void multiply(Words& words, const Former& former) {
  const std::string radius = "wheel_radius", turning = "max_wheel_velocity";
  if (words.find(former.now) != nullptr) return;
  const double product = words.number(radius, 0.0) * words.number(turning, 0.0);
  if (product <= 0.0) {
    return words.refuse(former.set(words) + " without " + (former.name == radius ? turning : radius) +
                        " is no speed: write " + former.now + ", the radius times the turning speed, in its place");
  }
  words.put(former.now, product);
  words.say(radius + ": " + words.text(radius, "") + " and " + turning + ": " + words.text(turning, "") +
            " are taken as " + former.now + ": " + shortest(product) + ": write that instead");
}

/// A parameter that is two now; it counts on for itself.
void share(Words& words, const Former& former) {
  const XmlRpcValue* value = words.find(former.name);
  if (words.find(former.now) != nullptr) return;
  words.say(former.set(words) + " is taken as " + former.now + ": " + as_text(*value) +
            " too, which it was until 2026-11-29: write both");
  words.put(former.now, *value);
}

/// A part of what `method` says; `was` is it with method: hidwa, `now` with method: paper.
void follow_method(Words& words, const Former& former) {
  const std::string hidwa = former.was, paper = former.now;
  if (words.text(former.name, hidwa) == (words.text("method", "hidwa") == "paper" ? paper : hidwa)) return;
  words.say(std::string("unknown parameter ") + former.name + ": it has no effect; it is " + hidwa +
            (hidwa == paper
                 ? " with either method: remove it"
                 : " with method: hidwa, and " + paper + " with method: paper: set method instead, or remove it"));
}

constexpr Former kFormer[] = {
    {"axis_angular_sign", "1", turn_round, "axis_angular"},
    {"axis_linear_sign", "1", turn_round, "axis_linear"},
    {"clutch_axis_sign", "1", turn_round, "clutch_axis"},
    {"gesture_axis_sign", "1", turn_round, "gesture_axis"},
    {"gesture_linear_sign", "1", turn_round, "gesture_linear_axis"},
    {"wheel_radius", "0", multiply, "max_wheel_speed"},
    {"max_wheel_velocity", "0", multiply, "max_wheel_speed"},
    {"blocked_time", "1", share, "stall_time"},
    {"PathAlign_forward_point_distance", "0.1", rename, "forward_point_distance"},
    {"GoalAlign_forward_point_distance", "0.1", rename, "forward_point_distance"},
    {"BaseObstacle_sum_scores", "false", drop, "the cost at the last pose counts: remove it"},
    {"ObstacleFootprint_sum_scores", "false", drop, "the cost at the last pose counts: remove it"},
    {"RotateToGoal_slowing_factor", "5", drop, "it is 5: remove it"},
    {"RotateToGoal_lookahead_time", "0.5", follow_method, "-1"},
    {"Oscillation_scale", "1", leave_out, "Oscillation"},
    {"Oscillation_x_only_threshold", "0.05", drop, "it is 0.05 m/s: remove it"},
    {"Oscillation_reset_time", "-1", drop, "time alone allows nothing again: remove it"},
    {"PreferForward_scale", "1", distribute, ""},
    {"PreferForward_strafe_x", "0.1", drop, "it is 0.1 m/s: remove it"},
    {"PreferForward_strafe_theta", "0.2", drop, "it is 0.2 rad/s: remove it"},
    {"left_wheel_joint", "", pair_up, "wheel_joints"},
    {"right_wheel_joint", "", pair_up, "wheel_joints"},
    {"s_nv", "1", divide, ""},
    {"velocity_reference_tolerance_x", "0.2", drop, "it is 0.2 m/s: remove it"},
    {"velocity_reference_tolerance_theta", "0.5", drop, "it is 0.5 rad/s: remove it"},
    {"min_vel_theta", "0", drop,
     "max_vel_theta holds to both sides: remove it. Where the motors cannot turn slowly on the spot, set "
     "min_in_place_vel_theta"},
    {"velocity_reference", "command", follow_method, "odometry"},
    {"escape", "true", follow_method, "false"},
    {"turn_when_stuck", "true", follow_method, "false"},
    {"prune_distance", "1", drop, "it is 1 m: remove it"},
    {"forward_prune_auto", "true", follow_method, "false"},
    {"Oscillation_reset_dist", "0.05", drop, "it is 0.05 m: remove it"},
    {"Oscillation_reset_angle", "0.2", drop, "it is 0.2 rad: remove it"},
    {"clutch_threshold", "0.5", drop, "it is 0.5: remove it"},
    {"gesture_jump", "0.3", drop, "it is 0.3 m: remove it"},
    {"command", "feasible", follow_method, "target", true},
    {"hold_ends_when_refused", "true", follow_method, "false", true},
    {"hold_linear", "operator", follow_method, "operator", true},
    {"integration", "midpoint", follow_method, "euler", true},
    {"map_grid", "geodesic", follow_method, "l1", true},
    {"operator_in_goal_window", "false", follow_method, "true", true},
    {"oscillation_while_steering", "false", follow_method, "true", true},
    {"plan_hysteresis", "0.2", follow_method, "0", true},
    {"sample_operator", "true", follow_method, "false", true},
    {"sample_previous", "true", follow_method, "false", true},
    {"sample_zero", "true", follow_method, "false", true},
    {"tie_break", "least_change", follow_method, "first", true},
};

/// A file of before that sets all parts of the method as the paper has them means the paper's method. Fewer of them
/// have no effect.
void find_method(Words& words) {
  if (words.find("method") != nullptr) return;
  const bool paper = std::all_of(std::begin(kFormer), std::end(kFormer), [&](const Former& former) {
    return !former.chose_method || std::string(former.was) == former.now ||
           words.text(former.name, former.was) == former.now;
  });
  if (!paper) return;
  words.put("method", std::string("paper"));
  words.say(
      "method: paper is in force, for sample_zero, tie_break and the others that it took the place of are all set as "
      "the paper has them: write method: paper instead of them");
}

}  // namespace

PresentContent in_present_words(const XmlRpcValue& content) {
  Words words(content);
  find_method(words);
  for (const Former& former : kFormer) {
    if (words.find(former.name) == nullptr) continue;
    if (words.text(former.name, "") != former.was || former.take == follow_method) {
      former.take(words, former);
    }
    if (former.take != share) words.forget(former.name);
  }
  return words.present();
}

}  // namespace hidwa_local_planner
