// SPDX-License-Identifier: BSD-3-Clause
// One critic, one candidate, poses by hand.
#pragma once

#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "hidwa_local_planner/core/critic.hpp"
#include "hidwa_local_planner/critics/built_in.hpp"
#include "support/scene.hpp"
#include "support/tile_filler.hpp"

namespace hidwa_local_planner::test {

/// A tile of one candidate. `omegas`: of its rollout, at each pose; without any, that of the sample.
class HandTile {
 public:
  HandTile(const Twist2& u, const std::vector<Pose2>& poses, double dt = 0.1, const std::vector<double>& omegas = {})
      : v_(u.v), omega_at_(omegas) {
    for (const Pose2& q : poses) {
      x_.push_back(q.x);
      y_.push_back(q.y);
      heading_.push_back(q.theta);
      cos_.push_back(std::cos(q.theta));
      sin_.push_back(std::sin(q.theta));
    }
    omega_at_.resize(poses.size(), u.omega);
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
  Tile& tile() { return tile_; }

 private:
  double v_;
  std::vector<double> x_, y_, heading_, cos_, sin_;
  std::vector<double> omega_at_;
  Tile tile_;
};

struct CriticAnswer {
  double raw = 0.0;
  std::string reason;  // empty where it is legal
  bool rejected() const { return !reason.empty(); }
};

/// A built-in critic in a scene.
class CriticBench {
 public:
  CriticBench(const std::string& name, const Scene& scene) : scene_(scene), critic_(critics::built_in().make(name)) {
    weight_ = critic_->configure(scene_.parameters, none_);
    filler_.prepare(scene_);
  }
  double weight() const { return weight_; }
  Critic& critic() { return *critic_; }
  Scene& scene() { return scene_; }

  void prepare() {
    filler_.prepare(scene_);
    critic_->prepare(filler_.view());
  }
  CriticAnswer score(const Twist2& u, const std::vector<Pose2>& poses, double dt = 0.1,
                     const std::vector<double>& omegas = {}) {
    HandTile hand(u, poses, dt, omegas);
    filler_.fill(hand.tile());
    CriticAnswer answer;
    const char* reason = nullptr;
    TileScores scores(&answer.raw, &reason, 1);
    critic_->score(filler_.view(), hand.tile(), scores);
    if (reason != nullptr) answer.reason = reason;
    return answer;
  }
  void debrief(const Twist2& command) { critic_->debrief(filler_.view(), command); }

 private:
  Scene scene_;
  ParameterSource none_;
  std::shared_ptr<Critic> critic_;
  double weight_ = 0.0;
  TileFiller filler_;
};

}  // namespace hidwa_local_planner::test
