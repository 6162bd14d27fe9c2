// SPDX-License-Identifier: BSD-3-Clause
#include <costmap_2d/costmap_2d.h>
#include <costmap_2d/line.h>

#include <algorithm>
#include <limits>

namespace costmap_2d {

bool Costmap2D::setConvexPolygonCost(const std::vector<geometry_msgs::Point>& polygon, unsigned char cost_value) {
  std::vector<MapLocation> corners;
  for (const geometry_msgs::Point& point : polygon) {
    MapLocation corner;
    if (!worldToMap(point.x, point.y, corner.x, corner.y)) return false;
    corners.push_back(corner);
  }
  std::vector<MapLocation> filled;
  convexFillCells(corners, filled);
  for (const MapLocation& cell : filled) setCost(cell.x, cell.y, cost_value);
  return true;
}

void Costmap2D::polygonOutlineCells(const std::vector<MapLocation>& polygon,
                                    std::vector<MapLocation>& polygon_cells) const {
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const MapLocation& from = polygon[i];
    const MapLocation& to = polygon[(i + 1) % polygon.size()];
    visitLine(static_cast<int>(from.x), static_cast<int>(from.y), static_cast<int>(to.x), static_cast<int>(to.y),
              static_cast<int>(size_x_), std::numeric_limits<double>::infinity(), [&](int index) {
                MapLocation cell;
                indexToCells(static_cast<unsigned int>(index), cell.x, cell.y);
                polygon_cells.push_back(cell);
              });
  }
}

void Costmap2D::convexFillCells(const std::vector<MapLocation>& polygon,
                                std::vector<MapLocation>& polygon_cells) const {
  if (polygon.size() < 3) return;
  std::vector<MapLocation> outline;
  polygonOutlineCells(polygon, outline);

  // The outline's leftmost and rightmost cell of each row bound what lies inside.
  const auto rows = std::minmax_element(outline.begin(), outline.end(),
                                        [](const MapLocation& a, const MapLocation& b) { return a.y < b.y; });
  const unsigned int first_row = rows.first->y;
  struct Span {
    unsigned int least = std::numeric_limits<unsigned int>::max();
    unsigned int greatest = 0;
  };
  std::vector<Span> spans(rows.second->y - first_row + 1);
  for (const MapLocation& cell : outline) {
    Span& span = spans[cell.y - first_row];
    span.least = std::min(span.least, cell.x);
    span.greatest = std::max(span.greatest, cell.x);
  }
  for (unsigned int row = 0; row < spans.size(); ++row) {
    for (unsigned int x = spans[row].least; x <= spans[row].greatest; ++x)
      polygon_cells.push_back({x, first_row + row});
  }
}

}  // namespace costmap_2d
