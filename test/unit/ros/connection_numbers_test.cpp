// SPDX-License-Identifier: BSD-3-Clause
#include "ros/connection_numbers.hpp"

#include <gtest/gtest.h>
#include <boost/make_shared.hpp>

namespace hidwa_local_planner {
namespace {

ConnectionNumbers::Header header() { return boost::make_shared<ros::M_string>(); }

// Two senders in turn: neither connects anew with each message.
TEST(ConnectionNumbers, SendersInTurnKeepTheirNumbers) {
  ConnectionNumbers numbers;
  const ConnectionNumbers::Header a = header(), b = header();
  for (int i = 0; i < 3; ++i) {
    EXPECT_EQ(numbers.of(a), 1U);
    EXPECT_EQ(numbers.of(b), 2U);
  }
  EXPECT_EQ(numbers.of(header()), 3U);
}

TEST(ConnectionNumbers, AHeaderOfNoLongerThanSixteenConnectionsAgoIsKnown) {
  ConnectionNumbers numbers;
  const ConnectionNumbers::Header first = header();
  EXPECT_EQ(numbers.of(first), 1U);
  for (std::size_t i = 1; i < ConnectionNumbers::kRemembered; ++i) numbers.of(header());
  EXPECT_EQ(numbers.of(first), 1U);
  numbers.of(header());  // the 17th
  EXPECT_EQ(numbers.of(first), 18U);
}

// One that ended, whose header nobody else holds, is not mistaken for one that begins.
TEST(ConnectionNumbers, EveryHeaderThatBeginsHasANewNumber) {
  ConnectionNumbers numbers;
  for (std::uint64_t i = 1; i <= 100; ++i) EXPECT_EQ(numbers.of(header()), i);
}

}  // namespace
}  // namespace hidwa_local_planner
