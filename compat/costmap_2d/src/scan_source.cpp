// SPDX-License-Identifier: BSD-3-Clause
#include <costmap_2d/scan_source.h>
#include <tf2_geometry_msgs/tf2_geometry_msgs.h>

#include <stdexcept>
#include <utility>

namespace costmap_2d {
namespace {

// A parameter of the source, or of the nearest namespace above it.
double inheritedParam(const ros::NodeHandle& nh, const std::string& key, double fallback) {
  std::string found;
  return nh.searchParam(key, found) ? nh.param(found, fallback) : fallback;
}

}  // namespace

ScanSource::ScanSource(ros::NodeHandle& layer_nh, const std::string& name, tf2_ros::Buffer& tf,
                       std::string global_frame, double transform_tolerance)
    : name_(name), tf_(tf), global_frame_(std::move(global_frame)), last_update_(ros::Time::now()) {
  const ros::NodeHandle nh(layer_nh, name);
  const std::string type = nh.param<std::string>("data_type", "PointCloud");
  if (type != "LaserScan") {
    throw std::runtime_error(nh.getNamespace() + "/data_type is " + type +
                             (nh.hasParam("data_type") ? "" : " (the default)") +
                             "; this costmap_2d reads LaserScan only: set data_type: LaserScan, or use the navigation "
                             "stack's own costmap_2d");
  }
  if (nh.param("observation_persistence", 0.0) != 0.0) {
    ROS_WARN("%s/observation_persistence is taken as 0 here: the last scan counts.", nh.getNamespace().c_str());
  }
  topic_ = nh.param("topic", name);
  sensor_frame_ = nh.param<std::string>("sensor_frame", "");
  marking_ = nh.param("marking", true);
  clearing_ = nh.param("clearing", false);
  expected_update_period_ = nh.param("expected_update_rate", 0.0);
  filter_.min_height = nh.param("min_obstacle_height", 0.0);
  filter_.max_height = nh.param("max_obstacle_height", 2.0);
  filter_.inf_is_valid = nh.param("inf_is_valid", false);
  obstacle_range_ = inheritedParam(nh, "obstacle_range", obstacle_range_);
  raytrace_range_ = inheritedParam(nh, "raytrace_range", raytrace_range_);

  ros::NodeHandle topic_nh;
  subscriber_.subscribe(topic_nh, topic_, 50);
  waits_for_tf_ =
      std::make_unique<tf2_ros::MessageFilter<sensor_msgs::LaserScan>>(subscriber_, tf_, global_frame_, 50, topic_nh);
  waits_for_tf_->setTolerance(ros::Duration(std::min(0.05, transform_tolerance)));
  if (!sensor_frame_.empty()) {
    waits_for_tf_->setTargetFrames({global_frame_, sensor_frame_});
  }
  waits_for_tf_->registerCallback([this](const sensor_msgs::LaserScanConstPtr& scan) { onScan(scan); });
}

void ScanSource::subscribe() { subscriber_.subscribe(); }

void ScanSource::unsubscribe() { subscriber_.unsubscribe(); }

void ScanSource::onScan(const sensor_msgs::LaserScanConstPtr& scan) {
  auto seen = std::make_shared<Observation>();
  seen->obstacle_range = obstacle_range_;
  seen->raytrace_range = raytrace_range_;
  try {
    const auto scan_pose = tf_.lookupTransform(global_frame_, scan->header.frame_id, scan->header.stamp).transform;
    const auto sensor = sensor_frame_.empty() || sensor_frame_ == scan->header.frame_id
                            ? scan_pose
                            : tf_.lookupTransform(global_frame_, sensor_frame_, scan->header.stamp).transform;
    seen->origin.x = sensor.translation.x;
    seen->origin.y = sensor.translation.y;
    seen->origin.z = sensor.translation.z;
    seen->points = projectScan(*scan, scan_pose, filter_);
  } catch (const tf2::TransformException& fault) {
    ROS_ERROR_THROTTLE(5.0, "%s: a scan is dropped: %s", name_.c_str(), fault.what());
    return;
  }
  const std::lock_guard<std::mutex> lock(mutex_);
  latest_ = std::move(seen);
  last_update_ = ros::Time::now();
}

std::shared_ptr<const Observation> ScanSource::latest() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return latest_;
}

bool ScanSource::isCurrent() const {
  if (expected_update_period_ == 0.0) return true;
  const std::lock_guard<std::mutex> lock(mutex_);
  const double age = (ros::Time::now() - last_update_).toSec();
  const bool current = age <= expected_update_period_;
  if (!current) {
    ROS_WARN_THROTTLE(1.0, "No scan on %s for %.2f s; one is expected every %.2f s (expected_update_rate).",
                      subscriber_.getTopic().c_str(), age, expected_update_period_);
  }
  return current;
}

void ScanSource::resetLastUpdate() {
  const std::lock_guard<std::mutex> lock(mutex_);
  last_update_ = ros::Time::now();
}

void ScanSource::forget() {
  const std::lock_guard<std::mutex> lock(mutex_);
  latest_.reset();
}

}  // namespace costmap_2d
