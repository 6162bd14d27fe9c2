// SPDX-License-Identifier: BSD-3-Clause
#include "tracking/laser_choice.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace hidwa_local_planner {
namespace tracking {
namespace {

TEST(LaserChoice, TheFirstLaserCountsAsLongAsItIsHeard) {
  LaserChoice choice;
  for (double now = 100.0; now < 110.0; now += 0.1) {
    EXPECT_EQ(choice.fault("front", now), "");
    const std::string rear = choice.fault("rear", now + 0.05);
    EXPECT_NE(rear.find("those in front are used, those in rear are not"), std::string::npos) << rear;
  }
}

TEST(LaserChoice, AnotherOneCountsOnceTheFirstIsSilent) {
  LaserChoice choice;
  EXPECT_EQ(choice.fault("front", 100.0), "");
  EXPECT_NE(choice.fault("rear", 100.0 + LaserChoice::kSilent), "");
  EXPECT_EQ(choice.fault("rear", 100.001 + LaserChoice::kSilent), "");
  EXPECT_NE(choice.fault("front", 101.5), "");
  EXPECT_EQ(choice.fault("front", 5.0), "");  // the clock was set back
}

// Three points of a body of 0.5 m: at 2.5 degrees, 0.0436 rad, that is 0.5 m / (3 x 0.0436) = 3.8 m.
TEST(LaserChoice, CoarseScansAreTold) {
  EXPECT_EQ(coarse(2.0 * M_PI / 180.0), "");
  EXPECT_EQ(coarse(-M_PI / 180.0), "");
  EXPECT_NE(coarse(2.5 * M_PI / 180.0).find("2.5 degrees apart: people farther away than 3.8 m"), std::string::npos);
  EXPECT_NE(coarse(-2.5 * M_PI / 180.0), "");
}

}  // namespace
}  // namespace tracking
}  // namespace hidwa_local_planner
