// SPDX-License-Identifier: BSD-3-Clause
#include "floor.hpp"

#include "files.hpp"

namespace hidwa_local_planner {
namespace study {

Options with_floor(Options options) {
  if (options.regions.empty()) {
    options.regions = options.map.empty() ? share_file("maps/office_regions.yaml") : "none";
  }
  if (options.map.empty()) options.map = share_file("maps/office.yaml");
  return options;
}

Scene scene_of(const Options& options) { return load_scene(options.map, options.regions, options.start, options.goal); }

nlohmann::json json_of(const sim::Pose& pose) { return {pose.x, pose.y, pose.theta}; }

nlohmann::json json_of_floor(const Options& options, const Scene& scene) {
  return {{"map", fingerprint_of_file(options.map)}, {"start", json_of(scene.start)}, {"goal", json_of(scene.goal)}};
}

}  // namespace study
}  // namespace hidwa_local_planner
