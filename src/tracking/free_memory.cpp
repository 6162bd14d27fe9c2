// SPDX-License-Identifier: BSD-3-Clause
#include "tracking/free_memory.hpp"

#include <algorithm>
#include <cmath>

namespace hidwa_local_planner {
namespace tracking {
namespace {

constexpr double kCellSize = 0.1;         // [m]
constexpr float kSettled = 1.0F;          // level from which a cell counts as standing
constexpr float kMostSettled = 2.0F;      // so it is free again after `settle_time` of free sights
constexpr std::uint16_t kSights = 2;      // scans that must have seen a cell free
constexpr double kLongestStep = 0.25;     // between scans, for what stands [s]
constexpr double kShiftInMargin = 0.5;    // so much of a cell's width the margin along edges takes up
constexpr std::int64_t kWidestShift = 5;  // cells; beyond nothing is known
constexpr double kWidestGap = 0.35;       // between beams that bound what was seen [rad]

std::int64_t cell_of(double coordinate) { return static_cast<std::int64_t>(std::floor(coordinate / kCellSize)); }

std::int64_t wrapped(std::int64_t i, std::int64_t size) { return ((i % size) + size) % size; }

}  // namespace

FreeMemory::FreeMemory(const TrackerSettings& settings)
    : settings_(settings), size_(2 * static_cast<std::int64_t>(std::ceil((settings.reach + 1.0) / kCellSize)) + 1) {
  cells_.resize(static_cast<std::size_t>(size_ * size_));
}

void FreeMemory::clear() {
  std::fill(cells_.begin(), cells_.end(), Cell());
  placed_ = false;
  scan_ = 0;
}

bool FreeMemory::inside(std::int64_t ix, std::int64_t iy) const {
  return ix >= corner_x_ && ix < corner_x_ + size_ && iy >= corner_y_ && iy < corner_y_ + size_;
}

FreeMemory::Cell& FreeMemory::at(std::int64_t ix, std::int64_t iy) {
  return cells_[static_cast<std::size_t>(wrapped(iy, size_) * size_ + wrapped(ix, size_))];
}

const FreeMemory::Cell& FreeMemory::at(std::int64_t ix, std::int64_t iy) const {
  return cells_[static_cast<std::size_t>(wrapped(iy, size_) * size_ + wrapped(ix, size_))];
}

void FreeMemory::centre_on(const Point& sensor) {
  const std::int64_t x = cell_of(sensor.x()) - size_ / 2;
  const std::int64_t y = cell_of(sensor.y()) - size_ / 2;
  if (!placed_ || std::abs(x - corner_x_) >= size_ || std::abs(y - corner_y_) >= size_) {
    std::fill(cells_.begin(), cells_.end(), Cell());
  } else {
    // Columns and rows that leave the window are those that enter it, in the grid's memory.
    for (std::int64_t i = std::min(x, corner_x_); i < std::max(x, corner_x_); ++i) {
      for (std::int64_t k = 0; k < size_; ++k) at(i, k) = Cell();
    }
    for (std::int64_t k = std::min(y, corner_y_); k < std::max(y, corner_y_); ++k) {
      for (std::int64_t i = 0; i < size_; ++i) at(i, k) = Cell();
    }
  }
  corner_x_ = x;
  corner_y_ = y;
  placed_ = true;
}

bool FreeMemory::was_free(const Cell& cell, double time) const {
  return cell.sights >= kSights && time - cell.free_at <= settings_.free_memory;
}

PlaceKind FreeMemory::kind(const Point& place, double distance, double time, const Travel& now) const {
  const std::int64_t ix = cell_of(place.x());
  const std::int64_t iy = cell_of(place.y());
  if (!inside(ix, iy)) return PlaceKind::unknown;
  const Cell& own = at(ix, iy);
  bool free = was_free(own, time);
  std::int64_t around = 1;
  if (free) {
    const double shifted = shift({own.free_driven, own.free_turned}, now, distance, settings_.odometry_slip);
    around += static_cast<std::int64_t>(std::ceil(shifted / kCellSize - kShiftInMargin));
    around = std::max<std::int64_t>(around, 1);
    if (around > kWidestShift) return PlaceKind::unknown;
  }
  if (!inside(ix - around, iy - around) || !inside(ix + around, iy + around)) return PlaceKind::unknown;
  for (std::int64_t dy = -around; dy <= around; ++dy) {
    for (std::int64_t dx = -around; dx <= around; ++dx) {
      const Cell& cell = at(ix + dx, iy + dy);
      const bool beside = std::abs(dx) <= 1 && std::abs(dy) <= 1;
      if (cell.standing >= kSettled && beside) return PlaceKind::standing;
      free = free && cell.standing < kSettled && was_free(cell, time);
    }
  }
  return free ? PlaceKind::was_free : PlaceKind::unknown;
}

void FreeMemory::judge(Beams& beams, const Travel& now) const {
  for (Beam& beam : beams.all) {
    if (beam.hit) beam.kind = kind(beam.tip(), beam.length, beams.end, now);
  }
}

// The cells that a line crosses, in order (Amanatides and Woo 1987).
template <typename Visit>
void FreeMemory::walk(const Point& from, const Point& to, Visit visit) const {
  std::int64_t ix = cell_of(from.x());
  std::int64_t iy = cell_of(from.y());
  const std::int64_t steps = std::abs(cell_of(to.x()) - ix) + std::abs(cell_of(to.y()) - iy);
  const Point d = to - from;
  const double never = 1e18;
  const auto first = [&](double start, double delta, std::int64_t i) {
    const double border = kCellSize * static_cast<double>(delta > 0.0 ? i + 1 : i);
    return delta == 0.0 ? never : (border - start) / delta;
  };
  double tx = first(from.x(), d.x(), ix);
  double ty = first(from.y(), d.y(), iy);
  const double step_x = d.x() == 0.0 ? never : kCellSize / std::abs(d.x());
  const double step_y = d.y() == 0.0 ? never : kCellSize / std::abs(d.y());
  visit(ix, iy);
  for (std::int64_t i = 0; i < steps; ++i) {
    if (tx < ty) {
      ix += d.x() > 0.0 ? 1 : -1;
      tx += step_x;
    } else {
      iy += d.y() > 0.0 ? 1 : -1;
      ty += step_y;
    }
    visit(ix, iy);
  }
}

void FreeMemory::mark_edge(std::int64_t ix, std::int64_t iy) {
  for (std::int64_t dy = -1; dy <= 1; ++dy) {
    for (std::int64_t dx = -1; dx <= 1; ++dx) {
      if (inside(ix + dx, iy + dy)) at(ix + dx, iy + dy).edge = scan_;
    }
  }
}

void FreeMemory::mark_edges(const Beams& beams) {
  const Beam* before = nullptr;
  std::size_t gap = 0;  // beams that say nothing, since `before`
  const auto connect = [&](const Beam& beam) {
    const bool near = before != nullptr && beams.increment * static_cast<double>(gap + 1) <= kWidestGap;
    walk(near ? before->tip() : beam.tip(), beam.tip(), [&](std::int64_t ix, std::int64_t iy) { mark_edge(ix, iy); });
    before = &beam;
    gap = 0;
  };
  // In a whole turn once more up to the first beam that says something: the last one's neighbour.
  const std::size_t n = beams.all.size();
  for (std::size_t k = 0; k < (beams.whole_turn ? 2 * n : n); ++k) {
    const Beam& beam = beams.all[k % n];
    if (beam.length > 0.0) {
      connect(beam);
      if (k >= n) return;
    } else {
      ++gap;
    }
  }
}

void FreeMemory::mark_hits(const Beams& beams, float gain) {
  for (const Beam& beam : beams.all) {
    if (!beam.hit || beam.track >= 0) continue;
    const std::int64_t ix = cell_of(beam.tip().x());
    const std::int64_t iy = cell_of(beam.tip().y());
    if (!inside(ix, iy)) continue;
    Cell& cell = at(ix, iy);
    if (cell.looked == scan_) continue;
    cell.looked = scan_;
    cell.standing = std::min(cell.standing + gain, kMostSettled);
  }
}

void FreeMemory::mark_free(const Beams& beams, const Travel& now, float loss) {
  for (const Beam& beam : beams.all) {
    if (beam.length <= 0.0) continue;
    walk(beam.origin, beam.tip(), [&](std::int64_t ix, std::int64_t iy) {
      if (!inside(ix, iy)) return;
      Cell& cell = at(ix, iy);
      if (cell.edge == scan_ || cell.looked == scan_) return;
      cell.looked = scan_;
      cell.standing = std::max(cell.standing - loss, 0.0F);
      cell.free_at = beams.end;
      cell.free_driven = static_cast<float>(now.driven);
      cell.free_turned = static_cast<float>(now.turned);
      if (cell.sights < kSights) ++cell.sights;
    });
  }
}

void FreeMemory::take(const Beams& beams, const Travel& now, double elapsed) {
  ++scan_;
  const float step = static_cast<float>(std::min(elapsed, kLongestStep) / settings_.settle_time);
  mark_edges(beams);
  mark_hits(beams, step);
  mark_free(beams, now, step);
}

}  // namespace tracking
}  // namespace hidwa_local_planner
