// SPDX-License-Identifier: BSD-3-Clause
#include "sim/occupancy_map.hpp"

#include <vector>

#include "sim/pgm.hpp"
#include "yaml_file.hpp"

namespace hidwa_local_planner {
namespace sim {
namespace {

std::string image_path(const YamlFile& file, const std::string& yaml_path) {
  const auto image = file.as<std::string>(file.root()["image"], "image");
  if (image.empty()) file.fail("'image' is empty");
  const std::size_t slash = yaml_path.find_last_of('/');
  return image[0] == '/' || slash == std::string::npos ? image : yaml_path.substr(0, slash + 1) + image;
}

struct Thresholds {
  bool negate;
  double occupied;
  double free;
};

Thresholds read_thresholds(const YamlFile& file) {
  const YAML::Node& root = file.root();
  if (root["mode"] && file.as<std::string>(root["mode"], "mode") != "trinary") {
    file.fail("'mode' other than trinary is not supported");
  }
  // Some tools write negate as a number, some as a boolean.
  const auto negate = file.as<std::string>(root["negate"], "negate");
  Thresholds t{negate == "1" || negate == "true", file.as<double>(root["occupied_thresh"], "occupied_thresh"),
               file.as<double>(root["free_thresh"], "free_thresh")};
  if (!(t.free <= t.occupied)) file.fail("'free_thresh' must not exceed 'occupied_thresh'");
  return t;
}

Cell classify(double brightness, const Thresholds& t) {
  const double occupancy = t.negate ? brightness : 1.0 - brightness;
  if (occupancy > t.occupied) return Cell::kOccupied;
  return occupancy < t.free ? Cell::kFree : Cell::kUnknown;
}

}  // namespace

OccupancyMap make_map(int width, int height, double resolution, double origin_x, double origin_y) {
  OccupancyMap map;
  map.width = width;
  map.height = height;
  map.resolution = resolution;
  map.origin_x = origin_x;
  map.origin_y = origin_y;
  map.cells.assign(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), Cell::kFree);
  return map;
}

OccupancyMap load_map(const std::string& yaml_path) {
  const YamlFile file(yaml_path);
  if (!file.root().IsMap()) file.fail("is not a map_server YAML (image, resolution, origin, ...)");
  const auto resolution = file.as<double>(file.root()["resolution"], "resolution");
  const auto origin = file.as<std::vector<double>>(file.root()["origin"], "origin");
  if (!(resolution > 0.0) || !std::isfinite(resolution)) file.fail("'resolution' must be positive [m]");
  if (origin.size() != 3) file.fail("'origin' must be [x, y, yaw]");
  if (!std::isfinite(origin[0]) || !std::isfinite(origin[1])) file.fail("'origin' is not a number");
  if (origin[2] != 0.0) file.fail("'origin' has a yaw other than 0, which is not supported: rotate the image instead");
  const Thresholds thresholds = read_thresholds(file);
  const GreyImage image = read_pgm(image_path(file, yaml_path));

  OccupancyMap map = make_map(image.width, image.height, resolution, origin[0], origin[1]);
  for (int row = 0; row < map.height; ++row) {
    for (int column = 0; column < map.width; ++column) {
      // The image's first row is the top of the map.
      map.cells[map.index(column, row)] = classify(image.pixels[map.index(column, map.height - 1 - row)], thresholds);
    }
  }
  return map;
}

}  // namespace sim
}  // namespace hidwa_local_planner
