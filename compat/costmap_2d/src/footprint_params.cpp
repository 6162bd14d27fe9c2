// SPDX-License-Identifier: BSD-3-Clause
// The footprint as text and as a parameter.
#include <costmap_2d/footprint.h>
#include <ros/console.h>
#include <yaml-cpp/yaml.h>

#include <stdexcept>

namespace costmap_2d {
namespace {

constexpr char kRemedy[] = "it must be a list of three or more pairs of numbers in metres, [[x1, y1], [x2, y2], ...]";

double number(XmlRpc::XmlRpcValue& value, const std::string& name) {
  if (value.getType() == XmlRpc::XmlRpcValue::TypeInt) return static_cast<int>(value);
  if (value.getType() == XmlRpc::XmlRpcValue::TypeDouble) return static_cast<double>(value);
  throw std::runtime_error("parameter " + name + ": " + kRemedy);
}

}  // namespace

bool makeFootprintFromString(const std::string& footprint_string, std::vector<geometry_msgs::Point>& footprint) {
  std::vector<geometry_msgs::Point> points;
  try {
    for (const YAML::Node& pair : YAML::Load(footprint_string)) {
      if (!pair.IsSequence() || pair.size() != 2) throw YAML::Exception(YAML::Mark::null_mark(), "not a pair");
      geometry_msgs::Point point;
      point.x = pair[0].as<double>();
      point.y = pair[1].as<double>();
      points.push_back(point);
    }
  } catch (const YAML::Exception& fault) {
    ROS_ERROR("The footprint \"%s\" cannot be read (%s): %s", footprint_string.c_str(), fault.what(), kRemedy);
    return false;
  }
  if (points.size() < 3) {
    ROS_ERROR("The footprint \"%s\" has fewer than three corners: %s", footprint_string.c_str(), kRemedy);
    return false;
  }
  footprint.swap(points);
  return true;
}

std::vector<geometry_msgs::Point> makeFootprintFromXMLRPC(XmlRpc::XmlRpcValue& footprint_xmlrpc,
                                                          const std::string& full_param_name) {
  const std::string fault = "parameter " + full_param_name + ": " + kRemedy;
  if (footprint_xmlrpc.getType() != XmlRpc::XmlRpcValue::TypeArray || footprint_xmlrpc.size() < 3) {
    throw std::runtime_error(fault);
  }
  std::vector<geometry_msgs::Point> points;
  for (int i = 0; i < footprint_xmlrpc.size(); ++i) {
    XmlRpc::XmlRpcValue& pair = footprint_xmlrpc[i];
    if (pair.getType() != XmlRpc::XmlRpcValue::TypeArray || pair.size() != 2) throw std::runtime_error(fault);
    geometry_msgs::Point point;
    point.x = number(pair[0], full_param_name);
    point.y = number(pair[1], full_param_name);
    points.push_back(point);
  }
  return points;
}

std::vector<geometry_msgs::Point> makeFootprintFromParams(ros::NodeHandle& nh) {
  std::vector<geometry_msgs::Point> points;
  std::string key;
  XmlRpc::XmlRpcValue value;
  if (nh.searchParam("footprint", key) && nh.getParam(key, value)) {
    if (value.getType() != XmlRpc::XmlRpcValue::TypeString) return makeFootprintFromXMLRPC(value, key);
    const std::string text = static_cast<std::string>(value);
    // "" and "[]" mean: none given.
    if (!text.empty() && text != "[]") {
      if (makeFootprintFromString(text, points)) return points;
      throw std::runtime_error("parameter " + key + ": " + kRemedy);
    }
  }
  if (nh.searchParam("robot_radius", key) && nh.getParam(key, value)) {
    points = makeFootprintFromRadius(number(value, key));
  }
  return points;
}

void writeFootprintToParam(ros::NodeHandle& nh, const std::vector<geometry_msgs::Point>& footprint) {
  XmlRpc::XmlRpcValue list;
  list.setSize(static_cast<int>(footprint.size()));
  for (int i = 0; i < list.size(); ++i) {
    list[i].setSize(2);
    list[i][0] = footprint[std::size_t(i)].x;
    list[i][1] = footprint[std::size_t(i)].y;
  }
  nh.setParam("footprint", list);
}

}  // namespace costmap_2d
