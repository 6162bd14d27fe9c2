// SPDX-License-Identifier: BSD-3-Clause
#include "sim/scripted_operator.hpp"

#include <cmath>
#include <utility>

#include "yaml_file.hpp"

namespace hidwa_local_planner {
namespace sim {
namespace {

ScriptEntry read_entry(const YamlFile& file, const YAML::Node& node, const std::string& name) {
  if (!node.IsMap()) file.fail(name + " must be a map such as {after_m: 12.0, for_s: 3.0, stick: [1.0, 0.0]}");
  ScriptEntry entry;
  bool triggered = false;
  for (const auto& item : node) {
    const auto key = item.first.as<std::string>();
    const std::string full = name + "." + key;
    const auto condition = [&](std::optional<double>& field) {
      field = file.as<double>(item.second, full);
      triggered = true;
    };
    if (key == "after_m") {
      condition(entry.after_m);
    } else if (key == "when_x_below") {
      condition(entry.when_x_below);
    } else if (key == "when_x_above") {
      condition(entry.when_x_above);
    } else if (key == "when_y_below") {
      condition(entry.when_y_below);
    } else if (key == "when_y_above") {
      condition(entry.when_y_above);
    } else if (key != "for_s" && key != "stick") {
      file.fail("'" + full +
                "' is not known: after_m, when_x_below, when_x_above, when_y_below, when_y_above, "
                "for_s and stick are");
    }
  }
  if (!triggered) file.fail(name + " says not when: give after_m, or when_x_below, when_x_above, when_y_below, ...");
  entry.for_s = file.as<double>(node["for_s"], name + ".for_s");
  if (!(entry.for_s > 0.0)) file.fail("'" + name + ".for_s' must be positive [s]");
  const auto stick = file.as<std::vector<double>>(node["stick"], name + ".stick");
  if (stick.size() != 2 || !(std::abs(stick[0]) <= 1.0 && std::abs(stick[1]) <= 1.0)) {
    file.fail("'" + name + ".stick' must be [left, up], each from -1 to 1");
  }
  entry.stick = {stick[0], stick[1]};
  return entry;
}

}  // namespace

std::vector<ScriptEntry> load_script(const std::string& yaml_path) {
  const YamlFile file(yaml_path);
  if (!file.root().IsSequence()) file.fail("must be a list of entries {after_m: ..., for_s: ..., stick: [left, up]}");
  std::vector<ScriptEntry> script;
  for (std::size_t i = 0; i < file.root().size(); ++i) {
    script.push_back(read_entry(file, file.root()[i], "entry " + std::to_string(i + 1)));
  }
  return script;
}

ScriptedOperator::ScriptedOperator(std::vector<ScriptEntry> script) : script_(std::move(script)) {}

bool ScriptedOperator::begins(const ScriptEntry& e, const Pose& pose) const {
  return (!e.after_m || distance_ >= *e.after_m) && (!e.when_x_below || pose.x < *e.when_x_below) &&
         (!e.when_x_above || pose.x > *e.when_x_above) && (!e.when_y_below || pose.y < *e.when_y_below) &&
         (!e.when_y_above || pose.y > *e.when_y_above);
}

Stick ScriptedOperator::update(const Observation& now) {
  if (last_pose_) distance_ += std::hypot(now.pose.x - last_pose_->x, now.pose.y - last_pose_->y);
  last_pose_ = now.pose;
  constexpr double kRounding = 1e-6;  // [s], of differences of times
  if (began_ && now.time - *began_ >= script_[current_].for_s - kRounding) {
    began_.reset();
    ++current_;
  }
  if (!began_ && current_ < script_.size() && begins(script_[current_], now.pose)) began_ = now.time;
  return began_ ? script_[current_].stick : Stick();
}

}  // namespace sim
}  // namespace hidwa_local_planner
