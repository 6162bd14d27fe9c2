// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "hidwa_local_planner/core/tile.hpp"

namespace hidwa_local_planner::critics {

/// Candidates of a tile that are measured, ascending: the first and the last one, and some between them, whose speeds
/// are about 0.1 m/s apart; all where the speeds are in no order. The others are interpolated.
class SpeedKnots {
 public:
  /// Reserves memory for `count` candidates.
  void reserve(std::size_t count) { knots_.reserve(count); }

  void choose(const Tile& tile) {
    knots_.clear();
    const bool ascending = std::is_sorted(tile.v, tile.v + tile.count);
    for (std::size_t c = 0; c < tile.count; ++c) {
      const bool end = c == 0 || c + 1 == tile.count;
      if (end || !ascending || tile.v[c + 1] - tile.v[knots_.back()] > kSpeedsApart) knots_.push_back(c);
    }
  }
  std::size_t size() const { return knots_.size(); }
  /// The candidate.
  std::size_t operator[](std::size_t i) const { return knots_[i]; }

  /// From what was found at the knots [size()] to all candidates of the tile [count].
  void interpolate(const Tile& tile, const std::vector<double>& found, double* all) const {
    all[0] = found[0];
    for (std::size_t i = 1; i < knots_.size(); ++i) {
      const double from = tile.v[knots_[i - 1]], span = tile.v[knots_[i]] - from;
      const double slope = span > 0.0 ? (found[i] - found[i - 1]) / span : 0.0;
      for (std::size_t c = knots_[i - 1] + 1; c < knots_[i]; ++c) all[c] = found[i - 1] + slope * (tile.v[c] - from);
      all[knots_[i]] = found[i];
    }
  }

 private:
  static constexpr double kSpeedsApart = 0.1;  // [m/s]
  std::vector<std::size_t> knots_;
};

}  // namespace hidwa_local_planner::critics
