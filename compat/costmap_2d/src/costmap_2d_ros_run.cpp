// SPDX-License-Identifier: BSD-3-Clause
// The running costmap: updates, pauses, the robot's pose.
#include <costmap_2d/costmap_2d_ros.h>
#include <tf2/utils.h>
#include <tf2_geometry_msgs/tf2_geometry_msgs.h>

namespace costmap_2d {

void Costmap2DROS::waitForUpdate() const {
  while (ros::ok() && update_thread_.joinable() && !initialized_) ros::WallDuration(0.01).sleep();
}

void Costmap2DROS::start() {
  if (stopped_) {
    for (const auto& layer : *layered_costmap_->getPlugins()) layer->activate();
    stopped_ = false;
  }
  resume();
}

void Costmap2DROS::stop() {
  pause();
  for (const auto& layer : *layered_costmap_->getPlugins()) layer->deactivate();
  stopped_ = true;
}

void Costmap2DROS::pause() {
  stop_updates_ = true;
  initialized_ = false;
}

void Costmap2DROS::resume() {
  stop_updates_ = false;
  waitForUpdate();
}

void Costmap2DROS::updateMap() {
  if (stop_updates_) return;
  geometry_msgs::PoseStamped pose;
  if (!getRobotPose(pose)) return;
  const double x = pose.pose.position.x;
  const double y = pose.pose.position.y;
  const double yaw = tf2::getYaw(pose.pose.orientation);
  layered_costmap_->updateMap(x, y, yaw);

  if (footprint_publisher_.getNumSubscribers() > 0) {
    geometry_msgs::PolygonStamped footprint;
    footprint.header.frame_id = global_frame_;
    footprint.header.stamp = ros::Time::now();
    transformFootprint(x, y, yaw, getRobotFootprint(), footprint);
    footprint_publisher_.publish(footprint);
  }
  initialized_ = true;
}

void Costmap2DROS::resetLayers() {
  const boost::unique_lock<Costmap2D::mutex_t> lock(*getCostmap()->getMutex());
  getCostmap()->resetMap(0, 0, getCostmap()->getSizeInCellsX(), getCostmap()->getSizeInCellsY());
  for (const auto& layer : *layered_costmap_->getPlugins()) layer->reset();
}

bool Costmap2DROS::getRobotPose(geometry_msgs::PoseStamped& global_pose) const {
  const ros::Time now = ros::Time::now();
  geometry_msgs::TransformStamped transform;
  try {
    const bool has_now = tf_.canTransform(global_frame_, robot_base_frame_, now);
    transform = tf_.lookupTransform(global_frame_, robot_base_frame_, has_now ? now : ros::Time(0));
  } catch (const tf2::TransformException& fault) {
    ROS_ERROR_THROTTLE(1.0, "%s: no robot pose: %s", name_.c_str(), fault.what());
    return false;
  }
  global_pose.header = transform.header;
  global_pose.pose.position.x = transform.transform.translation.x;
  global_pose.pose.position.y = transform.transform.translation.y;
  global_pose.pose.position.z = transform.transform.translation.z;
  global_pose.pose.orientation = transform.transform.rotation;

  const double age = (now - transform.header.stamp).toSec();
  if (!transform.header.stamp.isZero() && age > transform_tolerance_) {
    ROS_WARN_THROTTLE(1.0,
                      "%s: the transform from %s to %s is %.3f s old; at most %.3f s is allowed "
                      "(transform_tolerance).",
                      name_.c_str(), robot_base_frame_.c_str(), global_frame_.c_str(), age, transform_tolerance_);
    return false;
  }
  return true;
}

void Costmap2DROS::updateLoop(double frequency, double publish_frequency) {
  ros::Rate rate(frequency);
  ros::Time last_publish;
  while (ros::ok() && !shutdown_) {
    const ros::WallTime begun = ros::WallTime::now();
    updateMap();
    const double spent = (ros::WallTime::now() - begun).toSec();
    ROS_DEBUG_NAMED("timing", "%s: update took %.6f s", name_.c_str(), spent);

    if (publish_frequency > 0.0 && layered_costmap_->isInitialized()) {
      unsigned int x0, xn, y0, yn;
      layered_costmap_->getBounds(&x0, &xn, &y0, &yn);
      publisher_->updateBounds(x0, xn, y0, yn);
      const ros::Time now = ros::Time::now();
      if (now < last_publish || now >= last_publish + ros::Duration(1.0 / publish_frequency)) {
        publisher_->publishCostmap();
        last_publish = now;
      }
    }
    rate.sleep();
    if (rate.cycleTime() > ros::Duration(1.0 / frequency)) {
      ROS_WARN_THROTTLE(5.0, "%s: the update took %.4f s, longer than its period of %.4f s (update_frequency).",
                        name_.c_str(), rate.cycleTime().toSec(), 1.0 / frequency);
    }
  }
}

}  // namespace costmap_2d
