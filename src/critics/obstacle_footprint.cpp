// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>

#include "critics/built_in_entry.hpp"
#include "hidwa_local_planner/core/critic.hpp"
#include "hidwa_local_planner/core/footprint.hpp"

namespace hidwa_local_planner::critics {
namespace {

void append_side(const Point& a, const Point& b, double spacing, Polygon& points) {
  const int parts = std::max(1, static_cast<int>(std::ceil((b - a).norm() / spacing)));
  for (int part = 0; part < parts; ++part) points.push_back(a + (b - a) * (static_cast<double>(part) / parts));
}

void trace_outline(const Footprint& footprint, double spacing, Polygon& points) {
  points.clear();
  if (footprint.is_circle()) {
    const double radius = footprint.radius();
    const int parts = std::max(8, 4 * static_cast<int>(std::ceil(0.5 * M_PI * radius / spacing)));
    for (int part = 0; part < parts; ++part) {
      const double angle = 2.0 * M_PI * part / parts;
      points.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
    }
    return;
  }
  const Polygon& outline = footprint.outline();
  for (std::size_t i = 0; i < outline.size(); ++i) {
    append_side(outline[i], outline[(i + 1) % outline.size()], spacing, points);
  }
}

/// The largest cost under the footprint's outline at the last pose. Rejects candidates whose
/// outline touches a lethal or (by policy) unknown cell or leaves the map; not where it already does, with method:
/// hidwa.
class ObstacleFootprint : public Critic {
 public:
  double configure(const Parameters& parameters, const ParameterSource& /*own*/) override {
    escape_ = parameters.method == Method::hidwa;
    unknown_is_obstacle_ = parameters.unknown_is_obstacle;
    return parameters.ObstacleFootprint_scale;
  }

  void prepare(const CycleView& cycle) override {
    trace_outline(*cycle.footprint, 0.5 * cycle.grid->resolution, outline_);
    const Pose2& q = cycle.pose;
    rejects_ = !(escape_ && outline_cost(*cycle.grid, q.x, q.y, std::cos(q.theta), std::sin(q.theta)) < 0.0);
  }

  void score(const CycleView& cycle, const Tile& tile, TileScores& scores) override {
    for (std::size_t c = 0; c < tile.count; ++c) {
      if (scores.rejected(c)) continue;
      double last = 0.0;
      for (std::size_t k = 0; k <= tile.steps && last >= 0.0; ++k) {
        last = outline_cost(*cycle.grid, tile.x_at(k, c), tile.y_at(k, c), tile.cos_heading[k], tile.sin_heading[k]);
        if (last < 0.0 && !rejects_) last = cost::kLethal;
      }
      if (last < 0.0) {
        scores.reject(c, "outline hits an obstacle");
      } else {
        scores.set(c, last);
      }
    }
  }

 private:
  /// The largest cost under the outline at a pose; negative where it touches an obstacle.
  double outline_cost(const GridView& grid, double x, double y, double cosine, double sine) const {
    std::uint8_t largest = cost::kFree;
    for (const Point& p : outline_) {
      const Cell cell = grid.cell_at(x + cosine * p.x() - sine * p.y(), y + sine * p.x() + cosine * p.y());
      if (grid.obstacle(cell, unknown_is_obstacle_)) return -1.0;
      if (const std::uint8_t value = grid.at(cell); value != cost::kUnknown) largest = std::max(largest, value);
    }
    return largest;
  }

  bool escape_ = true;
  bool unknown_is_obstacle_ = true;
  bool rejects_ = true;
  Polygon outline_;  // points of the outline at most half a cell apart, robot frame [m]
};

const BuiltInEntry entry("ObstacleFootprint", make<ObstacleFootprint>);

}  // namespace
}  // namespace hidwa_local_planner::critics
