// SPDX-License-Identifier: BSD-3-Clause
#include "core/autonomy/no_way_report.hpp"

#include <array>
#include <cstdio>

#include "core/autonomy/way_finder.hpp"
#include "core/util/elapsed.hpp"

namespace hidwa_local_planner {
namespace {

constexpr double kTellsAgain = 20.0;       // [s]
constexpr std::size_t kLongestText = 200;  // the memory of a text is taken once

}  // namespace

void NoWayReport::tell(const char* what) {
  problem_.reserve(kLongestText);
  problem_ = what;
}

void NoWayReport::tell(const char* what, const WaySearch::End& end) {
  std::array<char, kLongestText> said{};
  if (end.obstacle_known) {
    std::snprintf(said.data(), said.size(),
                  "%s: no farther than (%.2f, %.2f); nearest %s there %.3f m away, at (%.2f, %.2f)", what, end.pose.x,
                  end.pose.y, end.unknown ? "unknown cell" : "obstacle", end.gap, end.obstacle.x(), end.obstacle.y());
  } else {
    std::snprintf(said.data(), said.size(), "%s: no farther than (%.2f, %.2f)", what, end.pose.x, end.pose.y);
  }
  tell(said.data());
}

bool NoWayReport::tells_late(bool long_search, const Pose2& start, double now) {
  if (told_late_) problem_.clear();
  const bool due = elapsed(told_at_time_, kTellsAgain, now) || distance(told_at_, start) >= WayFinder::kSamePlace;
  told_late_ = long_search && problem_.empty() && due;
  if (told_late_) {
    told_at_time_ = now;
    told_at_ = start;
  }
  return told_late_;
}

}  // namespace hidwa_local_planner
