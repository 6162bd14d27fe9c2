// SPDX-License-Identifier: BSD-3-Clause
#include "benchmark/office_drive.hpp"

#include <memory>
#include <string>

#include "drive/outline.hpp"

namespace hidwa_local_planner::test {

drive::DriveSetup office_drive() {
  const std::string folder = HIDWA_MAPS;
  drive::DriveSetup setup;
  setup.ground =
      std::make_shared<drive::Ground>(std::make_shared<sim::OccupancyMap>(sim::load_map(folder + "/office.yaml")));
  const sim::RegionsFile file = sim::load_regions(folder + "/office_regions.yaml");
  setup.regions = file.regions;
  setup.start = file.start.value();
  setup.goal = file.goal.value();
  setup.footprint = drive::telepresence_footprint();
  setup.outline = drive::circle_outline(0.30, 0.01);
  setup.laser.noise = 0.01;
  return setup;
}

}  // namespace hidwa_local_planner::test
