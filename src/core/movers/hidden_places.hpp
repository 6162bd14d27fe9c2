// SPDX-License-Identifier: BSD-3-Clause
// Where somebody may stand unseen, and come out.
//
// An obstacle hides what is behind it. Seen from a sensor, the length of sight jumps at its edge: beside that line of
// sight, on the side of the shadow, somebody may stand. He comes out across the line. So such places lie along it, half
// a body beside it, and count where a body fits there and on the line (no wall is crossed), where the shadow is wide
// enough to hide one, and where one gets through beside the edge (no slit is passed). Who stands deeper in the shadow
// crosses the line later, and near to one of them.
//
// What is outside of all fields of view is another matter: see BlindMotion.
#pragma once

#include <cstddef>
#include <vector>

#include "hidwa_local_planner/core/grid_view.hpp"
#include "hidwa_local_planner/core/sensor_sector.hpp"
#include "hidwa_local_planner/core/types.hpp"

namespace hidwa_local_planner {

class HiddenPlaces {
 public:
  /// Whoever comes out is in a disc of this radius around one of the places until half of him is in view [m]: his
  /// middle is on the line then, hypot(0.2, half of the spacing) away; his body, and a cell.
  static constexpr double kRadius = 0.5;

  HiddenPlaces();
  /// Once a cycle: the places up to `reach` from the robot [m].
  void find(const GridView& grid, const Pose2& robot, const SensorSectors& sectors, double reach);
  void clear() { places_.clear(); }
  /// Costmap frame [m].
  const std::vector<Point>& all() const { return places_; }

 private:
  // What a sensor sees.
  struct View {
    Point from{0.0, 0.0};         // costmap frame [m]
    double middle = 0.0;          // of its field of view [rad]
    double half = 0.0;            // of its width [rad]
    double reach = 0.0;           // of places [m]
    double range = 0.0;           // of sight [m]
    std::vector<double> lengths;  // [bins] of sight [m]
  };
  void look(const GridView& grid, View& view) const;
  void find_beside(const GridView& grid, const View& view);
  bool lets_through(const View& view, std::size_t border, bool to_left, double length) const;
  void add_along(const GridView& grid, const View& view, double angle, double side, double from, double to);
  bool faces(const View& view, double bearing) const;
  bool hidden(const Point& point) const;
  static bool fits(const GridView& grid, const Point& middle);

  std::vector<View> views_;
  std::size_t view_count_ = 0;
  std::size_t bins_ = 0;
  double bin_ = 0.0;  // its width [rad]
  std::vector<Point> places_;
};

}  // namespace hidwa_local_planner
