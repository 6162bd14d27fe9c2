// SPDX-License-Identifier: BSD-3-Clause
// The whole process stands still for a while, as on a machine that is too busy, and the person steers all the time.
#include "person.hpp"

namespace hidwa_plugin_tests {
namespace {

using Pause = Operated;

TEST_F(Pause, IsNotHeldAgainstTheStick) {
  start();
  drive();
  person().left = 1.0f;
  ASSERT_TRUE(reaches("SHARED"));
  for (int i = 0; i < 3; ++i) {
    Stage::get().skip(0.9);  // input_timeout is 0.5 s
    // Odometry and transforms are old at first, so a cycle may brake or fail; that is not looked at here.
    all_cycles([](const Host::Cycle&) { return true; }, 0.8);
    EXPECT_EQ(state().state_name, "SHARED");  // without having let go of the stick
  }
  for (const OperatorState& told : person().states()) EXPECT_NE(told.state_name, "LOST");
}

}  // namespace
}  // namespace hidwa_plugin_tests

int main(int argc, char** argv) {
  ros::init(argc, argv, "pause_test");
  ros::NodeHandle node;
  ::testing::InitGoogleTest(&argc, argv);
  return RUN_ALL_TESTS();
}
