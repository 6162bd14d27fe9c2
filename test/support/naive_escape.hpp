// SPDX-License-Identifier: BSD-3-Clause
// A robot in collision, the slow way: depths by the Minkowski difference, clusters by searching all cells. Shares
// nothing with the core but its plain types.
#pragma once

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include "support/naive_collision.hpp"
#include "support/naive_gap.hpp"
#include "support/naive_padding.hpp"
#include "support/scene.hpp"

namespace hidwa_local_planner::test {

/// How much the robot shares with a square: the root of an area, or for a disc a length [m].
inline double naive_overlap_of(const NaiveBody& body, const Pose2& pose, double x, double y, double side) {
  if (body.radius <= 0.0) return std::sqrt(naive_shared_area(naive_place(body.corners, pose), x, y, side));
  return std::max(0.0, body.radius - naive_to_square(pose, x, y, side));
}

/// The shortest move that takes the robot out of the square [x, x + side] x [y, y + side] [m]; 0 where it shares no
/// area. An outline that is not convex counts as its hull once it shares area.
inline double naive_depth(const NaiveBody& body, const Pose2& pose, double x, double y, double side) {
  const Polygon square = naive_square(x, y, side);
  if (body.radius > 0.0) {
    const Point centre(pose.x, pose.y);
    double nearest = INFINITY;
    for (std::size_t k = 0; k < 4; ++k) {
      nearest = std::min(nearest, naive_to_segment(centre, square[k], square[(k + 1) % 4]));
    }
    const bool within = pose.x > x && pose.x < x + side && pose.y > y && pose.y < y + side;
    return std::max(0.0, within ? body.radius + nearest : body.radius - nearest);
  }
  if (naive_overlap_of(body, pose, x, y, side) <= 0.0) return 0.0;
  const Polygon placed = naive_place(body.corners, pose);
  // They overlap by as much as the origin lies inside their difference.
  Polygon difference;
  for (const Point& a : placed) {
    for (const Point& b : square) difference.push_back(a - b);
  }
  const Polygon hull = naive_hull(difference);
  double depth = INFINITY;
  for (std::size_t k = 0; k < hull.size(); ++k) {
    const Point &a = hull[k], &b = hull[(k + 1) % hull.size()];
    const double length = (b - a).norm();
    if (length > 0.0) depth = std::min(depth, (a.x() * b.y() - a.y() * b.x()) / length);
  }
  return std::max(depth, 0.0);
}

/// What may be done from one pose in collision.
class NaiveEscape {
 public:
  using Cell2 = std::pair<int, int>;

  /// `steps`: how many cells from the overlapped ones a cluster is followed.
  NaiveEscape(const GridView& grid, const NaiveBody& body, bool unknown_is_obstacle, const Pose2& pose, int steps)
      : grid_(grid), body_(body), unknown_(unknown_is_obstacle), pose_(pose) {
    overlapped_ = depths(pose);
    for (const auto& [cell, depth] : overlapped_) cluster_[cell] = -1;
    follow(steps);
    name_clusters();
  }
  bool overlaps() const { return !overlapped_.empty(); }
  bool in_cluster(int i, int j) const { return cluster_.count({i, j}) > 0; }
  double start_total() const { return total(pose_); }

  /// The deepest cell of each cluster, added up [m].
  double total(const Pose2& pose) const {
    std::map<int, double> deepest;
    for (const auto& [cell, depth] : depths(pose)) {
      if (in_cluster(cell.first, cell.second)) {
        double& most = deepest[cluster_.at(cell)];
        most = std::max(most, depth);
      }
    }
    double sum = 0.0;
    for (const auto& [cluster, depth] : deepest) sum += depth;
    return sum;
  }

  /// How much deeper than allowed the robot reaches into a cell there [m]. Until the next cycle it may enter neighbours
  /// of the overlapped cells only.
  double excess(const Pose2& pose, bool next_cycle) const {
    double worst = 0.0;
    for (const auto& [cell, depth] : depths(pose)) worst = std::max(worst, depth - limit(cell, next_cycle));
    return worst;
  }

  /// From the robot's centre to the nearest of the overlapped cells [m].
  double clearance(const Pose2& pose) const {
    double nearest = INFINITY;
    for (const auto& [cell, depth] : overlapped_) {
      nearest = std::min(nearest, naive_to_square(pose, corner_x(cell.first), corner_y(cell.second), grid_.resolution));
    }
    return nearest;
  }

  /// Never deeper along a way than before, nor in any cell deeper than allowed.
  bool descends(const std::vector<Pose2>& poses, bool next_cycle) const {
    constexpr double kSame = 1e-7;  // [m]
    double least = start_total();
    for (const Pose2& pose : poses) {
      if (excess(pose, next_cycle) > kSame || total(pose) > least + kSame) return false;
      least = std::min(least, total(pose));
    }
    return true;
  }

 private:
  double corner_x(int i) const { return grid_.origin_x + i * grid_.resolution; }
  double corner_y(int j) const { return grid_.origin_y + j * grid_.resolution; }
  bool obstacle(int i, int j) const {
    if (i < 0 || j < 0 || i >= grid_.size_x || j >= grid_.size_y) return true;
    return naive_is_obstacle(grid_.costs[j * grid_.size_x + i], unknown_);
  }

  // Of all obstacle cells that the robot overlaps.
  std::map<Cell2, double> depths(const Pose2& pose) const {
    std::map<Cell2, double> found;
    const double outer = naive_outer_radius(body_) + 0.001;
    const auto index = [this](double value, double origin) {
      return static_cast<int>(std::floor((value - origin) / grid_.resolution));
    };
    for (int j = index(pose.y - outer, grid_.origin_y); j <= index(pose.y + outer, grid_.origin_y); ++j) {
      for (int i = index(pose.x - outer, grid_.origin_x); i <= index(pose.x + outer, grid_.origin_x); ++i) {
        if (!obstacle(i, j)) continue;
        const double depth = naive_depth(body_, pose, corner_x(i), corner_y(j), grid_.resolution);
        if (depth > 1e-9) found[{i, j}] = depth;
      }
    }
    return found;
  }

  static bool neighbours(const Cell2& a, const Cell2& b) {
    return std::max(std::abs(a.first - b.first), std::abs(a.second - b.second)) == 1;
  }

  void follow(int steps) {
    std::map<Cell2, double> ring = overlapped_;
    for (int step = 0; step < steps; ++step) {
      std::map<Cell2, double> next;
      for (const auto& [from, depth] : ring) {
        for (int dj = -1; dj <= 1; ++dj) {
          for (int di = -1; di <= 1; ++di) {
            const Cell2 cell{from.first + di, from.second + dj};
            if (cluster_.count(cell) > 0 || !obstacle(cell.first, cell.second) || buried(cell)) continue;
            next[cell] = std::max(next[cell], std::min(depth, 0.5 * grid_.resolution));
          }
        }
      }
      for (const auto& [cell, depth] : next) {
        cluster_[cell] = -1;
        inherited_[cell] = depth;
      }
      ring = next;
    }
  }
  bool buried(const Cell2& c) const {
    return obstacle(c.first + 1, c.second) && obstacle(c.first - 1, c.second) && obstacle(c.first, c.second + 1) &&
           obstacle(c.first, c.second - 1);
  }

  // Every cell takes the least name around it until nothing changes any more.
  void name_clusters() {
    int name = 0;
    for (auto& [cell, cluster] : cluster_) cluster = name++;
    bool changed = true;
    while (changed) {
      changed = false;
      for (auto& [cell, cluster] : cluster_) {
        for (int dj = -1; dj <= 1; ++dj) {
          for (int di = -1; di <= 1; ++di) {
            const auto other = cluster_.find({cell.first + di, cell.second + dj});
            if (other == cluster_.end() || other->second >= cluster) continue;
            cluster = other->second;
            changed = true;
          }
        }
      }
    }
  }

  double limit(const Cell2& cell, bool next_cycle) const {
    if (cluster_.count(cell) == 0) return 0.0;
    double limit = 0.0;
    for (const auto& [other, depth] : overlapped_) {
      if (other == cell) limit = std::max(limit, depth);
      if (neighbours(other, cell)) limit = std::max(limit, std::min(depth, 0.5 * grid_.resolution));
    }
    const auto found = inherited_.find(cell);
    if (!next_cycle && found != inherited_.end()) limit = std::max(limit, found->second);
    return limit;
  }

  GridView grid_;
  NaiveBody body_;
  bool unknown_;
  Pose2 pose_;
  std::map<Cell2, double> overlapped_;  // and how deep [m]
  std::map<Cell2, double> inherited_;   // of the others: of their nearest overlapped ones, half a cell at most [m]
  std::map<Cell2, int> cluster_;
};

}  // namespace hidwa_local_planner::test
