// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>

#include "critics/built_in_entry.hpp"
#include "hidwa_local_planner/core/critic.hpp"

namespace hidwa_local_planner::critics {
namespace {

// A sample slower than this does not drive [m/s].
constexpr double kStill = 1e-5;

constexpr double kSlowingFactor = 5.0;  // [rad s^2/m^2]
constexpr double kLookahead = 0.5;      // [s]

/// Turns the robot to the goal's heading once it is there. Outside the position tolerance it scores 0. Inside, latched
/// until a new goal: while still driving it rejects what does not slow down and scores speed^2 * kSlowingFactor plus
/// the heading error; once stopped, also latched, it rejects driving and scores the heading error [rad]. While the
/// person steers, or a way leads to the heading, it scores likewise and rejects nothing.
///
/// The heading is that at the lookahead time, or with `method: paper` that at the end of the rollout.
///
/// Autonomy's turn ends gently: the heading error is that of where the turn comes to rest if it slows down within
/// comfort_acc_lim_theta from the lookahead time on: omega^2 / (2 a) farther (constant deceleration a).
class RotateToGoal : public Critic {
 public:
  double configure(const Parameters& parameters, const ParameterSource& /*own*/) override {
    xy_goal_tolerance_ = parameters.xy_goal_tolerance;
    trans_stopped_velocity_ = parameters.trans_stopped_velocity;
    looks_ahead_ = parameters.method != Method::paper;
    comfort_ = parameters.turns_gently() ? parameters.comfort_acc_lim_theta : 0.0;
    return parameters.RotateToGoal_scale;
  }

  void prepare(const CycleView& cycle) override {
    if (cycle.goal_next && distance(cycle.pose, cycle.goal) <= xy_goal_tolerance_) in_window_ = true;
    if (in_window_ && std::abs(cycle.velocity.v) <= trans_stopped_velocity_) rotating_ = true;
    speed2_ = cycle.velocity.v * cycle.velocity.v;
    rejects_ = !cycle.steered && !cycle.operator_decides;
  }

  void score(const CycleView& cycle, const Tile& tile, TileScores& scores) override {
    if (!in_window_) return;
    const double error = heading_error(tile, cycle.goal.theta);
    for (std::size_t c = 0; c < tile.count; ++c) {
      if (scores.rejected(c)) continue;
      const double speed2 = tile.v[c] * tile.v[c];
      if (rejects_ && rotating_ && std::abs(tile.v[c]) > kStill) {
        scores.reject(c, "drives on although the goal's position is reached");
      } else if (rejects_ && !rotating_ && speed2 >= speed2_) {
        scores.reject(c, "does not slow down at the goal");
      } else {
        scores.set(c, rotating_ ? error : speed2 * kSlowingFactor + error);
      }
    }
  }

  void reset() override { in_window_ = rotating_ = false; }

  void save(ArchiveWriter& state) const override { state(in_window_, rotating_); }
  void load(ArchiveReader& state) override { state(in_window_, rotating_); }

 private:
  double heading_error(const Tile& tile, double goal_heading) const {
    double heading = tile.heading[tile.steps], omega = tile.omega_at[tile.steps];
    if (looks_ahead_) {
      const double at = std::min(kLookahead / tile.dt, static_cast<double>(tile.steps));
      const auto k = std::min(static_cast<std::size_t>(at), tile.steps - 1);
      const double part = at - static_cast<double>(k);
      heading = tile.heading[k] + part * (tile.heading[k + 1] - tile.heading[k]);
      omega = tile.omega_at[k] + part * (tile.omega_at[k + 1] - tile.omega_at[k]);
    }
    if (rejects_ && comfort_ > 0.0) heading += omega * std::abs(omega) / (2.0 * comfort_);
    return std::abs(wrap_angle(goal_heading - heading));
  }

  double xy_goal_tolerance_ = 0.25;      // [m]
  double trans_stopped_velocity_ = 0.1;  // [m/s]
  bool looks_ahead_ = true;
  double comfort_ = 0.0;  // [rad/s^2]; 0: the turn need not end gently
  bool in_window_ = false;
  bool rotating_ = false;
  bool rejects_ = true;
  double speed2_ = 0.0;  // squared current speed [m^2/s^2]
};

const BuiltInEntry entry("RotateToGoal", make<RotateToGoal>);

}  // namespace
}  // namespace hidwa_local_planner::critics
