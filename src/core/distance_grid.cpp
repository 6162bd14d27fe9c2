// SPDX-License-Identifier: BSD-3-Clause
#include "hidwa_local_planner/core/distance_grid.hpp"

#include <algorithm>

namespace hidwa_local_planner {
namespace {

constexpr std::int32_t kStraight = 5;
constexpr std::int32_t kDiagonal = 7;

bool blocks(std::uint8_t value) { return value == cost::kLethal || value == cost::kInscribed; }

struct Step {
  std::ptrdiff_t offset;
  std::int32_t units;
};

std::array<Step, 8> steps(std::size_t stride) {
  const auto row = static_cast<std::ptrdiff_t>(stride);
  return {{{1, kStraight},
           {-1, kStraight},
           {row, kStraight},
           {-row, kStraight},
           {row + 1, kDiagonal},
           {row - 1, kDiagonal},
           {-row + 1, kDiagonal},
           {-row - 1, kDiagonal}}};
}

}  // namespace

void DistanceGrid::reset(const GridView& grid) {
  size_x_ = grid.size_x;
  size_y_ = grid.size_y;
  stride_ = static_cast<std::size_t>(size_x_) + 2;
  units_.assign(stride_ * (static_cast<std::size_t>(size_y_) + 2), kFar);
}

void DistanceGrid::make_l1(const GridView& grid, const std::vector<Cell>& sources) {
  reset(grid);
  metres_per_unit_ = grid.resolution;
  for (const Cell cell : sources) units_[index(cell)] = 0;
  // Two sweeps are exact for Manhattan distance.
  for (int j = 0; j < size_y_; ++j) {
    std::int32_t* row = &units_[index({0, j})];
    for (std::ptrdiff_t i = 0; i < size_x_; ++i) {
      row[i] = std::min(row[i], std::min(row[i - 1], row[i - static_cast<std::ptrdiff_t>(stride_)]) + 1);
    }
  }
  for (int j = size_y_ - 1; j >= 0; --j) {
    std::int32_t* row = &units_[index({0, j})];
    for (std::ptrdiff_t i = size_x_ - 1; i >= 0; --i) {
      row[i] = std::min(row[i], std::min(row[i + 1], row[i + static_cast<std::ptrdiff_t>(stride_)]) + 1);
    }
  }
}

void DistanceGrid::push(std::size_t index, std::int32_t units) {
  units_[index] = units;
  buckets_[static_cast<std::size_t>(units) % buckets_.size()].push_back(static_cast<std::uint32_t>(index));
  ++queued_;
}

// Dial's algorithm: cells leave the buckets in the order of their distance. Those of the rim join at theirs.
void DistanceGrid::flood(Kind into) {
  const std::array<Step, 8> neighbours = steps(stride_);
  std::size_t rim_next = 0;
  for (std::int32_t distance = 0; queued_ > 0 || rim_next < rim_.size(); ++distance) {
    if (queued_ == 0) distance = std::max(distance, rim_[rim_next].units);
    for (; rim_next < rim_.size() && rim_[rim_next].units == distance; ++rim_next) {
      if (units_[rim_[rim_next].index] > distance) push(rim_[rim_next].index, distance);
    }
    std::vector<std::uint32_t>& bucket = buckets_[static_cast<std::size_t>(distance) % buckets_.size()];
    queued_ -= bucket.size();
    for (const std::uint32_t from : bucket) {
      if (units_[from] != distance) continue;  // a shorter way was found since
      for (const Step& step : neighbours) {
        const auto to = static_cast<std::size_t>(static_cast<std::ptrdiff_t>(from) + step.offset);
        if (kinds_[to] == into && units_[to] > distance + step.units) push(to, distance + step.units);
      }
    }
    bucket.clear();
  }
}

// The blocked cells beside reached ones, which are free or blocked sources, nearest first.
void DistanceGrid::collect_rim() {
  const std::array<Step, 8> neighbours = steps(stride_);
  for (int j = 0; j < size_y_; ++j) {
    for (int i = 0; i < size_x_; ++i) {
      const std::size_t at = index({i, j});
      if (kinds_[at] != Kind::blocked || units_[at] < kFar) continue;
      std::int32_t best = kFar;
      for (const Step& step : neighbours) {
        const auto from = static_cast<std::size_t>(static_cast<std::ptrdiff_t>(at) + step.offset);
        best = std::min(best, units_[from] + step.units);
      }
      if (best < kFar) rim_.push_back({best, static_cast<std::uint32_t>(at)});
    }
  }
  std::sort(rim_.begin(), rim_.end(), [](const Rim& a, const Rim& b) {
    return a.units != b.units ? a.units < b.units : a.index < b.index;
  });
}

void DistanceGrid::make_geodesic(const GridView& grid, const std::vector<Cell>& sources) {
  reset(grid);
  metres_per_unit_ = grid.resolution / kStraight;
  kinds_.assign(units_.size(), Kind::border);
  for (int j = 0; j < size_y_; ++j) {
    for (int i = 0; i < size_x_; ++i) kinds_[index({i, j})] = blocks(grid.at({i, j})) ? Kind::blocked : Kind::free;
  }
  for (std::vector<std::uint32_t>& bucket : buckets_) bucket.clear();
  queued_ = 0;
  rim_.clear();
  for (const Cell cell : sources) push(index(cell), 0);
  flood(Kind::free);
  collect_rim();
  flood(Kind::blocked);
}

}  // namespace hidwa_local_planner
