// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

#include "critics/built_in_entry.hpp"
#include "hidwa_local_planner/core/critic.hpp"

namespace hidwa_local_planner::critics {
namespace {

constexpr double kHardlyDrives = 0.05;  // [m/s]
constexpr double kMoved = 0.05;         // [m]
constexpr double kTurned = 0.2;         // [rad]

/// Ends driving or turning back and forth: after a commanded change of sign only the new direction is legal, until the
/// robot has moved or turned enough. Turning counts only while the robot hardly drives. Scores 0. While the
/// person steers it rejects only with `method: paper`; where the person decides it rejects nothing.
class Oscillation : public Critic {
 public:
  double configure(const Parameters& parameters, const ParameterSource& /*own*/) override {
    while_steering_ = parameters.method == Method::paper;
    return 1.0;
  }

  void prepare(const CycleView& cycle) override {
    silent_ = cycle.operator_decides || (cycle.steered && !while_steering_);
  }

  void score(const CycleView& /*cycle*/, const Tile& tile, TileScores& scores) override {
    if (silent_ || (x_.only == 0 && theta_.only == 0)) return;
    for (std::size_t c = 0; c < tile.count; ++c) {
      if (!scores.rejected(c) && (x_.bans(tile.v[c]) || theta_.bans(tile.omega))) {
        scores.reject(c, "goes back and forth");
      }
    }
  }

  void debrief(const CycleView& cycle, const Twist2& command) override {
    bool changed = x_.note(command.v);
    if (std::abs(command.v) <= kHardlyDrives && theta_.note(command.omega)) changed = true;
    if (changed) since_pose_ = cycle.pose;
    if ((x_.only != 0 || theta_.only != 0) && may_forget(cycle)) reset();
  }

  void reset() override { x_ = theta_ = Axis{}; }

  void save(ArchiveWriter& state) const override { archive(*this, state); }
  void load(ArchiveReader& state) override { archive(*this, state); }

 private:
  /// What one axis may do: 0 both directions, +1 only positive, -1 only negative.
  struct Axis {
    int last_sign = 0;
    int only = 0;
    // True when the sign changed.
    bool note(double velocity) {
      const int sign = velocity > 0.0 ? 1 : velocity < 0.0 ? -1 : 0;
      const bool changed = sign != 0 && last_sign != 0 && sign != last_sign;
      if (changed) only = sign;
      if (sign != 0) last_sign = sign;
      return changed;
    }
    bool bans(double velocity) const { return velocity * only < 0.0; }
    template <typename Self, typename Archive>
    static void archive(Self& self, Archive& io) {
      io(self.last_sign, self.only);
    }
  };

  bool may_forget(const CycleView& cycle) const {
    return distance(cycle.pose, since_pose_) > kMoved ||
           std::abs(wrap_angle(cycle.pose.theta - since_pose_.theta)) > kTurned;
  }

  template <typename Self, typename Archive>
  static void archive(Self& self, Archive& io) {
    io(self.x_, self.theta_, self.since_pose_);
  }

  bool while_steering_ = false;
  bool silent_ = false;
  Axis x_, theta_;
  Pose2 since_pose_;
};

const BuiltInEntry entry("Oscillation", make<Oscillation>);

}  // namespace
}  // namespace hidwa_local_planner::critics
