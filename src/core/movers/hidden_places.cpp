// SPDX-License-Identifier: BSD-3-Clause
#include "core/movers/hidden_places.hpp"

#include <algorithm>
#include <cmath>

#include "core/util/rotation.hpp"

namespace hidwa_local_planner {
namespace {

// Of the middle of a body, from what it stands beside: somebody squeezes past, and cells are coarse [m].
constexpr double kFits = 0.15;
// Between two places, and between two that are tried [m].
constexpr double kSpacing = 0.3;
constexpr double kTried = 0.05;
constexpr double kSameLength = 1e-9;
// Farther from the robot's centre no sensor is mounted [m].
constexpr double kFarthestMount = 100.0;
// A circle around a sensor has no fewer bins, and no more.
constexpr double kFewest = 90.0, kMost = 720.0;
// Memory is reserved for this many places.
constexpr std::size_t kUsualPlaces = 512;

}  // namespace

HiddenPlaces::HiddenPlaces() { places_.reserve(kUsualPlaces); }

void HiddenPlaces::find(const GridView& grid, const Pose2& robot, const SensorSectors& sectors, double reach) {
  places_.clear();
  view_count_ = 0;
  reach = std::min(reach, std::hypot(grid.size_x, grid.size_y) * grid.resolution);  // beyond the map is nobody
  double farthest = 0.0;
  for (const SensorSector& sector : sectors) {
    const double off = std::hypot(sector.pose.x, sector.pose.y);
    if (!is_finite(sector.pose) || off > kFarthestMount || !(sector.range > 0.0)) continue;
    if (views_.size() == view_count_) {
      views_.emplace_back();
      views_.back().lengths.reserve(static_cast<std::size_t>(kMost));
    }
    View& view = views_[view_count_++];
    view.from = Rotation::of(robot.theta).placed(robot.x, robot.y, sector.pose.x, sector.pose.y);
    view.middle = wrap_angle(robot.theta + sector.pose.theta);
    view.half = 0.5 * sector.width;
    view.reach = reach + off;
    view.range = std::min(view.reach + kBodyRadius + kFits, sector.range);  // a place lies beside its line
    farthest = std::max(farthest, view.range);
  }
  bins_ = static_cast<std::size_t>(std::clamp(std::ceil(2.0 * M_PI * farthest / grid.resolution), kFewest, kMost));
  bin_ = 2.0 * M_PI / static_cast<double>(bins_);
  for (std::size_t i = 0; i < view_count_; ++i) look(grid, views_[i]);
  for (std::size_t i = 0; i < view_count_; ++i) find_beside(grid, views_[i]);
}

// A cell blocks the sight as a disc around it does.
void HiddenPlaces::look(const GridView& grid, View& view) const {
  view.lengths.assign(bins_, view.range);
  const Cell lo = grid.cell_at(view.from.x() - view.range, view.from.y() - view.range);
  const Cell hi = grid.cell_at(view.from.x() + view.range, view.from.y() + view.range);
  const double radius = M_SQRT1_2 * grid.resolution;
  const auto count = static_cast<long>(bins_);
  for (int j = std::max(0, lo.j); j <= std::min(grid.size_y - 1, hi.j); ++j) {
    for (int i = std::max(0, lo.i); i <= std::min(grid.size_x - 1, hi.i); ++i) {
      if (grid.at({i, j}) != cost::kLethal) continue;
      const Point to = grid.centre({i, j}) - view.from;
      const double length = to.norm();
      if (length >= view.range || length <= radius) continue;
      const double angle = std::atan2(to.y(), to.x()), half = std::asin(radius / length);
      const auto last = static_cast<long>(std::floor((angle + half) / bin_));
      for (auto k = static_cast<long>(std::floor((angle - half) / bin_)); k <= last; ++k) {
        double& sight = view.lengths[static_cast<std::size_t>((k % count + count) % count)];
        sight = std::min(sight, length);
      }
    }
  }
}

void HiddenPlaces::find_beside(const GridView& grid, const View& view) {
  for (std::size_t k = 0; k < bins_; ++k) {
    const double here = view.lengths[k], next = view.lengths[(k + 1) % bins_];
    if (std::abs(next - here) < 2.0 * kFits) continue;
    const double angle = static_cast<double>(k + 1) * bin_;
    if (!faces(view, angle)) continue;
    const double edge = std::min(here, next);
    if (!lets_through(view, k + 1, next > here, edge)) continue;
    add_along(grid, view, angle, next > here ? -1.0 : 1.0, edge, std::min(view.reach, std::max(here, next)));
  }
}

// Whether what is seen on the open side of an edge, which is `length` away [m], leaves room for a body beside it.
bool HiddenPlaces::lets_through(const View& view, std::size_t border, bool to_left, double length) const {
  const double angle = static_cast<double>(border) * bin_;
  const Point edge = length * Point(std::cos(angle), std::sin(angle));
  for (std::size_t m = 0;; ++m) {
    const double turned = static_cast<double>(m) * bin_, off = turned + 0.5 * bin_;
    if (turned >= M_PI_2 || length * std::sin(turned) >= 2.0 * kFits) return true;
    const double sight = view.lengths[(to_left ? border + m : border + bins_ - 1 - m) % bins_];
    const double bearing = to_left ? angle + off : angle - off;
    const Point seen = sight * Point(std::cos(bearing), std::sin(bearing));
    if (sight < view.range && (seen - edge).norm() < 2.0 * kFits) return false;
  }
}

// `side`: 1 where the shadow is to the left of the line of sight at `angle`, which is open from `from` to `to` [m].
void HiddenPlaces::add_along(const GridView& grid, const View& view, double angle, double side, double from,
                             double to) {
  const Point ahead(std::cos(angle), std::sin(angle)), across = side * Point(-ahead.y(), ahead.x());
  const auto place_at = [&](double length) { return Point(view.from + length * ahead + kBodyRadius * across); };
  double added = from - 2.0 * kSpacing, counted = added;  // the last place, and the last one that could be one [m]
  const auto end_stretch = [&] {
    if (counted - added <= 0.5 * kSpacing) return;
    places_.push_back(place_at(counted));
    added = counted;
  };
  for (double length = from; length < to; length += kTried) {
    const Point place = place_at(length);
    if (!fits(grid, view.from + length * ahead) || !fits(grid, place) || !hidden(place) ||
        !hidden(place + kFits * across)) {
      end_stretch();
      continue;
    }
    counted = length;
    if (length - added < kSpacing - kSameLength) continue;
    places_.push_back(place);
    added = length;
  }
  end_stretch();
}

bool HiddenPlaces::faces(const View& view, double bearing) const {
  return view.half >= M_PI || std::abs(wrap_angle(bearing - view.middle)) <= view.half;
}

// From all sensors.
bool HiddenPlaces::hidden(const Point& point) const {
  return std::all_of(views_.begin(), views_.begin() + static_cast<std::ptrdiff_t>(view_count_), [&](const View& view) {
    const Point to = point - view.from;
    const double bearing = std::atan2(to.y(), to.x());
    if (!faces(view, bearing)) return true;
    const auto bin = static_cast<std::size_t>((bearing < 0.0 ? bearing + 2.0 * M_PI : bearing) / bin_);
    return to.norm() > view.lengths[std::min(bin, bins_ - 1)];
  });
}

// Somebody's middle can be there.
bool HiddenPlaces::fits(const GridView& grid, const Point& middle) {
  if (!grid.holds(middle)) return false;
  const Cell lo = grid.cell_at(middle.x() - kFits, middle.y() - kFits);
  const Cell hi = grid.cell_at(middle.x() + kFits, middle.y() + kFits);
  for (int j = lo.j; j <= hi.j; ++j) {
    for (int i = lo.i; i <= hi.i; ++i) {
      const Cell cell{i, j};
      if (!grid.contains(cell)) return false;
      if (grid.at(cell) == cost::kLethal && (grid.centre(cell) - middle).norm() <= kFits) return false;
    }
  }
  return true;
}

}  // namespace hidwa_local_planner
