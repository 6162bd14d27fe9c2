// SPDX-License-Identifier: BSD-3-Clause
#include "benchmark/naive_cycle.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "benchmark/naive_footprint.hpp"
#include "support/naive_critics.hpp"
#include "support/naive_motion.hpp"
#include "support/naive_trail.hpp"

namespace hidwa_local_planner::test {
namespace {

// From the scene's pose at `reference` towards the candidate's velocity, at the largest number of steps any candidate
// of its omega needs. `fastest`: of all candidates [m/s].
void roll_out(const Scene& scene, const Twist2& reference, double fastest, NaiveCandidate& c) {
  const Parameters& p = scene.parameters;
  const double steps = std::ceil(std::max(
      {1.0, fastest * p.sim_time / p.linear_granularity, std::abs(c.u.omega) * p.sim_time / p.angular_granularity}));
  c.dt = p.sim_time / steps;
  Twist2 now = reference;
  Pose2 q = scene.situation.pose;
  c.poses.assign(1, q);
  for (int k = 0; k < static_cast<int>(steps); ++k) {
    const Twist2 next{naive_ramp_v(p, now.v, c.u.v, c.dt), naive_ramp_omega(p, now.omega, c.u.omega, c.dt)};
    const double v = 0.5 * (now.v + next.v), omega = 0.5 * (now.omega + next.omega);
    q.x += v * std::cos(q.theta + 0.5 * omega * c.dt) * c.dt;
    q.y += v * std::sin(q.theta + 0.5 * omega * c.dt) * c.dt;
    q.theta += omega * c.dt;
    c.poses.push_back(q);
    now = next;
  }
}

bool rollout_free(const NaiveFootprint& robot, const std::vector<Pose2>& poses, double spacing) {
  for (std::size_t k = 1; k < poses.size(); ++k) {
    const Pose2 &a = poses[k - 1], &b = poses[k];
    const double moved = std::hypot(b.x - a.x, b.y - a.y) + std::abs(b.theta - a.theta) * robot.outer_radius();
    const int parts = std::max(1, static_cast<int>(std::ceil(moved / spacing - 1e-9)));
    for (int part = 1; part <= parts; ++part) {
      const double t = static_cast<double>(part) / parts;
      const Pose2 q{a.x + t * (b.x - a.x), a.y + t * (b.y - a.y), a.theta + t * (b.theta - a.theta)};
      if (robot.collides(q)) return false;
    }
  }
  return true;
}

// More room than this no manoeuvre asks for [m].
constexpr double kFarthestRoom = 0.5;

class Cycle {
 public:
  Cycle(const Scene& scene, const NaiveBody& body)
      : scene_(scene),
        grid_(scene.grid()),
        robot_(grid_, body, scene.parameters.unknown_is_obstacle),
        critics_(scene, body),
        names_(split_names(scene.parameters.critics)),
        reference_(scene.situation.last_command),
        // One velocity for the latency: what is under way is the last command.
        under_way_(naive_outlook({scene.parameters, scene.situation.period, reference_}, 0.0,
                                 scene.parameters.control_latency)),
        keep_(std::max(0.0, robot_.room(scene.situation.pose, kFarthestRoom) - 1e-6)) {}

  std::optional<NaiveChoice> choose() {
    judge();
    while (!legal_.empty()) {
      const auto best = std::min_element(legal_.begin(), legal_.end(),
                                         [this](const Legal& a, const Legal& b) { return preferred(a, b); });
      if (can_brake(best->sample, true)) return NaiveChoice{best->sample, command(best->sample), best->total};
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
    double fastest = 0.0;
    for (const NaiveCandidate& c : candidates) fastest = std::max(fastest, std::abs(c.u.v));
    NaiveCandidate rolled;  // kept for its memory
    for (const NaiveCandidate& c : candidates) {
      rolled.u = c.u;
      roll_out(scene_, reference_, fastest, rolled);
      if (!rollout_free(robot_, rolled.poses, grid_.resolution / 2)) continue;
      if (!can_brake(c.u, false)) continue;
      if (const std::optional<double> total = total_of(rolled)) legal_.push_back({c.u, *total});
    }
  }
  // J of a rollout; nothing where a critic rejects it.
  std::optional<double> total_of(const NaiveCandidate& c) const {
    const Parameters& p = scene_.parameters;
    const Twist2& wanted = scene_.intent.u_h;
    double total = p.s_v * std::abs(wanted.v - c.u.v) + p.s_omega * std::abs(wanted.omega - c.u.omega);
    for (const std::string& critic : names_) {
      bool rejects = false;
      total += NaiveCritics::weight(critic, p) * critics_.raw(critic, c, rejects);
      if (rejects) return std::nullopt;
    }
    return total;
  }
  Twist2 command(const Twist2& sample) const {
    return naive_command(scene_.parameters, reference_, sample, scene_.situation.period);
  }
  bool can_brake(const Twist2& sample, bool surely) const {
    const Situation& s = scene_.situation;
    const std::vector<NaiveTrailPose> poses =
        naive_braking_poses(scene_.parameters, {s.pose, under_way_, command(sample), s.period, 0.0},
                            robot_.outer_radius(), grid_.resolution, surely);
    return std::all_of(poses.begin(), poses.end(),
                       [&](const NaiveTrailPose& q) { return robot_.keeps(q.pose, std::min(q.growth, keep_)); });
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
  NaiveFootprint robot_;
  NaiveCritics critics_;  // with their distance grids
  std::vector<std::string> names_;
  Twist2 reference_;
  NaiveOutlook under_way_;
  double keep_;  // the room that the robot has now [m]
  std::vector<Legal> legal_;
};

}  // namespace

std::optional<NaiveChoice> naive_cycle(const Scene& scene, const NaiveBody& body) {
  return Cycle(scene, body).choose();
}

}  // namespace hidwa_local_planner::test
