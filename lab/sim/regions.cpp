// SPDX-License-Identifier: BSD-3-Clause
#include "sim/regions.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "yaml_file.hpp"

namespace hidwa_local_planner {
namespace sim {
namespace {

bool all_finite(const std::vector<double>& values) {
  return std::all_of(values.begin(), values.end(), [](double value) { return std::isfinite(value); });
}

std::optional<Pose> read_pose(const YamlFile& file, const std::string& key) {
  const YAML::Node node = file.root()[key];
  if (!node) return std::nullopt;
  const auto values = file.as<std::vector<double>>(node, key);
  if (values.size() != 3) file.fail("'" + key + "' must be [x, y, yaw]");
  if (!all_finite(values)) file.fail("'" + key + "' has a value that is not a number");
  return Pose{values[0], values[1], values[2]};
}

Region read_region(const YamlFile& file, const YAML::Node& node, const std::string& entry) {
  if (!node.IsMap()) file.fail(entry + " must be {name: NAME, polygon: [[x, y], ...]}");
  Region region;
  region.name = file.as<std::string>(node["name"], entry + ".name");
  const auto corners = file.as<std::vector<std::vector<double>>>(node["polygon"], entry + ".polygon");
  for (const std::vector<double>& corner : corners) {
    if (corner.size() != 2) file.fail("'" + entry + ".polygon': each corner must be [x, y]");
    if (!all_finite(corner)) file.fail("'" + entry + ".polygon' has a corner that is not a number");
    region.polygon.emplace_back(corner[0], corner[1]);
  }
  if (region.polygon.size() < 3) file.fail("'" + entry + ".polygon' needs three corners or more");
  return region;
}

}  // namespace

RegionsFile load_regions(const std::string& yaml_path) {
  const YamlFile file(yaml_path);
  if (!file.root().IsMap()) file.fail("must hold 'regions', and may hold 'start' and 'goal'");
  RegionsFile result;
  const YAML::Node regions = file.root()["regions"];
  if (!regions || !regions.IsSequence()) file.fail("'regions' must be a list");
  for (std::size_t i = 0; i < regions.size(); ++i) {
    result.regions.push_back(read_region(file, regions[i], "regions[" + std::to_string(i) + "]"));
  }
  result.start = read_pose(file, "start");
  result.goal = read_pose(file, "goal");
  return result;
}

RegionCounter::RegionCounter(std::vector<Region> regions)
    : regions_(std::move(regions)), crossed_(regions_.size(), false) {}

bool RegionCounter::update(const Polygon& footprint) {
  bool more = false;
  for (std::size_t i = 0; i < regions_.size(); ++i) {
    if (crossed_[i] || !touch(footprint, regions_[i].polygon)) continue;
    crossed_[i] = true;
    ++crossed_count_;
    more = true;
  }
  return more;
}

}  // namespace sim
}  // namespace hidwa_local_planner
