// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <vector>

#include "critics/built_in_entry.hpp"

namespace hidwa_local_planner::critics {
namespace {

using To = PlanDistance::To;
enum class From { centre, nose };

// Of equals the first; without a plan the robot's own.
Pose2 nearest_pose(const std::vector<Pose2>& plan, const Pose2& robot) {
  const auto nearest = std::min_element(plan.begin(), plan.end(), [&](const Pose2& a, const Pose2& b) {
    return distance(a, robot) < distance(b, robot);
  });
  return nearest == plan.end() ? robot : *nearest;
}

double bearing_error(const Pose2& pose, const Pose2& target) {
  return std::abs(wrap_angle(std::atan2(target.y - pose.y, target.x - pose.x) - pose.theta));
}

/// The raw score is how far from the plan or from the local goal, the last pose of the plan's window, a candidate ends
/// [m]: its centre, or its nose, a point ahead of it. The nose aligns the robot. The local goal of the nose is moved
/// ahead as far, towards the final goal. It weighs scale/2 per metre, as Nav2's resolution * scale / 2 per cell.
/// Where no pose of the plan lies on the map, the score is how far the last pose's heading is off the bearing to the
/// nearest plan pose [rad], so that a steered robot can be led back.
/// `method: paper` rejects candidates whose point has no way to the plan, as Nav2 does, unless the operator decides.
class MapGridCritic final : public Critic {
 public:
  MapGridCritic(To to, From from, double Parameters::*scale) : to_(to), from_(from), scale_(scale) {}

  double configure(const Parameters& parameters, const ParameterSource& /*own*/) override {
    paper_ = parameters.method == Method::paper;
    forward_ = from_ == From::nose ? parameters.forward_point_distance : 0.0;
    return 0.5 * parameters.*scale_;
  }

  void prepare(const CycleView& cycle) override {
    off_map_ = !cycle.plan_on_map();
    rejects_ = paper_ && !cycle.operator_decides;
    chosen_ = choose(cycle);
    unreached_ = cycle.grid->resolution * (cycle.grid->size_x + cycle.grid->size_y);
    if (off_map_) {
      nearest_ = nearest_pose(*cycle.plan, cycle.pose);
    } else if (chosen_) {
      cycle.expect(*chosen_);
    }
  }

  void score(const CycleView& /*cycle*/, const Tile& tile, TileScores& scores) override {
    if (off_map_) return score_bearings(tile, scores);
    if (!chosen_) return;
    double* raw = scores.set_all();
    if (!tile.distances(*chosen_, forward_, scores, raw)) score_unreached(tile, raw, scores);
  }

 private:
  std::optional<PlanDistance> choose(const CycleView& cycle) const {
    if (to_ == To::goal) return PlanDistance::to_goal(forward_);
    // At the goal the nose lies beyond the path's end: it would push the robot back.
    if (from_ == From::nose && distance(cycle.pose, cycle.goal) <= forward_) return std::nullopt;
    return PlanDistance::to_path();
  }

  void score_bearings(const Tile& tile, TileScores& scores) const {
    for (std::size_t c = 0; c < tile.count; ++c) {
      if (!scores.rejected(c)) scores.set(c, bearing_error(tile.last_pose(c), nearest_));
    }
  }

  // Where the distance is negative: there is no way, or the candidate is rejected already and nothing was measured.
  void score_unreached(const Tile& tile, double* raw, TileScores& scores) const {
    for (std::size_t c = 0; c < tile.count; ++c) {
      if (raw[c] >= 0.0) continue;
      if (!scores.rejected(c) && rejects_) scores.reject(c, "trajectory leaves the map or the plan cannot be reached");
      raw[c] = scores.rejected(c) ? 0.0 : unreached_;
    }
  }

  const To to_;
  const From from_;
  double Parameters::*const scale_;
  bool paper_ = false;    // method: paper
  double forward_ = 0.0;  // the point's distance ahead of the robot [m]

  std::optional<PlanDistance> chosen_;  // none: the critic is off in this cycle
  bool off_map_ = false;
  bool rejects_ = false;    // what has no way to the plan
  Pose2 nearest_;           // the plan's pose nearest to the robot, when it is off the map
  double unreached_ = 0.0;  // the score where there is no way [m]
};

template <To to, From from, double Parameters::*scale>
std::shared_ptr<Critic> make_grid() {
  return std::make_shared<MapGridCritic>(to, from, scale);
}

namespace path_dist {
const BuiltInEntry entry("PathDist", make_grid<To::path, From::centre, &Parameters::PathDist_scale>);
}
namespace path_align {
const BuiltInEntry entry("PathAlign", make_grid<To::path, From::nose, &Parameters::PathAlign_scale>);
}
namespace goal_dist {
const BuiltInEntry entry("GoalDist", make_grid<To::goal, From::centre, &Parameters::GoalDist_scale>);
}
namespace goal_align {
const BuiltInEntry entry("GoalAlign", make_grid<To::goal, From::nose, &Parameters::GoalAlign_scale>);
}

}  // namespace
}  // namespace hidwa_local_planner::critics
