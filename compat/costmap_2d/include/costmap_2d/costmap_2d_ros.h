// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <costmap_2d/costmap_2d.h>
#include <costmap_2d/costmap_2d_publisher.h>
#include <costmap_2d/footprint.h>
#include <costmap_2d/layered_costmap.h>
#include <geometry_msgs/Point.h>
#include <geometry_msgs/Polygon.h>
#include <geometry_msgs/PoseStamped.h>
#include <ros/ros.h>
#include <tf2_ros/buffer.h>

#include <atomic>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

namespace costmap_2d {

/// A layered costmap fed from parameters, tf and topics below the namespace ~/`name`, updated by a thread of
/// its own.
class Costmap2DROS {
 public:
  /// Waits for the robot's transform and, with a static layer, for the map, serving callbacks meanwhile.
  /// Throws std::runtime_error when the parameters ask for what is not supported.
  Costmap2DROS(const std::string& name, tf2_ros::Buffer& tf);
  ~Costmap2DROS();
  Costmap2DROS(const Costmap2DROS&) = delete;
  Costmap2DROS& operator=(const Costmap2DROS&) = delete;

  /// Subscribes again after stop() and waits for one update.
  void start();
  /// Unsubscribes and ends updates.
  void stop();
  /// Ends updates, stays subscribed.
  void pause();
  /// Goes on after pause() and waits for one update.
  void resume();

  /// One update at the robot's present pose; none while the pose cannot be had.
  void updateMap();
  void resetLayers();

  bool isCurrent() const { return layered_costmap_->isCurrent(); }
  bool isStopped() const { return stopped_; }

  /// The robot's pose in the global frame; false, with a reason logged, when tf has none younger than
  /// transform_tolerance.
  bool getRobotPose(geometry_msgs::PoseStamped& global_pose) const;

  const std::string& getName() const noexcept { return name_; }
  double getTransformTolerance() const { return transform_tolerance_; }  // [s]
  Costmap2D* getCostmap() const { return layered_costmap_->getCostmap(); }
  const std::string& getGlobalFrameID() const noexcept { return global_frame_; }
  const std::string& getBaseFrameID() const noexcept { return robot_base_frame_; }
  LayeredCostmap* getLayeredCostmap() const { return layered_costmap_.get(); }

  /// The padded footprint in the robot's frame [m].
  geometry_msgs::Polygon getRobotFootprintPolygon() const { return toPolygon(getRobotFootprint()); }
  std::vector<geometry_msgs::Point> getRobotFootprint() const;
  std::vector<geometry_msgs::Point> getUnpaddedRobotFootprint() const;
  /// The padded footprint at the robot's pose in the global frame [m]; unchanged when the pose cannot be had.
  void getOrientedFootprint(std::vector<geometry_msgs::Point>& oriented_footprint) const;

  void setUnpaddedRobotFootprint(const std::vector<geometry_msgs::Point>& points);
  void setUnpaddedRobotFootprintPolygon(const geometry_msgs::Polygon& footprint);

 private:
  void waitForTransform() const;
  void loadLayers();
  void loadFootprint();
  void subscribeFootprint();
  void waitForUpdate() const;
  void updateLoop(double frequency, double publish_frequency);

  const std::string name_;
  tf2_ros::Buffer& tf_;
  ros::NodeHandle nh_;
  std::string global_frame_;
  std::string robot_base_frame_;
  double transform_tolerance_ = 0.3;  // [s]
  double footprint_padding_ = 0.01;   // [m]

  std::unique_ptr<LayeredCostmap> layered_costmap_;
  std::unique_ptr<Costmap2DPublisher> publisher_;
  ros::Publisher footprint_publisher_;
  ros::Subscriber footprint_subscriber_;

  mutable std::mutex footprint_mutex_;
  std::vector<geometry_msgs::Point> unpadded_footprint_;
  std::vector<geometry_msgs::Point> padded_footprint_;

  std::atomic<bool> stop_updates_{false};
  std::atomic<bool> initialized_{false};
  std::atomic<bool> stopped_{false};
  std::atomic<bool> shutdown_{false};
  std::thread update_thread_;
};

}  // namespace costmap_2d
