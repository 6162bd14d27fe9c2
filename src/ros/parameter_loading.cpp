// SPDX-License-Identifier: BSD-3-Clause
#include "ros/parameter_loading.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <sstream>

#include "hidwa_local_planner/critics/built_in.hpp"
#include "ros/former_parameters.hpp"

namespace hidwa_local_planner {
namespace {

using XmlRpc::XmlRpcValue;

/// A list of names as the text that split_names() reads; nothing where an element is no text.
std::optional<std::string> joined(const XmlRpcValue& list) {
  std::string text;
  for (int i = 0; i < list.size(); ++i) {
    const XmlRpcValue& element = list[i];
    if (element.getType() != XmlRpcValue::TypeString) return std::nullopt;
    text += (i == 0 ? "" : ", ") + static_cast<const std::string&>(element);
  }
  return text;
}

bool takes_list(const ParameterInfo& info) { return info.name == "critics" || info.name == "wheel_joints"; }

std::optional<ParameterValue> converted(const ParameterInfo& info, const XmlRpcValue& value) {
  switch (value.getType()) {
    case XmlRpcValue::TypeBoolean: {
      const bool flag = static_cast<const bool&>(value);
      // YAML 1.1 reads the bare word off as false.
      if (info.type == "enum" && !flag) return ParameterValue(std::string("off"));
      return ParameterValue(flag);
    }
    case XmlRpcValue::TypeInt:
      return ParameterValue(static_cast<const int&>(value));
    case XmlRpcValue::TypeDouble:
      return ParameterValue(static_cast<const double&>(value));
    case XmlRpcValue::TypeString:
      return ParameterValue(static_cast<const std::string&>(value));
    case XmlRpcValue::TypeArray: {
      const std::optional<std::string> names = joined(value);
      if (!takes_list(info) || !names) return std::nullopt;
      return ParameterValue(*names);
    }
    default:
      return std::nullopt;
  }
}

std::string remedy_for(const ParameterInfo& info, const XmlRpcValue& value) {
  if (value.getType() == XmlRpcValue::TypeString && info.is_number()) {
    return kNumberIsText;
  }
  if (value.getType() == XmlRpcValue::TypeDouble && info.type == "int") return " (write it without a decimal point)";
  return "";
}

void take(LoadedParameters& loaded, const ParameterInfo& info, const std::string& key, const XmlRpcValue& value) {
  std::string fault;
  if (const std::optional<ParameterValue> plain = converted(info, value)) {
    fault = set_parameter(loaded.parameters, info.name, *plain);
  } else {
    fault = info.name + ": expected a single value" + (takes_list(info) ? " or a list of names" : "");
  }
  if (!fault.empty()) {
    loaded.faults.push_back(fault + ", found " + key + ": " + as_text(value) + remedy_for(info, value));
    return;
  }
  loaded.found.push_back(key + ": " + as_text(value));
}

std::string unknown(const std::string& key) {
  if (const std::string remark = remark_on(key); !remark.empty()) {
    return "unknown parameter " + key + ": it has no effect; " + remark;
  }
  const std::string near = suggestion_for(key);
  return "unknown parameter " + key +
         (near.empty() ? ": it has no effect; remove it, or find the right name in docs/use/parameters.md"
                       : ": it has no effect; do you mean " + near + "?");
}

/// DWB's layout, `PathAlign: {scale: 32}`.
void take_nested(LoadedParameters& loaded, const std::string& group, const XmlRpcValue& members,
                 const std::set<std::string>& former) {
  for (const auto& [member, value] : members) {
    const std::string key = group + "/" + member;
    if (former.count(key) != 0) continue;
    const std::string flat = group + "_" + member;
    const ParameterInfo* info = find_parameter(flat);
    if (info == nullptr) {
      const std::string near = suggestion_for(flat);
      loaded.warnings.push_back("unknown parameter " + key + ": it has no effect" +
                                (near.empty() ? "" : "; do you mean " + near + "?"));
      continue;
    }
    take(loaded, *info, key, value);
    loaded.aliases.push_back(key);
  }
}

std::size_t edit_distance(const std::string& a, const std::string& b) {
  std::vector<std::size_t> row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t change = diagonal + (std::tolower(a[i - 1]) == std::tolower(b[j - 1]) ? 0u : 1u);
      diagonal = row[j];
      row[j] = std::min({row[j] + 1, row[j - 1] + 1, change});
    }
  }
  return row[b.size()];
}

}  // namespace

LoadedParameters load_parameters(const XmlRpcValue& content,
                                 const std::function<Parameters(const Parameters&)>& completed) {
  LoadedParameters loaded;
  if (!content.valid()) return loaded;
  if (content.getType() != XmlRpcValue::TypeStruct) {
    loaded.faults.push_back("expected the planner's parameters by name, found " + as_text(content));
    return loaded;
  }
  const PresentContent present = in_present_words(content);
  loaded.faults = present.faults;
  loaded.warnings = present.warnings;
  // What was refused stays where it is: the next start must find it.
  if (present.faults.empty()) loaded.aliases.assign(present.former.begin(), present.former.end());
  std::vector<std::pair<std::string, const XmlRpcValue*>> groups;
  for (const auto& [key, value] : present.content) {
    if (present.former.count(key) != 0) continue;
    if (const ParameterInfo* info = find_parameter(key)) {
      take(loaded, *info, key, value);
    } else if (value.getType() == XmlRpcValue::TypeStruct) {
      groups.emplace_back(key, &value);
    } else {
      loaded.warnings.push_back(unknown(key));
    }
  }
  std::set<std::string> listed;
  for (const std::string& critic : split_names(loaded.parameters.critics)) listed.insert(short_name(critic));
  const CriticRegistry own = critics::built_in();
  for (const auto& [group, members] : groups) {
    if (own.knows(group)) {
      take_nested(loaded, group, *members, present.former);
    } else if (!remark_on(group).empty()) {
      loaded.warnings.push_back(unknown(group));
    } else if (listed.count(group) == 0) {
      loaded.warnings.push_back("unknown namespace " + group + ": no critic of that name is listed in critics");
    }
  }
  const Parameters whole = completed ? completed(loaded.parameters) : loaded.parameters;
  for (const std::string& fault : validate(whole)) loaded.faults.push_back(fault);
  return loaded;
}

std::vector<std::string> misplaced_parameters(const XmlRpcValue& host) {
  std::vector<std::string> names;
  if (!host.valid() || host.getType() != XmlRpcValue::TypeStruct) return names;
  for (const auto& [key, value] : host) {
    if (key == "controller_frequency" || key == "odom_topic") continue;  // the host's own
    if (find_parameter(key) != nullptr) names.push_back(key);
  }
  return names;
}

std::string as_text(const XmlRpcValue& value) {
  if (value.getType() == XmlRpcValue::TypeBoolean) return static_cast<bool>(XmlRpcValue(value)) ? "true" : "false";
  std::ostringstream text;
  value.write(text);
  return text.str();
}

std::string short_name(const std::string& critic) {
  const std::size_t end = critic.find_last_of("/:");
  return end == std::string::npos ? critic : critic.substr(end + 1);
}

std::string suggestion_for(const std::string& key) {
  // What base_local_planner, DWA, DWB and TEB call it.
  static const std::map<std::string, std::string> others = {
      {"max_trans_vel", "max_vel_x"},
      {"max_vel_trans", "max_vel_x"},
      {"max_speed_xy", "max_vel_x"},
      {"max_vel_x_backwards", "min_vel_x (negative)"},
      {"max_rot_vel", "max_vel_theta"},
      {"max_rotational_vel", "max_vel_theta"},
      {"min_in_place_rotational_vel", "min_in_place_vel_theta"},
      {"acc_lim_th", "acc_lim_theta"},
      {"acc_lim_trans", "acc_lim_x"},
      {"acc_limit_trans", "acc_lim_x"},
      {"theta_stopped_vel", "rot_stopped_velocity"},
      {"rot_stopped_vel", "rot_stopped_velocity"},
      {"trans_stopped_vel", "trans_stopped_velocity"},
      {"sim_granularity", "linear_granularity"},
      {"angular_sim_granularity", "angular_granularity"},
      {"vtheta_samples", "vth_samples"},
      {"path_distance_bias", "PathDist_scale (its unit differs)"},
      {"pdist_scale", "PathDist_scale (its unit differs)"},
      {"goal_distance_bias", "GoalDist_scale (its unit differs)"},
      {"gdist_scale", "GoalDist_scale (its unit differs)"},
      {"occdist_scale", "BaseObstacle_scale (its unit differs)"},
      {"twirling_scale", "Twirling_scale, with Twirling in critics"},
      {"PathAlign.forward_point_distance", "forward_point_distance"},
      {"GoalAlign.forward_point_distance", "forward_point_distance"},
      {"max_scaling_factor", "footprint_padding"},
      {"min_obstacle_dist", "footprint_padding"},
      {"dwa", "generator: dwa"},
      {"use_dwa", "generator: dwa"}};
  const auto other = others.find(key);
  if (other != others.end()) return other->second;
  if (!remark_on(key).empty()) return "";

  std::vector<std::string> names;
  for (const ParameterInfo& info : parameter_table()) names.push_back(info.name);
  return nearest_name(key, names);
}

std::string remark_on(const std::string& key) {
  static const std::string sideways = "the robot does not drive sideways: remove it";
  static const std::string minimum =
      "remove it. Where the motors cannot turn slowly on the spot, set min_in_place_vel_theta; where they cannot drive "
      "slowly, min_vel_x";
  static const std::string always = "candidates are published whenever somebody subscribes: remove it";
  static const std::string frames = "the frames are those of the costmaps: remove it";
  static const std::map<std::string, std::string> remarks = {
      {"max_vel_y", sideways},
      {"min_vel_y", sideways},
      {"acc_lim_y", sideways},
      {"decel_lim_y", sideways},
      {"vy_samples", sideways},
      {"y_vels", sideways},
      {"holonomic_robot", sideways},
      {"min_trans_vel", minimum},
      {"min_vel_trans", minimum},
      {"min_speed_xy", minimum},
      {"min_rot_vel", minimum},
      {"min_speed_theta", minimum},
      {"oscillation_reset_dist", "it is 0.05 m: remove it"},
      {"oscillation_reset_angle", "it is 0.2 rad: remove it"},
      {"latch_xy_goal_tolerance", "the goal's position is always latched: remove it"},
      {"prune_plan", "the plan is always pruned (forward_prune_distance): remove it"},
      {"stop_time_buffer", "admissibility: braking sees to it that the robot stops in time: remove it"},
      {"scaling_speed", "admissibility: braking sees to it that the robot stops in time: remove it"},
      {"escape_vel", "for driving backwards set a negative min_vel_x, else remove it"},
      {"backup_vel", "for driving backwards set a negative min_vel_x, else remove it"},
      {"meter_scoring", "distances are always in metres: remove it"},
      {"publish_traj_pc", always},
      {"publish_cost_grid_pc", always},
      {"publish_evaluation", always},
      {"debug_trajectory_details", always},
      {"global_frame_id", frames},
      {"map_frame", frames},
      {"footprint_model", "the footprint is the local costmap's (footprint or robot_radius): remove it"}};
  const auto remark = remarks.find(key);
  return remark == remarks.end() ? "" : remark->second;
}

std::string nearest_name(const std::string& misspelt, const std::vector<std::string>& names) {
  const std::size_t limit = std::max<std::size_t>(2, misspelt.size() / 5);
  std::string best;
  std::size_t smallest = limit + 1;
  for (const std::string& name : names) {
    const std::size_t distance = edit_distance(misspelt, name);
    if (distance < smallest && distance < name.size()) {
      smallest = distance;
      best = name;
    }
  }
  return best;
}

}  // namespace hidwa_local_planner
