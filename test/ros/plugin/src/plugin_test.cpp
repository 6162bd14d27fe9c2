// SPDX-License-Identifier: BSD-3-Clause
// The planner loaded from the install space: drives, arrives, reads its parameters, takes other packages'
// critics.
#include <algorithm>
#include <cmath>
#include <functional>

#include <gtest/gtest.h>
#include <hidwa_local_planner/Evaluation.h>
#include <nav_msgs/Path.h>
#include <visualization_msgs/MarkerArray.h>
#include <hidwa_local_planner/core/parameters.hpp>

#include "stage.hpp"

namespace hidwa_plugin_tests {
namespace {

using hidwa_local_planner::Evaluation;
using hidwa_local_planner::TrajectoryScore;

TEST(Plugin, BeforeInitializeEverythingFailsAndNothingThrows) {
  pluginlib::ClassLoader<nav_core::BaseLocalPlanner> loader("nav_core", "nav_core::BaseLocalPlanner");
  const auto planner = loader.createInstance("hidwa_local_planner/HIDWAPlannerROS");
  geometry_msgs::Twist command;
  EXPECT_FALSE(planner->setPlan({}));
  EXPECT_FALSE(planner->computeVelocityCommands(command));
  EXPECT_FALSE(planner->isGoalReached());
  planner->initialize("Nothing", nullptr, nullptr);
  EXPECT_FALSE(planner->computeVelocityCommands(command));
}

TEST(Plugin, ArrivesAndTheSameGoalAgainIsANewOne) {
  Host host("Arrives");
  ASSERT_TRUE(host.plan_ahead(1.5, "map"));
  EXPECT_FALSE(host.planner().isGoalReached());
  ASSERT_TRUE(host.cycle_until([&](const Host::Cycle&) { return host.planner().isGoalReached(); }))
      << host.report().fault;
  host.stop();
  ASSERT_TRUE(host.plan_ahead(1.5, "map"));
  EXPECT_FALSE(host.planner().isGoalReached());
  EXPECT_TRUE(host.drives());
}

// At the goal but not in its heading yet, cancelled, then carried in that heading far away: move_base asks for the goal
// before it asks for a command.
TEST(Plugin, ReachedIsJudgedWhereTheRobotIs) {
  Host host("Judged");
  Stage::get().clear();
  std::vector<geometry_msgs::PoseStamped> plan = straight_plan(0.2);  // within xy_goal_tolerance at once
  Pose away = Stage::get().robot.pose();
  away.x += 1.8;
  away.theta = std::remainder(away.theta + 1.5, 2.0 * M_PI);
  plan.back().pose.orientation.z = std::sin(0.5 * away.theta);
  plan.back().pose.orientation.w = std::cos(0.5 * away.theta);
  ASSERT_TRUE(host.planner().setPlan(plan));
  EXPECT_FALSE(host.planner().isGoalReached());  // 1.5 rad off
  ASSERT_TRUE(host.cycle().success);
  host.stop();
  Stage::get().robot.put(away);
  Stage::get().pass(1.0);
  ASSERT_TRUE(host.planner().setPlan(plan));
  EXPECT_FALSE(Stage::get().pass_until([&] { return host.planner().isGoalReached(); }, 0.5)) << "1.8 m away";
}

/// The topic on which move_base tells its goals.
ros::Publisher publisher_of_goals() {
  const ros::Publisher goals = ros::NodeHandle("~").advertise<geometry_msgs::PoseStamped>("current_goal", 2);
  EXPECT_TRUE(wait_for([&] { return goals.getNumSubscribers() > 0; }));
  return goals;
}

geometry_msgs::PoseStamped five_metres_on(geometry_msgs::PoseStamped goal) {
  goal.pose.position.x += 5.0;
  return goal;
}

// move_base hands over the plan that it was making when a new goal came; where it finds none to the new one, that plan
// stays.
TEST(Plugin, APlanToAnEarlierGoalIsNeitherFollowedNorReached) {
  Host host("Earlier");
  Stage::get().clear();
  const ros::Publisher goals = publisher_of_goals();
  const std::vector<geometry_msgs::PoseStamped> plan = straight_plan(1.5, "map");
  goals.publish(plan.back());
  ASSERT_TRUE(host.planner().setPlan(plan));
  ASSERT_TRUE(host.drives());
  goals.publish(five_metres_on(plan.back()));
  ASSERT_TRUE(host.planner().setPlan(plan));  // late
  const Pose before = Stage::get().robot.pose();
  ASSERT_TRUE(host.cycle_until([](const Host::Cycle& c) { return !c.success; }));
  EXPECT_FALSE(host.planner().isGoalReached());
  EXPECT_LE(host.largest_change().linear.x, 2.5 * kPeriod + 1e-9);  // it braked
  const Pose after = Stage::get().robot.pose();
  EXPECT_LT(std::hypot(after.x - before.x, after.y - before.y), 0.5);
  // The plan to the present goal is followed.
  goals.publish(plan.back());
  EXPECT_TRUE(host.drives());
  ASSERT_TRUE(host.cycle_until([&](const Host::Cycle&) { return host.planner().isGoalReached(); }));
}

// From goal to goal and back: the plan may come before the topic brings the goal.
TEST(Plugin, APlanThatIsAheadOfItsGoalIsFollowed) {
  Host host("Ahead");
  Stage::get().clear();
  const ros::Publisher goals = publisher_of_goals();
  const std::vector<geometry_msgs::PoseStamped> plan = straight_plan(3.0, "map");
  goals.publish(plan.back());
  goals.publish(five_metres_on(plan.back()));
  ASSERT_TRUE(host.planner().setPlan(plan));
  EXPECT_TRUE(host.cycle().success);
  goals.publish(plan.back());
  EXPECT_TRUE(host.cycle().success);
  EXPECT_TRUE(host.drives());
}

TEST(Plugin, ShowsPlansAndTrajectories) {
  Host host("Shows");
  const Messages<nav_msgs::Path> global_plan(ns("Shows") + "global_plan");
  const Messages<nav_msgs::Path> local_plan(ns("Shows") + "local_plan");
  const Messages<visualization_msgs::MarkerArray> trajectories(ns("Shows") + "trajectories");
  ASSERT_TRUE(host.plan_ahead(6.0, "map"));
  ASSERT_TRUE(host.cycle_until([&](const Host::Cycle& c) {
    return c.command.linear.x > 0.4 && global_plan.any() && local_plan.any() && trajectories.any();
  }));
  EXPECT_EQ(global_plan.newest().header.frame_id, "odom");
  // At most 1 m behind and forward_prune_distance ahead of the robot, a pose every 0.05 m.
  const hidwa_local_planner::Parameters defaults;
  const double poses = static_cast<double>(global_plan.newest().poses.size());
  EXPECT_GE(poses, defaults.forward_prune_distance / 0.05);
  EXPECT_LE(poses, (1.0 + defaults.forward_prune_distance) / 0.05 + 2.0);
  EXPECT_EQ(local_plan.newest().header.frame_id, "odom");
  EXPECT_GT(local_plan.newest().poses.size(), 2u);
  const visualization_msgs::MarkerArray shown = trajectories.newest();
  EXPECT_GT(shown.markers.size(), 419u);
  EXPECT_EQ(shown.markers.back().ns, "chosen");
}

TEST(Plugin, ReportsDiagnostics) {
  Host host("Healthy");
  const Diagnosis diagnosis("Healthy");
  ASSERT_TRUE(host.plan_ahead(6.0));
  EXPECT_TRUE(host.cycle_until([&](const Host::Cycle&) { return diagnosis.number("cycle time p99 [ms]") > 0.0; }));
  EXPECT_DOUBLE_EQ(diagnosis.number("cycle budget [ms]"), 0.5 * 1e3 * kPeriod);
}

TEST(Plugin, ReverseWhereAllowed) {
  ros::param::set(ns("Reverse") + "min_vel_x", -0.3);
  ros::param::set(ns("Reverse") + "critics", "PathDist, GoalDist, BaseObstacle");
  Host host("Reverse");
  ASSERT_TRUE(host.plan_ahead(-2.0));
  EXPECT_TRUE(host.cycle_until([](const Host::Cycle& c) { return c.success && c.command.linear.x < -0.25; }));
  EXPECT_GE(host.cycle().command.linear.x, -0.3 - 1e-9);
}

TEST(Plugin, ParametersOfTheServerStayAndUnknownOnesAreNamed) {
  const LogListener log;
  const std::string at = ns("Stays");
  ros::param::set(at + "max_vel_x", 0.31);
  ros::param::set(at + "critics", std::vector<std::string>{"PathDist", "GoalDist"});
  ros::param::set(at + "mode", false);  // what YAML makes of off
  ros::param::set(at + "PathDist/scale", 16);
  ros::param::set(at + "max_vel_xx", 0.2);
  Host host("Stays");
  EXPECT_EQ(ros::param::param(at + "max_vel_x", 0.0), 0.31);
  EXPECT_EQ(ros::param::param<std::string>(at + "critics", ""), "PathDist, GoalDist");
  EXPECT_EQ(ros::param::param<std::string>(at + "mode", ""), "off");
  EXPECT_EQ(ros::param::param(at + "PathDist_scale", 0.0), 16.0);
  EXPECT_FALSE(ros::param::has(at + "PathDist/scale"));
  EXPECT_TRUE(wait_for([&] { return log.said("max_vel_xx: it has no effect; do you mean max_vel_x?"); }));
  ASSERT_TRUE(host.plan_ahead(2.0));
  ASSERT_TRUE(host.drives(0.3));
  EXPECT_LE(host.cycle().command.linear.x, 0.31 + 1e-9);
}

TEST(Plugin, SaysThatTheMapIsSmallForTheHorizon) {
  const LogListener log;
  ros::param::set(ns("Far") + "sim_time", 10.0);
  Host far("Far");
  EXPECT_TRUE(wait_for([&] { return log.said("set its width and height"); }));
}

/// The first evaluation of a planner that drives 2 m ahead that is `ready`.
Evaluation evaluation_of(Host& host, const std::function<bool(const Evaluation&)>& ready) {
  const Messages<Evaluation> evaluations(ns(host.name()) + "evaluation");
  Evaluation newest;
  EXPECT_TRUE(host.plan_ahead(2.0));
  EXPECT_TRUE(host.cycle_until([&](const Host::Cycle&) {
    newest = evaluations.newest();
    return !newest.twists.empty() && ready(newest);
  }));
  return newest;
}

/// How many candidates it rejected in that cycle.
std::size_t rejections_by(const std::string& critic, const hidwa_local_planner::Cycle& report) {
  const std::vector<std::string>& names = report.rejection_names;
  const auto name = std::find(names.begin(), names.end(), critic);
  return name == names.end() ? 0 : report.rejection_counts[static_cast<std::size_t>(name - names.begin())];
}

TEST(Plugin, TakesCriticsOfOtherPackages) {
  const std::string at = ns("Example"), critic = "hidwa_example_critics/TurnLimit";
  ros::param::set(at + "critics", "PathDist, GoalDist, " + critic);
  ros::param::set(at + "TurnLimit/limit", 0.25);
  ros::param::set(at + "TurnLimit/scale", 3.0);
  Host host("Example");
  const Evaluation evaluation =
      evaluation_of(host, [&host](const Evaluation&) { return !host.report().rejection_names.empty(); });
  int rejected = 0;
  for (const TrajectoryScore& twist : evaluation.twists) {
    const double omega = std::abs(twist.traj.velocity.angular.z);
    EXPECT_EQ(twist.refused_by == critic, omega > 0.25) << omega;
    if (!twist.refused_by.empty()) {
      EXPECT_EQ(twist.reason, "turns too fast");
      ++rejected;
      continue;
    }
    const auto term = std::find_if(twist.scores.begin(), twist.scores.end(),
                                   [&critic](const auto& score) { return score.name == critic; });
    ASSERT_NE(term, twist.scores.end());
    EXPECT_DOUBLE_EQ(term->raw_score, omega);
    EXPECT_DOUBLE_EQ(term->scale, 3.0);
  }
  EXPECT_GT(rejected, 0);
  EXPECT_GT(rejections_by(critic, host.report()), 0u);
}

// The others stay: it drives, no faster than they are.
TEST(Plugin, ScoresThatAreNoNumbersRejectTheirCandidatesAlone) {
  const LogListener log;
  const std::string critic = "hidwa_broken_critics/HalfNotANumber";
  ros::param::set(ns("Half") + "critics", "PathDist, GoalDist, " + critic);
  Host host("Half");
  hidwa_local_planner::Cycle report;  // of the same cycle
  const Evaluation evaluation = evaluation_of(host, [&](const Evaluation& newest) {
    report = host.report();
    return report.header.stamp == newest.header.stamp && report.command.linear.x > 0.15;
  });
  EXPECT_EQ(report.outcome, hidwa_local_planner::Cycle::DRIVE);
  EXPECT_LE(report.command.linear.x, 0.2 + 1e-9);
  std::size_t fast = 0;
  for (const TrajectoryScore& twist : evaluation.twists) {
    const bool no_number = twist.traj.velocity.linear.x > 0.2;
    EXPECT_EQ(twist.refused_by, no_number ? critic : "") << twist.traj.velocity.linear.x;
    fast += no_number ? 1 : 0;
  }
  EXPECT_GT(fast, 0u);
  EXPECT_LT(fast, evaluation.twists.size());
  EXPECT_EQ(rejections_by(critic, report), fast);
  EXPECT_TRUE(wait_for([&] { return log.said("the critic " + critic + " gives scores that are no finite numbers"); }));
}

TEST(Plugin, ACriticOfAnotherPackageTakesWordsAndListsAndMeasuresDistances) {
  const LogListener log;
  const std::string at = ns("Lists");
  ros::param::set(at + "critics", "PathDist, SlowNear");
  ros::param::set(at + "SlowNear/to", std::vector<std::string>{"path", "goal"});
  ros::param::set(at + "SlowNear/distances", std::vector<double>{0.01, 100.0});
  ros::param::set(at + "SlowNear/speeds", std::vector<double>{0.0, 0.125});
  ros::param::set(at + "SlowNear/measured_at", "nose");
  ros::param::set(at + "SlowNear/scael", 3.0);
  Host host("Lists");
  EXPECT_TRUE(wait_for([&] {
    return log.said(
        "unknown parameter SlowNear/scael of the critic SlowNear: it has no effect; do you mean SlowNear/scale?");
  }));
  const Evaluation evaluation = evaluation_of(host, [](const Evaluation&) { return true; });
  int on_path = 0, beside = 0;
  for (const TrajectoryScore& twist : evaluation.twists) {
    const auto term = std::find_if(twist.scores.begin(), twist.scores.end(),
                                   [](const auto& score) { return score.name == "SlowNear"; });
    ASSERT_NE(term, twist.scores.end());
    const double v = std::abs(twist.traj.velocity.linear.x);
    const bool slow = term->raw_score == v;  // the nose ends on a cell of the path
    if (!slow) {
      EXPECT_DOUBLE_EQ(term->raw_score, std::max(0.0, v - 0.125));
    }
    if (v > 0.125) ++(slow ? on_path : beside);
  }
  EXPECT_GT(on_path, 0);
  EXPECT_GT(beside, 0);
}

// reconfigure_test tries all of them while the robot drives.
TEST(ABrokenCritic, IsSaidAtTheStartAndNothingDrives) {
  const LogListener log;
  ros::param::set(ns("Broken") + "critics", "PathDist, hidwa_broken_critics/NoLibrary");
  Host host("Broken");
  EXPECT_TRUE(wait_for([&] {
    return log.said("the critic hidwa_broken_critics/NoLibrary cannot be loaded") &&
           log.said("critics: hidwa_broken_critics/NoLibrary is declared, but");
  }));
  ASSERT_TRUE(host.plan_ahead(2.0));
  EXPECT_TRUE(host.refuses_to_drive());
  EXPECT_NE(host.report().fault.find("are not valid"), std::string::npos) << host.report().fault;
}

}  // namespace
}  // namespace hidwa_plugin_tests
