// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <costmap_2d/costmap_2d.h>
#include <geometry_msgs/Point.h>
#include <geometry_msgs/Transform.h>
#include <sensor_msgs/LaserScan.h>

#include <vector>

namespace costmap_2d {

/// Which beams of a scan become points.
struct ScanFilter {
  double min_height = 0.0;    // [m] in the global frame
  double max_height = 2.0;    // [m] in the global frame
  bool inf_is_valid = false;  // an infinite range is free space up to range_max
};

/// One scan in the costmap's frame.
struct Observation {
  geometry_msgs::Point origin;               // of the sensor [m]
  std::vector<geometry_msgs::Point> points;  // beam ends [m]
  double obstacle_range = 2.5;               // [m] no marking from here on
  double raytrace_range = 3.0;               // [m] clearing up to here
};

/// An area [m] that only grows.
struct TouchedArea {
  double* min_x;
  double* min_y;
  double* max_x;
  double* max_y;

  void add(double x, double y) const;
};

/// The scan's valid beam ends, brought into the frame of `sensor_pose`.
std::vector<geometry_msgs::Point> projectScan(const sensor_msgs::LaserScan& scan,
                                              const geometry_msgs::Transform& sensor_pose,
                                              const ScanFilter& filter);

/// Frees the cells on each beam, at most raytrace_range from the sensor, beam end included. A beam that
/// leaves the map is followed to its edge; a sensor outside the map clears nothing (false).
bool clearBeams(Costmap2D& grid, const Observation& observation, const TouchedArea& touched);

/// Makes lethal the cell of each beam end nearer than obstacle_range and no higher than max_height [m].
void markPoints(Costmap2D& grid, const Observation& observation, double max_height,
                const TouchedArea& touched);

/// Combines two grids of equal geometry in cells min_i <= x < max_i, min_j <= y < max_j: the greater cost
/// wins, what the source does not know stays, what the target does not know is taken.
void mergeMaximum(Costmap2D& target, const Costmap2D& source, int min_i, int min_j, int max_i, int max_j);
/// The same, but wherever the source knows something it wins.
void mergeOverwrite(Costmap2D& target, const Costmap2D& source, int min_i, int min_j, int max_i, int max_j);

}  // namespace costmap_2d
