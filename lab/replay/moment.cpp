// SPDX-License-Identifier: BSD-3-Clause
#include "moment.hpp"

#include <cmath>

#include "core/util/words.hpp"

namespace hidwa_local_planner {
namespace replay {
namespace {

const std::string kRosTime = "ros:";

}  // namespace

std::optional<Moment> moment_of(const std::string& text) {
  Moment moment;
  moment.ros_time = text.compare(0, kRosTime.size(), kRosTime) == 0;
  const std::optional<double> seconds = number_in(moment.ros_time ? text.substr(kRosTime.size()) : text);
  if (!seconds) return std::nullopt;
  moment.seconds = *seconds;
  return moment;
}

void MomentSearch::Nearest::see(double candidate, double wanted) {
  if (!time || std::abs(candidate - wanted) < std::abs(*time - wanted)) time = candidate;
}

bool MomentSearch::Nearest::hits(double wanted) const { return time && std::abs(*time - wanted) <= 1.0; }

void MomentSearch::see(double time) {
  if (!first_) first_ = time;
  last_ = time;
  since_first_.see(time, since_first());
  ros_time_.see(time, wanted_.seconds);
}

std::optional<double> MomentSearch::found() const {
  if (!wanted_.ros_time && first_ && since_first_.hits(since_first())) return since_first_.time;
  if (ros_time_.hits(wanted_.seconds)) return ros_time_.time;
  return std::nullopt;
}

std::string MomentSearch::remark() const {
  if (!first_) return "no cycle can be repeated: record with record_cycles: true";
  const std::optional<double> meant = found();
  if (!meant) {
    return format(
        "there is no cycle at %.3f s; they go from 0 to %.3f s since the first record, which is ROS time %.3f to %.3f, "
        "with gaps where input was missing",
        wanted_.seconds, last_ - *first_, *first_, last_);
  }
  if (ros_time_.hits(wanted_.seconds) && *ros_time_.time != *meant) {
    return format("the time counts from the first record; for the cycle at this ROS time give --at ros:%.3f",
                  wanted_.seconds);
  }
  return "";
}

}  // namespace replay
}  // namespace hidwa_local_planner
