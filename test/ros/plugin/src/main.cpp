// SPDX-License-Identifier: BSD-3-Clause
// Of each of the programs. Its launch file gives the node the program's name.
#include <gtest/gtest.h>
#include <ros/ros.h>

int main(int argc, char** argv) {
  ros::init(argc, argv, "plugin_test");
  const ros::NodeHandle node;
  ::testing::InitGoogleTest(&argc, argv);
  return RUN_ALL_TESTS();
}
