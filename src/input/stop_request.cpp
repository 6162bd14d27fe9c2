// SPDX-License-Identifier: BSD-3-Clause
#include "hidwa_local_planner/input/stop_request.hpp"

namespace hidwa_local_planner::input {
namespace {

// A pull that has begun lasts until the stick has come back by a quarter: no flutter at the threshold.
constexpr double kStillPulled = 0.75;

}  // namespace

void StopRequest::take(const StickReading& reading, const Parameters& parameters) {
  button_ = reading.stop;
  const double threshold = parameters.stop_pull * (pulled_ ? kStillPulled : 1.0);
  const bool pulled = pull_stops(parameters) && static_cast<double>(-reading.linear) >= threshold;
  if (!pulled || !parameters.require_neutral) armed_ = true;
  pulled_ = pulled && armed_;
}

}  // namespace hidwa_local_planner::input
