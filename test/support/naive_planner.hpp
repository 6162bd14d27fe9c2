// SPDX-License-Identifier: BSD-3-Clause
// A whole cycle, the slow way: the twin of Planner::plan for robots that do not stand in collision, in the
// first cycle that is not stopped.
#pragma once

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "support/naive_blind.hpp"
#include "support/naive_critics.hpp"
#include "support/naive_escape.hpp"
#include "support/naive_gap.hpp"
#include "support/naive_motion.hpp"
#include "support/naive_padding.hpp"
#include "support/naive_reference.hpp"
#include "support/naive_trail.hpp"

namespace hidwa_local_planner::test {

/// Overlaps smaller than this may be rounding: scenes with such a pose are left out.
constexpr double kDoubtfulOverlap = 1e-6;
/// So are gaps that are so near to what is asked for [m].
constexpr double kDoubtfulGap = 1e-7;

/// The outline that the planner was given: 16 corners are a circle in these scenes.
inline NaiveBody naive_body(const Scene& scene) {
  NaiveBody body{scene.outline, 0.0};
  if (scene.outline.size() == 16) body = {{}, naive_outer_radius(body)};
  return naive_padded(body, scene.parameters.footprint_padding);
}

/// The scene of now: the measured pose led on as the commands since then say, or odometry; of the measured velocity
/// what is believed.
inline Scene naive_led_on(Scene scene, const NaiveReference& reference) {
  NaiveTrail trail(scene.situation.pose, naive_outer_radius(naive_body(scene)));
  trail.follow(reference.likeliest().past, 0.01);
  scene.situation.pose = trail.pose();
  scene.situation.velocity = reference.believed();
  scene.parameters = reference.limited();
  return scene;
}

class NaivePlanner {
 public:
  /// `former`: cycles before this one, in which the host stopped the robot.
  explicit NaivePlanner(const Scene& scene, std::vector<NaiveCycle> former = {})
      : origin_(scene.situation.pose),
        reference_(scene.parameters, with(std::move(former), naive_cycle(scene.situation))),
        blind_(scene, naive_body(scene)),
        scene_(naive_led_on(scene, reference_)),
        grid_(scene_.grid()),
        body_(naive_body(scene_)),
        critics_(scene_, body_) {
    stands_in_collision_ = collides(scene_.situation.pose);
    Scene slow = scene_;
    if (stands_in_collision_) {
      if (scene_.parameters.method == Method::paper) return;
      slow_down(slow.parameters);
      find_clusters(slow.parameters);
      if (!clusters_->overlaps()) slow = scene_;  // only its centre's cell is inscribed
    }
    blind_.narrow(slow.parameters);
    keep_ = std::max(0.0, gap(scene_.situation.pose, 1.0) - 1e-6);
    gentle_ = scene_.intent.influence == Influence::none && scene_.parameters.turns_gently() && !escapes();
    try_all(slow);
    if (!gentle_ || !stands()) return;
    gentle_ = false;
    try_all(slow);
  }
  bool stands_in_collision() const { return stands_in_collision_; }
  /// It chooses what leads out of a collision, not what is cheapest.
  bool gets_out() const {
    return escapes() && scene_.intent.influence == Influence::none && !scene_.situation.goal_latched;
  }
  bool doubtful() const { return doubtful_; }
  bool gives_up() const { return scene_.intent.influence == Influence::none && !critics_.on_map(); }
  const std::vector<NaiveCandidate>& candidates() const { return candidates_; }
  const NaiveCandidate* best() const { return best_ < 0 ? nullptr : &candidates_[static_cast<std::size_t>(best_)]; }
  Twist2 command() const { return command_for(best()->u); }
  const NaiveReference& reference() const { return reference_; }
  /// The best total of another velocity than the chosen one's.
  double runner_up() const {
    double total = INFINITY;
    for (const NaiveCandidate& c : candidates_) {
      const bool other = std::abs(c.u.v - best()->u.v) + std::abs(c.u.omega - best()->u.omega) > 1e-9;
      if (c.rejected_by.empty() && other) total = std::min(total, c.total);
    }
    return total;
  }

 private:
  static std::vector<NaiveCycle> with(std::vector<NaiveCycle> cycles, const NaiveCycle& last) {
    cycles.push_back(last);
    return cycles;
  }
  void try_all(const Scene& slow) {
    candidates_ = naive_candidates(slow, reference_.reference(), gentle_);
    naive_roll_out(scene_, reference_.reference(), candidates_, gentle_);
    for (NaiveCandidate& c : candidates_) judge(c);
    choose();
  }
  // Nothing but rest is left, and rest is not what it wants.
  bool stands() const { return best_ < 0 || (best()->u == Twist2{} && !scene_.situation.goal_latched); }
  bool escapes() const { return clusters_ != nullptr && clusters_->overlaps(); }

  // How far the outline's farthest point moves with a command that is braked in the next cycle [m].
  double way(const Twist2& u) const {
    const Parameters& p = scene_.parameters;
    const double arm = body_.radius > 0.0 ? 0.0 : naive_outer_radius(body_);
    const double v = std::abs(u.v), omega = std::abs(u.omega);
    const double delay = p.control_latency + scene_.situation.period + latest();
    return v * delay + v * v / 2.0 / p.braking_x() + arm * (omega * delay + omega * omega / 2.0 / p.braking_theta());
  }
  double fastest(const Twist2& axis) const {  // within half a cell, by bisection
    double lo = 0.0, hi = 100.0;
    while (hi - lo > 1e-13) {
      const double middle = (lo + hi) / 2.0;
      (way({axis.v * middle, axis.omega * middle}) <= grid_.resolution / 2.0 ? lo : hi) = middle;
    }
    return lo;
  }
  void slow_down(Parameters& p) const {
    const double v = fastest({1.0, 0.0});
    p.min_vel_x = std::max(p.min_vel_x, -v);
    p.max_vel_x = std::min(p.max_vel_x, v);
    p.max_vel_theta = std::min(p.max_vel_theta, fastest({0.0, 1.0}));
  }
  // And a map without the clusters, in which a disc minds no inscribed cells.
  void find_clusters(const Parameters& slow) {
    const double longest = std::max(-slow.min_vel_x, slow.max_vel_x) * slow.sim_time;
    const int steps = 1 + static_cast<int>(std::ceil(longest / grid_.resolution));
    clusters_ = std::make_unique<NaiveEscape>(grid_, body_, slow.unknown_is_obstacle, scene_.situation.pose, steps);
    rest_ = scene_.costs;
    for (int j = 0; j < grid_.size_y; ++j) {
      for (int i = 0; i < grid_.size_x; ++i) {
        std::uint8_t& cost = rest_[grid_.index({i, j})];
        if (cost == cost::kInscribed || clusters_->in_cluster(i, j)) cost = cost::kFree;
      }
    }
    grid_.costs = rest_.data();
  }
  // So many poses of a rollout at once that the outline moves no more than a quarter of a cell.
  std::vector<Pose2> looked_at(const NaiveCandidate& c) const {
    const double arm = body_.radius > 0.0 ? 0.0 : naive_outer_radius(body_);
    const double step = (std::max(std::abs(c.u.v), std::abs(reference_.reference().v)) +
                         arm * std::max(std::abs(c.u.omega), std::abs(reference_.reference().omega))) *
                        c.dt;
    const std::size_t last = c.poses.size() - 1;
    const double most = grid_.resolution / 4.0;
    const bool all_at_once = step * static_cast<double>(last) <= most;
    const std::size_t every = all_at_once ? last : static_cast<std::size_t>(std::max(1.0, std::floor(most / step)));
    std::vector<Pose2> poses;
    for (std::size_t k = every; k < last; k += every) poses.push_back(c.poses[k]);
    poses.push_back(c.poses.back());
    return poses;
  }
  bool slow_enough(const Twist2& u) const {
    const Twist2 braked = command_for({});
    const bool brakes =
        std::abs(u.v) <= std::abs(braked.v) + 1e-9 && std::abs(u.omega) <= std::abs(braked.omega) + 1e-9;
    return brakes || way(u) <= grid_.resolution / 2.0 + 1e-9;
  }
  bool leads_out(const NaiveCandidate& c) const {
    if (!clusters_->descends(looked_at(c), false)) return false;
    const Pose2& end = c.poses.back();
    if (scene_.intent.influence != Influence::none && c.u.v == 0.0) return true;
    if (clusters_->start_total() <= grid_.resolution / 2.0 && (c.u.v != 0.0 || c.u.omega != 0.0)) return true;
    return clusters_->total(end) < clusters_->start_total() - 1e-6 ||
           clusters_->clearance(end) > clusters_->clearance(scene_.situation.pose) + 1e-6;
  }
  bool sinks(const Twist2& sample, double spacing) const {
    const Situation& s = scene_.situation;
    for (const NaiveOutlook& way : reference_.ways()) {
      for (const bool evenly : {false, true}) {
        NaiveTrail trail(origin_, naive_outer_radius(body_));
        trail.follow(way.past, spacing);
        std::vector<Pose2> poses;
        const auto look = [&](const std::vector<NaiveLeg>& legs) {
          for (const NaiveTrailPose& at : trail.follow(legs, spacing)) poses.push_back(at.pose);
        };
        look(way.pending);
        look(naive_brake_legs(scene_.parameters, s.period, way.end(), command_for(sample), latest(), evenly));
        if (!clusters_->descends(poses, true)) return true;
      }
    }
    return false;
  }

  // Between two poses it may go deeper for so short a time that a look at nearby poses decides: doubtful.
  bool goes_deeper(const Twist2& sample) {
    if (sinks(sample, grid_.resolution / 8)) return true;
    if (sinks(sample, grid_.resolution / 128)) doubtful_ = true;
    return false;
  }

  bool collides(const Pose2& q) {
    const double overlap = naive_overlap(grid_, body_, q, scene_.parameters.unknown_is_obstacle);
    if (overlap > 0.0 && overlap < kDoubtfulOverlap) doubtful_ = true;
    return overlap > 0.0 || naive_centre_inscribed(grid_, body_, q);
  }
  double gap(const Pose2& q, double most) const {
    return naive_gap(grid_, body_, q, scene_.parameters.unknown_is_obstacle, most);
  }
  // The robot has more room than `needed` [m].
  bool keeps(const Pose2& q, double needed) {
    if (needed <= 0.0) return !collides(q);
    const double left = gap(q, needed + 1e-3) - needed;
    if (std::abs(left) < kDoubtfulGap) doubtful_ = true;
    return left > 0.0;
  }
  Twist2 command_for(const Twist2& sample) const {
    const Twist2 from = reference_.reference();
    Parameters p = scene_.parameters;
    const bool rests = sample == Twist2{};
    if (gentle_ && !rests) p = naive_gentle(p, from.omega, sample.omega);
    if (gentle_ && rests && scene_.situation.goal_latched) p = naive_gentle_rest(p, from.omega);
    return naive_command(p, from, sample, scene_.situation.period);
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
        if (collides(q)) return true;
      }
    }
    return false;
  }
  // How much later than a period a command to brake may take effect [s].
  double latest() const { return 2 * std::max(0.0, scene_.situation.longest_period - scene_.situation.period); }
  // From the latest to none, no more than `apart` [s] from each other; the latest alone where it is hardly later.
  std::vector<double> holds(double apart) const {
    if (latest() <= 0.1 * scene_.situation.period) return {latest()};
    std::vector<double> all;
    const int parts = static_cast<int>(std::ceil(latest() / apart));
    for (int part = parts; part >= 0; --part) all.push_back(latest() * part / parts);
    return all;
  }
  // Whether a command is braked on time or as late as it may be, and however the robot goes on until it takes effect.
  bool cannot_brake(const Twist2& sample, bool surely) {
    if (hits_one_way(reference_.ways(), sample, surely)) return true;
    if (!surely) return false;
    return hits_one_way(reference_.unlikely_ways(), sample, true) ||
           (lacks_room(sample) && hits_one_way(reference_.lagging_ways(), sample, true));
  }
  std::vector<NaiveBraking> manoeuvres(const std::vector<NaiveOutlook>& ways, const Twist2& sample, bool surely) const {
    const Situation& s = scene_.situation;
    std::vector<NaiveBraking> all;
    for (const NaiveOutlook& way : ways) {
      for (const double hold : holds(surely ? 0.5 * s.period : latest())) {
        all.push_back({origin_, way, command_for(sample), s.period, hold});
      }
    }
    return all;
  }
  bool hits_one_way(const std::vector<NaiveOutlook>& ways, const Twist2& sample, bool surely) {
    for (const NaiveBraking& manoeuvre : manoeuvres(ways, sample, surely)) {
      if (hits(manoeuvre, surely)) return true;
    }
    return false;
  }
  // The robot has less room now than the growth of some manoeuvre.
  bool lacks_room(const Twist2& sample) {
    std::vector<NaiveOutlook> ways = reference_.ways();
    ways.insert(ways.end(), reference_.unlikely_ways().begin(), reference_.unlikely_ways().end());
    double growth = 0.0;
    for (const NaiveBraking& manoeuvre : manoeuvres(ways, sample, true)) {
      for (const NaiveTrailPose& q :
           naive_braking_poses(scene_.parameters, manoeuvre, naive_outer_radius(body_), grid_.resolution, false)) {
        growth = std::max(growth, q.growth);
      }
    }
    if (growth > 0.0 && std::abs(growth - keep_) < kDoubtfulGap) doubtful_ = true;
    return growth > keep_;
  }
  bool hits(const NaiveBraking& manoeuvre, bool surely) {
    const double radius = naive_outer_radius(body_);
    for (const NaiveTrailPose& q :
         naive_braking_poses(scene_.parameters, manoeuvre, radius, grid_.resolution, surely)) {
      if (!keeps(q.pose, std::min(q.growth, keep_))) return true;
    }
    return false;
  }

  void judge(NaiveCandidate& c) {
    const Parameters& p = scene_.parameters;
    if ((escapes() && (!slow_enough(c.u) || !leads_out(c))) || rollout_collides(c)) {
      c.rejected_by = "Collision";
    } else if (cannot_brake(c.u, false) || (escapes() && goes_deeper(c.u))) {
      c.rejected_by = "Braking";
    } else if (blind_.too_fast(c.u)) {
      c.rejected_by = "Blind";
    }
    double autonomy = 0.0;
    for (const std::string& critic : split_names(p.critics)) {
      bool rejects = false;
      c.raw.push_back(critics_.raw(critic, c, rejects));
      if (rejects && c.rejected_by.empty()) c.rejected_by = critic;
      autonomy += NaiveCritics::weight(critic, p) * c.raw.back();
    }
    const double deviation =
        p.s_v * std::abs(scene_.intent.u_h.v - c.u.v) + p.s_omega * std::abs(scene_.intent.u_h.omega - c.u.omega);
    c.total = autonomy;
    if (scene_.intent.influence == Influence::shared) c.total += deviation;
    if (scene_.intent.influence == Influence::direct) c.total = deviation;
  }

  // Autonomy in collision: what drives and ends least deep, by whole millimetres.
  double depth_class(const NaiveCandidate& c) const {
    if (c.u.v == 0.0) return INFINITY;
    return std::floor(clusters_->total(c.poses.back()) / 0.001);
  }
  bool preferred(const NaiveCandidate& a, const NaiveCandidate& b) const {
    if (gets_out()) {
      const double da = depth_class(a), db = depth_class(b);
      if (da != db) return da < db;
      if (std::isfinite(da)) return a.total < b.total;
    }
    if (std::abs(a.total - b.total) > 1e-9) return a.total < b.total;
    const Parameters& p = scene_.parameters;
    if (p.method == Method::paper) {  // the first sample
      return std::abs(a.u.v - b.u.v) > 1e-9 ? a.u.v < b.u.v : a.u.omega < b.u.omega - 1e-9;
    }
    const Twist2& last = scene_.situation.last_command;
    const auto change = [&](const Twist2& u) {
      return std::abs(u.v - last.v) / p.acc_lim_x + std::abs(u.omega - last.omega) / p.acc_lim_theta;
    };
    if (std::abs(change(a.u) - change(b.u)) > 1e-9) return change(a.u) < change(b.u);
    if (std::abs(std::abs(a.u.omega) - std::abs(b.u.omega)) > 1e-9) return std::abs(a.u.omega) < std::abs(b.u.omega);
    if (last.omega != 0.0) return a.u.omega * last.omega > b.u.omega * last.omega;
    return a.u.omega > b.u.omega;
  }
  void choose() {
    while (true) {
      best_ = -1;
      for (std::size_t i = 0; i < candidates_.size(); ++i) {
        if (!candidates_[i].rejected_by.empty()) continue;
        if (best_ < 0 || preferred(candidates_[i], candidates_[static_cast<std::size_t>(best_)]))
          best_ = static_cast<int>(i);
      }
      if (best_ < 0) return;
      NaiveCandidate& chosen = candidates_[static_cast<std::size_t>(best_)];
      if (blind_.too_fast_while_braking(command_for(chosen.u))) {
        chosen.rejected_by = "Blind";
        continue;
      }
      const bool deeper = escapes() && sinks(chosen.u, grid_.resolution / 128);
      if (!cannot_brake(chosen.u, true) && !deeper) return;
      chosen.rejected_by = "Braking";
    }
  }

  Pose2 origin_;  // where the pose was measured
  NaiveReference reference_;
  NaiveBlind blind_;
  Scene scene_;
  GridView grid_;
  NaiveBody body_;
  NaiveCritics critics_;
  double keep_ = 0.0;  // no more room than this is asked for: what the robot has now [m]
  std::vector<NaiveCandidate> candidates_;
  int best_ = -1;
  bool stands_in_collision_ = false;
  bool gentle_ = false;  // its turns are
  std::unique_ptr<NaiveEscape> clusters_;
  std::vector<std::uint8_t> rest_;
  bool doubtful_ = false;
};

}  // namespace hidwa_local_planner::test
