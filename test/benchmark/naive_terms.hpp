// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "support/scene.hpp"

namespace hidwa_local_planner::test {

/// The default critics and the operator's term as plain functions. Oscillation has nothing to say while a
/// person steers.
class NaiveTerms {
 public:
  /// Makes the distances to the plan, to its end and to its end moved ahead.
  explicit NaiveTerms(const Scene& scene);

  /// J of a rollout; nothing where a critic rejects it.
  std::optional<double> total(const Twist2& sample, const std::vector<Pose2>& poses) const;

 private:
  double distance_at(const std::vector<int>& distances, double x, double y) const;
  double map_grid(const std::vector<int>& distances, double forward, const Pose2& last) const;
  std::optional<double> base_obstacle(const std::vector<Pose2>& poses) const;
  std::optional<double> rotate_to_goal(const Twist2& sample, const Pose2& last) const;

  const Scene& scene_;
  GridView grid_;
  std::vector<int> path_, goal_, ahead_;  // in fifths of a cell
  bool aligns_ = true;                    // PathAlign says nothing at the goal
};

}  // namespace hidwa_local_planner::test
