// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "drive/result.hpp"
#include "sim/polygon.hpp"

namespace hidwa_local_planner {
namespace study {

/// How steadily a robot got to its goal, by its commands. It stands while neither axis is asked for more than
/// kStandsBelow. What comes after it was first as near to its goal as it has to come does not count.
struct Passage {
  int stops = 0;               // how often it stood after it had moved
  double longest_stand = 0.0;  // [s], before it first moved too
  double standing = 0.0;       // [s], in all
};

constexpr double kStandsBelow = 0.01;  // [m/s, rad/s]

/// `goal` in the map's frame, `tolerance` [m]: how near it has to come. Needs the drive's samples.
Passage passage_of(const drive::DriveResult& drive, const sim::Pose& goal, double tolerance);

}  // namespace study
}  // namespace hidwa_local_planner
