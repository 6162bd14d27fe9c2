// SPDX-License-Identifier: BSD-3-Clause
#include <costmap_2d/cost_values.h>
#include <costmap_2d/costmap_2d_publisher.h>
#include <costmap_2d/layer_list.h>
#include <costmap_2d/static_layer.h>
#include <gtest/gtest.h>

#include <stdexcept>

namespace costmap_2d {
namespace {

TEST(StaticMapValues, Trinary) {
  const StaticMapValues values;
  EXPECT_EQ(values.cost(-1), NO_INFORMATION);
  EXPECT_EQ(values.cost(0), FREE_SPACE);
  EXPECT_EQ(values.cost(99), FREE_SPACE);
  EXPECT_EQ(values.cost(100), LETHAL_OBSTACLE);
}

TEST(StaticMapValues, ScaledAndUntracked) {
  StaticMapValues values;
  values.trinary = false;
  values.track_unknown_space = false;
  EXPECT_EQ(values.cost(-1), FREE_SPACE);
  EXPECT_EQ(values.cost(50), 127);  // 50 / 100 x 254
}

TEST(Publisher, Occupancy) {
  EXPECT_EQ(Costmap2DPublisher::occupancy(FREE_SPACE), 0);
  EXPECT_EQ(Costmap2DPublisher::occupancy(1), 1);
  EXPECT_EQ(Costmap2DPublisher::occupancy(252), 98);  // 1 + 97 x 251 / 251
  EXPECT_EQ(Costmap2DPublisher::occupancy(INSCRIBED_INFLATED_OBSTACLE), 99);
  EXPECT_EQ(Costmap2DPublisher::occupancy(LETHAL_OBSTACLE), 100);
  EXPECT_EQ(Costmap2DPublisher::occupancy(NO_INFORMATION), -1);
}

TEST(LayerList, AnUnknownTypeIsNamedWithWhatThereIs) {
  EXPECT_NO_THROW(makeLayer({"walls", "costmap_2d::StaticLayer"}));
  try {
    makeLayer({"boxes", "costmap_2d::VoxelLayer"});
    FAIL() << "no error";
  } catch (const std::runtime_error& fault) {
    const std::string text = fault.what();
    EXPECT_NE(text.find("boxes"), std::string::npos);
    EXPECT_NE(text.find("costmap_2d::VoxelLayer"), std::string::npos);
    EXPECT_NE(text.find("costmap_2d::ObstacleLayer"), std::string::npos);
  }
}

}  // namespace
}  // namespace costmap_2d
