// SPDX-License-Identifier: BSD-3-Clause
#include "tracking/field_of_view.hpp"

#include <algorithm>
#include <cmath>

namespace hidwa_local_planner {
namespace tracking {
namespace {

constexpr double kNarrow = M_PI / 18.0;  // of a gap between beams that see: 10 degrees [rad]

}  // namespace

void FieldOfView::add(const RangeScan& scan, const Beams& beams) {
  const std::size_t n = beams.all.size();
  range_ = scan.range_max;
  if (answered_.size() != n || first_ != scan.angle_min || increment_ != scan.angle_increment) {
    answered_.assign(n, 0);
    first_ = scan.angle_min;
    increment_ = scan.angle_increment;
    whole_turn_ = beams.whole_turn;
  }
  for (std::size_t i = 0; i < n; ++i) {
    if (beams.all[i].length > 0.0) answered_[i] = 1;
  }
}

SensorSectors FieldOfView::sectors(double reach) const {
  const double range = std::min(reach, range_);
  struct Run {
    std::size_t first, count;  // index of the first beam, and the number of beams
  };
  const std::size_t n = answered_.size();
  const double step = std::abs(increment_);
  std::vector<Run> runs;
  for (std::size_t i = 0; i < n; ++i) {
    if (answered_[i] == 0) continue;
    const std::size_t end = runs.empty() ? 0 : runs.back().first + runs.back().count;
    if (!runs.empty() && static_cast<double>(i - end) * step < kNarrow) {
      runs.back().count = i + 1 - runs.back().first;
    } else {
      runs.push_back({i, 1});
    }
  }
  if (runs.empty()) return {};
  // Beams between the last run and the first one.
  const std::size_t gap = n - (runs.back().first + runs.back().count) + runs.front().first;
  if (whole_turn_ && static_cast<double>(gap) * step < kNarrow) {
    if (runs.size() == 1) return {{{}, 2.0 * M_PI, range}};
    runs.front() = {runs.back().first, runs.back().count + gap + runs.front().count};
    runs.pop_back();
  }
  SensorSectors sectors;
  for (const Run& run : runs) {
    const double middle = static_cast<double>(run.first) + 0.5 * static_cast<double>(run.count - 1);
    sectors.push_back(
        {{0.0, 0.0, wrap_angle(first_ + middle * increment_)}, static_cast<double>(run.count) * step, range});
  }
  return sectors;
}

}  // namespace tracking
}  // namespace hidwa_local_planner
