// SPDX-License-Identifier: BSD-3-Clause
#include "ros/loop_time.hpp"

#include <mutex>

namespace hidwa_local_planner {
namespace {

std::int64_t steady_now() { return static_cast<std::int64_t>(ros::SteadyTime::now().toNSec()); }

}  // namespace

LoopTime LoopTime::now() {
  if (ros::Time::isSimTime()) {
    const ros::Time stamp = ros::Time::now();
    return {stamp.toSec(), stamp};
  }
  static std::mutex mutex;
  static ClockSettings settings;
  const std::lock_guard<std::mutex> lock(mutex);
  const std::int64_t before = steady_now();
  const ros::Time stamp = ros::Time::now();
  const std::int64_t back = settings.observe(before, static_cast<std::int64_t>(stamp.toNSec()), steady_now());
  const double ahead = 1e-9 * static_cast<double>(back);
  return {stamp.toSec() + ahead, stamp, ahead};
}

// Nobody knows when between the two readings the system's clock was read.
std::int64_t ClockSettings::observe(std::int64_t before, std::int64_t system, std::int64_t after) {
  const std::int64_t least = system - after, most = system - before;
  if (!first_) first_ = ahead_ = most;
  if (ahead_ < least - kLeast || ahead_ > most + kLeast) ahead_ = most;
  return *first_ - ahead_;
}

}  // namespace hidwa_local_planner
