// SPDX-License-Identifier: BSD-3-Clause
#include "core/util/words.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace hidwa_local_planner {
namespace {

TEST(Words, ShortestLosesNothingAndHasNoDigitTooMany) {
  EXPECT_EQ(shortest(0.0), "0");
  EXPECT_EQ(shortest(0.1), "0.1");
  EXPECT_EQ(shortest(-2.5), "-2.5");
  EXPECT_EQ(shortest(100000.0), "100000");
  EXPECT_EQ(shortest(1.2345678), "1.2345678");
  EXPECT_EQ(shortest(0.1 + 0.2), "0.30000000000000004");
  for (const double number : {1.0 / 3.0, 1e-300, -std::numeric_limits<double>::max(), 5e-324}) {
    EXPECT_EQ(std::strtod(shortest(number).c_str(), nullptr), number);
  }
  EXPECT_EQ(shortest(std::numeric_limits<double>::quiet_NaN()), "nan");
}

TEST(Words, ANumberIsTheWholeText) {
  EXPECT_EQ(number_in("-2.5e1"), -25.0);
  for (const char* text : {"", "1 m", "m", "nan", "inf", "1e999"}) EXPECT_FALSE(number_in(text)) << text;
}

TEST(Words, WordedRounds) {
  EXPECT_EQ(worded(2.0 / 3.0), "0.6667");
  EXPECT_EQ(worded(0.4996, 3), "0.5");
}

TEST(Words, FixedKeepsItsDecimalsAndHasNoNegativeZero) {
  EXPECT_EQ(fixed(1.0, 3), "1.000");
  EXPECT_EQ(fixed(-0.001, 2), "0.00");
  EXPECT_EQ(fixed(-0.006, 2), "-0.01");
  EXPECT_EQ(fixed(-0.4, 0), "0");
}

TEST(Words, FormatHasNoLimit) {
  const std::string text(3000, 'x');
  EXPECT_EQ(format("%s is %.1f", text.c_str(), 0.25), text + " is 0.2");
  EXPECT_EQ(format("%s", ""), "");
}

TEST(Words, SplitAndJoined) {
  EXPECT_EQ(split("a,,b,", ','), (std::vector<std::string>{"a", "", "b", ""}));
  EXPECT_EQ(split("", ','), (std::vector<std::string>{""}));
  EXPECT_EQ(joined({"a", "b"}), "a, b");
}

}  // namespace
}  // namespace hidwa_local_planner
