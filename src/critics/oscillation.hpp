// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "hidwa_local_planner/core/critic.hpp"

namespace hidwa_local_planner {

/// Ends driving or turning back and forth: after a commanded change of sign only the new direction is legal, until the
/// robot has moved, turned or waited enough. Turning counts only while the robot hardly drives. Scores 0. While the
/// person steers it does not refuse, unless `oscillation_while_steering`; where the person decides it never does.
class OscillationCritic : public Critic {
 public:
  double configure(const Parameters& parameters, const ParameterSource& own) override;
  void prepare(const CycleView& cycle) override;
  void score(const CycleView& cycle, const Tile& tile, TileScores& scores) override;
  void debrief(const CycleView& cycle, const Twist2& command) override;
  void reset() override;
  void save(ArchiveWriter& state) const override { archive(*this, state); }
  void load(ArchiveReader& state) override { archive(*this, state); }

 private:
  /// What one axis may do: 0 both directions, +1 only positive, -1 only negative.
  struct Axis {
    int last_sign = 0;
    int only = 0;
    bool note(double velocity);  // true when the sign changed
    bool bans(double velocity) const { return velocity * only < 0.0; }
    template <typename Self, typename Archive>
    static void archive(Self& self, Archive& io) {
      io(self.last_sign, self.only);
    }
  };
  bool may_forget(const CycleView& cycle) const;
  template <typename Self, typename Archive>
  static void archive(Self& self, Archive& io) {
    io(self.x_, self.theta_, self.since_pose_, self.since_time_);
  }

  double x_only_threshold_ = 0.05;  // [m/s]
  double reset_dist_ = 0.05;        // [m]
  double reset_angle_ = 0.2;        // [rad]
  double reset_time_ = -1.0;        // [s]; negative: never
  bool while_steering_ = false;
  bool silent_ = false;
  Axis x_, theta_;
  Pose2 since_pose_;
  double since_time_ = 0.0;  // [s]
};

}  // namespace hidwa_local_planner
