// SPDX-License-Identifier: BSD-3-Clause
#include "core/evaluation/tie_rule.hpp"

#include <gtest/gtest.h>

namespace hidwa_local_planner {
namespace {

struct Preference {
  const char* why;
  Method method;
  Twist2 last, preferred, other;
};

// Accelerations 2.5 m/s^2 and 3.2 rad/s^2.
TEST(TieRule, OfTwoEqualCandidatesOneIsPreferred) {
  const Preference preferences[] = {
      {"it changes less: 0.1 / 2.5 = 0.04 s against 0.16 / 3.2 = 0.05 s",
       Method::hidwa,
       {0.3, 0.0},
       {0.2, 0.0},
       {0.3, 0.16}},
      {"both are 0.1 s away, and it turns less", Method::hidwa, {0.25, 0.32}, {0.25, 0.0}, {0.5, 0.32}},
      {"it is nearer to the last turn", Method::hidwa, {0.0, -0.1}, {0.0, -0.2}, {0.0, 0.2}},
      {"both are as near up to rounding, and it turns to the side of the last turn",
       Method::hidwa,
       {0.0, -1e-10},
       {0.0, -0.2},
       {0.0, 0.2}},
      {"nothing else is left, and it turns left", Method::hidwa, {0.3, 0.0}, {0.3, 0.2}, {0.3, -0.2}},
      {"it is slower, in the paper's method", Method::paper, {0.5, 1.0}, {0.1, 1.0}, {0.2, -1.0}},
      {"both are as slow, and it is further to the right", Method::paper, {0.5, 1.0}, {0.1, -0.5}, {0.1, 0.5}},
  };
  for (const Preference& preference : preferences) {
    SCOPED_TRACE(preference.why);
    Parameters p;
    p.method = preference.method;
    const TieRule rule(p, preference.last);
    EXPECT_TRUE(rule.prefers(preference.preferred, preference.other));
    EXPECT_FALSE(rule.prefers(preference.other, preference.preferred));
    EXPECT_FALSE(rule.prefers(preference.preferred, preference.preferred));
  }
}

}  // namespace
}  // namespace hidwa_local_planner
