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
#include "unit/robot/urdf_texts.hpp"

namespace hidwa_plugin_tests {
namespace {

namespace robot = hidwa_local_planner::robot;

/// Wheels of 0.1 m, 0.4 m apart, at most `velocity` [rad/s]; as many digits as an XML file has.
std::string urdf(const std::string& velocity, const std::string& wheel = robot::tyre("0.1")) {
  const std::string limit = velocity.empty() ? "" : robot::limit_text(velocity);
  return "<robot name='r'><link name='base_link'/>" + robot::wheel_text("left", "0", "0.2", limit, wheel) +
         robot::wheel_text("right", "0", "-0.2", limit, wheel) + "</robot>";
}

/// Puts a URDF where the planner `name` will look for it.
void describe(const std::string& name, const std::string& text) {
  ros::param::set("/" + name + "_urdf", text);
  ros::param::set(ns(name) + "robot_description_param", name + "_urdf");
}

bool reaches(Host& host, double speed) {
  return host.cycle_until([&](const Host::Cycle& c) { return std::abs(c.command.linear.x - speed) < 1e-6; });
}

/// Whether it drives at the full speed of the parameters.
bool drives_at_full_speed(Host& host) { return host.plan_ahead(6.0) && reaches(host, 0.5); }

TEST(RobotDescription, ATighterUrdfHoldsInEverySampleAndCommand) {
  const LogListener log;
  describe("Tight", urdf("2.0"));
  Host host("Tight");
  ASSERT_TRUE(host.plan_ahead(6.0));
  ASSERT_TRUE(reaches(host, 0.2)) << host.report().fault;  // 0.1 m x 2 rad/s
  const Messages<hidwa_local_planner::Evaluation> evaluations(ns("Tight") + "evaluation");
  ASSERT_TRUE(host.cycle_until([&](const Host::Cycle&) { return !evaluations.newest().twists.empty(); }));
  const hidwa_local_planner::Evaluation evaluation = evaluations.newest();
  double fastest = 0.0, turn = 0.0;
  for (const hidwa_local_planner::TrajectoryScore& twist : evaluation.twists) {
    const double v = std::abs(twist.traj.velocity.linear.x);
    const double omega = std::abs(twist.traj.velocity.angular.z);
    EXPECT_LE(v + omega * 0.2, 0.2 + 1e-6);
    fastest = std::max(fastest, v);
    turn = std::max(turn, omega);
  }
  EXPECT_NEAR(fastest, 0.2, 1e-6);
  EXPECT_NEAR(turn, 1.0, 0.05);  // 2 x 0.2 / 0.4 = 1 rad/s
  EXPECT_TRUE(wait_for([&] { return log.said("_joint allows 0.2 m/s and holds: max_vel_x 0.5 m/s is more"); }));
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

/// A URDF that sets no limit, and what is to be said of it.
struct UrdfWithoutLimit {
  const char* name;
  std::string text;
  const char* words;
};

class AUrdfWithoutLimit : public ::testing::TestWithParam<UrdfWithoutLimit> {};

TEST_P(AUrdfWithoutLimit, IsSaidOnceAndTheParametersHold) {
  const LogListener log;
  const std::string name = GetParam().name;
  describe(name, GetParam().text);
  Host host(name);
  EXPECT_TRUE(drives_at_full_speed(host)) << host.report().fault;
  EXPECT_TRUE(wait_for([&] { return log.said(GetParam().words); })) << GetParam().words;
  EXPECT_EQ(log.times(GetParam().words), 1);
}

// Texts of robot/ that each come by another way.
INSTANTIATE_TEST_SUITE_P(
    All, AUrdfWithoutLimit,
    ::testing::Values(
        UrdfWithoutLimit{"Unlimited", urdf(""), "have no <limit velocity>: the limits of the parameters hold"},
        UrdfWithoutLimit{"Absurd", urdf("100"), "left_joint allows 10 m/s, max_vel_x 0.5 m/s holds"},
        UrdfWithoutLimit{"BadXml", "<robot name='r'><link", "BadXml_urdf: it is not a valid URDF"},
        UrdfWithoutLimit{"ZeroRadius", urdf("2", robot::tyre("0")), "left_joint: its link left has a radius of 0 m"},
        UrdfWithoutLimit{"Mesh", urdf("2", "<mesh filename='package://r/tyre.stl'/>"), "set max_wheel_speed"}),
    [](const auto& urdf) { return std::string(urdf.param.name); });

TEST(RobotDescription, MissingJointsAndParametersAreNamed) {
  const LogListener log;
  describe("Missing", urdf("2"));
  ros::param::set(ns("Missing") + "wheel_joints", "wheel_l, right_joint");
  const Host missing("Missing");
  EXPECT_TRUE(wait_for([&] {
    return log.said(
        "wheel_l: there is no such joint (wheel_joints); those that turn freely are left_joint, right_joint");
  }));
  ros::param::set(ns("Nowhere") + "robot_description_param", "no_such_urdf");
  const Host nowhere("Nowhere");
  EXPECT_TRUE(
      wait_for([&] { return log.said("no_such_urdf: there is no such parameter: correct robot_description_param"); }));
  ros::param::set("/number_urdf", 5);
  ros::param::set(ns("Number") + "robot_description_param", "number_urdf");
  const Host number("Number");
  EXPECT_TRUE(wait_for([&] { return log.said("/number_urdf is no text"); }));
  ros::param::set(ns("Illegal") + "robot_description_param", "no name!");
  Host illegal("Illegal");
  EXPECT_TRUE(drives_at_full_speed(illegal)) << illegal.report().fault;
}

TEST(RobotDescription, AnEmptyNameTurnsItOff) {
  ros::param::set("robot_description", urdf("2"));
  ros::param::set(ns("Off") + "robot_description_param", "");
  {
    Host host("Off");
    EXPECT_TRUE(drives_at_full_speed(host)) << host.report().fault;
  }
  Host host("Default");
  ASSERT_TRUE(host.plan_ahead(6.0));
  EXPECT_TRUE(reaches(host, 0.2)) << host.report().fault;
  ros::param::del("robot_description");
}

/// A costmap with neither footprint nor radius, and a planner that is given it.
class OutlineOfTheUrdf : public ::testing::Test {
 protected:
  void initialize(const std::string& name) { planner_->initialize(name, &Stage::get().tf, &bare_); }
  static std::string demo_urdf() { return ros::param::param<std::string>("~demo_urdf", ""); }

  const LogListener log_;
  costmap_2d::Costmap2DROS bare_{"bare_costmap", Stage::get().tf};
  pluginlib::ClassLoader<nav_core::BaseLocalPlanner> loader_{"nav_core", "nav_core::BaseLocalPlanner"};
  boost::shared_ptr<nav_core::BaseLocalPlanner> planner_ =
      loader_.createInstance("hidwa_local_planner/HIDWAPlannerROS");
};

TEST_F(OutlineOfTheUrdf, IsThatOfACostmapThatHasNone) {
  const auto before = Stage::get().costmap->getUnpaddedRobotFootprint();
  describe("Outlined", demo_urdf());
  ros::param::set(ns("Outlined") + "footprint_from_urdf", true);
  initialize("Outlined");
  // A body of 0.275 m, corners 0.5 % farther out: 0.275 / cos(pi / 32) = 0.2763 m.
  const auto points = bare_.getUnpaddedRobotFootprint();
  ASSERT_GE(points.size(), 12u);
  for (const geometry_msgs::Point& point : points) EXPECT_NEAR(std::hypot(point.x, point.y), 0.2763, 1e-3);
  EXPECT_TRUE(wait_for([&] { return log_.said("the URDF's collision geometry is taken"); }));

  // A costmap with a radius of its own keeps it.
  describe("Kept", demo_urdf());
  ros::param::set(ns("Kept") + "footprint_from_urdf", true);
  Host host("Kept");
  EXPECT_EQ(Stage::get().costmap->getUnpaddedRobotFootprint().size(), before.size());
  EXPECT_NEAR(std::hypot(before[0].x, before[0].y), 0.25, 1e-9);
}

TEST_F(OutlineOfTheUrdf, IsLeftAloneUnlessItIsAskedFor) {
  describe("Unasked", demo_urdf());
  initialize("Unasked");
  // costmap_2d's own circle where nothing is set.
  for (const geometry_msgs::Point& point : bare_.getUnpaddedRobotFootprint()) {
    EXPECT_NEAR(std::hypot(point.x, point.y), 0.46, 1e-3);
  }
  EXPECT_TRUE(wait_for([&] { return log_.said("footprint_from_urdf for the URDF's collision geometry"); }));
}

TEST_F(OutlineOfTheUrdf, IsReadUnderTheCostmapsLock) {
  std::future<void> made;
  {
    const boost::unique_lock<costmap_2d::Costmap2D::mutex_t> lock(*bare_.getCostmap()->getMutex());
    made = std::async(std::launch::async, [&] { initialize("Waiting"); });
    // As long as three take that do not wait.
    for (int i = 0; i < 3; ++i) const Host other("Meanwhile_" + std::to_string(i));
    EXPECT_EQ(made.wait_for(std::chrono::seconds(0)), std::future_status::timeout);
  }
  made.get();
}

TEST_F(OutlineOfTheUrdf, IsNotTakenWithoutItsMeshes) {
  const auto before = bare_.getUnpaddedRobotFootprint();
  ros::param::set(ns("Meshed") + "footprint_from_urdf", true);
  describe("Meshed", urdf("2", "<mesh filename='package://r/tyre.stl'/>"));
  initialize("Meshed");
  EXPECT_EQ(bare_.getUnpaddedRobotFootprint().size(), before.size());
  EXPECT_TRUE(wait_for([&] { return log_.said("the URDF gives no outline"); }));
}

}  // namespace
}  // namespace hidwa_plugin_tests
