// SPDX-License-Identifier: BSD-3-Clause
#include <costmap_2d/cost_values.h>
#include <costmap_2d/layered_costmap.h>
#include <costmap_2d/scan_grid.h>
#include <costmap_2d/static_layer.h>
#include <tf2/utils.h>
#include <tf2_geometry_msgs/tf2_geometry_msgs.h>

#include <algorithm>
#include <cmath>
#include <cstring>

namespace costmap_2d {

unsigned char StaticMapValues::cost(signed char value) const {
  if (value == unknown_value) return track_unknown_space ? NO_INFORMATION : FREE_SPACE;
  if (value >= lethal_threshold) return LETHAL_OBSTACLE;
  if (trinary) return FREE_SPACE;
  return static_cast<unsigned char>(std::max(0.0, double(value) / lethal_threshold * LETHAL_OBSTACLE));
}

void StaticLayer::onInitialize() {
  ros::NodeHandle nh("~/" + name_);
  enabled_ = nh.param("enabled", true);
  first_map_only_ = nh.param("first_map_only", false);
  use_maximum_ = nh.param("use_maximum", false);
  values_.track_unknown_space = nh.param("track_unknown_space", true);
  values_.trinary = nh.param("trinary_costmap", true);
  values_.lethal_threshold = std::clamp(nh.param("lethal_cost_threshold", 100), 1, 100);
  values_.unknown_value = nh.param("unknown_cost_value", -1);
  if (nh.param("subscribe_to_updates", false)) {
    ROS_WARN("%s: subscribe_to_updates is not supported here; whole maps are.", name_.c_str());
  }
  subscriber_ = ros::NodeHandle().subscribe(nh.param<std::string>("map_topic", "map"), 1, &StaticLayer::onMap, this);
  ROS_INFO("%s: waiting for the map on %s", name_.c_str(), subscriber_.getTopic().c_str());
  ros::WallTime next_word = ros::WallTime::now() + ros::WallDuration(5.0);
  while (ros::ok() && !received_) {
    ros::spinOnce();
    ros::WallDuration(0.02).sleep();
    if (ros::WallTime::now() > next_word) {
      ROS_WARN("%s: still no map on %s; is a map server running?", name_.c_str(), subscriber_.getTopic().c_str());
      next_word += ros::WallDuration(5.0);
    }
  }
}

void StaticLayer::onMap(const nav_msgs::OccupancyGrid& message) {
  const nav_msgs::MapMetaData& info = message.info;
  if (message.data.size() != std::size_t(info.width) * info.height || message.data.empty() ||
      !(info.resolution > 0.0f)) {
    ROS_ERROR("%s: the map on %s is ignored: %zu values do not make %u x %u cells of %g m", name_.c_str(),
              subscriber_.getTopic().c_str(), message.data.size(), info.width, info.height, double(info.resolution));
    return;
  }
  Costmap2D& master = *layered_costmap_->getCostmap();
  const boost::unique_lock<Costmap2D::mutex_t> lock(*master.getMutex());
  const double resolution = info.resolution;
  if (!layered_costmap_->isRolling()) {
    layered_costmap_->resizeMap(info.width, info.height, resolution, info.origin.position.x, info.origin.position.y,
                                true);
  }
  map_.resizeMap(info.width, info.height, resolution, info.origin.position.x, info.origin.position.y);
  unsigned char* cells = map_.getCharMap();
  std::transform(message.data.begin(), message.data.end(), cells,
                 [this](signed char value) { return values_.cost(value); });
  map_frame_ = message.header.frame_id;
  received_ = changed_ = true;
  ROS_INFO("%s: received a map of %u x %u cells of %.3f m", name_.c_str(), info.width, info.height, resolution);
  if (first_map_only_) subscriber_.shutdown();
}

void StaticLayer::reset() { changed_ = received_; }

void StaticLayer::updateBounds(double /*robot_x*/, double /*robot_y*/, double /*robot_yaw*/, double* min_x,
                               double* min_y, double* max_x, double* max_y) {
  if (!received_ || !(changed_ || layered_costmap_->isRolling())) return;
  changed_ = false;
  const Costmap2D& area = *layered_costmap_->getCostmap();
  *min_x = std::min(*min_x, area.getOriginX());
  *min_y = std::min(*min_y, area.getOriginY());
  *max_x = std::max(*max_x, area.getOriginX() + area.getSizeInMetersX());
  *max_y = std::max(*max_y, area.getOriginY() + area.getSizeInMetersY());
}

void StaticLayer::updateCosts(Costmap2D& master_grid, int min_i, int min_j, int max_i, int max_j) {
  if (!received_) return;
  if (layered_costmap_->isRolling()) {
    copyTransformed(master_grid, min_i, min_j, max_i, max_j);
  } else if (use_maximum_) {
    mergeMaximum(master_grid, map_, min_i, min_j, max_i, max_j);
  } else {
    copyAligned(master_grid, min_i, min_j, max_i, max_j);
  }
}

void StaticLayer::copyAligned(Costmap2D& master, int min_i, int min_j, int max_i, int max_j) const {
  const auto count = static_cast<std::size_t>(max_i - min_i);
  for (int j = min_j; j < max_j; ++j) {
    const unsigned int first = master.getIndex(static_cast<unsigned int>(min_i), static_cast<unsigned int>(j));
    std::memcpy(master.getCharMap() + first, map_.getCharMap() + first, count);
  }
}

void StaticLayer::copyTransformed(Costmap2D& master, int min_i, int min_j, int max_i, int max_j) const {
  geometry_msgs::TransformStamped transform;
  try {
    transform = tf_->lookupTransform(map_frame_, layered_costmap_->getGlobalFrameID(), ros::Time(0));
  } catch (const tf2::TransformException& fault) {
    ROS_ERROR_THROTTLE(5.0, "%s: the map is left out: %s", name_.c_str(), fault.what());
    return;
  }
  const double yaw = tf2::getYaw(transform.transform.rotation);
  const double cosine = std::cos(yaw);
  const double sine = std::sin(yaw);
  for (auto j = static_cast<unsigned int>(min_j); j < static_cast<unsigned int>(max_j); ++j) {
    for (auto i = static_cast<unsigned int>(min_i); i < static_cast<unsigned int>(max_i); ++i) {
      double x, y;
      master.mapToWorld(i, j, x, y);
      unsigned int mx, my;
      if (!map_.worldToMap(transform.transform.translation.x + cosine * x - sine * y,
                           transform.transform.translation.y + sine * x + cosine * y, mx, my)) {
        continue;
      }
      const unsigned char cost = map_.getCost(mx, my);
      master.setCost(i, j, use_maximum_ ? std::max(cost, master.getCost(i, j)) : cost);
    }
  }
}

}  // namespace costmap_2d
