// SPDX-License-Identifier: BSD-3-Clause
#include <costmap_2d/costmap_math.h>
#include <costmap_2d/footprint.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace costmap_2d {

void calculateMinAndMaxDistances(const std::vector<geometry_msgs::Point>& footprint, double& min_dist,
                                 double& max_dist) {
  min_dist = std::numeric_limits<double>::max();
  max_dist = 0.0;
  if (footprint.size() <= 2) return;
  for (std::size_t i = 0; i < footprint.size(); ++i) {
    const geometry_msgs::Point& a = footprint[i];
    const geometry_msgs::Point& b = footprint[(i + 1) % footprint.size()];
    min_dist = std::min(min_dist, distanceToLine(0.0, 0.0, a.x, a.y, b.x, b.y));
    max_dist = std::max(max_dist, std::hypot(a.x, a.y));
  }
}

geometry_msgs::Point toPoint(geometry_msgs::Point32 pt) {
  geometry_msgs::Point point;
  point.x = pt.x;
  point.y = pt.y;
  point.z = pt.z;
  return point;
}

geometry_msgs::Point32 toPoint32(geometry_msgs::Point pt) {
  geometry_msgs::Point32 point;
  point.x = static_cast<float>(pt.x);
  point.y = static_cast<float>(pt.y);
  point.z = static_cast<float>(pt.z);
  return point;
}

geometry_msgs::Polygon toPolygon(std::vector<geometry_msgs::Point> pts) {
  geometry_msgs::Polygon polygon;
  for (const geometry_msgs::Point& point : pts) polygon.points.push_back(toPoint32(point));
  return polygon;
}

std::vector<geometry_msgs::Point> toPointVector(geometry_msgs::Polygon polygon) {
  std::vector<geometry_msgs::Point> points;
  for (const geometry_msgs::Point32& point : polygon.points) points.push_back(toPoint(point));
  return points;
}

void transformFootprint(double x, double y, double theta, const std::vector<geometry_msgs::Point>& footprint_spec,
                        std::vector<geometry_msgs::Point>& oriented_footprint) {
  const double cosine = std::cos(theta);
  const double sine = std::sin(theta);
  std::vector<geometry_msgs::Point> moved;
  for (const geometry_msgs::Point& corner : footprint_spec) {
    geometry_msgs::Point point;
    point.x = x + cosine * corner.x - sine * corner.y;
    point.y = y + sine * corner.x + cosine * corner.y;
    moved.push_back(point);
  }
  oriented_footprint.swap(moved);
}

void transformFootprint(double x, double y, double theta, const std::vector<geometry_msgs::Point>& footprint_spec,
                        geometry_msgs::PolygonStamped& oriented_footprint) {
  std::vector<geometry_msgs::Point> moved;
  transformFootprint(x, y, theta, footprint_spec, moved);
  oriented_footprint.polygon = toPolygon(moved);
}

void padFootprint(std::vector<geometry_msgs::Point>& footprint, double padding) {
  for (geometry_msgs::Point& corner : footprint) {
    corner.x += sign0(corner.x) * padding;
    corner.y += sign0(corner.y) * padding;
  }
}

std::vector<geometry_msgs::Point> makeFootprintFromRadius(double radius) {
  constexpr int kCorners = 16;
  std::vector<geometry_msgs::Point> points(kCorners);
  for (int i = 0; i < kCorners; ++i) {
    const double angle = 2.0 * M_PI * i / kCorners;
    points[std::size_t(i)].x = radius * std::cos(angle);
    points[std::size_t(i)].y = radius * std::sin(angle);
  }
  return points;
}

}  // namespace costmap_2d
