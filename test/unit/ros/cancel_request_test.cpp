// SPDX-License-Identifier: BSD-3-Clause
#include "ros/host/cancel_request.hpp"

#include <gtest/gtest.h>

namespace hidwa_local_planner {
namespace {

TEST(CancelRequest, LastsUntilItIsMet) {
  CancelRequest cancel;
  EXPECT_FALSE(cancel.pending(10.0));
  cancel.request(10.01);
  EXPECT_TRUE(cancel.pending(10.05));
  EXPECT_TRUE(cancel.pending(10.10));
  cancel.met();
  EXPECT_FALSE(cancel.pending(10.15));
}

TEST(CancelRequest, APlanMeanwhileDoesNotEndIt) {
  CancelRequest cancel;
  EXPECT_FALSE(cancel.pending(10.0));
  cancel.request(10.01);
  cancel.plan_arrives(10.05);
  EXPECT_TRUE(cancel.pending(10.05));
  // Nor one after a request that came before the first cycle.
  cancel.met();
  cancel.request(20.0);
  cancel.plan_arrives(20.02);
  EXPECT_TRUE(cancel.pending(20.02));
}

TEST(CancelRequest, LongBrakingIsNoSilence) {
  CancelRequest cancel;
  cancel.request(10.0);
  for (double now = 10.5; now < 13.1; now += 0.5) EXPECT_TRUE(cancel.pending(now));
  cancel.plan_arrives(13.5);  // 3.5 s after the request, 0.5 s after the last cycle
  EXPECT_TRUE(cancel.pending(13.5));
}

TEST(CancelRequest, APlanAfterASilenceIsAnotherOnes) {
  CancelRequest cancel;
  EXPECT_FALSE(cancel.pending(10.0));
  cancel.request(10.01);
  cancel.plan_arrives(11.5);  // 1.49 s of silence
  EXPECT_FALSE(cancel.pending(11.5));
}

}  // namespace
}  // namespace hidwa_local_planner
