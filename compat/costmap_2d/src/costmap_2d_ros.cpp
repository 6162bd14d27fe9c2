// SPDX-License-Identifier: BSD-3-Clause
#include <costmap_2d/costmap_2d_ros.h>
#include <costmap_2d/layer_list.h>
#include <tf2/utils.h>
#include <tf2_geometry_msgs/tf2_geometry_msgs.h>

#include <stdexcept>

namespace costmap_2d {

Costmap2DROS::Costmap2DROS(const std::string& name, tf2_ros::Buffer& tf) : name_(name), tf_(tf), nh_("~/" + name) {
  global_frame_ = nh_.param<std::string>("global_frame", "map");
  robot_base_frame_ = nh_.param<std::string>("robot_base_frame", "base_link");
  transform_tolerance_ = nh_.param("transform_tolerance", 0.3);
  footprint_padding_ = nh_.param("footprint_padding", 0.01);
  waitForTransform();

  layered_costmap_ = std::make_unique<LayeredCostmap>(global_frame_, nh_.param("rolling_window", false),
                                                      nh_.param("track_unknown_space", false));
  const double resolution = nh_.param("resolution", 0.05);
  const double width = nh_.param("width", 10.0);
  const double height = nh_.param("height", 10.0);
  if (!(resolution > 0.0 && width >= resolution && height >= resolution)) {
    throw std::runtime_error("parameters resolution, width and height of " + nh_.getNamespace() +
                             " must be positive lengths in metres, the resolution the least of them");
  }
  layered_costmap_->resizeMap(static_cast<unsigned int>(width / resolution),
                              static_cast<unsigned int>(height / resolution), resolution, nh_.param("origin_x", 0.0),
                              nh_.param("origin_y", 0.0));
  loadLayers();
  loadFootprint();
  publisher_ = std::make_unique<Costmap2DPublisher>(&nh_, layered_costmap_->getCostmap(), global_frame_, "costmap",
                                                    nh_.param("always_send_full_costmap", false));
  // In this order: both topics may bear the same name, and roscpp refuses a subscription to its own other
  // type.
  subscribeFootprint();
  footprint_publisher_ = nh_.advertise<geometry_msgs::PolygonStamped>("footprint", 1);
  const double update_frequency = nh_.param("update_frequency", 5.0);
  if (update_frequency > 0.0) {
    update_thread_ =
        std::thread(&Costmap2DROS::updateLoop, this, update_frequency, nh_.param("publish_frequency", 0.0));
  }
}

Costmap2DROS::~Costmap2DROS() {
  shutdown_ = true;
  if (update_thread_.joinable()) update_thread_.join();
}

void Costmap2DROS::waitForTransform() const {
  ros::WallTime next_word = ros::WallTime::now() + ros::WallDuration(5.0);
  std::string fault;
  while (ros::ok() && !tf_.canTransform(global_frame_, robot_base_frame_, ros::Time(0), &fault)) {
    ros::spinOnce();
    ros::WallDuration(0.02).sleep();
    if (ros::WallTime::now() > next_word) {
      ROS_WARN("%s: waiting for the transform from %s to %s: %s", name_.c_str(), robot_base_frame_.c_str(),
               global_frame_.c_str(), fault.c_str());
      next_word += ros::WallDuration(5.0);
    }
    fault.clear();
  }
}

void Costmap2DROS::loadLayers() {
  for (const LayerEntry& entry : readLayerList(nh_)) {
    ROS_INFO("%s: layer \"%s\" of type %s", name_.c_str(), entry.name.c_str(), entry.type.c_str());
    const boost::shared_ptr<Layer> layer = makeLayer(entry);
    layered_costmap_->addPlugin(layer);
    layer->initialize(layered_costmap_.get(), name_ + "/" + entry.name, &tf_);
  }
}

void Costmap2DROS::loadFootprint() {
  std::vector<geometry_msgs::Point> points = makeFootprintFromParams(nh_);
  if (points.empty()) {
    constexpr double kDefaultRadius = 0.46;  // [m]
    ROS_WARN("%s: neither footprint nor robot_radius is set; a radius of %.2f m is taken.", name_.c_str(),
             kDefaultRadius);
    points = makeFootprintFromRadius(kDefaultRadius);
  }
  setUnpaddedRobotFootprint(points);
}

void Costmap2DROS::subscribeFootprint() {
  std::string key;
  if (!nh_.searchParam("footprint_topic", key)) key = "footprint_topic";
  footprint_subscriber_ =
      nh_.subscribe(nh_.param<std::string>(key, "footprint"), 1, &Costmap2DROS::setUnpaddedRobotFootprintPolygon, this);
}

std::vector<geometry_msgs::Point> Costmap2DROS::getRobotFootprint() const {
  const std::lock_guard<std::mutex> lock(footprint_mutex_);
  return padded_footprint_;
}

std::vector<geometry_msgs::Point> Costmap2DROS::getUnpaddedRobotFootprint() const {
  const std::lock_guard<std::mutex> lock(footprint_mutex_);
  return unpadded_footprint_;
}

void Costmap2DROS::getOrientedFootprint(std::vector<geometry_msgs::Point>& oriented_footprint) const {
  geometry_msgs::PoseStamped pose;
  if (!getRobotPose(pose)) return;
  transformFootprint(pose.pose.position.x, pose.pose.position.y, tf2::getYaw(pose.pose.orientation),
                     getRobotFootprint(), oriented_footprint);
}

void Costmap2DROS::setUnpaddedRobotFootprint(const std::vector<geometry_msgs::Point>& points) {
  std::vector<geometry_msgs::Point> padded = points;
  padFootprint(padded, footprint_padding_);
  {
    const std::lock_guard<std::mutex> lock(footprint_mutex_);
    if (points == unpadded_footprint_) return;
    unpadded_footprint_ = points;
    padded_footprint_ = padded;
  }
  layered_costmap_->setFootprint(padded);
}

void Costmap2DROS::setUnpaddedRobotFootprintPolygon(const geometry_msgs::Polygon& footprint) {
  setUnpaddedRobotFootprint(toPointVector(footprint));
}

}  // namespace costmap_2d
