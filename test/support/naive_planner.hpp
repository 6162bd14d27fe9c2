// SPDX-License-Identifier: BSD-3-Clause
// A whole cycle, the slow way: the twin of Planner::plan for robots that do not stand in collision, in the
// first cycle that is not stopped.
#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "support/naive_critics.hpp"
#include "support/naive_motion.hpp"
#include "support/naive_padding.hpp"
#include "support/naive_reference.hpp"

namespace hidwa_local_planner::test {

/// Overlaps smaller than this may be rounding: scenes with such a pose are left out.
constexpr double kDoubtfulOverlap = 1e-6;


/// The outline that the planner was given: 16 corners are a circle in these scenes.
inline NaiveBody naive_body(const Scene& scene) {
  NaiveBody body{scene.outline, 0.0};
  if (scene.outline.size() == 16) body = {{}, naive_outer_radius(body)};
  return naive_padded(body, scene.parameters.footprint_padding);
}

class NaivePlanner {
 public:
  /// `former`: cycles before this one, in which the host stopped the robot.
  explicit NaivePlanner(const Scene& scene, std::vector<NaiveCycle> former = {})
      : scene_(scene),
        grid_(scene.grid()),
        body_(naive_body(scene)),
        critics_(scene, body_),
        under_way_(scene.parameters, scene.situation.period, Twist2{}) {
    const Situation& s = scene_.situation;
    former.push_back(naive_cycle(s));
    const NaiveReference reference(scene_.parameters, former);
    reference_ = reference.of(s.velocity);
    under_way_ = {scene_.parameters, s.period,
                  reference.agrees(s.velocity) ? reference.effects() : std::vector<NaiveEffect>{{0.0, reference_}}};
    stands_in_collision_ = collides(s.pose, body_);
    if (stands_in_collision_) return;
    candidates_ = naive_candidates(scene_, reference_);
    naive_roll_out(scene_, reference_, candidates_);
    for (NaiveCandidate& c : candidates_) judge(c);
    choose();
  }
  bool stands_in_collision() const { return stands_in_collision_; }
  bool doubtful() const { return doubtful_; }
  bool gives_up() const { return scene_.intent.influence == Influence::none && !critics_.on_map(); }
  const std::vector<NaiveCandidate>& candidates() const { return candidates_; }
  const NaiveCandidate* best() const {
    return best_ < 0 ? nullptr : &candidates_[static_cast<std::size_t>(best_)];
  }
  Twist2 command() const {
    return naive_command(scene_.parameters, reference_, best()->u, scene_.situation.period);
  }
  /// The best total of another velocity than the chosen one's.
  double runner_up() const {
    double total = INFINITY;
    for (const NaiveCandidate& c : candidates_) {
      const bool other = std::abs(c.u.v - best()->u.v) + std::abs(c.u.omega - best()->u.omega) > 1e-9;
      if (c.refused_by.empty() && other) total = std::min(total, c.total);
    }
    return total;
  }

 private:
  bool collides(const Pose2& q, const NaiveBody& body) {
    const double overlap = naive_overlap(grid_, body, q, scene_.parameters.unknown_is_obstacle);
    if (overlap > 0.0 && overlap < kDoubtfulOverlap) doubtful_ = true;
    return overlap > 0.0 || naive_centre_inscribed(grid_, body, q);
  }

  bool rollout_collides(const NaiveCandidate& c) {
    const double radius = naive_outer_radius(body_);
    for (std::size_t k = 1; k < c.poses.size(); ++k) {
      const Pose2 &a = c.poses[k - 1], &b = c.poses[k];
      const double moved = std::hypot(b.x - a.x, b.y - a.y) + std::abs(b.theta - a.theta) * radius;
      const int parts = std::max(1, static_cast<int>(std::ceil(moved / (grid_.resolution / 2) - 1e-9)));
      for (int part = 1; part <= parts; ++part) {
        const double t = static_cast<double>(part) / parts;
        const Pose2 q{a.x + t * (b.x - a.x), a.y + t * (b.y - a.y), a.theta + t * (b.theta - a.theta)};
        if (collides(q, body_)) return true;
      }
    }
    return false;
  }
  bool cannot_brake(const Twist2& sample, double spacing, const NaiveBody& body) {
    const Twist2 command = naive_command(scene_.parameters, reference_, sample, scene_.situation.period);
    for (const Pose2& q :
         naive_braking_poses(scene_, under_way_, command, naive_outer_radius(body_), spacing)) {
      if (collides(q, body)) return true;
    }
    return false;
  }

  void judge(NaiveCandidate& c) {
    const Parameters& p = scene_.parameters;
    if (rollout_collides(c)) {
      c.refused_by = "Collision";
    } else if (cannot_brake(c.u, grid_.resolution / 2, body_)) {
      c.refused_by = "Braking";
    }
    double autonomy = 0.0;
    for (const std::string& critic : split_names(p.critics)) {
      bool refuses = false;
      c.raw.push_back(critics_.raw(critic, c, refuses));
      if (refuses && c.refused_by.empty()) c.refused_by = critic;
      autonomy += NaiveCritics::weight(critic, p) * c.raw.back();
    }
    const double deviation = p.s_v * std::abs(scene_.intent.u_h.v - c.u.v) +
                             p.s_omega * std::abs(scene_.intent.u_h.omega - c.u.omega);
    c.total = p.s_nv * autonomy;
    if (scene_.intent.influence == Influence::shared) c.total += deviation;
    if (scene_.intent.influence == Influence::direct) c.total = deviation;
  }

  bool preferred(const NaiveCandidate& a, const NaiveCandidate& b) const {
    if (std::abs(a.total - b.total) > 1e-9) return a.total < b.total;
    const Parameters& p = scene_.parameters;
    const Twist2& last = scene_.situation.last_command;
    const auto change = [&](const Twist2& u) {
      return std::abs(u.v - last.v) / p.acc_lim_x + std::abs(u.omega - last.omega) / p.acc_lim_theta;
    };
    if (std::abs(change(a.u) - change(b.u)) > 1e-9) return change(a.u) < change(b.u);
    if (std::abs(std::abs(a.u.omega) - std::abs(b.u.omega)) > 1e-9)
      return std::abs(a.u.omega) < std::abs(b.u.omega);
    if (last.omega != 0.0) return a.u.omega * last.omega > b.u.omega * last.omega;
    return a.u.omega > b.u.omega;
  }
  void choose() {
    NaiveBody grown = naive_padded(body_, grid_.resolution / 32);
    if (collides(scene_.situation.pose, grown)) grown = body_;
    while (true) {
      best_ = -1;
      for (std::size_t i = 0; i < candidates_.size(); ++i) {
        if (!candidates_[i].refused_by.empty()) continue;
        if (best_ < 0 || preferred(candidates_[i], candidates_[static_cast<std::size_t>(best_)]))
          best_ = static_cast<int>(i);
      }
      if (best_ < 0) return;
      NaiveCandidate& chosen = candidates_[static_cast<std::size_t>(best_)];
      if (!cannot_brake(chosen.u, grid_.resolution / 16, grown)) return;
      chosen.refused_by = "Braking";
    }
  }

  const Scene& scene_;
  GridView grid_;
  NaiveBody body_;
  NaiveCritics critics_;
  Twist2 reference_;
  NaiveEffects under_way_;
  std::vector<NaiveCandidate> candidates_;
  int best_ = -1;
  bool stands_in_collision_ = false;
  bool doubtful_ = false;
};

}  // namespace hidwa_local_planner::test
