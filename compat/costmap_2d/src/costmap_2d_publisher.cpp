// SPDX-License-Identifier: BSD-3-Clause
#include <costmap_2d/cost_values.h>
#include <costmap_2d/costmap_2d_publisher.h>
#include <map_msgs/OccupancyGridUpdate.h>

#include <algorithm>
#include <utility>

namespace costmap_2d {
namespace {

std::array<double, 5> geometry(const Costmap2D& map) {
  return {double(map.getSizeInCellsX()), double(map.getSizeInCellsY()), map.getResolution(), map.getOriginX(),
          map.getOriginY()};
}

}  // namespace

Costmap2DPublisher::Costmap2DPublisher(ros::NodeHandle* nh, Costmap2D* costmap, std::string global_frame,
                                       const std::string& topic_name, bool always_send_full_costmap)
    : costmap_(costmap), global_frame_(std::move(global_frame)), always_whole_(always_send_full_costmap) {
  grid_publisher_ = nh->advertise<nav_msgs::OccupancyGrid>(
      topic_name, 1, [this](const ros::SingleSubscriberPublisher& subscriber) { subscriber.publish(wholeGrid()); });
  update_publisher_ = nh->advertise<map_msgs::OccupancyGridUpdate>(topic_name + "_updates", 1);
}

signed char Costmap2DPublisher::occupancy(unsigned char cost) {
  if (cost == FREE_SPACE) return 0;
  if (cost == INSCRIBED_INFLATED_OBSTACLE) return 99;
  if (cost == LETHAL_OBSTACLE) return 100;
  if (cost == NO_INFORMATION) return -1;
  return static_cast<signed char>(1 + (97 * (cost - 1)) / 251);
}

void Costmap2DPublisher::updateBounds(unsigned int x0, unsigned int xn, unsigned int y0, unsigned int yn) {
  if (x0 >= xn || y0 >= yn) return;
  const bool empty = x0_ >= xn_;
  x0_ = empty ? x0 : std::min(x0, x0_);
  xn_ = empty ? xn : std::max(xn, xn_);
  y0_ = empty ? y0 : std::min(y0, y0_);
  yn_ = empty ? yn : std::max(yn, yn_);
}

nav_msgs::OccupancyGrid Costmap2DPublisher::wholeGrid() const {
  const boost::unique_lock<Costmap2D::mutex_t> lock(*costmap_->getMutex());
  nav_msgs::OccupancyGrid grid;
  grid.header.frame_id = global_frame_;
  grid.header.stamp = ros::Time::now();
  grid.info.width = costmap_->getSizeInCellsX();
  grid.info.height = costmap_->getSizeInCellsY();
  grid.info.resolution = static_cast<float>(costmap_->getResolution());
  grid.info.origin.position.x = costmap_->getOriginX();
  grid.info.origin.position.y = costmap_->getOriginY();
  grid.info.origin.orientation.w = 1.0;
  grid.data.resize(std::size_t(grid.info.width) * grid.info.height);
  std::transform(costmap_->getCharMap(), costmap_->getCharMap() + grid.data.size(), grid.data.begin(), occupancy);
  return grid;
}

bool Costmap2DPublisher::geometryChanged() const { return geometry(*costmap_) != sent_geometry_; }

void Costmap2DPublisher::publishUpdate() {
  map_msgs::OccupancyGridUpdate update;
  update.header.frame_id = global_frame_;
  update.header.stamp = ros::Time::now();
  update.x = static_cast<int>(x0_);
  update.y = static_cast<int>(y0_);
  update.width = xn_ - x0_;
  update.height = yn_ - y0_;
  update.data.reserve(std::size_t(update.width) * update.height);
  for (unsigned int y = y0_; y < yn_; ++y) {
    for (unsigned int x = x0_; x < xn_; ++x) update.data.push_back(occupancy(costmap_->getCost(x, y)));
  }
  update_publisher_.publish(update);
}

void Costmap2DPublisher::publishCostmap() {
  if (grid_publisher_.getNumSubscribers() > 0) {
    const boost::unique_lock<Costmap2D::mutex_t> lock(*costmap_->getMutex());
    if (always_whole_ || geometryChanged()) {
      sent_geometry_ = geometry(*costmap_);
      grid_publisher_.publish(wholeGrid());
    } else if (x0_ < xn_) {
      publishUpdate();
    }
  }
  x0_ = xn_ = y0_ = yn_ = 0;
}

}  // namespace costmap_2d
