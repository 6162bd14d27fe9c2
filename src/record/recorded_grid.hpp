// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "hidwa_local_planner/core/grid_view.hpp"
#include "hidwa_local_planner/core/util/archive.hpp"

namespace hidwa_local_planner {
namespace record {

/// Where the cells of a costmap lie.
struct GridPlace {
  std::int32_t size_x = 0;  // [cells]
  std::int32_t size_y = 0;  // [cells]
  double resolution = 0.0;  // [m]
  double origin_x = 0.0;    // [m], costmap frame
  double origin_y = 0.0;    // [m]
};

/// A costmap with costs of its own.
struct StoredGrid : GridPlace {
  Bytes costs;  // row-major, row 0 at the origin

  GridView view() const { return {costs.data(), size_x, size_y, resolution, origin_x, origin_y}; }
};

/// A costmap as a record holds it; without cells where there was no valid one.
struct RecordedGrid : GridPlace {
  Bytes deflated;  // costs, by zlib

  template <typename Self, typename Archive>
  static void archive(Self& self, Archive& io) {
    io(self.size_x, self.size_y, self.resolution, self.origin_x, self.origin_y, self.deflated);
  }
};

RecordedGrid packed(const GridView& grid);
/// False, and `grid` is empty, where `recorded` is damaged.
bool unpack(const RecordedGrid& recorded, StoredGrid& grid);

}  // namespace record
}  // namespace hidwa_local_planner
