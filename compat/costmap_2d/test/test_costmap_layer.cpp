// SPDX-License-Identifier: BSD-3-Clause
#include <costmap_2d/cost_values.h>
#include <costmap_2d/costmap_layer.h>
#include <costmap_2d/layered_costmap.h>
#include <gtest/gtest.h>

namespace costmap_2d {
namespace {

/// A layer that keeps what it is told, and tells what an update is to cover.
class KeptLayer : public CostmapLayer {
 public:
  void updateBounds(double, double, double, double* min_x, double* min_y, double* max_x, double* max_y) override {
    useExtraBounds(min_x, min_y, max_x, max_y);
  }
};

class CostmapLayerTest : public testing::Test {
 protected:
  CostmapLayerTest() {
    layer_.initialize(&costmap_, "kept", nullptr);
    costmap_.addPlugin(boost::shared_ptr<Layer>(&layer_, [](Layer*) {}));
    costmap_.resizeMap(10, 8, 0.5, 1.0, 2.0);
    for (unsigned int y = 0; y < 8; ++y) {
      for (unsigned int x = 0; x < 10; ++x) layer_.setCost(x, y, LETHAL_OBSTACLE);
    }
  }
  int marked() const {
    int count = 0;
    for (unsigned int y = 0; y < 8; ++y) {
      for (unsigned int x = 0; x < 10; ++x) count += layer_.getCost(x, y) == LETHAL_OBSTACLE;
    }
    return count;
  }

  LayeredCostmap costmap_{"odom", false, false};
  KeptLayer layer_;
};

TEST_F(CostmapLayerTest, IsAsLargeAsTheMasterGrid) {
  EXPECT_EQ(layer_.getSizeInCellsX(), 10u);
  EXPECT_EQ(layer_.getSizeInCellsY(), 8u);
  EXPECT_EQ(layer_.getOriginX(), 1.0);
}

TEST_F(CostmapLayerTest, ForgetsWhatLiesOutsideTheArea) {
  layer_.clearArea(2, 1, 6, 4);  // cells 3, 4, 5 times 2, 3 stay
  EXPECT_EQ(marked(), 6);
  EXPECT_EQ(layer_.getCost(3, 2), LETHAL_OBSTACLE);
  EXPECT_EQ(layer_.getCost(2, 2), NO_INFORMATION);
  EXPECT_EQ(layer_.getCost(6, 3), NO_INFORMATION);
}

TEST_F(CostmapLayerTest, OrInsideIt) {
  layer_.clearArea(2, 1, 6, 4, true);
  EXPECT_EQ(marked(), 80 - 6);
}

TEST_F(CostmapLayerTest, AnAreaBeyondTheGridIsNoFault) {
  layer_.clearArea(-5, -5, 100, 100);
  EXPECT_EQ(marked(), 80);
}

TEST_F(CostmapLayerTest, ExtraBoundsWidenOneUpdate) {
  layer_.addExtraBounds(2.0, 3.0, 3.0, 3.5);
  layer_.addExtraBounds(2.5, 2.5, 4.0, 3.0);
  double x0 = 3.9, y0 = 4.0, x1 = 3.95, y1 = 4.5;
  layer_.updateBounds(0.0, 0.0, 0.0, &x0, &y0, &x1, &y1);
  EXPECT_EQ(x0, 2.0);
  EXPECT_EQ(y0, 2.5);
  EXPECT_EQ(x1, 4.0);
  EXPECT_EQ(y1, 4.5);
  double again = 3.9;
  layer_.updateBounds(0.0, 0.0, 0.0, &again, &y0, &x1, &y1);
  EXPECT_EQ(again, 3.9);
}

}  // namespace
}  // namespace costmap_2d
