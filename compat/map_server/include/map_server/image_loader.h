// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nav_msgs/OccupancyGrid.h>

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace map_server {

enum class Mode { kTrinary, kScale, kRaw };

/// What a map's YAML file says.
struct MapDescription {
  std::string image;               // absolute path
  double resolution = 0.0;         // [m/pixel]
  std::array<double, 3> origin{};  // x [m], y [m], yaw [rad] of the lower left corner
  double occupied_thresh = 0.0;    // probability from which a cell is occupied
  double free_thresh = 0.0;        // probability below which a cell is free
  bool negate = false;             // white is occupied
  Mode mode = Mode::kTrinary;
};

/// Reads a YAML file; throws std::runtime_error naming the file, the key and the remedy.
MapDescription readDescription(const std::string& yaml_file);

/// A picture: rows from the top, each pixel its channels' mean and its opacity, 0 to 255.
struct Picture {
  unsigned int width = 0;
  unsigned int height = 0;
  std::vector<double> grey;
  std::vector<std::uint8_t> opacity;  // empty: opaque throughout
};

/// Loads any format SDL_image knows. In trinary mode opacity counts as one of the channels of the mean.
/// Throws std::runtime_error naming the file and the reason.
Picture readPicture(const std::string& file, Mode mode);

/// The occupancy of one pixel: 100 occupied, 0 free, -1 unknown; in scale mode 1 to 99 between the
/// thresholds; in raw mode the grey value itself.
signed char occupancy(double grey, std::uint8_t opacity, const MapDescription& description);

/// The map, rows from the bottom; header left empty.
nav_msgs::OccupancyGrid makeMap(const Picture& picture, const MapDescription& description);

}  // namespace map_server
