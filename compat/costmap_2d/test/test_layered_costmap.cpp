// SPDX-License-Identifier: BSD-3-Clause
// Whole costmaps without ROS: a layer of scans as the obstacle layer makes them, and the inflation layer.
#include <costmap_2d/cost_values.h>
#include <costmap_2d/footprint.h>
#include <costmap_2d/inflation_layer.h>
#include <costmap_2d/layered_costmap.h>
#include <costmap_2d/scan_grid.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <random>

namespace costmap_2d {
namespace {

class ScanLayer : public Layer {
 public:
  Observation observation;

  void matchSize() override {
    const Costmap2D& master = *layered_costmap_->getCostmap();
    grid_.resizeMap(master.getSizeInCellsX(), master.getSizeInCellsY(), master.getResolution(), master.getOriginX(),
                    master.getOriginY());
  }
  void updateBounds(double, double, double, double* min_x, double* min_y, double* max_x, double* max_y) override {
    const Costmap2D& master = *layered_costmap_->getCostmap();
    grid_.updateOrigin(master.getOriginX(), master.getOriginY());
    const TouchedArea touched{min_x, min_y, max_x, max_y};
    clearBeams(grid_, observation, touched);
    markPoints(grid_, observation, 2.0, touched);
  }
  void updateCosts(Costmap2D& master, int min_i, int min_j, int max_i, int max_j) override {
    mergeMaximum(master, grid_, min_i, min_j, max_i, max_j);
  }
  void setCurrent(bool current) { current_ = current; }
  void setEnabled(bool enabled) { enabled_ = enabled; }
  const Costmap2D& grid() const { return grid_; }

 private:
  Costmap2D grid_;
};

// Takes its parameters from the test alone.
class PlainInflationLayer : public InflationLayer {
  void onInitialize() override {}
};

struct Scene {
  explicit Scene(bool rolling, unsigned int cells) : costmap("odom", rolling, false) {
    scans.reset(new ScanLayer);
    inflation.reset(new PlainInflationLayer);
    costmap.addPlugin(scans);
    costmap.addPlugin(inflation);
    scans->initialize(&costmap, "scans", nullptr);
    inflation->initialize(&costmap, "inflation", nullptr);
    costmap.resizeMap(cells, cells, 0.05, 0.0, 0.0);
    costmap.setFootprint(makeFootprintFromRadius(0.3));
    inflation->setInflationParameters(0.55, 10.0);
  }

  // A scan of `beams` ends round (x, y) at random distances.
  void look(std::mt19937& random, double x, double y, int beams) {
    std::uniform_real_distribution<double> range(0.3, 4.0);
    scans->observation = Observation();
    scans->observation.origin.x = x;
    scans->observation.origin.y = y;
    for (int i = 0; i < beams; ++i) {
      const double angle = 2.0 * M_PI * i / beams, r = range(random);
      geometry_msgs::Point end;
      end.x = x + r * std::cos(angle);
      end.y = y + r * std::sin(angle);
      scans->observation.points.push_back(end);
    }
  }

  LayeredCostmap costmap;
  boost::shared_ptr<ScanLayer> scans;
  boost::shared_ptr<InflationLayer> inflation;
};

// What one full rewrite would give: the scan layer's own grid, inflated as a whole.
Costmap2D rewritten(const Scene& scene) {
  Costmap2D whole = scene.scans->grid();
  Inflator inflator;
  Inflator::Settings settings;
  settings.inflation_radius = 0.55;
  settings.inscribed_radius = scene.costmap.getInscribedRadius();
  inflator.configure(settings);
  inflator.inflate(whole, 0, 0, static_cast<int>(whole.getSizeInCellsX()), static_cast<int>(whole.getSizeInCellsY()));
  return whole;
}

void expectEqual(const Costmap2D& got, const Costmap2D& expected, int step) {
  ASSERT_DOUBLE_EQ(got.getOriginX(), expected.getOriginX());
  ASSERT_DOUBLE_EQ(got.getOriginY(), expected.getOriginY());
  for (unsigned int i = 0; i < got.getSizeInCellsX() * got.getSizeInCellsY(); ++i) {
    ASSERT_EQ(got.getCharMap()[i], expected.getCharMap()[i])
        << "step " << step << " cell " << i % got.getSizeInCellsX() << ", " << i / got.getSizeInCellsX();
  }
}

TEST(LayeredCostmap, PartialUpdatesEqualAFullRewrite) {
  std::mt19937 random(21);
  Scene scene(false, 300);  // 15 m, scans of 3 m: most of the map is not touched
  for (int step = 0; step < 60; ++step) {
    const double x = 7.0 + 5.0 * std::cos(0.13 * step), y = 7.0 + 5.0 * std::sin(0.21 * step);
    scene.look(random, x, y, 90);
    scene.costmap.updateMap(x, y, 0.0);
    expectEqual(*scene.costmap.getCostmap(), rewritten(scene), step);
  }
}

TEST(LayeredCostmap, RollingWindowEqualsAFullRewrite) {
  std::mt19937 random(22);
  Scene scene(true, 80);
  for (int step = 0; step < 80; ++step) {
    const double x = 0.031 * step, y = -0.017 * step;
    scene.look(random, x, y, 90);
    scene.costmap.updateMap(x, y, 0.0);
    expectEqual(*scene.costmap.getCostmap(), rewritten(scene), step);
    // The robot stays within one cell of the middle.
    const Costmap2D& map = *scene.costmap.getCostmap();
    EXPECT_LT(std::abs(x - map.getOriginX() - 2.0), 0.1);
    EXPECT_LT(std::abs(y - map.getOriginY() - 2.0), 0.1);
  }
}

TEST(LayeredCostmap, CurrentWhenEveryEnabledLayerIs) {
  Scene scene(true, 20);
  EXPECT_TRUE(scene.costmap.isCurrent());
  scene.scans->setCurrent(false);
  EXPECT_FALSE(scene.costmap.isCurrent());
  scene.scans->setEnabled(false);
  EXPECT_TRUE(scene.costmap.isCurrent());
}

TEST(LayeredCostmap, InscribedRadiusReachesTheCosts) {
  Scene scene(false, 40);
  EXPECT_NEAR(scene.costmap.getInscribedRadius(), 0.3 * std::cos(M_PI / 16), 1e-12);
  EXPECT_EQ(scene.inflation->computeCost(0.29), INSCRIBED_INFLATED_OBSTACLE);
  scene.costmap.setFootprint(makeFootprintFromRadius(0.2));
  EXPECT_LT(scene.inflation->computeCost(0.29), INSCRIBED_INFLATED_OBSTACLE);
}

TEST(LayeredCostmap, AnUpdateOfAFourMetreWindowIsQuick) {
  std::mt19937 random(23);
  Scene scene(true, 80);
  std::vector<double> times;  // [ms]
  for (int step = 0; step < 300; ++step) {
    const double x = 0.025 * step;  // 0.5 m/s at 20 Hz
    scene.look(random, x, 0.0, 720);
    const std::clock_t begun = std::clock();  // of this process: other load does not count
    scene.costmap.updateMap(x, 0.0, 0.0);
    times.push_back(1e3 * double(std::clock() - begun) / CLOCKS_PER_SEC);
  }
  std::sort(times.begin(), times.end());
  std::printf("update of 80 x 80 cells, 720 beams: median %.3f ms, greatest %.3f ms\n", times[150], times.back());
  EXPECT_LT(times[150], 5.0);  // several times what it takes: only a change of order fails
}

}  // namespace
}  // namespace costmap_2d
