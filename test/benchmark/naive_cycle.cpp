// SPDX-License-Identifier: BSD-3-Clause
#include "benchmark/naive_cycle.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "benchmark/naive_footprint.hpp"
#include "benchmark/naive_terms.hpp"
#include "support/naive_motion.hpp"
#include "support/naive_planner.hpp"

namespace hidwa_local_planner::test {
namespace {

// From `start` at `reference` towards a sample, at the largest number of steps any candidate of its omega
// needs.
void roll_out(const Scene& scene, const Twist2& reference, double fastest, const Twist2& sample,
              std::vector<Pose2>& poses) {
  const Parameters& p = scene.parameters;
  const double steps = std::ceil(std::max({1.0, fastest * p.sim_time / p.linear_granularity,
                                           std::abs(sample.omega) * p.sim_time / p.angular_granularity}));
  const double dt = p.sim_time / steps;
  Twist2 now = reference;
  Pose2 q = scene.situation.pose;
  poses.assign(1, q);
  for (int k = 0; k < static_cast<int>(steps); ++k) {
    const Twist2 next{naive_ramp_v(p, now.v, sample.v, dt), naive_ramp_omega(p, now.omega, sample.omega, dt)};
    const double v = 0.5 * (now.v + next.v), omega = 0.5 * (now.omega + next.omega);
    q.x += v * std::cos(q.theta + 0.5 * omega * dt) * dt;
    q.y += v * std::sin(q.theta + 0.5 * omega * dt) * dt;
    q.theta += omega * dt;
    poses.push_back(q);
    now = next;
  }
}

bool rollout_free(const NaiveFootprint& robot, const std::vector<Pose2>& poses, double spacing) {
  for (std::size_t k = 1; k < poses.size(); ++k) {
    const Pose2 &a = poses[k - 1], &b = poses[k];
    const double moved =
        std::hypot(b.x - a.x, b.y - a.y) + std::abs(b.theta - a.theta) * robot.outer_radius();
    const int parts = std::max(1, static_cast<int>(std::ceil(moved / spacing - 1e-9)));
    for (int part = 1; part <= parts; ++part) {
      const double t = static_cast<double>(part) / parts;
      const Pose2 q{a.x + t * (b.x - a.x), a.y + t * (b.y - a.y), a.theta + t * (b.theta - a.theta)};
      if (robot.collides(q)) return false;
    }
  }
  return true;
}

class Cycle {
 public:
  Cycle(const Scene& scene, const NaiveBody& body)
      : scene_(scene),
        grid_(scene.grid()),
        body_(body),
        robot_(grid_, body, scene.parameters.unknown_is_obstacle),
        reference_(scene.situation.last_command),
        under_way_(scene.parameters, scene.situation.period, reference_) {}

  std::optional<NaiveChoice> choose() {
    judge();
    const double cell = grid_.resolution;
    NaiveFootprint grown(grid_, naive_padded(body_, cell / 32), scene_.parameters.unknown_is_obstacle);
    if (grown.collides(scene_.situation.pose)) grown = robot_;
    while (!legal_.empty()) {
      const auto best = std::min_element(legal_.begin(), legal_.end(),
                                         [this](const Legal& a, const Legal& b) { return preferred(a, b); });
      if (can_brake(best->sample, grown, cell / 16))
        return NaiveChoice{best->sample, command(best->sample), best->total};
      legal_.erase(best);
    }
    return std::nullopt;
  }

 private:
  struct Legal {
    Twist2 sample;
    double total;
  };

  void judge() {
    const std::vector<NaiveCandidate> candidates = naive_candidates(scene_, reference_);
    const NaiveTerms terms(scene_);
    double fastest = 0.0;
    for (const NaiveCandidate& c : candidates) fastest = std::max(fastest, std::abs(c.u.v));
    std::vector<Pose2> poses;
    for (const NaiveCandidate& c : candidates) {
      roll_out(scene_, reference_, fastest, c.u, poses);
      if (!rollout_free(robot_, poses, grid_.resolution / 2)) continue;
      if (!can_brake(c.u, robot_, grid_.resolution / 2)) continue;
      if (const std::optional<double> total = terms.total(c.u, poses)) legal_.push_back({c.u, *total});
    }
  }
  Twist2 command(const Twist2& sample) const {
    return naive_command(scene_.parameters, reference_, sample, scene_.situation.period);
  }
  bool can_brake(const Twist2& sample, const NaiveFootprint& robot, double spacing) const {
    const std::vector<Pose2> poses =
        naive_braking_poses(scene_, under_way_, command(sample), robot_.outer_radius(), spacing);
    return std::none_of(poses.begin(), poses.end(), [&](const Pose2& q) { return robot.collides(q); });
  }
  double change(const Twist2& u) const {
    const Twist2& last = scene_.situation.last_command;
    return std::abs(u.v - last.v) / scene_.parameters.acc_lim_x +
           std::abs(u.omega - last.omega) / scene_.parameters.acc_lim_theta;
  }
  bool preferred(const Legal& a, const Legal& b) const {
    if (std::abs(a.total - b.total) > 1e-9) return a.total < b.total;
    return change(a.sample) < change(b.sample);
  }

  const Scene& scene_;
  GridView grid_;
  const NaiveBody& body_;
  NaiveFootprint robot_;
  Twist2 reference_;
  NaiveEffects under_way_;
  std::vector<Legal> legal_;
};

}  // namespace

std::optional<NaiveChoice> naive_cycle(const Scene& scene, const NaiveBody& body) {
  return Cycle(scene, body).choose();
}

}  // namespace hidwa_local_planner::test
