// SPDX-License-Identifier: BSD-3-Clause
// dynamic_reconfigure: a change counts in the next cycle, a set that does not validate is refused whole.
#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "change.hpp"
#include "stage.hpp"

namespace hidwa_plugin_tests {
namespace {

/// A planner on the way at its full 0.5 m/s.
void drive(Host& host) {
  ASSERT_TRUE(host.plan_ahead(8.0));
  ASSERT_TRUE(host.drives(0.499)) << host.report().fault;
}

TEST(Reconfigure, AChangeCountsInTheNextCycle) {
  Host host("Changes");
  drive(host);
  Change change;
  ASSERT_TRUE(change.set("max_vel_x", 0.2).send(host));
  EXPECT_EQ(change.number("max_vel_x"), 0.2);
  // 0.5 - 2.5 x 0.05 = 0.375 m/s: the first step down to 0.2.
  EXPECT_NEAR(host.cycle().command.linear.x, 0.375, 1e-6);
  EXPECT_TRUE(host.cycle_until([](const Host::Cycle& c) { return std::abs(c.command.linear.x - 0.2) < 1e-6; }));
}

TEST(Reconfigure, ASetWithOneFaultIsRefusedWhole) {
  const LogListener log;
  Host host("Refuses");
  drive(host);
  Change change;
  ASSERT_TRUE(change.set("max_vel_x", 0.2).set("min_vel_x", 0.3).set("sim_time", -1.0).send(host));
  // What was in force comes back, in all three.
  EXPECT_EQ(change.number("max_vel_x"), 0.5);
  EXPECT_EQ(change.number("min_vel_x"), 0.0);
  EXPECT_EQ(change.number("sim_time"), 1.85);
  EXPECT_EQ(ros::param::param(ns("Refuses") + "max_vel_x", 0.0), 0.5);
  for (int i = 0; i < 5; ++i) EXPECT_NEAR(host.cycle().command.linear.x, 0.5, 1e-3);
  EXPECT_TRUE(wait_for([&] { return log.said("min_vel_x = 0.3 m/s is above max_vel_x"); }));
  EXPECT_TRUE(wait_for([&] { return log.said("sim_time = -1 s is outside"); }));
}

TEST(Reconfigure, NamesOfChoicesAreCheckedAndACriticsShortNameWillDo) {
  Host host("Names");
  Change wrong;
  ASSERT_TRUE(wrong.set("generator", "teb").send(host));
  EXPECT_EQ(wrong.text("generator"), "standard");
  Change right;
  ASSERT_TRUE(right.set("generator", "dwa").set("critics", "PathDist, GoalDist, TurnLimit").send(host));
  EXPECT_EQ(right.text("generator"), "dwa");
  EXPECT_EQ(right.text("critics"), "PathDist, GoalDist, TurnLimit");
  ASSERT_TRUE(host.plan_ahead(2.0));
  EXPECT_TRUE(host.drives()) << host.report().fault;
}

/// A critic, and two parts of what is said when it is refused.
struct Refusal {
  std::string critic, reason, fault;
};

TEST(Reconfigure, ACriticThatCannotBeUsedIsRefusedWhileDriving) {
  const LogListener log;
  ros::param::set(ns("Broken") + "SlowNear/speeds", "fast");
  Host host("Broken");
  drive(host);
  const std::string ours = "the critic hidwa_broken_critics/";
  const std::string remedy = " is declared, but its library cannot be loaded; rebuild its package";
  for (const Refusal& refusal :
       {Refusal{"NoSuchCritic", " TurnLimit", "critics: no critic named NoSuchCritic; there are "},
        Refusal{"SlowNear", "expected a list of numbers, found fast", "SlowNear/speeds: expected"},
        Refusal{"NotInTheLibrary", ours + "NotInTheLibrary cannot be loaded: ", "critics: NotInTheLibrary" + remedy},
        Refusal{"NoLibrary", ours + "NoLibrary cannot be loaded: ", "critics: NoLibrary" + remedy},
        Refusal{"CannotBeMade", ours + "CannotBeMade cannot be loaded: no memory of its own",
                "critics: CannotBeMade" + remedy},
        Refusal{"CannotBeConfigured",
                "hidwa_broken_critics/CannotBeConfigured: its table is missing; mend them, or take it out",
                "critics: one of them cannot use its parameters"}}) {
    SCOPED_TRACE(refusal.critic);
    Change change;
    ASSERT_TRUE(change.set("critics", "PathDist, " + refusal.critic).send(host));
    EXPECT_NE(change.text("critics").find("GoalAlign"), std::string::npos);
    for (int i = 0; i < 5; ++i) EXPECT_NEAR(host.cycle().command.linear.x, 0.5, 1e-3);
    EXPECT_TRUE(wait_for([&] { return log.said(refusal.reason) && log.said("parameters refused: " + refusal.fault); }));
  }
}

TEST(Reconfigure, ABadStartRefusesToDriveUntilAValidSetComes) {
  const LogListener log;
  ros::param::set(ns("BadStart") + "max_vel_x", 99.0);
  ros::param::set(ns("BadStart") + "sim_time", "long");
  Host host("BadStart");
  EXPECT_TRUE(wait_for([&] { return log.said("max_vel_x = 99 m/s is outside"); }));
  EXPECT_TRUE(wait_for([&] { return log.said("sim_time: long"); }));
  ASSERT_TRUE(host.plan_ahead(3.0));
  EXPECT_TRUE(host.refuses_to_drive());
  // Another change alone leaves the fault where it is.
  Change other;
  ASSERT_TRUE(other.set("delta", 1.0).send(host));
  EXPECT_FALSE(host.cycle().success);
  Change change;
  ASSERT_TRUE(change.set("max_vel_x", 0.4).send(host));
  EXPECT_TRUE(host.drives(0.39)) << host.report().fault;
}

TEST(Reconfigure, AnotherOdometryTopicIsListenedTo) {
  Host host("Topic");
  drive(host);
  Change away;
  ASSERT_TRUE(away.set("odom_topic", "nobody_speaks_here").send(host));
  EXPECT_TRUE(host.cycle_until([](const Host::Cycle& c) { return !c.success; }));
  EXPECT_NE(host.report().fault.find("nobody_speaks_here"), std::string::npos);
  Change back;
  ASSERT_TRUE(back.set("odom_topic", "odom").send(host));
  EXPECT_TRUE(host.drives()) << host.report().fault;
}

}  // namespace
}  // namespace hidwa_plugin_tests
