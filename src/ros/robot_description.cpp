// SPDX-License-Identifier: BSD-3-Clause
#include "ros/robot_description.hpp"

#include <algorithm>
#include <cmath>

#include <ros/console.h>

#include "core/util/words.hpp"
#include "robot/urdf_reading.hpp"

namespace hidwa_local_planner {
namespace {

constexpr double kDefaultRadius = 0.46;  // what costmap_2d writes to robot_radius where nothing is set [m]

/// Whether somebody set a footprint or a radius for the costmap, as costmap_2d searches for them.
bool has_own_footprint(const ros::NodeHandle& costmap) {
  std::string key;
  XmlRpc::XmlRpcValue value;
  if (costmap.searchParam("footprint", key) && costmap.getParam(key, value)) {
    if (value.getType() != XmlRpc::XmlRpcValue::TypeString) return true;
    const std::string& text = static_cast<const std::string&>(value);
    if (!text.empty() && text != "[]") return true;
  }
  double radius = kDefaultRadius;
  if (costmap.searchParam("robot_radius", key)) costmap.getParam(key, radius);
  return radius != kDefaultRadius;
}

std::vector<geometry_msgs::Point> points_of(const Polygon& outline) {
  std::vector<geometry_msgs::Point> points;
  for (const Point& corner : outline) {
    geometry_msgs::Point point;
    point.x = corner.x();
    point.y = corner.y();
    points.push_back(point);
  }
  return points;
}

}  // namespace

RobotDescription::RobotDescription(const ros::NodeHandle& handle, const std::string& base_frame)
    : handle_(handle), base_frame_(base_frame) {}

Parameters RobotDescription::limited(const Parameters& wanted) {
  std::vector<std::string> joints = split_names(wanted.wheel_joints);
  joints.resize(2);  // more are refused (validate())
  const Names names{wanted.robot_description_param, joints[0], joints[1]};
  if (names_ != names) read(names);
  if (!wheels_) return wanted;
  robot::LimitedParameters result = robot::limited(wanted, *wheels_);
  say(result.remarks);
  return result.parameters;
}

void RobotDescription::read(const Names& names) {
  names_ = names;
  wheels_.reset();
  outline_.reset();
  said_.clear();
  const std::optional<std::string> urdf = text(names[0]);
  if (!urdf) return;
  const robot::UrdfReading reading = robot::read_urdf(*urdf, base_frame_);
  if (!reading.model) return complain(reading.fault);
  if (!reading.warning.empty()) {
    ROS_WARN("%s: %s: %s", handle_.getNamespace().c_str(), names[0].c_str(), reading.warning.c_str());
  }
  find_wheels(*reading.model, names);
  outline_ = robot::outline_of(*reading.model);
}

std::optional<std::string> RobotDescription::text(const std::string& parameter) const {
  if (parameter.empty()) return std::nullopt;
  try {
    std::string key;
    std::string urdf;
    if (!handle_.searchParam(parameter, key)) {
      if (parameter != Parameters().robot_description_param) {
        complain("there is no such parameter: correct robot_description_param");
      }
      return std::nullopt;
    }
    if (handle_.getParam(key, urdf)) return urdf;
    complain(key + " is no text: load the URDF with <param textfile=...> or <param command=\"xacro ...\">");
  } catch (const ros::Exception& error) {
    complain(std::string(error.what()) + ": correct robot_description_param");
  }
  return std::nullopt;
}

void RobotDescription::find_wheels(const robot::Model& model, const Names& names) {
  robot::WheelSearch search = robot::find_wheels(model, names[1], names[2]);
  wheels_ = std::move(search.wheels);
  if (search.undecided) {
    ROS_WARN("%s: %s sets no limit: %s", handle_.getNamespace().c_str(), names[0].c_str(), search.fault.c_str());
  } else if (!search.fault.empty()) {
    complain(search.fault);
  }
}

void RobotDescription::complain(const std::string& fault) const {
  ROS_ERROR("%s: %s: %s; the parameters' limits hold", handle_.getNamespace().c_str(), (*names_)[0].c_str(),
            fault.c_str());
}

void RobotDescription::say(const std::vector<robot::Remark>& remarks) {
  std::vector<std::string> subjects;
  for (const robot::Remark& remark : remarks) {
    subjects.push_back(remark.subject);
    if (std::find(said_.begin(), said_.end(), remark.subject) != said_.end()) continue;
    switch (remark.level) {
      case robot::Remark::Level::fault:
        complain(remark.text);
        break;
      case robot::Remark::Level::warning:
        ROS_WARN("%s: %s", handle_.getNamespace().c_str(), remark.text.c_str());
        break;
      default:
        ROS_INFO("%s: %s", handle_.getNamespace().c_str(), remark.text.c_str());
    }
  }
  said_ = std::move(subjects);
}

void RobotDescription::give_outline(costmap_2d::Costmap2DROS& costmap, bool wanted) const {
  if (!outline_) return;
  const boost::unique_lock<costmap_2d::Costmap2D::mutex_t> lock(*costmap.getCostmap()->getMutex());
  const std::string name = costmap.getName();
  const bool empty = costmap.getUnpaddedRobotFootprint().size() < 3;
  if (!empty && has_own_footprint(ros::NodeHandle("~/" + name))) return;
  const std::string situation =
      name +
      (empty ? " has no footprint" : " has neither footprint nor robot_radius (other than the default of 0.46 m)");
  if (!outline_->fault.empty() || !outline_->skipped.empty()) {
    const std::string reason = !outline_->fault.empty() ? outline_->fault
                                                        : "the collision geometry of " + joined(outline_->skipped) +
                                                              " is a mesh or has no size";
    ROS_WARN("%s: %s, and the URDF gives no outline (%s): set footprint or robot_radius",
             handle_.getNamespace().c_str(), situation.c_str(), reason.c_str());
    return;
  }
  if (!wanted) {
    ROS_WARN("%s: %s: set footprint or robot_radius, or footprint_from_urdf for the URDF's collision geometry",
             handle_.getNamespace().c_str(), situation.c_str());
    return;
  }
  double reach = 0.0;  // [m]
  for (const Point& corner : outline_->corners) reach = std::max(reach, corner.norm());
  costmap.setUnpaddedRobotFootprint(points_of(outline_->corners));
  ROS_WARN("%s: %s: the URDF's collision geometry is taken, %zu corners up to %.3f m from %s",
           handle_.getNamespace().c_str(), situation.c_str(), outline_->corners.size(), reach, base_frame_.c_str());
}

}  // namespace hidwa_local_planner
