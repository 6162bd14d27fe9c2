// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "drive/drive.hpp"
#include "study/setting.hpp"

namespace hidwa_local_planner {
namespace study {

/// Who drives through a gap, and what it knows of it.
struct GapSubject {
  Subject subject;
  double resolution = 0.05;  // of the local costmap [m]
  double padding = 0.01;     // of the footprint [m]
  double noise = 0.01;       // standard deviation of a laser's range [m]
};

/// As assign(), and costmap.resolution, costmap.footprint_padding, laser.noise. Throws UsageError.
void assign_gap(GapSubject& subject, const Assignment& assignment);

/// The outlines that drive through gaps: circle (radius 0.30 m), square (0.5 m), long (0.9 m x 0.4 m).
const std::vector<std::string>& gap_outlines();
/// How wide one of them is, without its padding [m].
double width_of(const std::string& outline);

/// A drive along the x axis through a gap of `width` [m] in a wall of 0.2 m. `phase`, 0 to 1: by which part of a cell
/// the gap's middle is beside a corner of the costmap's cells.
drive::DriveResult drive_gap(const GapSubject& subject, const std::string& outline, double width, double phase,
                             std::uint64_t seed);

/// The narrowest gap that it gets through, to a centimetre, as bisection finds it: between its own width and one that
/// it gets through.
struct Narrowest {
  double width = 0.0;  // [m]
  int drives = 0;      // that it took
  drive::DriveResult result;
};
Narrowest narrowest_gap(const GapSubject& subject, const std::string& outline, double phase, std::uint64_t seed);

}  // namespace study
}  // namespace hidwa_local_planner
