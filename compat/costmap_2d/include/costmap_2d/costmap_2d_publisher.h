// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <costmap_2d/costmap_2d.h>
#include <nav_msgs/OccupancyGrid.h>
#include <ros/ros.h>

#include <array>
#include <string>

namespace costmap_2d {

/// Publishes a costmap as nav_msgs/OccupancyGrid on `topic`, whole to each new subscriber and when its
/// geometry changed, otherwise what was rewritten as map_msgs/OccupancyGridUpdate on `topic`_updates.
class Costmap2DPublisher {
 public:
  Costmap2DPublisher(ros::NodeHandle* nh, Costmap2D* costmap, std::string global_frame,
                     const std::string& topic_name, bool always_send_full_costmap = false);

  /// Adds cells x0 <= x < xn, y0 <= y < yn to what the next update holds.
  void updateBounds(unsigned int x0, unsigned int xn, unsigned int y0, unsigned int yn);
  void publishCostmap();

  /// Cost to occupancy: 0 free, 99 inscribed, 100 lethal, -1 unknown, between them 1 to 98.
  static signed char occupancy(unsigned char cost);

 private:
  nav_msgs::OccupancyGrid wholeGrid() const;
  void publishUpdate();
  bool geometryChanged() const;

  Costmap2D* costmap_;
  const std::string global_frame_;
  const bool always_whole_;
  ros::Publisher grid_publisher_;
  ros::Publisher update_publisher_;
  unsigned int x0_ = 0, xn_ = 0, y0_ = 0, yn_ = 0;
  std::array<double, 5> sent_geometry_{};  // sizes, resolution, origin of the last whole grid sent
};

}  // namespace costmap_2d
