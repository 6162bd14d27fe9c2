// SPDX-License-Identifier: BSD-3-Clause
// Limits and outline out of the URDF on the parameter server.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <future>

#include <gtest/gtest.h>
#include <hidwa_local_planner/Evaluation.h>

#include "change.hpp"
#include "stage.hpp"

namespace hidwa_plugin_tests {
namespace {

std::string ns(const std::string& name) { return ros::this_node::getName() + "/" + name + "/"; }

std::string wheel(const std::string& side, const std::string& y, const std::string& limit, const std::string& tyre) {
  return "<joint name='" + side + "_wheel_joint' type='continuous'><parent link='base_link'/><child link='" + side +
         "_wheel'/><origin xyz='0 " + y + " 0.1'/><axis xyz='0 1 0'/>" + limit + "</joint><link name='" + side +
         "_wheel'><collision><origin rpy='1.5707963 0 0'/><geometry>" + tyre + "</geometry></collision></link>";
}

/// Wheels of 0.1 m, 0.4 m apart, at most `velocity` [rad/s]; as many digits as an XML file has.
std::string urdf(const std::string& velocity, const std::string& tyre = "<cylinder radius='0.1' length='0.04'/>") {
  const std::string limit = velocity.empty() ? "" : "<limit effort='6' velocity='" + velocity + "'/>";
  return "<robot name='r'><link name='base_link'/>" + wheel("left", "0.2", limit, tyre) +
         wheel("right", "-0.2", limit, tyre) + "</robot>";
}

/// Puts a URDF where the planner `name` will look for it.
void describe(const std::string& name, const std::string& text) {
  ros::param::set("/" + name + "_urdf", text);
  ros::param::set(ns(name) + "robot_description_param", name + "_urdf");
}

bool reaches(Host& host, double speed) {
  return host.cycle_until([&](const Host::Cycle& c) { return std::abs(c.command.linear.x - speed) < 1e-6; });
}

TEST(RobotDescription, ATighterUrdfHoldsInEverySampleAndCommand) {
  const LogListener log;
  describe("Tight", urdf("2.0"));
  Host host("Tight");
  ros::NodeHandle node("~/Tight");
  std::mutex mutex;
  hidwa_local_planner::Evaluation evaluation;
  const ros::Subscriber subscriber = node.subscribe<hidwa_local_planner::Evaluation>(
      "evaluation", 1, [&](const hidwa_local_planner::Evaluation::ConstPtr& message) {
        const std::lock_guard<std::mutex> lock(mutex);
        evaluation = *message;
      });
  ASSERT_TRUE(host.plan_ahead(6.0));
  ASSERT_TRUE(reaches(host, 0.2)) << host.report().fault;  // 0.1 m x 2 rad/s
  ASSERT_TRUE(host.cycle_until([&](const Host::Cycle&) {
    const std::lock_guard<std::mutex> lock(mutex);
    return !evaluation.twists.empty();
  }));
  double fastest = 0.0, turn = 0.0;
  {
    const std::lock_guard<std::mutex> lock(mutex);
    for (const hidwa_local_planner::TrajectoryScore& twist : evaluation.twists) {
      const double v = std::abs(twist.traj.velocity.linear.x);
      const double omega = std::abs(twist.traj.velocity.angular.z);
      EXPECT_LE(v + omega * 0.2, 0.2 + 1e-6);
      fastest = std::max(fastest, v);
      turn = std::max(turn, omega);
    }
  }
  EXPECT_NEAR(fastest, 0.2, 1e-6);
  EXPECT_NEAR(turn, 1.0, 0.05);  // 2 x 0.2 / 0.4 = 1 rad/s
  EXPECT_TRUE(wait_for([&] { return log.said("_wheel_joint allows 0.2 m/s and holds: max_vel_x 0.5 m/s is more"); }));
  // What the parameters say stays theirs.
  EXPECT_EQ(ros::param::param(ns("Tight") + "max_vel_x", 0.0), 0.5);
  EXPECT_EQ(ros::param::param(ns("Tight") + "max_wheel_speed", -1.0), 0.0);

  // A change of parameters loses nothing, and may restrict further.
  ASSERT_TRUE(Change().set("max_vel_x", 0.45).send(host));
  for (int i = 0; i < 20; ++i) EXPECT_LE(host.cycle().command.linear.x, 0.2 + 1e-9);
  ASSERT_TRUE(Change().set("max_wheel_speed", 0.1).send(host));
  EXPECT_TRUE(reaches(host, 0.1));
  EXPECT_EQ(log.times("max_vel_x 0.5 m/s is more"), 1);
  EXPECT_EQ(log.times("allows 0.2 m/s and holds: max_vel_x 0.45 m/s"), 0);  // still the same side
}

TEST(RobotDescription, WithoutALimitTheParametersHold) {
  const LogListener log;
  describe("Unlimited", urdf(""));
  Host host("Unlimited");
  ASSERT_TRUE(host.plan_ahead(6.0));
  EXPECT_TRUE(reaches(host, 0.5)) << host.report().fault;
  EXPECT_TRUE(wait_for([&] { return log.said("have no <limit velocity>: the limits of the parameters hold"); }));
}

TEST(RobotDescription, AnAbsurdLimitIsHeldByTheParametersAndSaidOnce) {
  const LogListener log;
  describe("Absurd", urdf("100"));
  Host host("Absurd");
  ASSERT_TRUE(host.plan_ahead(6.0));
  EXPECT_TRUE(reaches(host, 0.5)) << host.report().fault;
  EXPECT_TRUE(wait_for([&] { return log.said("left_wheel_joint allows 10 m/s, max_vel_x 0.5 m/s holds"); }));
  EXPECT_EQ(log.times("max_vel_x 0.5 m/s holds"), 1);
}

/// A URDF that cannot be used, and what is to be said of it.
struct BrokenUrdf {
  const char* name;
  std::string text;
  const char* fault;
};

class ABrokenUrdf : public ::testing::TestWithParam<BrokenUrdf> {};

TEST_P(ABrokenUrdf, IsSaidOnceAndTheParametersHold) {
  const LogListener log;
  const std::string name = std::string("With") + GetParam().name;
  describe(name, GetParam().text);
  Host host(name);
  ASSERT_TRUE(host.plan_ahead(6.0));
  EXPECT_TRUE(reaches(host, 0.5)) << host.report().fault;
  EXPECT_TRUE(wait_for([&] { return log.said(GetParam().fault); })) << GetParam().fault;
  EXPECT_EQ(log.times(name + ": " + name + "_urdf: "), 1);
  EXPECT_EQ(log.times("; the parameters' limits hold"), 1);
}

INSTANTIATE_TEST_SUITE_P(
    All, ABrokenUrdf,
    ::testing::Values(BrokenUrdf{"BadXml", "<robot name='r'><link", "is not a valid URDF"},
                      BrokenUrdf{"NoText", "", "is not a valid URDF"},
                      BrokenUrdf{"BadLimit", urdf("fast"), "left_wheel_joint"},
                      BrokenUrdf{"ZeroVelocity", urdf("0"), "left_wheel_joint: <limit velocity> is 0 rad/s"},
                      BrokenUrdf{"ZeroRadius", urdf("2", "<cylinder radius='0' length='0.04'/>"),
                                 "left_wheel_joint: its link left_wheel has a radius of 0 m"},
                      BrokenUrdf{"Mesh", urdf("2", "<mesh filename='package://r/tyre.stl'/>"), "set max_wheel_speed"}),
    [](const auto& broken) { return std::string(broken.param.name); });

TEST(RobotDescription, MissingJointsAndParametersAreNamed) {
  const LogListener log;
  describe("Missing", urdf("2"));
  ros::param::set(ns("Missing") + "wheel_joints", "wheel_l, right_wheel_joint");
  Host missing("Missing");
  EXPECT_TRUE(wait_for([&] {
    return log.said(
        "wheel_l: there is no such joint (wheel_joints); those that turn freely are "
        "left_wheel_joint, right_wheel_joint");
  }));
  ros::param::set(ns("Nowhere") + "robot_description_param", "no_such_urdf");
  Host nowhere("Nowhere");
  EXPECT_TRUE(
      wait_for([&] { return log.said("no_such_urdf: there is no such parameter: correct robot_description_param"); }));
  ros::param::set("/number_urdf", 5);
  ros::param::set(ns("Number") + "robot_description_param", "number_urdf");
  Host number("Number");
  EXPECT_TRUE(wait_for([&] { return log.said("/number_urdf is no text"); }));
  ros::param::set(ns("Illegal") + "robot_description_param", "no name!");
  Host illegal("Illegal");
  ASSERT_TRUE(illegal.plan_ahead(6.0));
  EXPECT_TRUE(reaches(illegal, 0.5)) << illegal.report().fault;
}

TEST(RobotDescription, AnEmptyNameTurnsItOff) {
  const LogListener log;
  ros::param::set("robot_description", urdf("2"));
  ros::param::set(ns("Off") + "robot_description_param", "");
  {
    Host host("Off");
    ASSERT_TRUE(host.plan_ahead(6.0));
    EXPECT_TRUE(reaches(host, 0.5)) << host.report().fault;
  }
  Host host("Default");
  ASSERT_TRUE(host.plan_ahead(6.0));
  EXPECT_TRUE(reaches(host, 0.2)) << host.report().fault;
  ros::param::del("robot_description");
}

TEST(RobotDescription, ItsGeometryIsTheOutlineOfACostmapThatHasNone) {
  const LogListener log;
  Stage& stage = Stage::get();
  costmap_2d::Costmap2DROS bare("bare_costmap", stage.tf);
  const auto before = stage.costmap->getUnpaddedRobotFootprint();
  pluginlib::ClassLoader<nav_core::BaseLocalPlanner> loader("nav_core", "nav_core::BaseLocalPlanner");
  const auto planner = loader.createInstance("hidwa_local_planner/HIDWAPlannerROS");
  std::string text;
  ASSERT_TRUE(ros::param::get("~demo_urdf", text));
  describe("Outlined", text);
  ros::param::set(ns("Outlined") + "footprint_from_urdf", true);
  planner->initialize("Outlined", &stage.tf, &bare);
  // A body of 0.275 m, corners 0.5 % farther out: 0.275 / cos(pi / 32) = 0.2763 m.
  const auto points = bare.getUnpaddedRobotFootprint();
  ASSERT_GE(points.size(), 12u);
  for (const geometry_msgs::Point& point : points) EXPECT_NEAR(std::hypot(point.x, point.y), 0.2763, 1e-3);
  EXPECT_TRUE(wait_for([&] { return log.said("the URDF's collision geometry is taken"); }));

  // A costmap with a radius of its own keeps it.
  describe("Kept", text);
  Host host("Kept");
  EXPECT_EQ(stage.costmap->getUnpaddedRobotFootprint().size(), before.size());
  EXPECT_NEAR(std::hypot(before[0].x, before[0].y), 0.25, 1e-9);
}

TEST(RobotDescription, ItsGeometryIsLeftAloneUnlessItIsAskedFor) {
  const LogListener log;
  Stage& stage = Stage::get();
  costmap_2d::Costmap2DROS bare("bare_costmap", stage.tf);
  pluginlib::ClassLoader<nav_core::BaseLocalPlanner> loader("nav_core", "nav_core::BaseLocalPlanner");
  const auto planner = loader.createInstance("hidwa_local_planner/HIDWAPlannerROS");
  std::string text;
  ASSERT_TRUE(ros::param::get("~demo_urdf", text));
  describe("Unasked", text);
  planner->initialize("Unasked", &stage.tf, &bare);
  // costmap_2d's own circle where nothing is set.
  for (const geometry_msgs::Point& point : bare.getUnpaddedRobotFootprint()) {
    EXPECT_NEAR(std::hypot(point.x, point.y), 0.46, 1e-3);
  }
  EXPECT_TRUE(wait_for([&] { return log.said("footprint_from_urdf for the URDF's collision geometry"); }));
}

TEST(RobotDescription, TheOutlineIsReadUnderTheCostmapsLock) {
  Stage& stage = Stage::get();
  costmap_2d::Costmap2DROS bare("bare_costmap", stage.tf);
  pluginlib::ClassLoader<nav_core::BaseLocalPlanner> loader("nav_core", "nav_core::BaseLocalPlanner");
  const auto planner = loader.createInstance("hidwa_local_planner/HIDWAPlannerROS");
  std::future<void> made;
  {
    const boost::unique_lock<costmap_2d::Costmap2D::mutex_t> lock(*bare.getCostmap()->getMutex());
    made = std::async(std::launch::async, [&] { planner->initialize("Waiting", &stage.tf, &bare); });
    // As long as three take that do not wait.
    for (int i = 0; i < 3; ++i) const Host other("Meanwhile_" + std::to_string(i));
    EXPECT_EQ(made.wait_for(std::chrono::seconds(0)), std::future_status::timeout);
  }
  made.get();
}

TEST(RobotDescription, AnOutlineWithoutItsMeshesIsNotTaken) {
  const LogListener log;
  Stage& stage = Stage::get();
  costmap_2d::Costmap2DROS bare("bare_costmap", stage.tf);
  const auto before = bare.getUnpaddedRobotFootprint();
  pluginlib::ClassLoader<nav_core::BaseLocalPlanner> loader("nav_core", "nav_core::BaseLocalPlanner");
  const auto planner = loader.createInstance("hidwa_local_planner/HIDWAPlannerROS");
  ros::param::set(ns("Meshed") + "footprint_from_urdf", true);
  describe("Meshed", urdf("2", "<mesh filename='package://r/tyre.stl'/>"));
  planner->initialize("Meshed", &stage.tf, &bare);
  EXPECT_EQ(bare.getUnpaddedRobotFootprint().size(), before.size());
  EXPECT_TRUE(wait_for([&] { return log.said("the URDF gives no outline"); }));
}

}  // namespace
}  // namespace hidwa_plugin_tests

int main(int argc, char** argv) {
  ros::init(argc, argv, "robot_description_test");
  ros::NodeHandle node;
  ::testing::InitGoogleTest(&argc, argv);
  return RUN_ALL_TESTS();
}
