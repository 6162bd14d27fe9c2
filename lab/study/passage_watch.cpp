// SPDX-License-Identifier: BSD-3-Clause
#include "study/passage_watch.hpp"

#include <algorithm>
#include <cmath>

namespace hidwa_local_planner {
namespace study {
namespace {

bool asks_for_rest(const Twist2& command) {
  return std::abs(command.v) < kStandsBelow && std::abs(command.omega) < kStandsBelow;
}

}  // namespace

Passage passage_of(const drive::DriveResult& drive, const sim::Pose& goal, double tolerance) {
  Passage passage;
  bool moved = false, stands = false;
  double since = 0.0;  // when it began to stand [s]
  const auto end_stand = [&](double now) {
    if (!stands) return;
    passage.longest_stand = std::max(passage.longest_stand, now - since);
    passage.standing += now - since;
    stands = false;
  };
  for (const drive::DriveSample& sample : drive.samples) {
    if (std::hypot(goal.x - sample.pose.x, goal.y - sample.pose.y) <= tolerance) {
      end_stand(sample.time);
      return passage;
    }
    if (!asks_for_rest(sample.command)) {
      end_stand(sample.time);
      moved = true;
    } else if (!stands) {
      stands = true;
      since = sample.time;
      if (moved) ++passage.stops;
    }
  }
  end_stand(drive.duration);
  return passage;
}

}  // namespace study
}  // namespace hidwa_local_planner
