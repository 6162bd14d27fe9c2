// SPDX-License-Identifier: BSD-3-Clause
#include "ros/handover.hpp"

#include <thread>

#include <gtest/gtest.h>

namespace hidwa_local_planner {
namespace {

TEST(Handover, TheNewestOnce) {
  Handover<int> handover;
  EXPECT_EQ(handover.take(), nullptr);
  handover.put(1);
  handover.put(2);
  const std::unique_ptr<int> taken = handover.take();
  ASSERT_NE(taken, nullptr);
  EXPECT_EQ(*taken, 2);
  EXPECT_EQ(handover.take(), nullptr);
}

TEST(Handover, BetweenThreadsEachValueIsTakenAtMostOnceAndInOrder) {
  constexpr int kLast = 100000;
  Handover<int> handover;
  std::thread giver([&] {
    for (int i = 1; i <= kLast; ++i) handover.put(i);
  });
  int newest = 0;
  while (newest < kLast) {
    const std::unique_ptr<int> taken = handover.take();
    if (!taken) continue;
    ASSERT_GT(*taken, newest);
    newest = *taken;
  }
  giver.join();
  EXPECT_EQ(handover.take(), nullptr);
}

}  // namespace
}  // namespace hidwa_local_planner
