// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <string>

#include "core/util/words.hpp"
#include "tracking/range_scan.hpp"
#include "tracking/tracker_settings.hpp"

namespace hidwa_local_planner {
namespace {

bool says_something(const RangeScan& scan) {
  return std::any_of(scan.ranges.begin(), scan.ranges.end(),
                     [&scan](float r) { return r > 0.0F && static_cast<double>(r) >= scan.range_min; });
}

}  // namespace

std::string fault_of(const TrackerSettings& settings) {
  for (const TrackerSetting& one : kTrackerSettings) {
    const double value = settings.*one.value;
    if (!(value >= one.low && value <= one.high)) {  // also what is not a number
      return std::string(one.name) + " is " + (std::isfinite(value) ? worded(value, 6) : "not finite") +
             ": it must be from " + worded(one.low) + " to " + worded(one.high) + one.unit;
    }
  }
  return "";
}

std::string fault_of(const RangeScan& scan) {
  if (!std::isfinite(scan.stamp) || scan.stamp < 0.0) return "the stamp is not a time";
  if (!is_finite(scan.sensor) || !is_finite(scan.sensor_end)) return "the sensor's pose is not finite";
  if (scan.ranges.empty()) return "there are no ranges";
  if (!std::isfinite(scan.angle_min)) return "angle_min is not finite";
  const double width = scan.angle_increment * static_cast<double>(scan.ranges.size() - 1);
  if (!std::isfinite(width) || (scan.ranges.size() > 1 && scan.angle_increment == 0.0)) {
    return "angle_increment must be finite and not 0";
  }
  if (std::abs(width) > 2.0 * M_PI + 1.5 * std::abs(scan.angle_increment)) {
    return "angle_increment times the number of ranges is more than a turn";
  }
  if (!(scan.range_min >= 0.0 && scan.range_max > scan.range_min))
    return "range_max must be above range_min, and that not below 0";
  const double duration = scan.end() - scan.stamp;
  if (!(duration >= 0.0 && duration <= 2.0)) return "time_increment times the number of ranges must be from 0 to 2 s";
  if (!says_something(scan)) return "no range says anything: each is 0, below range_min or not a number";
  return "";
}

}  // namespace hidwa_local_planner
