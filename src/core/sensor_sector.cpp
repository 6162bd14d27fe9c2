// SPDX-License-Identifier: BSD-3-Clause
#include "hidwa_local_planner/core/sensor_sector.hpp"

#include <cmath>
#include <limits>
#include <locale>
#include <sstream>

namespace hidwa_local_planner {
namespace {

constexpr double kDegree = M_PI / 180.0;

bool read_sector(const std::string& text, SensorSector& sector) {
  std::istringstream words(text);
  words.imbue(std::locale::classic());
  double direction = 0.0, width = 0.0;
  std::string more;
  if (!(words >> sector.pose.x >> sector.pose.y >> direction >> width >> sector.range) || words >> more) return false;
  sector.pose.theta = kDegree * direction;
  sector.width = kDegree * width;
  return is_finite(sector.pose) && width > 0.0 && width <= 360.0 && sector.range > 0.0;
}

}  // namespace

bool SensorSector::contains(const Point& point) const {
  const Point to = point - Point(pose.x, pose.y);
  if (to.squaredNorm() > range * range) return false;
  return width >= 2.0 * M_PI || std::abs(wrap_angle(std::atan2(to.y(), to.x()) - pose.theta)) <= 0.5 * width;
}

bool operator==(const SensorSector& a, const SensorSector& b) {
  return a.pose.x == b.pose.x && a.pose.y == b.pose.y && a.pose.theta == b.pose.theta && a.width == b.width &&
         a.range == b.range;
}

SensorSectors parse_sensor_sectors(const std::string& text, std::string& fault) {
  SensorSectors sectors;
  if (text == "all") return {{{}, 2.0 * M_PI, std::numeric_limits<double>::infinity()}};
  std::istringstream parts(text);
  for (std::string part; std::getline(parts, part, ';');) {
    SensorSector sector;
    if (!read_sector(part, sector)) {
      fault = "sensor_sectors: '" + part +
              "' is no sensor: write 'x y direction width range' [m m deg deg m], with ';' between two sensors, or all";
      return {};
    }
    sectors.push_back(sector);
  }
  return sectors;
}

}  // namespace hidwa_local_planner
