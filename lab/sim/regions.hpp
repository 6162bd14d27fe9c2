// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sim/polygon.hpp"

namespace hidwa_local_planner {
namespace sim {

/// Part of the floor that a person would keep out of (people talking, a wet floor) and no sensor sees.
struct Region {
  std::string name;
  Polygon polygon;  // [m], map frame
};

/// What a regions file says.
struct RegionsFile {
  std::vector<Region> regions;
  std::optional<Pose> start;  // map frame
  std::optional<Pose> goal;   // map frame
};

/// Reads `regions: [{name: NAME, polygon: [[x, y], ...]}, ...]` and, where given, `start: [x, y, yaw]` and
/// `goal: [x, y, yaw]`. Throws std::runtime_error naming file, entry and fault.
RegionsFile load_regions(const std::string& yaml_path);

/// Counts the regions that the robot crosses: each at most once, when the footprint first touches it.
class RegionCounter {
 public:
  explicit RegionCounter(std::vector<Region> regions);

  /// `footprint` in the map frame. Returns whether a region was crossed that had not been before.
  bool update(const Polygon& footprint);

  int crossed() const { return crossed_count_; }
  bool crossed(std::size_t region) const { return crossed_[region]; }
  const std::vector<Region>& regions() const { return regions_; }

 private:
  std::vector<Region> regions_;
  std::vector<bool> crossed_;
  int crossed_count_ = 0;
};

}  // namespace sim
}  // namespace hidwa_local_planner
