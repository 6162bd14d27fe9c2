// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "hidwa_local_planner/core/grid_view.hpp"
#include "hidwa_local_planner/core/util/archive.hpp"

namespace hidwa_local_planner {
namespace record {

/// A costmap with costs of its own.
struct StoredGrid {
  int size_x = 0;           // [cells]
  int size_y = 0;           // [cells]
  double resolution = 0.0;  // [m]
  double origin_x = 0.0;    // [m], costmap frame
  double origin_y = 0.0;    // [m]
  Bytes costs;              // row-major, row 0 at the origin

  GridView view() const { return {costs.data(), size_x, size_y, resolution, origin_x, origin_y}; }
};

/// What a costmap differs in from the one before it.
struct GridPatch {
  std::int32_t size_x = 0;  // [cells]
  std::int32_t size_y = 0;  // [cells]
  double resolution = 0.0;  // [m]
  double origin_x = 0.0;    // [m]
  double origin_y = 0.0;    // [m]
  bool whole = false;       // against nothing, not against the one before
  Bytes changes;            // deflated (zlib); empty where no cell changed

  template <typename Self, typename Archive>
  static void archive(Self& self, Archive& io) {
    io(self.size_x, self.size_y, self.resolution, self.origin_x, self.origin_y, self.whole, self.changes);
  }
};

/// Costmaps that follow one another, each as a patch on the one before: a local costmap that rolled by whole cells is
/// compared where the two overlap. Recorder and reader each keep one of these.
class GridChain {
 public:
  /// The patch that leads to `grid`, which becomes the present one. `whole`: a patch that needs no other. The patch
  /// stays valid until the next call.
  const GridPatch& advance_to(const GridView& grid, bool whole);
  /// Applies a patch. False, and the present grid is empty, where it does not fit or is damaged.
  bool advance_by(const GridPatch& patch);
  const StoredGrid& present() const { return present_; }
  void clear() { present_ = StoredGrid(); }

 private:
  void predict(const GridPatch& patch);

  StoredGrid present_;
  GridPatch patch_;
  Bytes predicted_, difference_;
};

}  // namespace record
}  // namespace hidwa_local_planner
