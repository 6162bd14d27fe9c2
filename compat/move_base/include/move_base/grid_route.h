// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

namespace move_base {

/// The travel cost of a cell to which no way leads.
inline constexpr float kUnreached = std::numeric_limits<float>::infinity();

/// A point of the grid's plane in cells; cell (i, j) is centred on (i, j).
struct GridPoint {
  double x = 0.0;
  double y = 0.0;
};

/// Least-cost routes on a costmap that keep clearance.
///
/// Travelling one cell costs 50 + 0.8 x the costmap's cost; inscribed and lethal cells and the map's border
/// are closed. The travel cost T from the start solves |grad T| = cost (upwind differences on the four
/// neighbours, processed in order of T through buckets narrower than the least increment), so a route is not
/// bound to eight headings; it is followed downhill along the interpolated gradient, half a cell a step.
class GridRoute {
 public:
  /// `costs`: `width` x `height` cells, row-major; `allow_unknown`: unknown cells are open, at the highest
  /// cost.
  void setCosts(const unsigned char* costs, int width, int height, bool allow_unknown);

  /// Opens one cell at the least cost: the one the robot stands in.
  void open(int x, int y);
  bool isOpen(int x, int y) const { return inside(x, y) && travel_[cell(x, y)] != 0; }

  /// Spreads travel costs from the start's cell until the goal's cell has its own, or over all that can be
  /// reached. True when the goal was reached.
  bool propagate(const GridPoint& start, const GridPoint& goal);

  /// The reached cell nearest to `goal` and at most `tolerance` cells away.
  std::optional<GridPoint> nearestReached(const GridPoint& goal, double tolerance) const;

  /// The route from the start to `goal`, whose cell was reached.
  std::vector<GridPoint> trace(const GridPoint& goal) const;

  /// Travel cost from the start of the cell at `point`; infinite where it was not reached.
  float costTo(const GridPoint& point) const;

 private:
  std::size_t cell(int x, int y) const { return std::size_t(y) * std::size_t(width_) + std::size_t(x); }
  bool inside(int x, int y) const { return x >= 0 && y >= 0 && x < width_ && y < height_; }
  void push(std::size_t index, float cost);
  void relax(std::size_t index);
  GridPoint gradient(int x, int y) const;
  GridPoint gradientAt(const GridPoint& point) const;
  GridPoint lowestNeighbour(const GridPoint& point) const;

  static constexpr int kBuckets = 16;
  int width_ = 0;
  int height_ = 0;
  GridPoint start_;
  std::vector<std::uint8_t> travel_;   // cost of crossing a cell, 0: closed
  std::vector<float> cost_to_;         // T
  std::vector<std::uint8_t> waiting_;  // the cell lies in a bucket
  std::vector<std::vector<std::size_t>> buckets_;
};

}  // namespace move_base
