// SPDX-License-Identifier: BSD-3-Clause
#include "tracking/told_obstacles.hpp"

#include "hidwa_local_planner/tracking/tracker.hpp"

namespace hidwa_local_planner {
namespace tracking {

struct TellingTracker::Held {
  Tracker tracker;
};

TellingTracker::TellingTracker(const TrackerSettings& settings) : held_(new Held{Tracker(settings)}) {}
TellingTracker::~TellingTracker() = default;

ScanUse TellingTracker::update(const RangeScan& scan) { return held_->tracker.update(scan); }
double TellingTracker::stamp() const { return held_->tracker.stamp(); }
std::size_t TellingTracker::candidates() const { return held_->tracker.candidates(); }

std::vector<ToldObstacle> TellingTracker::obstacles() const {
  std::vector<ToldObstacle> told;
  for (const auto& o : held_->tracker.obstacles()) {
    told.push_back({o.id, o.position, o.velocity, o.radius, o.position_deviation, o.velocity_deviation, o.points});
  }
  return told;
}

}  // namespace tracking
}  // namespace hidwa_local_planner
