// SPDX-License-Identifier: BSD-3-Clause
#include "node_parameters.hpp"

#include <cmath>
#include <memory>
#include <stdexcept>
#include <vector>

#include <yaml-cpp/yaml.h>

#include "node_people.hpp"
#include "node_robots.hpp"

namespace hidwa_local_planner {
namespace sim {
namespace {

[[noreturn]] void bad_footprint() {
  throw std::runtime_error("parameter ~footprint must be a list of three corners [x, y] or more, in metres");
}

double number(XmlRpc::XmlRpcValue value) {
  if (value.getType() == XmlRpc::XmlRpcValue::TypeInt) return static_cast<int>(value);
  if (value.getType() == XmlRpc::XmlRpcValue::TypeDouble) return static_cast<double>(value);
  bad_footprint();
}

Polygon from_list(XmlRpc::XmlRpcValue list) {
  Polygon polygon;
  for (int i = 0; i < list.size(); ++i) {
    if (list[i].getType() != XmlRpc::XmlRpcValue::TypeArray || list[i].size() != 2) bad_footprint();
    polygon.emplace_back(number(list[i][0]), number(list[i][1]));
  }
  return polygon;
}

Polygon from_text(const std::string& text) {
  Polygon polygon;
  try {
    for (const std::vector<double>& corner : YAML::Load(text).as<std::vector<std::vector<double>>>()) {
      if (corner.size() != 2) bad_footprint();
      polygon.emplace_back(corner[0], corner[1]);
    }
  } catch (const YAML::Exception&) {
    bad_footprint();
  }
  return polygon;
}

DriveLimits read_limits(const ros::NodeHandle& node) {
  DriveLimits l;
  node.getParam("max_vel_x", l.max_vel_x);
  node.getParam("max_vel_theta", l.max_vel_theta);
  node.getParam("acc_lim_x", l.acc_lim_x);
  node.getParam("acc_lim_theta", l.acc_lim_theta);
  // Without limits of their own the axes slow down as fast as they speed up.
  l.decel_lim_x = node.param("decel_lim_x", l.acc_lim_x);
  l.decel_lim_theta = node.param("decel_lim_theta", l.acc_lim_theta);
  node.getParam("wheel_separation", l.wheel_separation);
  node.getParam("max_wheel_speed", l.max_wheel_speed);
  node.getParam("latency", l.latency);
  node.getParam("command_timeout", l.command_timeout);
  return l;
}

LaserSpec read_laser(const ros::NodeHandle& node) {
  LaserSpec laser;
  node.getParam("laser_beams", laser.beams);
  node.getParam("laser_field_of_view", laser.field_of_view);
  node.getParam("laser_range_min", laser.range_min);
  node.getParam("laser_range_max", laser.range_max);
  node.getParam("laser_noise", laser.noise);
  if (laser.beams < 1) throw std::runtime_error("parameter ~laser_beams must be positive");
  if (!(laser.range_max > laser.range_min && laser.range_min >= 0.0)) {
    throw std::runtime_error("parameters ~laser_range_min and ~laser_range_max: 0 <= min < max is needed");
  }
  return laser;
}

void require_positive(double value, const char* name) {
  if (!(std::isfinite(value) && value > 0.0)) {
    throw std::runtime_error("parameter ~" + std::string(name) + " must be positive");
  }
}

void read_rates(const ros::NodeHandle& node, SimNodeParameters& p) {
  node.getParam("rate", p.rate);
  node.getParam("odom_rate", p.odom_rate);
  node.getParam("ground_truth_rate", p.ground_truth_rate);
  node.getParam("scan_rate", p.scan_rate);
  require_positive(p.rate, "rate");
  require_positive(p.odom_rate, "odom_rate");
  require_positive(p.ground_truth_rate, "ground_truth_rate");
  require_positive(p.scan_rate, "scan_rate");
}

WorldSetup read_world(const ros::NodeHandle& node) {
  const std::string map = node.param<std::string>("map", "");
  if (map.empty()) throw std::runtime_error("parameter ~map is missing: the path of a map_server YAML file");
  WorldSetup world;
  world.map = std::make_shared<OccupancyMap>(load_map(map));
  const std::string regions = node.param<std::string>("regions", "");
  if (!regions.empty()) {
    const RegionsFile file = load_regions(regions);
    world.regions = file.regions;
    world.start = file.start.value_or(Pose());
  }
  node.getParam("x", world.start.x);
  node.getParam("y", world.start.y);
  node.getParam("yaw", world.start.theta);
  world.footprint = read_footprint(node, node.param("radius", 0.30));
  world.limits = read_limits(node);
  node.getParam("odom_slip_x", world.odometry_noise.slip_x);
  node.getParam("odom_slip_theta", world.odometry_noise.slip_theta);
  world.seed = static_cast<std::uint64_t>(node.param("seed", 1));
  return world;
}

}  // namespace

Polygon read_footprint(const ros::NodeHandle& node, double radius) {
  XmlRpc::XmlRpcValue value;
  if (!node.getParam("footprint", value)) {
    require_positive(radius, "radius");
    return circle_polygon(radius);
  }
  Polygon polygon;
  if (value.getType() == XmlRpc::XmlRpcValue::TypeArray) {
    polygon = from_list(value);
  } else if (value.getType() == XmlRpc::XmlRpcValue::TypeString) {
    polygon = from_text(value);
  }
  if (polygon.size() < 3) bad_footprint();
  return polygon;
}

SimNodeParameters read_parameters(const ros::NodeHandle& node) {
  SimNodeParameters p;
  p.world = read_world(node);
  p.laser = read_laser(node);
  node.getParam("laser_x", p.laser_pose.x);
  node.getParam("laser_y", p.laser_pose.y);
  node.getParam("laser_yaw", p.laser_pose.theta);
  node.getParam("laser_height", p.laser_height);
  read_rates(node, p);
  p.world.people = with_robots(node, read_people(node, p.world));
  node.getParam("follow_clock", p.follow_clock);
  node.getParam("tell_truth", p.tell_truth);
  node.getParam("map_frame", p.map_frame);
  node.getParam("odom_frame", p.odom_frame);
  node.getParam("base_frame", p.base_frame);
  node.getParam("laser_frame", p.laser_frame);
  return p;
}

}  // namespace sim
}  // namespace hidwa_local_planner
