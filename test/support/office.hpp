// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>

#include "drive/outline.hpp"
#include "drive/setup.hpp"

namespace hidwa_local_planner::test {

/// The demo's drive, in the default profile, with nobody on board. The base has this latency [s].
inline drive::DriveSetup office(double latency = 0.05) {
  const std::string folder = HIDWA_MAPS;
  drive::DriveSetup setup;
  setup.ground =
      std::make_shared<drive::Ground>(std::make_shared<sim::OccupancyMap>(sim::load_map(folder + "/office.yaml")));
  const sim::RegionsFile regions = sim::load_regions(folder + "/office_regions.yaml");
  setup.regions = regions.regions;
  setup.start = *regions.start;
  setup.goal = *regions.goal;
  setup.footprint = drive::telepresence_footprint();
  setup.outline = drive::circle_outline(0.30, 0.01);
  setup.limits.latency = latency;
  setup.laser.noise = 0.01;
  return setup;
}

}  // namespace hidwa_local_planner::test
