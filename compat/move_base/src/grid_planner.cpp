// SPDX-License-Identifier: BSD-3-Clause
#include <move_base/grid_planner.h>
#include <nav_msgs/Path.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace move_base {
namespace {

// World [m] to grid coordinates [cells] and back; a cell's centre has whole coordinates.
struct GridFrame {
  explicit GridFrame(const costmap_2d::Costmap2D& map)
      : origin_x(map.getOriginX()), origin_y(map.getOriginY()), resolution(map.getResolution()) {}
  GridPoint toGrid(const geometry_msgs::Point& point) const {
    return {(point.x - origin_x) / resolution - 0.5, (point.y - origin_y) / resolution - 0.5};
  }
  geometry_msgs::Point toWorld(const GridPoint& point) const {
    geometry_msgs::Point world;
    world.x = origin_x + (point.x + 0.5) * resolution;
    world.y = origin_y + (point.y + 0.5) * resolution;
    return world;
  }
  double origin_x, origin_y, resolution;
};

}  // namespace

std::vector<geometry_msgs::PoseStamped> posesAlong(const std::vector<geometry_msgs::Point>& points,
                                                   const geometry_msgs::PoseStamped& goal) {
  std::vector<geometry_msgs::PoseStamped> poses(points.size(), goal);
  const std::size_t last = points.empty() ? 0 : points.size() - 1;
  constexpr std::size_t kReach = 2;  // points on each side that give a heading
  for (std::size_t i = 0; i < points.size(); ++i) {
    poses[i].pose.position.x = points[i].x;
    poses[i].pose.position.y = points[i].y;
    poses[i].pose.position.z = 0.0;
    const geometry_msgs::Point& behind = points[i - std::min(i, kReach)];
    const geometry_msgs::Point& ahead = points[std::min(last, i + kReach)];
    if (i == last || (behind.x == ahead.x && behind.y == ahead.y)) continue;  // keeps the goal's orientation
    const double yaw = std::atan2(ahead.y - behind.y, ahead.x - behind.x);
    poses[i].pose.orientation.x = poses[i].pose.orientation.y = 0.0;
    poses[i].pose.orientation.z = std::sin(0.5 * yaw);
    poses[i].pose.orientation.w = std::cos(0.5 * yaw);
  }
  return poses;
}

void GridPlanner::initialize(std::string name, costmap_2d::Costmap2DROS* costmap_ros) {
  costmap_ros_ = costmap_ros;
  ros::NodeHandle nh("~/" + name);
  allow_unknown_ = nh.param("allow_unknown", true);
  default_tolerance_ = nh.param("default_tolerance", 0.0);
  publisher_ = nh.advertise<nav_msgs::Path>("plan", 1);
}

bool GridPlanner::inCostmapFrame(const geometry_msgs::PoseStamped& pose, const char* what) const {
  if (pose.header.frame_id == costmap_ros_->getGlobalFrameID()) return true;
  ROS_ERROR("The %s is in frame \"%s\"; it must be in the global costmap's frame \"%s\".", what,
            pose.header.frame_id.c_str(), costmap_ros_->getGlobalFrameID().c_str());
  return false;
}

bool GridPlanner::makePlan(const geometry_msgs::PoseStamped& start, const geometry_msgs::PoseStamped& goal,
                           std::vector<geometry_msgs::PoseStamped>& plan) {
  return makePlan(start, goal, default_tolerance_, plan);
}

bool GridPlanner::makePlan(const geometry_msgs::PoseStamped& start, const geometry_msgs::PoseStamped& goal,
                           double tolerance, std::vector<geometry_msgs::PoseStamped>& plan) {
  plan.clear();
  if (!inCostmapFrame(start, "start") || !inCostmapFrame(goal, "goal")) return false;
  const costmap_2d::Costmap2D& map = *costmap_ros_->getCostmap();
  unsigned int start_x, start_y, goal_x, goal_y;
  if (!map.worldToMap(start.pose.position.x, start.pose.position.y, start_x, start_y)) {
    ROS_WARN("The robot at (%.2f, %.2f) is outside the global costmap.", start.pose.position.x, start.pose.position.y);
    return false;
  }
  if (!map.worldToMap(goal.pose.position.x, goal.pose.position.y, goal_x, goal_y)) {
    ROS_WARN_THROTTLE(1.0, "The goal (%.2f, %.2f) is outside the global costmap.", goal.pose.position.x,
                      goal.pose.position.y);
    return false;
  }
  route_.setCosts(map.getCharMap(), static_cast<int>(map.getSizeInCellsX()), static_cast<int>(map.getSizeInCellsY()),
                  allow_unknown_);
  route_.open(static_cast<int>(start_x), static_cast<int>(start_y));

  const GridFrame frame(map);
  GridPoint end = frame.toGrid(goal.pose.position);
  const bool goal_open = route_.isOpen(static_cast<int>(goal_x), static_cast<int>(goal_y));
  bool reached = (goal_open || tolerance > 0.0) && route_.propagate(frame.toGrid(start.pose.position), end);
  if (!reached && tolerance > 0.0) {
    if (const auto nearest = route_.nearestReached(end, tolerance / map.getResolution())) {
      end = *nearest;
      reached = true;
    }
  }
  if (!reached) {
    ROS_WARN_THROTTLE(1.0, "No plan: the goal (%.2f, %.2f) %s.", goal.pose.position.x, goal.pose.position.y,
                      goal_open ? "cannot be reached" : "lies in an obstacle, or nearer to one than the robot fits");
    publish(plan);
    return false;
  }
  std::vector<geometry_msgs::Point> points;
  for (const GridPoint& point : route_.trace(end)) points.push_back(frame.toWorld(point));
  plan = posesAlong(points, goal);
  for (geometry_msgs::PoseStamped& pose : plan) pose.header.stamp = ros::Time::now();
  publish(plan);
  return true;
}

void GridPlanner::publish(const std::vector<geometry_msgs::PoseStamped>& plan) {
  nav_msgs::Path path;
  path.header.frame_id = costmap_ros_->getGlobalFrameID();
  path.header.stamp = ros::Time::now();
  path.poses = plan;
  publisher_.publish(path);
}

}  // namespace move_base
