// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <costmap_2d/layer.h>
#include <ros/node_handle.h>

#include <boost/shared_ptr.hpp>
#include <string>
#include <vector>

namespace costmap_2d {

/// One entry of a costmap's `plugins` list.
struct LayerEntry {
  std::string name;
  std::string type;
};

/// The `plugins` list of a costmap's namespace. Without one: the static layer where `static_map` is true, an
/// obstacle layer and an inflation layer; their parameters, given beside each other in the costmap's
/// namespace, are copied to where the layers look. Throws std::runtime_error when the list is malformed.
std::vector<LayerEntry> readLayerList(ros::NodeHandle& costmap_nh);

/// Throws std::runtime_error naming the layer and the types that exist here when `entry.type` is none of
/// them.
boost::shared_ptr<Layer> makeLayer(const LayerEntry& entry);

}  // namespace costmap_2d
