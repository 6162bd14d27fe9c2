// SPDX-License-Identifier: BSD-3-Clause
#include "ros/horizon_check.hpp"

#include <gtest/gtest.h>

#include "core/motion/velocity_limits.hpp"

namespace hidwa_local_planner {
namespace {

Parameters with(double sim_time, double acc_lim_x, double min_vel_x) {
  Parameters p;
  p.sim_time = sim_time;
  p.acc_lim_x = acc_lim_x;
  p.min_vel_x = min_vel_x;
  return p;
}

// Of a robot of 0.3 m, whose other parameters are the defaults. The farthest that it gets is its fastest speed times
// sim_time, and its radius: 0.5 x 1.85 + 0.3 = 1.225 m. It rests after 0.5 / 2.5 + 0.1 = 0.3 s.
TEST(HorizonCheck, ReportsASmallMapAndAShortHorizon) {
  struct Row {
    const char* name;
    Parameters parameters;
    double width, height;            // of the map [m]
    std::vector<std::string> words;  // of the one complaint, if any
  };
  for (const Row& row :
       {Row{"a map of 4 m holds the defaults", Parameters(), 4.0, 4.0, {}},
        Row{"so does one of 2 x 1.23 m", Parameters(), 2.46, 2.46, {}},
        Row{"a map that is low reaches 1.1 m", Parameters(), 4.0, 2.2, {"reaches 1.10 m", "1.2"}},
        Row{"at 1 m/s^2 it rests after 0.5 + 0.1 s", with(0.5, 1.0, 0.0), 4.0, 4.0, {"0.60 s"}},
        Row{"backwards it gets 1.0 x 1.85 + 0.3 = 2.15 m", with(1.85, 2.5, -1.0), 4.2, 4.2, {"reaches 2.10 m"}}}) {
    SCOPED_TRACE(row.name);
    const Parameters& p = row.parameters;
    const std::vector<std::string> complaints =
        horizon_complaints(p, VelocityLimits::from(p).x, row.width, row.height, 0.30);
    ASSERT_EQ(complaints.size(), row.words.empty() ? 0u : 1u);
    for (const std::string& words : row.words) {
      EXPECT_NE(complaints[0].find(words), std::string::npos) << complaints[0];
    }
  }
}

}  // namespace
}  // namespace hidwa_local_planner
