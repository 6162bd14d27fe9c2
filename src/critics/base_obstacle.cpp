// SPDX-License-Identifier: BSD-3-Clause
#include "critics/built_in_entry.hpp"
#include "hidwa_local_planner/core/critic.hpp"

namespace hidwa_local_planner::critics {
namespace {

/// The cost of the cell under the robot's centre at the last pose, in [0, 252].
/// Rejects candidates whose centre enters lethal, inscribed or (by policy) unknown cells or leaves the map. With
/// method: hidwa a robot that already stands in one may leave: nothing is rejected there.
class BaseObstacle : public Critic {
 public:
  double configure(const Parameters& parameters, const ParameterSource& /*own*/) override {
    escape_ = parameters.method == Method::hidwa;
    unknown_is_obstacle_ = parameters.unknown_is_obstacle;
    return parameters.BaseObstacle_scale;
  }

  void prepare(const CycleView& cycle) override {
    rejects_ = !(escape_ && obstacle(*cycle.grid, cycle.pose.x, cycle.pose.y));
  }

  void score(const CycleView& /*cycle*/, const Tile& tile, TileScores& scores) override {
    tile.costs(tile.steps, scores.set_all());
    if (!rejects_ || (tile.cells.touched_any & cell_class::kBlocked) == 0) return;
    for (std::size_t c = 0; c < tile.count; ++c) {
      if (!scores.rejected(c) && tile.centre_blocked(c))
        scores.reject(c, "centre hits an obstacle or its inscribed cells");
    }
  }

 private:
  bool obstacle(const GridView& grid, double x, double y) const {
    const Cell cell = grid.cell_at(x, y);
    return grid.obstacle(cell, unknown_is_obstacle_) || grid.at(cell) == cost::kInscribed;
  }

  bool escape_ = true;
  bool unknown_is_obstacle_ = true;
  bool rejects_ = true;
};

const BuiltInEntry entry("BaseObstacle", make<BaseObstacle>);

}  // namespace
}  // namespace hidwa_local_planner::critics
