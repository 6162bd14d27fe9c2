// SPDX-License-Identifier: BSD-3-Clause
#include <costmap_2d/inflation_layer.h>
#include <costmap_2d/layer_list.h>
#include <costmap_2d/obstacle_layer.h>
#include <costmap_2d/static_layer.h>
#include <ros/console.h>

#include <sstream>
#include <stdexcept>

namespace costmap_2d {
namespace {

constexpr char kSupported[] = "costmap_2d::StaticLayer, costmap_2d::ObstacleLayer and costmap_2d::InflationLayer";

std::string textMember(XmlRpc::XmlRpcValue& entry, const char* key, const std::string& list) {
  if (entry.getType() != XmlRpc::XmlRpcValue::TypeStruct || !entry.hasMember(key) ||
      entry[key].getType() != XmlRpc::XmlRpcValue::TypeString) {
    throw std::runtime_error("parameter " + list + ": each entry must be {name: ..., type: ...}");
  }
  return static_cast<std::string>(entry[key]);
}

void copyParam(ros::NodeHandle& nh, const std::string& layer, const std::string& key) {
  XmlRpc::XmlRpcValue value;
  if (nh.getParam(key, value) && !nh.hasParam(layer + "/" + key)) nh.setParam(layer + "/" + key, value);
}

std::vector<LayerEntry> defaultLayers(ros::NodeHandle& nh) {
  std::vector<LayerEntry> layers;
  if (nh.param("static_map", false)) {
    layers.push_back({"static_layer", "costmap_2d::StaticLayer"});
    for (const char* key : {"map_topic", "unknown_cost_value", "lethal_cost_threshold", "track_unknown_space"}) {
      copyParam(nh, "static_layer", key);
    }
  }
  if (nh.param<std::string>("map_type", "costmap") == "voxel") {
    layers.push_back({"obstacle_layer", "costmap_2d::VoxelLayer"});
  } else {
    layers.push_back({"obstacle_layer", "costmap_2d::ObstacleLayer"});
  }
  for (const char* key :
       {"max_obstacle_height", "raytrace_range", "obstacle_range", "track_unknown_space", "observation_sources"}) {
    copyParam(nh, "obstacle_layer", key);
  }
  std::istringstream sources(nh.param<std::string>("observation_sources", ""));
  for (std::string source; sources >> source;) copyParam(nh, "obstacle_layer", source);
  layers.push_back({"inflation_layer", "costmap_2d::InflationLayer"});
  for (const char* key : {"inflation_radius", "cost_scaling_factor"}) copyParam(nh, "inflation_layer", key);
  return layers;
}

}  // namespace

std::vector<LayerEntry> readLayerList(ros::NodeHandle& costmap_nh) {
  XmlRpc::XmlRpcValue list;
  const std::string key = costmap_nh.resolveName("plugins");
  if (!costmap_nh.getParam("plugins", list)) {
    ROS_INFO("%s is not set: layers are made from the parameters beside it.", key.c_str());
    return defaultLayers(costmap_nh);
  }
  if (list.getType() != XmlRpc::XmlRpcValue::TypeArray) {
    throw std::runtime_error("parameter " + key + " must be a list of {name: ..., type: ...}");
  }
  std::vector<LayerEntry> layers;
  for (int i = 0; i < list.size(); ++i) {
    layers.push_back({textMember(list[i], "name", key), textMember(list[i], "type", key)});
  }
  return layers;
}

boost::shared_ptr<Layer> makeLayer(const LayerEntry& entry) {
  if (entry.type == "costmap_2d::StaticLayer") return boost::shared_ptr<Layer>(new StaticLayer);
  if (entry.type == "costmap_2d::ObstacleLayer") return boost::shared_ptr<Layer>(new ObstacleLayer);
  if (entry.type == "costmap_2d::InflationLayer") return boost::shared_ptr<Layer>(new InflationLayer);
  throw std::runtime_error("costmap layer \"" + entry.name + "\" is of type \"" + entry.type +
                           "\"; this costmap_2d has " + kSupported +
                           ". Use one of these, or the navigation stack's own costmap_2d");
}

}  // namespace costmap_2d
