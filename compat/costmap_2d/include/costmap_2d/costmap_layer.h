// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <costmap_2d/costmap_2d.h>
#include <costmap_2d/layer.h>

namespace costmap_2d {

/// A layer that keeps a grid of its own, as large as the master grid. Whoever changes that grid from outside holds the
/// master grid's mutex.
class CostmapLayer : public Layer, public Costmap2D {
 public:
  void matchSize() override;

  /// Forgets the cells outside start < cell < end on both axes or, with `invert_area`, those inside.
  virtual void clearArea(int start_x, int start_y, int end_x, int end_y, bool invert_area = false);
  /// The next update rewrites this area [m, global frame] too.
  void addExtraBounds(double mx0, double my0, double mx1, double my1);

 protected:
  /// Widens an update's area to what addExtraBounds() was told, once.
  void useExtraBounds(double* min_x, double* min_y, double* max_x, double* max_y);

 private:
  struct Bounds {
    double min_x, min_y, max_x, max_y;  // [m]
  };
  static const Bounds kNowhere;
  Bounds extra_ = kNowhere;
};

}  // namespace costmap_2d
