// SPDX-License-Identifier: BSD-3-Clause
#include "core/collision/collision.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "core/collision/rounding.hpp"
#include "core/util/outline.hpp"

namespace hidwa_local_planner {
namespace {

// Clearances are told up to so many cells at least.
constexpr double kLeastClearance = 2.0;

// Flags of a cell beside its classes: an obstacle, of cost inscribed, and an obstacle with something else beside it.
// Obstacles in the midst of others are never nearest.
constexpr std::uint8_t kSolid = 8;
constexpr std::uint8_t kCore = 16;
constexpr std::uint8_t kEdge = 32;

// What its cost says of a cell.
constexpr std::uint8_t kSolidBlocks = kSolid | cell_class::kBlocked;
constexpr std::uint8_t kCoreBlocks = kCore | cell_class::kBlocked;

void flag_costs(const std::uint8_t* __restrict costs, int count, bool unknown_is_obstacle,
                std::uint8_t* __restrict flags) {
  const std::uint8_t other = unknown_is_obstacle ? cost::kUnknown : cost::kLethal;
  for (int i = 0; i < count; ++i) {
    const bool solid = (costs[i] == cost::kLethal) | (costs[i] == other);
    const std::uint8_t beside = costs[i] == cost::kInscribed ? kCoreBlocks : std::uint8_t{0};
    flags[i] = solid ? kSolidBlocks : beside;
  }
}

// Clips the parameter range [t0, t1] of the segment a + t d to the open slab (lo, hi).
bool clip(double a, double d, double lo, double hi, double& t0, double& t1) {
  if (d == 0.0) return a > lo && a < hi;
  double enter = (lo - a) / d;
  double leave = (hi - a) / d;
  if (enter > leave) std::swap(enter, leave);
  t0 = std::max(t0, enter);
  t1 = std::min(t1, leave);
  return t0 < t1;
}

bool segment_enters(const Point& a, const Point& b, double x, double y, double side) {
  double t0 = 0.0, t1 = 1.0;
  return clip(a.x(), b.x() - a.x(), x, x + side, t0, t1) && clip(a.y(), b.y() - a.y(), y, y + side, t0, t1);
}

double gap(double value, double lo, double hi) { return std::max({lo - value, value - hi, 0.0}); }

double distance_to_cell(double x, double y, double cell_x, double cell_y, double side) {
  const double dx = gap(x, cell_x, cell_x + side);
  const double dy = gap(y, cell_y, cell_y + side);
  return std::sqrt(dx * dx + dy * dy);
}

}  // namespace

// Nearest to each other are a corner of one and a side of the other.
double distance_to_square(const Polygon& polygon, double x, double y, double side) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
    least = std::min(least, distance_to_cell(polygon[i].x(), polygon[i].y(), x, y, side));
    for (const Point& corner : {Point(x, y), Point(x + side, y), Point(x, y + side), Point(x + side, y + side)}) {
      least = std::min(least, std::sqrt(squared_distance_to_segment(corner, polygon[j], polygon[i])));
    }
  }
  return least;
}

bool overlaps_square(const Polygon& polygon, double x, double y, double side) {
  for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
    if (segment_enters(polygon[j], polygon[i], x, y, side)) return true;
  }
  return contains(polygon, {x + 0.5 * side, y + 0.5 * side});
}

void CollisionChecker::prepare(const GridView& grid, const Footprint& footprint, bool unknown_is_obstacle,
                               const Pose2& centre, double reach, double margin, double largest_clearance) {
  grid_ = grid;
  footprint_ = &footprint;
  unknown_is_obstacle_ = unknown_is_obstacle;
  Shape shape;
  shape.outer = footprint.circumscribed_radius() + margin;
  shape.inscribed = footprint.inscribed_radius();
  shape.margin = margin;
  // By whole cells: what was collected for one cycle serves the next.
  shape.largest_clearance = std::max(kLeastClearance, std::ceil(largest_clearance / grid.resolution)) * grid.resolution;
  shape.resolution = grid.resolution;
  shape.circle = footprint.is_circle();
  shape.radius = static_cast<int>(std::ceil((reach + shape.outer + shape.largest_clearance) / grid.resolution)) + 3;
  const Cell middle = grid.cell_at(centre.x, centre.y);
  first_ = {middle.i - shape.radius, middle.j - shape.radius};
  if (mark_obstacles(shape)) {
    spread_marks();
    prepare_lists();
  } else {
    lists_.move_to(corner());
  }
}

// Where its centre lies inside, an outline that touches the midst of obstacles touches their edge too.
void CollisionChecker::prepare_lists() {
  ObstacleLists::Window window;
  window.cells = &cells_;
  window.solid = footprint_->inscribed_radius() > 0.0 ? kEdge : kSolid;
  window.core = footprint_->is_circle() ? kCore : std::uint8_t{0};
  window.solid_reach = footprint_->circumscribed_radius() + shape_.margin + shape_.largest_clearance;
  window.core_reach = shape_.largest_clearance + kRounding;
  window.corner = corner();
  window.resolution = grid_.resolution;
  lists_.prepare(window);
  planes_.reserve();
}

// What the costs say of the window's cells; beyond the map's edge are obstacles.
void CollisionChecker::mark_costs(CellFlags& cells) const {
  const int size = cells.width();
  const int begin = std::clamp(-first_.i, 0, size), end = std::clamp(grid_.size_x - first_.i, begin, size);
  for (int j = 0; j < size; ++j) {
    std::uint8_t* flags = cells.row(j);
    const int row = first_.j + j;
    if (row < 0 || row >= grid_.size_y || begin == end) {
      std::fill_n(flags, size, kSolidBlocks);
      continue;
    }
    std::fill_n(flags, begin, kSolidBlocks);
    flag_costs(grid_.costs + grid_.index({first_.i + begin, row}), end - begin, unknown_is_obstacle_, flags + begin);
    std::fill_n(flags + end, size - end, kSolidBlocks);
  }
}

// False where the robot sees around itself what it saw in the cycle before: then all that follows from it still holds.
bool CollisionChecker::mark_obstacles(const Shape& shape) {
  const int size = 2 * shape.radius + 1;
  fresh_.reset(size, size);
  mark_costs(fresh_);
  if (shape == shape_ && fresh_.same(cells_, kSolid | kCore | cell_class::kBlocked)) return false;
  shape_ = shape;
  cells_ = fresh_;  // no swap: both keep room for the largest window
  return true;
}

// Only a circle minds inscribed cells: they are hits, and near is whatever comes within the margin of one.
void CollisionChecker::spread_marks() {
  disc_reach(shape_.outer, shape_.resolution, 1, reach_);
  rim_ = static_cast<int>(reach_.size());
  cells_.spread(kSolid, reach_, cell_class::kNear);
  disc_reach(shape_.inscribed - kRounding, shape_.resolution, 0, reach_);
  cells_.spread(kSolid, reach_, cell_class::kHit);
  if (shape_.circle) {
    disc_reach(shape_.margin + kRounding, shape_.resolution, 1, reach_);
    cells_.spread(kCore, reach_, cell_class::kNear);
    reach_.assign(1, 0);
    cells_.spread(kCore, reach_, cell_class::kHit);
  }
  cells_.mark_edges(kSolid, kEdge);
}

bool CollisionChecker::clear(double x, double y) const {
  const Cell cell = grid_.cell_at(x, y);
  return in_reach(cell) && (flags_of(cell) & cell_class::kNear) == 0;
}

bool CollisionChecker::clear_around(double x, double y, double distance) const {
  const Cell lo = grid_.cell_at(x - distance, y - distance);
  const Cell hi = grid_.cell_at(x + distance, y + distance);
  if (!in_reach(lo) || !in_reach(hi)) return false;
  for (int j = lo.j; j <= hi.j; ++j) {
    const int last = hi.i - first_.i;
    if (cells_.find(cell_class::kNear, j - first_.j, lo.i - first_.i, last) <= last) return false;
  }
  return true;
}

// An outline need not contain the robot's centre: only where it does, the centre's cell alone can decide.
bool CollisionChecker::centre_collides(Cell cell) const {
  if (footprint_->inscribed_radius() <= 0.0) return false;
  if (obstacle(cell)) return true;
  return footprint_->is_circle() && grid_.at(cell) == cost::kInscribed;
}

bool CollisionChecker::meets_unknown_only(const Pose2& pose, const Rotation& heading) const {
  bool unknown = false, other = false;
  visit_obstacles(place(pose, heading), 0.0, [&](double gap, Cell cell) {
    if (gap > 0.0) return true;
    (grid_.contains(cell) && grid_.at(cell) == cost::kUnknown ? unknown : other) = true;
    return !other;
  });
  return unknown && !other;
}

double CollisionChecker::clearance(const Pose2& pose, const Rotation& heading, double cap) const {
  constexpr double kFree = std::numeric_limits<double>::min();
  const Cell cell = grid_.cell_at(pose.x, pose.y);
  const bool reached = in_reach(cell);
  if (reached && cap <= 0.0 && (flags_of(cell) & cell_class::kNear) == 0) return kFree;
  if (reached && surely_collides(cell)) return 0.0;
  if (centre_collides(cell)) return 0.0;
  const bool listed = reached && (footprint_->is_circle() || !footprint_->sides().empty());
  cap = std::min(std::max(cap, kRounding), shape_.largest_clearance);
  const Cell inside{cell.i - first_.i, cell.j - first_.j};
  const double least =
      listed ? lists_.smallest_gap(inside, pose, heading, *footprint_, cap) : smallest_gap(place(pose, heading), cap);
  return least <= 0.0 ? 0.0 : std::max(least - kRounding, kFree);
}

CollisionChecker::Placed CollisionChecker::place(const Pose2& pose, const Rotation& heading) const {
  if (footprint_->is_circle()) {
    const double r = footprint_->radius();
    return {pose, pose.x - r, pose.y - r, pose.x + r, pose.y + r};
  }
  const double half = 0.5 * grid_.resolution;
  planes_.turn(*footprint_, {0.0, 0.0, pose.theta}, heading, half);
  if (footprint_->sides().empty()) {
    corners_.clear();
    for (const Point& p : footprint_->outline()) corners_.push_back(heading.placed(pose.x, pose.y, p.x(), p.y()));
  }
  const double* reach = planes_.offset();  // the box's come first
  return {pose, pose.x - (reach[1] - half), pose.y - (reach[3] - half), pose.x + (reach[0] - half),
          pose.y + (reach[2] - half)};
}

// How far the outline is from a cell with this lower left corner, at least; not positive where they overlap.
double CollisionChecker::gap_to(const Pose2& pose, double x, double y) const {
  const double side = grid_.resolution;
  if (footprint_->is_circle()) {
    return distance_to_cell(pose.x, pose.y, x, y, side) - (footprint_->radius() - kRounding);
  }
  const double middle_x = x + 0.5 * side - pose.x, middle_y = y + 0.5 * side - pose.y;
  double most = -std::numeric_limits<double>::infinity();
  for (std::size_t m = 0; m < planes_.count(); ++m) {
    most = std::max(most, planes_.normal_x()[m] * middle_x + planes_.normal_y()[m] * middle_y - planes_.offset()[m]);
  }
  if (!footprint_->sides().empty() || most > shape_.largest_clearance) return most;
  return overlaps_square(corners_, x, y, side) ? 0.0 : std::max(distance_to_square(corners_, x, y, side), kRounding);
}

// To the nearest obstacle that it comes near; not positive where one overlaps. The slow way, for any outline anywhere.
double CollisionChecker::smallest_gap(const Placed& placed, double cap) const {
  double least = cap;
  visit_obstacles(placed, cap, [&](double gap, Cell) {
    least = std::min(least, gap);
    return least > 0.0;
  });
  return least;
}

// Calls visit(gap to it, its cell) for the obstacles in the outline's box, and so far `around` it [m], until it returns
// false.
template <typename Visit>
void CollisionChecker::visit_obstacles(const Placed& placed, double around, Visit&& visit) const {
  const Cell lo = grid_.cell_at(placed.lo_x - around, placed.lo_y - around);
  const Cell hi = grid_.cell_at(placed.hi_x + around, placed.hi_y + around);
  for (int j = lo.j; j <= hi.j; ++j) {
    for (int i = lo.i; i <= hi.i; ++i) {
      if (!obstacle({i, j})) continue;
      const double x = grid_.origin_x + i * grid_.resolution, y = grid_.origin_y + j * grid_.resolution;
      if (!visit(gap_to(placed.pose, x, y), Cell{i, j})) return;
    }
  }
}

}  // namespace hidwa_local_planner
