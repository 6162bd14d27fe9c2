// SPDX-License-Identifier: BSD-3-Clause
// Every element of the host's API that a local planner or a recovery uses, in one file that compiles against the
// navigation stack's own nav_core and costmap_2d and against compat's alike.
#include <costmap_2d/cost_values.h>
#include <costmap_2d/costmap_2d.h>
#include <costmap_2d/costmap_2d_ros.h>
#include <costmap_2d/costmap_layer.h>
#include <costmap_2d/footprint.h>
#include <costmap_2d/layered_costmap.h>
#include <costmap_2d/obstacle_layer.h>
#include <nav_core/base_global_planner.h>
#include <nav_core/base_local_planner.h>
#include <nav_core/recovery_behavior.h>

#include <boost/thread/locks.hpp>
#include <boost/thread/recursive_mutex.hpp>
#include <string>
#include <type_traits>
#include <vector>

namespace {

using costmap_2d::Costmap2D;
using costmap_2d::Costmap2DROS;
using costmap_2d::LayeredCostmap;
using nav_core::BaseLocalPlanner;
using Poses = std::vector<geometry_msgs::PoseStamped>;
using Points = std::vector<geometry_msgs::Point>;

// The interface: four pure functions and a virtual destructor.
static_assert(std::is_abstract<BaseLocalPlanner>::value, "");
static_assert(std::has_virtual_destructor<BaseLocalPlanner>::value, "");
static_assert(std::is_same<decltype(&BaseLocalPlanner::initialize),
                           void (BaseLocalPlanner::*)(std::string, tf2_ros::Buffer*, Costmap2DROS*)>::value,
              "");
static_assert(std::is_same<decltype(&BaseLocalPlanner::setPlan), bool (BaseLocalPlanner::*)(const Poses&)>::value, "");
static_assert(std::is_same<decltype(&BaseLocalPlanner::computeVelocityCommands),
                           bool (BaseLocalPlanner::*)(geometry_msgs::Twist&)>::value,
              "");
static_assert(std::is_same<decltype(&BaseLocalPlanner::isGoalReached), bool (BaseLocalPlanner::*)()>::value, "");
static_assert(std::has_virtual_destructor<nav_core::BaseGlobalPlanner>::value, "");
static_assert(std::has_virtual_destructor<nav_core::RecoveryBehavior>::value, "");

// The values of cells.
static_assert(costmap_2d::FREE_SPACE == 0, "");
static_assert(costmap_2d::INSCRIBED_INFLATED_OBSTACLE == 253, "");
static_assert(costmap_2d::LETHAL_OBSTACLE == 254, "");
static_assert(costmap_2d::NO_INFORMATION == 255, "");

// The mutex that move_base holds while it asks for a velocity.
static_assert(std::is_same<Costmap2D::mutex_t, boost::recursive_mutex>::value, "");
static_assert(std::is_same<decltype(std::declval<Costmap2D&>().getMutex()), Costmap2D::mutex_t*>::value, "");
static_assert(std::is_constructible<Costmap2DROS, const std::string&, tf2_ros::Buffer&>::value, "");

struct MapUse {
  double sum = 0.0;
  bool known = false;

  void read(const Costmap2D& map) {
    unsigned int mx = 0, my = 0;
    double wx = 0.0, wy = 0.0;
    int ix = 0, iy = 0;
    known = map.worldToMap(wx, wy, mx, my);
    map.worldToMapEnforceBounds(wx, wy, ix, iy);
    map.worldToMapNoBounds(wx, wy, ix, iy);
    map.mapToWorld(mx, my, wx, wy);
    map.indexToCells(map.getIndex(mx, my), mx, my);
    const unsigned char* cells = map.getCharMap();
    sum += map.getCost(mx, my) + cells[map.getIndex(mx, my)];
    sum += map.getSizeInCellsX() + map.getSizeInCellsY() + map.getSizeInMetersX() + map.getSizeInMetersY();
    sum += map.getResolution() + map.getOriginX() + map.getOriginY();
  }

  void write(Costmap2D& map, const Points& polygon) {
    map.setCost(0, 0, costmap_2d::LETHAL_OBSTACLE);
    map.setDefaultValue(costmap_2d::FREE_SPACE);
    map.updateOrigin(0.0, 0.0);
    map.resetMap(0, 0, map.getSizeInCellsX(), map.getSizeInCellsY());
    map.resizeMap(10, 10, 0.05, 0.0, 0.0);
    known = map.setConvexPolygonCost(polygon, map.getDefaultValue());
    std::vector<costmap_2d::MapLocation> corners(3), cells;
    map.polygonOutlineCells(corners, cells);
    map.convexFillCells(corners, cells);
    sum += map.cellDistance(1.0);
    known = map.copyCostmapWindow(Costmap2D(map), 0.0, 0.0, 0.1, 0.1);
    const Costmap2D other(10, 10, 0.05, 0.0, 0.0, costmap_2d::NO_INFORMATION);
    map = other;
  }
};

struct FootprintUse {
  Points points;
  double least = 0.0, greatest = 0.0;

  void use(ros::NodeHandle& nh) {
    points = costmap_2d::makeFootprintFromRadius(0.3);
    points = costmap_2d::makeFootprintFromParams(nh);
    if (!costmap_2d::makeFootprintFromString("[[1, 0], [0, 1], [-1, -1]]", points)) return;
    costmap_2d::padFootprint(points, 0.01);
    costmap_2d::transformFootprint(0.0, 0.0, 0.0, Points(points), points);
    costmap_2d::calculateMinAndMaxDistances(points, least, greatest);
    points = costmap_2d::toPointVector(costmap_2d::toPolygon(points));
    points.push_back(costmap_2d::toPoint(costmap_2d::toPoint32(points.front())));
  }
};

class UsingPlanner : public BaseLocalPlanner {
 public:
  void initialize(std::string name, tf2_ros::Buffer* tf, Costmap2DROS* costmap) override {
    tf_ = tf;
    costmap_ = costmap;
    ros::NodeHandle nh("~/" + name);
    footprint_.use(nh);
    frames_ = costmap->getName() + costmap->getGlobalFrameID() + costmap->getBaseFrameID();
  }

  bool setPlan(const Poses& plan) override { return !plan.empty(); }

  bool computeVelocityCommands(geometry_msgs::Twist& command) override {
    boost::unique_lock<Costmap2D::mutex_t> lock(*costmap_->getCostmap()->getMutex());
    geometry_msgs::PoseStamped pose;
    if (!costmap_->isCurrent() || !costmap_->getRobotPose(pose)) return false;
    map_.read(*costmap_->getCostmap());

    const Points& padded = costmap_->getRobotFootprint();
    const Points& unpadded = costmap_->getUnpaddedRobotFootprint();
    const geometry_msgs::Polygon polygon = costmap_->getRobotFootprintPolygon();
    Points oriented;
    costmap_->getOrientedFootprint(oriented);

    LayeredCostmap* layers = costmap_->getLayeredCostmap();
    const bool certain = layers->isCurrent() && layers->isInitialized() && !layers->isTrackingUnknown();
    const double radius = layers->getInscribedRadius() + layers->getCircumscribedRadius();
    command.linear.x = certain && layers->isRolling() ? radius : costmap_->getTransformTolerance();
    return layers->getFootprint().size() + padded.size() + unpadded.size() + polygon.points.size() > 0;
  }

  bool isGoalReached() override { return costmap_->isStopped(); }

  // What a host or a recovery behaviour does.
  void manage(const Points& points) {
    costmap_->pause();
    costmap_->resume();
    costmap_->stop();
    costmap_->start();
    costmap_->updateMap();
    costmap_->resetLayers();
    costmap_->setUnpaddedRobotFootprint(points);
    costmap_->setUnpaddedRobotFootprintPolygon(costmap_2d::toPolygon(points));
    map_.write(*costmap_->getCostmap(), points);
  }

 private:
  tf2_ros::Buffer* tf_ = nullptr;
  Costmap2DROS* costmap_ = nullptr;
  std::string frames_;
  MapUse map_;
  FootprintUse footprint_;
};

static_assert(!std::is_abstract<UsingPlanner>::value, "");

class UsingRecovery : public nav_core::RecoveryBehavior {
 public:
  void initialize(std::string name, tf2_ros::Buffer*, Costmap2DROS* global_costmap,
                  Costmap2DROS* local_costmap) override {
    name_ = name;
    costmaps_ = {global_costmap, local_costmap};
  }

  void runBehavior() override {
    for (Costmap2DROS* costmap : costmaps_) {
      for (const auto& layer : *costmap->getLayeredCostmap()->getPlugins()) {
        if (dynamic_cast<costmap_2d::ObstacleLayer*>(layer.get()) == nullptr) name_ += layer->getName();
        if (auto* grid = dynamic_cast<costmap_2d::CostmapLayer*>(layer.get())) clear(*grid);
      }
    }
  }

 private:
  static void clear(costmap_2d::CostmapLayer& layer) {
    int x = 0, y = 0;
    layer.worldToMapNoBounds(0.0, 0.0, x, y);
    layer.clearArea(x, y, x + 10, y + 10);
    layer.addExtraBounds(layer.getOriginX(), layer.getOriginY(), layer.getSizeInMetersX(), layer.getSizeInMetersY());
  }

  std::string name_;
  std::vector<Costmap2DROS*> costmaps_;
};

static_assert(!std::is_abstract<UsingRecovery>::value, "");

}  // namespace

// These emit the classes with all that they use.
nav_core::RecoveryBehavior* makeUsingRecovery() { return new UsingRecovery; }

BaseLocalPlanner* makeUsingPlanner(const Points& points, bool manage) {
  auto* planner = new UsingPlanner;
  if (manage) planner->manage(points);
  return planner;
}
