// SPDX-License-Identifier: BSD-3-Clause
#include "tracking/laser_choice.hpp"

#include <cmath>

#include "core/util/words.hpp"

namespace hidwa_local_planner {
namespace tracking {
namespace {

constexpr double kCoarse = 0.036;  // [rad], two degrees
constexpr double kBody = 0.5;      // width of a person [m]
constexpr double kPoints = 3.0;    // that a person must show

}  // namespace

std::string LaserChoice::fault(const std::string& frame, double now) {
  const bool counts = frame == frame_ || frame_.empty() || now < heard_ || now - heard_ > kSilent;
  if (!counts) {
    return "scans of two lasers come on one topic: those in " + frame_ + " are used, those in " + frame +
           " are not; give each laser a topic of its own, or merge their scans before they come here";
  }
  frame_ = frame;
  heard_ = now;
  return "";
}

std::string coarse(double increment) {
  const double angle = std::abs(increment);
  if (!(angle > kCoarse)) return "";
  return format(
      "the beams are %.1f degrees apart: people farther away than %.1f m are not seen; use a finer resolution of the "
      "laser",
      angle * 180.0 / M_PI, kBody / (kPoints * angle));
}

}  // namespace tracking
}  // namespace hidwa_local_planner
