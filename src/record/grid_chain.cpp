// SPDX-License-Identifier: BSD-3-Clause
#include "record/grid_chain.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

#include <zlib.h>

namespace hidwa_local_planner {
namespace record {
namespace {

// A costmap of 4000 x 4000 cells; what says it is larger is damaged.
constexpr std::size_t kMostCells = 16000000;

bool plausible(const GridPatch& patch) {
  return patch.size_x > 0 && patch.size_y > 0 && patch.resolution > 0.0 && std::isfinite(patch.origin_x) &&
         std::isfinite(patch.origin_y) &&
         static_cast<std::size_t>(patch.size_x) <= kMostCells / static_cast<std::size_t>(patch.size_y);
}

// By so many cells one origin lies beyond another; false where that is no whole number, or far.
bool whole_cells(double from, double to, double resolution, int& cells) {
  const double exact = (to - from) / resolution;
  if (!(std::abs(exact) < 1e6)) return false;
  cells = static_cast<int>(std::lround(exact));
  return std::abs(exact - cells) < 1e-3;
}

}  // namespace

// The grid before, seen from the new origin; zeros where it had no cells.
void GridChain::predict(const GridPatch& patch) {
  const int width = patch.size_x, height = patch.size_y;
  predicted_.assign(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), 0);
  int right = 0, up = 0;
  if (patch.whole || present_.costs.empty() || present_.resolution != patch.resolution ||
      !whole_cells(present_.origin_x, patch.origin_x, patch.resolution, right) ||
      !whole_cells(present_.origin_y, patch.origin_y, patch.resolution, up)) {
    return;
  }
  const int first = std::max(0, -right), last = std::min(width, present_.size_x - right);
  if (last <= first) return;
  for (int j = std::max(0, -up); j < std::min(height, present_.size_y - up); ++j) {
    const auto from = static_cast<std::size_t>(j + up) * static_cast<std::size_t>(present_.size_x) +
                      static_cast<std::size_t>(first + right);
    const auto to = static_cast<std::size_t>(j) * static_cast<std::size_t>(width) + static_cast<std::size_t>(first);
    std::memcpy(predicted_.data() + to, present_.costs.data() + from, static_cast<std::size_t>(last - first));
  }
}

const GridPatch& GridChain::advance_to(const GridView& grid, bool whole) {
  patch_.size_x = grid.size_x;
  patch_.size_y = grid.size_y;
  patch_.resolution = grid.resolution;
  patch_.origin_x = grid.origin_x;
  patch_.origin_y = grid.origin_y;
  patch_.whole = whole;
  patch_.changes.clear();
  if (!grid.valid()) {
    clear();
    return patch_;
  }
  predict(patch_);
  const std::size_t n = grid.cell_count();
  if (std::memcmp(predicted_.data(), grid.costs, n) != 0) {
    difference_.resize(n);
    for (std::size_t i = 0; i < n; ++i) difference_[i] = static_cast<std::uint8_t>(grid.costs[i] - predicted_[i]);
    uLongf size = compressBound(static_cast<uLong>(n));
    patch_.changes.resize(size);
    compress2(patch_.changes.data(), &size, difference_.data(), static_cast<uLong>(n), Z_BEST_SPEED);
    patch_.changes.resize(size);
  }
  present_ = {grid.size_x, grid.size_y, grid.resolution, grid.origin_x, grid.origin_y, std::move(present_.costs)};
  present_.costs.assign(grid.costs, grid.costs + n);
  return patch_;
}

bool GridChain::advance_by(const GridPatch& patch) {
  const bool empty = patch.size_x == 0 || patch.size_y == 0;
  if (empty || !plausible(patch) || (!patch.whole && present_.costs.empty())) {
    clear();
    return empty;
  }
  predict(patch);
  if (!patch.changes.empty()) {
    difference_.resize(predicted_.size());
    uLongf size = static_cast<uLong>(difference_.size());
    const int status =
        uncompress(difference_.data(), &size, patch.changes.data(), static_cast<uLong>(patch.changes.size()));
    if (status != Z_OK || size != difference_.size()) {
      clear();
      return false;
    }
    for (std::size_t i = 0; i < size; ++i) predicted_[i] = static_cast<std::uint8_t>(predicted_[i] + difference_[i]);
  }
  present_ = {patch.size_x, patch.size_y, patch.resolution, patch.origin_x, patch.origin_y, std::move(present_.costs)};
  present_.costs.swap(predicted_);
  return true;
}

}  // namespace record
}  // namespace hidwa_local_planner
