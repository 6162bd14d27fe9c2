// SPDX-License-Identifier: BSD-3-Clause
#include "hidwa_local_planner/core/parameter_text.hpp"

#include <gtest/gtest.h>

namespace hidwa_local_planner {
namespace {

TEST(ParameterText, ADoubleIsReadBackToTheSameBits) {
  for (const double value : {0.1, 1.0 / 3.0, 1e-300, -0.05, 12345678.9, 0.30000000000000004}) {
    Parameters p;
    p.sim_time = value;
    Parameters other;
    EXPECT_TRUE(set_lines(other, to_lines(p)).empty());
    EXPECT_EQ(other.sim_time, value);
  }
  EXPECT_EQ(to_text(0.1), "0.1");
  EXPECT_EQ(to_text(true), "true");
  EXPECT_EQ(to_text(40), "40");
}

TEST(ParameterText, LinesHoldEveryParameterOfEveryKind) {
  Parameters p;
  p.method = Method::paper;
  p.unknown_is_obstacle = false;
  p.vx_samples = 7;
  p.critics = "PathDist,\n GoalDist \\n";  // a YAML text may have lines of its own
  Parameters other;
  EXPECT_TRUE(set_lines(other, to_lines(p)).empty());
  for (const ParameterInfo& info : parameter_table()) {
    EXPECT_EQ(get_parameter(other, info.name), get_parameter(p, info.name)) << info.name;
  }
}

TEST(ParameterText, WhatCannotBeSetIsNamed) {
  Parameters p;
  EXPECT_EQ(set_parameter_text(p, "sim_tme", "1"), "there is no parameter 'sim_tme'");
  EXPECT_EQ(set_parameter_text(p, "sim_time", "1 s"), "sim_time needs a number, not '1 s'");
  EXPECT_EQ(set_parameter_text(p, "sim_time", "nan"), "sim_time needs a number, not 'nan'");
  EXPECT_EQ(set_parameter_text(p, "vx_samples", "2.5"), "vx_samples needs a whole number, not '2.5'");
  EXPECT_EQ(set_parameter_text(p, "record_cycles", "yes"), "record_cycles is true or false, not 'yes'");
  EXPECT_EQ(set_parameter_text(p, "method", "DWB"), "method: expected one of hidwa paper");
  EXPECT_EQ(set_lines(p, "nonsense\n"), (std::vector<std::string>{"'nonsense' is not of the form name=value"}));
}

}  // namespace
}  // namespace hidwa_local_planner
