// SPDX-License-Identifier: BSD-3-Clause
#include <costmap_2d/cost_values.h>
#include <costmap_2d/line.h>
#include <costmap_2d/scan_grid.h>
#include <tf2/LinearMath/Transform.h>
#include <tf2_geometry_msgs/tf2_geometry_msgs.h>

#include <algorithm>
#include <cmath>

namespace costmap_2d {
namespace {

double squaredDistance(const geometry_msgs::Point& a, const geometry_msgs::Point& b) {
  const double dx = a.x - b.x;
  const double dy = a.y - b.y;
  const double dz = a.z - b.z;
  return dx * dx + dy * dy + dz * dz;
}

// The greatest part t in [0, 1] of the way from `from` to `to` that keeps within [least, greatest].
double partWithin(double from, double to, double least, double greatest) {
  if (to > greatest) return (greatest - from) / (to - from);
  if (to < least) return (least - from) / (to - from);
  return 1.0;
}

}  // namespace

void TouchedArea::add(double x, double y) const {
  *min_x = std::min(*min_x, x);
  *min_y = std::min(*min_y, y);
  *max_x = std::max(*max_x, x);
  *max_y = std::max(*max_y, y);
}

std::vector<geometry_msgs::Point> projectScan(const sensor_msgs::LaserScan& scan,
                                              const geometry_msgs::Transform& sensor_pose, const ScanFilter& filter) {
  tf2::Transform pose;
  tf2::fromMsg(sensor_pose, pose);
  const tf2::Vector3 ahead = pose.getBasis().getColumn(0);
  const tf2::Vector3 left = pose.getBasis().getColumn(1);
  constexpr double kJustInside = 1e-4;  // [m]

  std::vector<geometry_msgs::Point> points;
  points.reserve(scan.ranges.size());
  for (std::size_t i = 0; i < scan.ranges.size(); ++i) {
    double range = scan.ranges[i];
    if (filter.inf_is_valid && std::isinf(range) && range > 0.0) range = scan.range_max - kJustInside;
    if (!(range >= scan.range_min && range < scan.range_max)) continue;  // also what is not a number
    const double angle = scan.angle_min + double(i) * scan.angle_increment;
    const tf2::Vector3 end = pose.getOrigin() + ahead * (range * std::cos(angle)) + left * (range * std::sin(angle));
    if (end.z() < filter.min_height || end.z() > filter.max_height) continue;
    geometry_msgs::Point point;
    point.x = end.x();
    point.y = end.y();
    point.z = end.z();
    points.push_back(point);
  }
  return points;
}

bool clearBeams(Costmap2D& grid, const Observation& observation, const TouchedArea& touched) {
  const double ox = observation.origin.x;
  const double oy = observation.origin.y;
  unsigned int x0, y0;
  if (!grid.worldToMap(ox, oy, x0, y0)) return false;
  touched.add(ox, oy);

  const double least_x = grid.getOriginX();
  const double least_y = grid.getOriginY();
  // Just inside the far edges, so that a clipped beam ends in the last cell.
  const double inside = 1e-3 * grid.getResolution();
  const double greatest_x = least_x + grid.getSizeInCellsX() * grid.getResolution() - inside;
  const double greatest_y = least_y + grid.getSizeInCellsY() * grid.getResolution() - inside;
  const double range_in_cells = observation.raytrace_range / grid.getResolution();
  unsigned char* cells = grid.getCharMap();

  for (const geometry_msgs::Point& point : observation.points) {
    const double part =
        std::min(partWithin(ox, point.x, least_x, greatest_x), partWithin(oy, point.y, least_y, greatest_y));
    const double dx = (point.x - ox) * part;
    const double dy = (point.y - oy) * part;
    int x1, y1;
    grid.worldToMapEnforceBounds(ox + dx, oy + dy, x1, y1);
    visitLine(static_cast<int>(x0), static_cast<int>(y0), x1, y1, static_cast<int>(grid.getSizeInCellsX()),
              range_in_cells, [cells](int index) { cells[index] = FREE_SPACE; });
    // One cell more than the range, since a line's cells lie up to half a cell beside it.
    const double length = std::hypot(dx, dy);
    const double reach = std::min(1.0, (observation.raytrace_range + grid.getResolution()) / std::max(length, 1e-9));
    touched.add(ox + dx * reach, oy + dy * reach);
  }
  return true;
}

void markPoints(Costmap2D& grid, const Observation& observation, double max_height, const TouchedArea& touched) {
  const double range_squared = observation.obstacle_range * observation.obstacle_range;
  for (const geometry_msgs::Point& point : observation.points) {
    unsigned int mx, my;
    if (point.z > max_height || squaredDistance(point, observation.origin) >= range_squared ||
        !grid.worldToMap(point.x, point.y, mx, my)) {
      continue;
    }
    grid.setCost(mx, my, LETHAL_OBSTACLE);
    touched.add(point.x, point.y);
  }
}

void mergeMaximum(Costmap2D& target, const Costmap2D& source, int min_i, int min_j, int max_i, int max_j) {
  const int width = static_cast<int>(target.getSizeInCellsX());
  for (int j = min_j; j < max_j; ++j) {
    unsigned char* to = target.getCharMap() + j * width;
    const unsigned char* from = source.getCharMap() + j * width;
    for (int i = min_i; i < max_i; ++i) {
      if (from[i] != NO_INFORMATION && (to[i] == NO_INFORMATION || to[i] < from[i])) to[i] = from[i];
    }
  }
}

void mergeOverwrite(Costmap2D& target, const Costmap2D& source, int min_i, int min_j, int max_i, int max_j) {
  const int width = static_cast<int>(target.getSizeInCellsX());
  for (int j = min_j; j < max_j; ++j) {
    unsigned char* to = target.getCharMap() + j * width;
    const unsigned char* from = source.getCharMap() + j * width;
    for (int i = min_i; i < max_i; ++i) {
      if (from[i] != NO_INFORMATION) to[i] = from[i];
    }
  }
}

}  // namespace costmap_2d
