// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <costmap_2d/scan_grid.h>
#include <message_filters/subscriber.h>
#include <ros/ros.h>
#include <sensor_msgs/LaserScan.h>
#include <tf2_ros/buffer.h>
#include <tf2_ros/message_filter.h>

#include <memory>
#include <mutex>
#include <string>

namespace costmap_2d {

/// One of an obstacle layer's observation_sources: a laser, its parameters and its last scan.
class ScanSource {
 public:
  /// Reads the parameters below `layer_nh`/`name`. Throws std::runtime_error naming what is not supported.
  ScanSource(ros::NodeHandle& layer_nh, const std::string& name, tf2_ros::Buffer& tf,
             std::string global_frame, double transform_tolerance);

  void subscribe();
  void unsubscribe();

  bool marking() const { return marking_; }
  bool clearing() const { return clearing_; }

  /// The last scan, null before the first.
  std::shared_ptr<const Observation> latest() const;

  /// False when the last scan came longer ago than expected_update_rate [s] (0: no limit).
  bool isCurrent() const;
  /// Counts as if a scan had just come.
  void resetLastUpdate();
  void forget();

 private:
  void onScan(const sensor_msgs::LaserScanConstPtr& scan);

  const std::string name_;
  tf2_ros::Buffer& tf_;
  const std::string global_frame_;
  std::string topic_;
  std::string sensor_frame_;
  bool marking_ = true;
  bool clearing_ = false;
  double expected_update_period_ = 0.0;  // [s]
  double obstacle_range_ = 2.5;          // [m]
  double raytrace_range_ = 3.0;          // [m]
  ScanFilter filter_;

  message_filters::Subscriber<sensor_msgs::LaserScan> subscriber_;
  std::unique_ptr<tf2_ros::MessageFilter<sensor_msgs::LaserScan>> waits_for_tf_;

  mutable std::mutex mutex_;
  std::shared_ptr<const Observation> latest_;
  ros::Time last_update_;
};

}  // namespace costmap_2d
