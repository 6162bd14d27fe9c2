// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "sim/operator.hpp"

namespace hidwa_local_planner {
namespace sim {

/// One deflection of the stick. It begins when every condition given holds, and not before the one ahead of
/// it in the script has ended.
struct ScriptEntry {
  std::optional<double> after_m;       // [m], distance driven since the start
  std::optional<double> when_x_below;  // [m], map frame
  std::optional<double> when_x_above;  // [m]
  std::optional<double> when_y_below;  // [m]
  std::optional<double> when_y_above;  // [m]
  double for_s = 0.0;                  // [s], how long
  Stick stick;
};

/// Reads a list of entries such as `{after_m: 12.0, for_s: 3.0, stick: [1.0, 0.0]}` (stick: left, up). Throws
/// std::runtime_error naming file, entry and fault.
std::vector<ScriptEntry> load_script(const std::string& yaml_path);

/// Follows a script; the stick is centred before, between and after its entries.
class ScriptedOperator : public Operator {
 public:
  explicit ScriptedOperator(std::vector<ScriptEntry> script);

  Stick update(const Observation& observation) override;

 private:
  bool begins(const ScriptEntry& entry, const Pose& pose) const;

  std::vector<ScriptEntry> script_;
  std::size_t current_ = 0;
  std::optional<double> began_;  // [s], when the current entry began
  std::optional<Pose> last_pose_;
  double distance_ = 0.0;  // [m]
};

}  // namespace sim
}  // namespace hidwa_local_planner
