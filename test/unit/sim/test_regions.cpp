// SPDX-License-Identifier: BSD-3-Clause
#include "sim/regions.hpp"

#include <string>

#include <gtest/gtest.h>

#include "temporary_file.hpp"

namespace hidwa_local_planner {
namespace sim {
namespace {

TEST(Regions, FileIsRead) {
  TemporaryFolder folder;
  const RegionsFile file = load_regions(folder.write("r.yaml",
                                                     "start: [1, 2, 0.5]\nregions:\n"
                                                     "  - {name: a, polygon: [[0, 0], [1, 0], [1, 1]]}\n"));
  ASSERT_EQ(file.regions.size(), 1u);
  EXPECT_EQ(file.regions[0].name, "a");
  EXPECT_EQ(file.regions[0].polygon.size(), 3u);
  ASSERT_TRUE(file.start);
  EXPECT_DOUBLE_EQ(file.start->theta, 0.5);
  EXPECT_FALSE(file.goal);
}

TEST(Regions, FaultsAreNamed) {
  TemporaryFolder folder;
  const auto fault = [&](const std::string& text) {
    return error_of([&] { load_regions(folder.write("r.yaml", text)); });
  };
  EXPECT_NE(fault("start: [1, 2, 0]\n").find("'regions'"), std::string::npos);
  EXPECT_NE(fault("regions: [{name: a, polygon: [[0, 0], [1, 0]]}]\n").find("regions[0]"), std::string::npos);
  EXPECT_NE(fault("regions: [{polygon: [[0, 0], [1, 0], [1, 1]]}]\n").find("regions[0].name"), std::string::npos);
  EXPECT_NE(fault("regions: []\ngoal: [1, 2]\n").find("goal"), std::string::npos);
  EXPECT_NE(fault("regions: []\ngoal: [1, 2, .nan]\n").find("'goal' has a value"), std::string::npos);
  EXPECT_NE(fault("regions: [{name: a, polygon: [[0, 0], [1, .inf], [1, 1]]}]\n").find("corner that is not a number"),
            std::string::npos);
}

TEST(RegionCounter, EachRegionCountsOnce) {
  RegionCounter counter({{"a", {{1, -1}, {2, -1}, {2, 1}, {1, 1}}}, {"b", {{4, -1}, {5, -1}, {5, 1}, {4, 1}}}});
  const Polygon disc = circle_polygon(0.3);
  int announced = 0;
  // There and back along the x axis: each region is met twice.
  for (int i = 0; i <= 1200; ++i) {
    const double x = i <= 600 ? 0.01 * i : 0.01 * (1200 - i);
    announced += counter.update(transformed(disc, {x, 0, 0})) ? 1 : 0;
    // The first is touched once x + 0.3 >= 1.
    EXPECT_EQ(counter.crossed(0), i >= 70) << i;
  }
  EXPECT_EQ(counter.crossed(), 2);
  EXPECT_EQ(announced, 2);
}

}  // namespace
}  // namespace sim
}  // namespace hidwa_local_planner
