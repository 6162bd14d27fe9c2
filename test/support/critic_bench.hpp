// SPDX-License-Identifier: BSD-3-Clause
// One critic, one candidate, poses by hand.
#pragma once

#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "core/distance/plan_grids.hpp"
#include "hidwa_local_planner/core/critic.hpp"
#include "hidwa_local_planner/core/critic_registry.hpp"
#include "hidwa_local_planner/core/footprint.hpp"
#include "hidwa_local_planner/critics/built_in.hpp"
#include "support/scene.hpp"

namespace hidwa_local_planner::test {

/// A tile of one candidate.
class HandTile {
 public:
  HandTile(const Twist2& u, const std::vector<Pose2>& poses, double dt = 0.1) : v_(u.v) {
    for (const Pose2& q : poses) {
      x_.push_back(q.x);
      y_.push_back(q.y);
      heading_.push_back(q.theta);
      cos_.push_back(std::cos(q.theta));
      sin_.push_back(std::sin(q.theta));
      omega_at_.push_back(u.omega);
    }
    tile_.omega = u.omega;
    tile_.dt = dt;
    tile_.steps = poses.size() - 1;
    tile_.count = tile_.stride = 1;
    tile_.v = &v_;
    tile_.x = x_.data();
    tile_.y = y_.data();
    tile_.heading = heading_.data();
    tile_.cos_heading = cos_.data();
    tile_.sin_heading = sin_.data();
    tile_.omega_at = omega_at_.data();
  }
  HandTile(const HandTile&) = delete;
  HandTile& operator=(const HandTile&) = delete;
  const Tile& tile() const { return tile_; }

 private:
  double v_;
  std::vector<double> x_, y_, heading_, cos_, sin_, omega_at_;
  Tile tile_;
};

struct Verdict {
  double raw = 0.0;
  std::string reason;  // empty where it is legal
  bool refused() const { return !reason.empty(); }
};

/// A built-in critic in a scene.
class CriticBench {
 public:
  CriticBench(const std::string& name, const Scene& scene) : scene_(scene), critic_(critics::built_in().make(name)) {
    weight_ = critic_->configure(scene_.parameters, none_);
  }
  double weight() const { return weight_; }
  Critic& critic() { return *critic_; }
  Scene& scene() { return scene_; }

  void prepare() {
    grid_ = scene_.grid();
    footprint_ = Footprint::from_outline(scene_.outline, scene_.parameters.footprint_padding);
    grids_.prepare(grid_, scene_.situation.plan, scene_.parameters.map_grid, scene_.parameters.unknown_is_obstacle);
    critic_->prepare(view());
  }
  Verdict score(const Twist2& u, const std::vector<Pose2>& poses, double dt = 0.1) {
    const HandTile hand(u, poses, dt);
    Verdict verdict;
    const char* reason = nullptr;
    TileScores scores(&verdict.raw, &reason, 1);
    critic_->score(view(), hand.tile(), scores);
    if (reason != nullptr) verdict.reason = reason;
    return verdict;
  }
  void debrief(const Twist2& command) { critic_->debrief(view(), command); }

 private:
  struct NoParameters : ParameterSource {
    double number(const std::string& /*key*/, double fallback) const override { return fallback; }
    bool flag(const std::string& /*key*/, bool fallback) const override { return fallback; }
  };
  CycleView view() {
    CycleView cycle;
    cycle.pose = scene_.situation.pose;
    cycle.velocity = scene_.situation.velocity;
    cycle.last_command = scene_.situation.last_command;
    cycle.goal = scene_.situation.goal;
    cycle.time = scene_.situation.time;
    cycle.steered = scene_.intent.influence != Influence::none;
    cycle.person_decides =
        cycle.steered && (scene_.intent.influence == Influence::direct || scene_.situation.goal_latched);
    cycle.plan = &scene_.situation.plan;
    cycle.grid = &grid_;
    cycle.footprint = &footprint_;
    cycle.grids = &grids_;
    return cycle;
  }

  Scene scene_;
  NoParameters none_;
  std::shared_ptr<Critic> critic_;
  double weight_ = 0.0;
  GridView grid_;
  Footprint footprint_;
  PlanGrids grids_;
};

}  // namespace hidwa_local_planner::test
