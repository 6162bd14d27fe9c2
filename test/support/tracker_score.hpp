// SPDX-License-Identifier: BSD-3-Clause
// Drives a robot through a world and compares what the tracker says with what is so.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <set>
#include <vector>

#include "support/scan_world.hpp"
#include "tracking/tracker.hpp"

namespace hidwa_local_planner::test {

/// What a drive came to.
struct TrackerScore {
  std::vector<double> delays;         // from coming into view to being found [s]
  std::vector<double> steady;         // errors of velocity, from 1 s after confirmation [m/s]
  std::vector<double> early;          // and before, or after a change of velocity [m/s]
  std::vector<double> places;         // errors of position [m]
  std::vector<double> place_ratios;   // squared error over the variance: 2 on average where the deviations are right
  std::vector<double> speed_ratios;   // the same of velocities
  std::vector<double> uncovered;      // how far the body reaches out of the disc [m]
  std::set<std::uint32_t> false_ids;  // tracks far from everybody
  std::set<std::uint32_t> true_ids;
  int visible = 0;       // scans times walkers that were in view and moved
  int followed = 0;      // of these, with a track
  int false_points = 0;  // points of tracks that lie on something that stands
};

inline double mean(const std::vector<double>& values) {
  double sum = 0.0;
  for (double v : values) sum += v;
  return values.empty() ? 0.0 : sum / static_cast<double>(values.size());
}
inline double rms(std::vector<double> values) {
  for (double& v : values) v *= v;
  return std::sqrt(mean(values));
}
inline double share_below(std::vector<double> values, double share) {
  if (values.empty()) return 0.0;
  std::sort(values.begin(), values.end());
  return values[std::min(values.size() - 1, static_cast<std::size_t>(share * static_cast<double>(values.size())))];
}

/// A walker as the score follows it.
struct Watched {
  double in_view_since = -1.0;  // [s]
  double found_at = -1.0;       // [s]
  double steady_since = -1.0;   // its velocity has not changed since [s]
  Point velocity{0.0, 0.0};
};

class TrackerDrive {
 public:
  TrackerDrive(ScanWorld world, ScanRobot robot, const TrackerSettings& settings, std::uint64_t seed)
      : world_(std::move(world)),
        robot_(std::move(robot)),
        tracker_(settings),
        random_(seed),
        watched_(world_.walkers.size()) {}

  double near = 0.5;  // walkers between these distances count [m]
  double far = 5.0;

  TrackerScore run(double duration) {
    const double step = 1.0 / world_.laser.rate;
    for (double time = 1.0; time < 1.0 + duration; time += step) {
      for (int i = 0; i < 5; ++i) robot_.advance(step / 5.0);
      std::vector<int> seen;
      tracker_.update(world_.scan(time, robot_.truth(), robot_.odometry(), random_, seen));
      judge(time, seen);
    }
    return score_;
  }

  const Tracker& tracker() const { return tracker_; }
  const ScanRobot& robot() const { return robot_; }

 private:
  const MovingObstacleEstimate* nearest_to(const Point& place, double within) const {
    const MovingObstacleEstimate* best = nullptr;
    for (const MovingObstacleEstimate& o : tracker_.obstacles()) {
      const double d = (o.position - place).norm();
      if (d < within) {
        within = d;
        best = &o;
      }
    }
    return best;
  }

  void judge(double time, const std::vector<int>& seen) {
    for (std::size_t w = 0; w < watched_.size(); ++w) {
      const Walker& walker = world_.walkers[w];
      const MovingObstacleEstimate* o = nearest_to(robot_.in_odometry(walker.at(time)), walker.radius + 0.5);
      if (o != nullptr) score_.true_ids.insert(o->id);
    }
    for (std::size_t w = 0; w < watched_.size(); ++w) judge_walker(w, time, seen[w]);
    for (const MovingObstacleEstimate& o : tracker_.obstacles()) {
      double nearest = 1e9;
      for (const Walker& walker : world_.walkers) {
        nearest = std::min(nearest, (o.position - robot_.in_odometry(walker.at(time))).norm() - walker.radius);
      }
      if (nearest > 0.5 && score_.true_ids.count(o.id) == 0) score_.false_ids.insert(o.id);
      judge_points(o, time);
    }
  }

  // A point that a track says may leave the costmap must be on a walker, as far as noise allows.
  void judge_points(const MovingObstacleEstimate& o, double time) {
    for (const Point& p : o.points) {
      bool on_walker = false;
      for (const Walker& walker : world_.walkers) {
        on_walker = on_walker ||
                    (p - robot_.in_odometry(walker.at(time))).norm() < walker.radius + 0.25 + 4.0 * world_.laser.noise;
      }
      if (!on_walker) ++score_.false_points;
    }
  }

  void judge_walker(std::size_t w, double time, int beams) {
    const Walker& walker = world_.walkers[w];
    Watched& watched = watched_[w];
    const Point place = robot_.in_odometry(walker.at(time));
    const Point velocity = robot_.turned(walker.velocity(time));
    if ((velocity - watched.velocity).norm() > 0.05) watched.steady_since = time;
    watched.velocity = velocity;
    const double distance = (place - Point(robot_.odometry().x, robot_.odometry().y)).norm();
    // In view is of whom half or more is seen.
    if (beams < 4 || beams < world_.half_of(walker, distance) || distance > far || distance < near ||
        velocity.norm() < 0.4) {
      watched.in_view_since = watched.found_at = -1.0;
      return;
    }
    ++score_.visible;
    if (watched.in_view_since < 0.0) watched.in_view_since = time;
    const MovingObstacleEstimate* o = nearest_to(place, walker.radius + 0.5);
    if (o == nullptr) return;
    ++score_.followed;
    if (watched.found_at < 0.0) {
      watched.found_at = time;
      score_.delays.push_back(time - watched.in_view_since);
    }
    compare(*o, walker, watched, time, place, velocity);
  }

  void compare(const MovingObstacleEstimate& o, const Walker& walker, const Watched& watched, double time,
               const Point& place, const Point& velocity) {
    const double off = (o.position - place).norm();
    const double wrong = (o.velocity - velocity).norm();
    const bool steady = time > watched.found_at + 1.0 && time > watched.steady_since + 1.0;
    (steady ? score_.steady : score_.early).push_back(wrong);
    score_.places.push_back(off);
    score_.uncovered.push_back(off + walker.radius - o.radius);
    score_.place_ratios.push_back(off * off / (o.position_deviation * o.position_deviation));
    score_.speed_ratios.push_back(wrong * wrong / (o.velocity_deviation * o.velocity_deviation));
  }

  ScanWorld world_;
  ScanRobot robot_;
  Tracker tracker_;
  Random random_;
  std::vector<Watched> watched_;
  TrackerScore score_;
};

}  // namespace hidwa_local_planner::test
