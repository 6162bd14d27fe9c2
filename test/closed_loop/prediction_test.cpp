// SPDX-License-Identifier: BSD-3-Clause
// How well the robot is predicted to those who watch: what was said in each cycle, against where the robot was then.
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "control/prediction.hpp"
#include "drive/drive.hpp"
#include "support/office.hpp"

namespace hidwa_local_planner::test {
namespace {

using control::NextMove;
using control::Prediction;
using control::TimedPose;

struct Said {
  double time = 0.0;  // of the drive [s]
  Pose2 pose;         // of the robot then, odometry's frame
  std::vector<TimedPose> poses;
  NextMove next = NextMove::stop;
  std::string reason;
};

std::vector<Said> watched_drive() {
  std::vector<Said> all;
  Prediction prediction;
  const drive::DriveResult result = drive::drive(office(), [&](const drive::Cycle& cycle) {
    prediction.update(cycle.loop, cycle.observation, cycle.result);
    all.push_back({cycle.time, cycle.observation.pose, prediction.poses(), prediction.next(), prediction.reason()});
  });
  EXPECT_TRUE(result.arrived);
  return all;
}

// Errors of what was said `ahead` [s] before, sorted [m]. Cycles are 0.05 s apart.
std::vector<double> errors(const std::vector<Said>& all, double ahead) {
  const auto cycles = static_cast<std::size_t>(std::lround(ahead / 0.05));
  const auto step = static_cast<std::size_t>(std::lround(ahead / Prediction::kStep));
  std::vector<double> found;
  for (std::size_t k = 0; k + cycles < all.size(); ++k) {
    if (all[k].poses.size() <= step) continue;
    EXPECT_NEAR(all[k].poses[step].time, ahead, 1e-9);
    found.push_back(distance(all[k].poses[step].pose, all[k + cycles].pose));
  }
  std::sort(found.begin(), found.end());
  return found;
}

double quantile(const std::vector<double>& sorted, double share) {
  return sorted[static_cast<std::size_t>(share * static_cast<double>(sorted.size() - 1))];
}

TEST(Prediction, IsNearTheTruthThroughTheOffice) {
  const std::vector<Said> all = watched_drive();
  ASSERT_GT(all.size(), 1000u);
  const struct {
    double ahead, median, most;  // [s, m, m]: half and 95 % of the errors are smaller
  } bounds[] = {{1.0, 0.02, 0.06}, {2.0, 0.04, 0.20}, {3.0, 0.06, 0.25}};
  for (const auto& bound : bounds) {
    const std::vector<double> found = errors(all, bound.ahead);
    ASSERT_GT(found.size(), 9 * all.size() / 10) << bound.ahead;
    EXPECT_LT(quantile(found, 0.5), bound.median) << bound.ahead;
    EXPECT_LT(quantile(found, 0.95), bound.most) << bound.ahead;
    RecordProperty("median_" + std::to_string(bound.ahead), std::to_string(quantile(found, 0.5)));
    RecordProperty("p95_" + std::to_string(bound.ahead), std::to_string(quantile(found, 0.95)));
  }
}

// Where a turn to a side is said, the robot turns there: by 5 degrees at least, three seconds later.
TEST(Prediction, TurnsComeAsTheyAreSaid) {
  const std::vector<Said> all = watched_drive();
  int said = 0, came = 0;
  for (std::size_t k = 0; k + 60 < all.size(); ++k) {
    if (all[k].next != NextMove::left && all[k].next != NextMove::right) continue;
    const double turn = wrap_angle(all[k + 60].pose.theta - all[k].pose.theta);
    ++said;
    came += (all[k].next == NextMove::left ? turn : -turn) > 0.09 ? 1 : 0;
  }
  EXPECT_GT(said, 200);
  EXPECT_GT(came, 95 * said / 100);
}

TEST(Prediction, SaysThatItComesToTheGoal) {
  const std::vector<Said> all = watched_drive();
  const auto stop = std::find_if(all.begin(), all.end(), [](const Said& said) { return said.next == NextMove::stop; });
  ASSERT_NE(stop, all.end());
  EXPECT_EQ(stop->reason, "it comes to the goal");
  EXPECT_GT(all.back().time - stop->time, 1.0);
  EXPECT_LT(all.back().time - stop->time, 10.0);
}

}  // namespace
}  // namespace hidwa_local_planner::test
