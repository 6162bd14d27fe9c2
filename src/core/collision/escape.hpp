// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/collision/collision.hpp"
#include "core/collision/escape_speed.hpp"
#include "core/collision/obstacle_clusters.hpp"
#include "core/collision/outline_depth.hpp"
#include "core/motion/cycle_start.hpp"
#include "hidwa_local_planner/core/footprint.hpp"
#include "hidwa_local_planner/core/grid_view.hpp"
#include "hidwa_local_planner/core/parameters.hpp"
#include "hidwa_local_planner/core/tile.hpp"

namespace hidwa_local_planner {

/// What a robot in collision may do. S is the set of obstacle cells that its outline overlaps at this cycle's pose,
/// also those that the map has just added.
///
///   1. All obstacles but S and the clusters it belongs to (ObstacleClusters) count as always: see rest().
///   2. A cell outside S may be entered only if it is a neighbour of one in S, no deeper than the robot stands in
///      that one, and at most half a cell deep. A rollout looks farther ahead than the next cycle: there, neighbours
///      of neighbours count, too.
///   3. The total depth never grows. It is the depth in the deepest cell of each cluster (OutlineDepth), summed over
///      the clusters. For a wall it does not depend on where its cells begin, so a robot that grazes one can drive
///      along it.
///   4. It ends less deep, or farther from S, or drives on along what it grazes (at most half a cell deep).
///   5. It is so slow that it stops within half a cell (EscapeSpeed), or brakes as hard as it can.
///
/// A circle whose outline is free counts as in collision too where its centre's cell is inscribed. It overlaps nothing:
/// only 1 holds, with the outline alone.
class EscapeRule {
 public:
  /// Once per evaluation, before the candidates are made. All must outlive the questions.
  void look(const Parameters& parameters, const GridView& grid, const Footprint& footprint, const CycleStart& start);
  /// The robot stands in collision: the ordinary rule would reject everything.
  bool applies() const { return !overlaps_.empty() || centre_inscribed_; }
  /// It overlaps something.
  bool overlaps() const { return !overlaps_.empty(); }
  /// Of the samples of this cycle.
  VelocityLimits slowed() const { return speed_.slowed(); }

  /// Once per evaluation where it applies; as of CollisionChecker::prepare().
  void prepare(double reach, double margin, double largest_clearance);
  /// All obstacles that the ordinary rule holds for.
  const CollisionChecker& rest() const { return rest_; }

  /// Of a way through the clusters, pose by pose.
  struct Descent {
    double least = 0.0;  // total depth so far [m]
    double total = 0.0;  // at the last pose [m]
  };
  Descent start() const { return {start_total_, start_total_}; }
  /// How long until it is asked again: cells of the clusters that it may enter.
  enum class Ahead { next_cycle, rollout };
  /// False where the robot goes deeper than it may. Poses in order.
  bool descends(const TurnedPose& at, Ahead ahead, Descent& descent);

  /// The fifth of the rules above.
  bool slow_enough(const Twist2& sample) const { return speed_.allows(sample, start_->reference, start_->period); }
  /// The second and the third of them, for a rollout.
  bool descends(const Tile& tile, std::size_t c, Descent& descent);
  /// The fourth, but for what it grazes.
  bool ends_better(const Pose2& end, const Descent& descent) const;
  /// Total depth at the end of a rollout that descends [m].
  double depth_at_end(const Tile& tile, std::size_t c);
  /// It stands at most half a cell deep.
  bool grazes() const { return start_total_ <= 0.5 * window_.map.resolution; }

  /// Whether a turn on the spot, so far as to `heading` [rad], may pass there.
  bool may_face(double heading);
  /// Whether the robot gets out, or nearer to it, straight on for `length` [m] once it faces `heading` [rad].
  bool leads_out(double heading, double length);

 private:
  void find_overlaps();
  void list_near_cells();
  void make_rest();
  void list_members();
  TurnedPose relative(const Pose2& pose, const Rotation& heading) const;
  double distance_to_overlapped(const Pose2& pose) const;
  std::size_t stride(const Tile& tile, std::size_t c) const;

  const Footprint* footprint_ = nullptr;
  double sim_time_ = 0.0;  // [s]
  const CycleStart* start_ = nullptr;
  EscapeSpeed speed_;
  OutlineDepth depth_;
  std::vector<ObstacleClusters::Overlap> overlaps_;
  bool centre_inscribed_ = false;

  ObstacleClusters clusters_;
  ObstacleClusters::Window window_;
  std::vector<std::uint8_t> rest_costs_;  // of the window
  CollisionChecker rest_;
  std::vector<double> x_, y_;   // centres of the clusters' cells, from the start's position [m]
  std::vector<double> depths_;  // in them [m]
  double start_total_ = 0.0;    // [m]
};

}  // namespace hidwa_local_planner
