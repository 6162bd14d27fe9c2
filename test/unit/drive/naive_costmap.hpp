// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "drive/local_costmap.hpp"
#include "hidwa_local_planner/core/footprint.hpp"

namespace hidwa_local_planner::test {

using CellNumbers = std::pair<int, int>;  // column and row, counted from the frame's origin

/// The cells of a line from one cell to another, each by itself: after k of n steps along the longer way, the
/// nearest cell of the shorter one, halves rounded down.
inline std::vector<CellNumbers> naive_line(CellNumbers from, CellNumbers to, double longest) {
  const int di = to.first - from.first, dj = to.second - from.second;
  const int n = std::max(std::abs(di), std::abs(dj));
  const int m = std::min(std::abs(di), std::abs(dj));
  const double length = std::hypot(di, dj);
  const int steps = length > longest ? static_cast<int>(n * (longest / length)) : n;
  std::vector<CellNumbers> cells;
  for (int k = 0; k <= steps; ++k) {
    const int beside = n > 0 ? (n / 2 + k * m) / n : 0;
    const int i = std::abs(di) >= std::abs(dj) ? k : beside, j = std::abs(di) >= std::abs(dj) ? beside : k;
    cells.emplace_back(from.first + (di < 0 ? -i : i), from.second + (dj < 0 ? -j : j));
  }
  return cells;
}

/// The slow and obvious local costmap: a set of lethal cells in a window, each cost by the nearest of all of
/// them.
class NaiveCostmap {
 public:
  NaiveCostmap(const drive::CostmapSettings& settings, Polygon outline)
      : settings_(settings),
        outline_(std::move(outline)),
        cells_(static_cast<int>(std::lround(settings.width / settings.resolution))) {}

  void update(const sim::Pose& robot, const drive::Beams& beams) {
    follow(robot);
    clear(beams);
    mark(beams);
    clear_under(robot);
  }

  int column() const { return column_; }
  int row() const { return row_; }
  int cells() const { return cells_; }

  std::uint8_t cost(int column, int row) const {
    double nearest = 1e9;  // [m]
    for (const CellNumbers& lethal : lethal_) {
      nearest = std::min(nearest, settings_.resolution * std::hypot(lethal.first - column, lethal.second - row));
    }
    const double reach = std::ceil(settings_.inflation.inflation_radius / settings_.resolution) * settings_.resolution;
    if (nearest > reach + 1e-9) return 0;
    if (nearest == 0.0) return 254;
    const double beyond = nearest - Footprint(outline_).inscribed_radius();
    if (beyond <= 0.0) return 253;
    return static_cast<std::uint8_t>(252.0 * std::exp(-settings_.inflation.cost_scaling_factor * beyond));
  }

 private:
  CellNumbers cell(double x, double y) const {
    return {static_cast<int>(std::floor(x / settings_.resolution - column_)) + column_,
            static_cast<int>(std::floor(y / settings_.resolution - row_)) + row_};
  }
  bool inside(const CellNumbers& c) const {
    return c.first >= column_ && c.second >= row_ && c.first < column_ + cells_ && c.second < row_ + cells_;
  }

  void follow(const sim::Pose& robot) {
    const auto moved = [this](double centre, int corner) {
      const double off = centre / settings_.resolution - 0.5 * cells_ - corner;
      return corner + static_cast<int>(off + std::copysign(1e-6, off));
    };
    column_ = moved(robot.x, column_);
    row_ = moved(robot.y, row_);
    std::set<CellNumbers> kept;
    for (const CellNumbers& c : lethal_) {
      if (inside(c)) kept.insert(c);
    }
    lethal_ = kept;
  }

  void clear(const drive::Beams& beams) {
    const CellNumbers from = cell(beams.origin.x(), beams.origin.y());
    if (!inside(from)) return;
    for (const Point& end : beams.ends) {
      // Where the beam leaves the window it ends.
      const double low_x = column_ * settings_.resolution, low_y = row_ * settings_.resolution;
      const double side = (cells_ - 1e-3) * settings_.resolution;
      double part = 1.0;
      const Point along = end - beams.origin;
      if (end.x() > low_x + side) part = std::min(part, (low_x + side - beams.origin.x()) / along.x());
      if (end.x() < low_x) part = std::min(part, (low_x - beams.origin.x()) / along.x());
      if (end.y() > low_y + side) part = std::min(part, (low_y + side - beams.origin.y()) / along.y());
      if (end.y() < low_y) part = std::min(part, (low_y - beams.origin.y()) / along.y());
      CellNumbers to = cell(beams.origin.x() + part * along.x(), beams.origin.y() + part * along.y());
      to.first = std::clamp(to.first, column_, column_ + cells_ - 1);
      to.second = std::clamp(to.second, row_, row_ + cells_ - 1);
      for (const CellNumbers& c : naive_line(from, to, settings_.raytrace_range / settings_.resolution)) {
        lethal_.erase(c);
      }
    }
  }

  void mark(const drive::Beams& beams) {
    for (const Point& end : beams.ends) {
      const CellNumbers c = cell(end.x(), end.y());
      if ((end - beams.origin).norm() < settings_.obstacle_range && inside(c)) lethal_.insert(c);
    }
  }

  void clear_under(const sim::Pose& robot) {
    std::vector<CellNumbers> corners;
    for (const Point& corner : sim::transformed(outline_, robot)) corners.push_back(cell(corner.x(), corner.y()));
    std::map<int, std::pair<int, int>> rows;  // first and last column
    for (std::size_t k = 0; k < corners.size(); ++k) {
      if (!inside(corners[k])) return;
      for (const CellNumbers& c : naive_line(corners[k], corners[(k + 1) % corners.size()], 1e9)) {
        auto& span = rows.try_emplace(c.second, c.first, c.first).first->second;
        span = {std::min(span.first, c.first), std::max(span.second, c.first)};
      }
    }
    for (const auto& [j, span] : rows) {
      for (int i = span.first; i <= span.second; ++i) lethal_.erase({i, j});
    }
  }

  drive::CostmapSettings settings_;
  Polygon outline_;
  int cells_;
  int column_ = 0, row_ = 0;  // of the window's lower left corner
  std::set<CellNumbers> lethal_;
};

}  // namespace hidwa_local_planner::test
