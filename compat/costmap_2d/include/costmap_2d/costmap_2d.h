// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <geometry_msgs/Point.h>

#include <boost/thread/recursive_mutex.hpp>
#include <string>
#include <vector>

namespace costmap_2d {

/// A cell of the grid, x along a row.
struct MapLocation {
  unsigned int x;
  unsigned int y;
};

/// A grid of costs over the plane, row-major from the corner of least x and y.
/// Not locked by itself: whoever shares it holds getMutex().
class Costmap2D {
 public:
  typedef boost::recursive_mutex mutex_t;

  Costmap2D() = default;

  /// `resolution` [m/cell]; the origin [m] is the outer corner of cell (0, 0); every cell starts at
  /// `default_value`.
  Costmap2D(unsigned int cells_size_x, unsigned int cells_size_y, double resolution, double origin_x,
            double origin_y, unsigned char default_value = 0);
  Costmap2D(const Costmap2D& map);
  Costmap2D& operator=(const Costmap2D& map);
  virtual ~Costmap2D() = default;

  /// Makes this a copy of a rectangle [m] of `map`; false when the rectangle leaves it.
  bool copyCostmapWindow(const Costmap2D& map, double win_origin_x, double win_origin_y, double win_size_x,
                         double win_size_y);

  unsigned char getCost(unsigned int mx, unsigned int my) const { return cells_[getIndex(mx, my)]; }
  void setCost(unsigned int mx, unsigned int my, unsigned char cost) { cells_[getIndex(mx, my)] = cost; }

  /// The centre of a cell [m].
  void mapToWorld(unsigned int mx, unsigned int my, double& wx, double& wy) const;
  /// The cell that holds a point [m]; false outside the map.
  bool worldToMap(double wx, double wy, unsigned int& mx, unsigned int& my) const;
  /// The same without bounds: cells outside the map have indices below zero or beyond its size (truncated
  /// towards zero).
  void worldToMapNoBounds(double wx, double wy, int& mx, int& my) const;
  /// The same, with points outside the map moved to its border cells.
  void worldToMapEnforceBounds(double wx, double wy, int& mx, int& my) const;

  unsigned int getIndex(unsigned int mx, unsigned int my) const { return my * size_x_ + mx; }
  void indexToCells(unsigned int index, unsigned int& mx, unsigned int& my) const {
    my = index / size_x_;
    mx = index - my * size_x_;
  }

  unsigned char* getCharMap() const { return const_cast<unsigned char*>(cells_.data()); }

  unsigned int getSizeInCellsX() const { return size_x_; }
  unsigned int getSizeInCellsY() const { return size_y_; }
  /// From the outer edge of the first cell to the centre of the last one [m].
  double getSizeInMetersX() const { return (size_x_ - 0.5) * resolution_; }
  double getSizeInMetersY() const { return (size_y_ - 0.5) * resolution_; }
  double getOriginX() const { return origin_x_; }
  double getOriginY() const { return origin_y_; }
  double getResolution() const { return resolution_; }

  /// What new and reset cells hold; existing cells keep their value.
  void setDefaultValue(unsigned char c) { default_value_ = c; }
  unsigned char getDefaultValue() const { return default_value_; }

  /// Gives one value to every cell of a convex polygon [m]; false, changing nothing, when a corner lies
  /// outside.
  bool setConvexPolygonCost(const std::vector<geometry_msgs::Point>& polygon, unsigned char cost_value);
  void polygonOutlineCells(const std::vector<MapLocation>& polygon,
                           std::vector<MapLocation>& polygon_cells) const;
  void convexFillCells(const std::vector<MapLocation>& polygon,
                       std::vector<MapLocation>& polygon_cells) const;

  /// Moves the map by whole cells towards the new origin [m]; what stays in view keeps its cost.
  virtual void updateOrigin(double new_origin_x, double new_origin_y);

  /// Writes a PGM picture of the costs; false when the file cannot be written.
  bool saveMap(const std::string& file_name) const;

  void resizeMap(unsigned int size_x, unsigned int size_y, double resolution, double origin_x,
                 double origin_y);
  /// Resets cells x0 <= x < xn, y0 <= y < yn to the default value.
  void resetMap(unsigned int x0, unsigned int y0, unsigned int xn, unsigned int yn);

  /// A distance [m] in cells, rounded up.
  unsigned int cellDistance(double world_dist) const;

  mutex_t* getMutex() const { return &access_; }

 protected:
  unsigned int size_x_ = 0;
  unsigned int size_y_ = 0;
  double resolution_ = 0.0;  // [m/cell]
  double origin_x_ = 0.0;    // [m]
  double origin_y_ = 0.0;    // [m]
  unsigned char default_value_ = 0;
  std::vector<unsigned char> cells_;

 private:
  mutable mutex_t access_;
};

}  // namespace costmap_2d
