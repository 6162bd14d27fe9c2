// SPDX-License-Identifier: BSD-3-Clause
// The planner loaded from the install space: drives, arrives, reads its parameters, takes other packages'
// critics.
#include <algorithm>
#include <cmath>
#include <functional>

#include <diagnostic_msgs/DiagnosticArray.h>
#include <gtest/gtest.h>
#include <hidwa_local_planner/Evaluation.h>
#include <nav_msgs/Path.h>
#include <visualization_msgs/MarkerArray.h>
#include <hidwa_local_planner/core/parameters.hpp>

#include "stage.hpp"

namespace hidwa_plugin_tests {
namespace {

using hidwa_local_planner::Evaluation;

std::string ns(const std::string& name) { return ros::this_node::getName() + "/" + name + "/"; }

bool drives(Host& host) {
  return host.cycle_until([](const Host::Cycle& c) { return c.success && c.command.linear.x > 0.1; });
}

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
  EXPECT_TRUE(drives(host));
}

/// Somebody else drives the robot straight on, then turns it, while the host does not call.
void drive_away(double metres, double turn) {
  constexpr double kSpeed = 1.0;  // [m/s, rad/s]
  Robot& robot = Stage::get().robot;
  const Pose start = robot.pose();
  geometry_msgs::Twist twist;
  twist.linear.x = kSpeed;
  robot.command(twist);
  ASSERT_TRUE(Stage::get().pass_until(
      [&] { return std::hypot(robot.pose().x - start.x, robot.pose().y - start.y) >= metres; }));
  twist.linear.x = 0.0;
  twist.angular.z = std::copysign(kSpeed, turn);
  robot.command(twist);
  ASSERT_TRUE(Stage::get().pass_until(
      [&] { return std::abs(std::remainder(robot.pose().theta - start.theta - turn, 2.0 * M_PI)) < 0.05; }));
  robot.command(geometry_msgs::Twist());
}

// At the goal but not in its heading yet, cancelled, moved by somebody else into that heading far away: move_base asks
// for the goal before it asks for a command.
TEST(Plugin, ReachedIsJudgedWhereTheRobotIs) {
  Host host("Judged");
  Stage::get().clear();
  std::vector<geometry_msgs::PoseStamped> plan = straight_plan(0.2);  // within xy_goal_tolerance at once
  const double heading = std::remainder(Stage::get().robot.pose().theta + 1.5, 2.0 * M_PI);
  plan.back().pose.orientation.z = std::sin(0.5 * heading);
  plan.back().pose.orientation.w = std::cos(0.5 * heading);
  ASSERT_TRUE(host.planner().setPlan(plan));
  EXPECT_FALSE(host.planner().isGoalReached());  // 1.5 rad off
  ASSERT_TRUE(host.cycle().success);
  host.stop();
  const double turned = Stage::get().robot.pose().theta;
  drive_away(1.8, std::remainder(heading - turned, 2.0 * M_PI));
  ASSERT_TRUE(host.planner().setPlan(plan));
  EXPECT_FALSE(host.planner().isGoalReached()) << "1.8 m away";
  EXPECT_FALSE(Stage::get().pass_until([&] { return host.planner().isGoalReached(); }, 0.5));
}

// move_base hands over the plan that it was making when a new goal came; where it finds none to the new one, that plan
// stays.
TEST(Plugin, APlanToAnEarlierGoalIsNeitherFollowedNorReached) {
  Host host("Earlier");
  Stage::get().clear();
  ros::NodeHandle node("~");
  const ros::Publisher goals = node.advertise<geometry_msgs::PoseStamped>("current_goal", 2);
  ASSERT_TRUE(wait_for([&] { return goals.getNumSubscribers() > 0; }));
  const std::vector<geometry_msgs::PoseStamped> plan = straight_plan(1.5, "map");
  goals.publish(plan.back());
  ASSERT_TRUE(host.planner().setPlan(plan));
  ASSERT_TRUE(drives(host));
  geometry_msgs::PoseStamped wall = plan.back();
  wall.pose.position.x += 5.0;
  goals.publish(wall);
  ASSERT_TRUE(host.planner().setPlan(plan));  // late
  const Pose before = Stage::get().robot.pose();
  ASSERT_TRUE(host.cycle_until([](const Host::Cycle& c) { return !c.success; }));
  EXPECT_FALSE(host.planner().isGoalReached());
  EXPECT_LE(host.largest_change().linear.x, 2.5 * kPeriod + 1e-9);  // it braked
  const Pose after = Stage::get().robot.pose();
  EXPECT_LT(std::hypot(after.x - before.x, after.y - before.y), 0.5);
  // The plan to the present goal is followed.
  goals.publish(plan.back());
  EXPECT_TRUE(drives(host));
  ASSERT_TRUE(host.cycle_until([&](const Host::Cycle&) { return host.planner().isGoalReached(); }));
}

// From goal to goal and back: the plan may come before the topic brings the goal.
TEST(Plugin, APlanThatIsAheadOfItsGoalIsFollowed) {
  Host host("Ahead");
  Stage::get().clear();
  ros::NodeHandle node("~");
  const ros::Publisher goals = node.advertise<geometry_msgs::PoseStamped>("current_goal", 2);
  ASSERT_TRUE(wait_for([&] { return goals.getNumSubscribers() > 0; }));
  const std::vector<geometry_msgs::PoseStamped> plan = straight_plan(3.0, "map");
  geometry_msgs::PoseStamped other = plan.back();
  other.pose.position.x += 5.0;
  goals.publish(plan.back());
  goals.publish(other);
  ASSERT_TRUE(host.planner().setPlan(plan));
  EXPECT_TRUE(host.cycle().success);
  goals.publish(plan.back());
  EXPECT_TRUE(host.cycle().success);
  EXPECT_TRUE(drives(host));
}

TEST(Plugin, CommandsStayWithinTheAccelerationLimit) {
  ros::param::set(ns("Limits") + "cycle_budget", -1.0);  // a busy machine would take fewer samples
  Host host("Limits");
  ASSERT_TRUE(host.plan_ahead(3.0));
  double last = 0.0;  // [m/s]
  // Until the limit of speed, not for a number of cycles: a sample lower (0.487 m/s) may win one of them.
  EXPECT_TRUE(host.cycle_until([&](const Host::Cycle& cycle) {
    EXPECT_TRUE(cycle.success);
    EXPECT_LE(std::abs(cycle.command.linear.x - last), 2.5 * kPeriod + 1e-9);
    last = cycle.command.linear.x;
    return std::abs(last - 0.5) <= 1e-6;
  }));
}

/// The newest message of a topic.
template <typename Message>
class Newest {
 public:
  explicit Newest(const std::string& topic) {
    subscriber_ = ros::NodeHandle().subscribe<Message>(topic, 1, [this](const boost::shared_ptr<const Message>& m) {
      const std::lock_guard<std::mutex> lock(mutex_);
      message_ = m;
    });
  }
  boost::shared_ptr<const Message> get() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return message_;
  }

 private:
  mutable std::mutex mutex_;
  boost::shared_ptr<const Message> message_;
  ros::Subscriber subscriber_;
};

TEST(Plugin, ShowsPlansAndTrajectories) {
  Host host("Shows");
  const Newest<nav_msgs::Path> global_plan(ns("Shows") + "global_plan");
  const Newest<nav_msgs::Path> local_plan(ns("Shows") + "local_plan");
  const Newest<visualization_msgs::MarkerArray> trajectories(ns("Shows") + "trajectories");
  ASSERT_TRUE(host.plan_ahead(6.0, "map"));
  ASSERT_TRUE(host.cycle_until([&](const Host::Cycle& c) {
    return c.command.linear.x > 0.4 && global_plan.get() && local_plan.get() && trajectories.get();
  }));
  EXPECT_EQ(global_plan.get()->header.frame_id, "odom");
  // At most 1 m behind and forward_prune_distance ahead of the robot, a pose every 0.05 m.
  const hidwa_local_planner::Parameters defaults;
  const double poses = static_cast<double>(global_plan.get()->poses.size());
  EXPECT_GE(poses, defaults.forward_prune_distance / 0.05);
  EXPECT_LE(poses, (1.0 + defaults.forward_prune_distance) / 0.05 + 2.0);
  EXPECT_EQ(local_plan.get()->header.frame_id, "odom");
  EXPECT_GT(local_plan.get()->poses.size(), 2u);
  const auto& markers = trajectories.get()->markers;
  EXPECT_GT(markers.size(), 419u);
  EXPECT_EQ(markers.back().ns, "chosen");
}

TEST(Plugin, ReportsDiagnostics) {
  Host host("Healthy");
  const Newest<diagnostic_msgs::DiagnosticArray> diagnostics("/diagnostics");
  ASSERT_TRUE(host.plan_ahead(6.0));
  const auto reported = [&](const Host::Cycle&) {
    const auto message = diagnostics.get();
    if (!message || message->status.empty() || message->status[0].name.find("Healthy") == std::string::npos) {
      return false;
    }
    bool timed = false;
    for (const diagnostic_msgs::KeyValue& value : message->status[0].values) {
      if (value.key == "cycle time p99 [ms]") timed = std::stod(value.value) > 0.0;
      if (value.key == "cycle budget [ms]") {
        EXPECT_DOUBLE_EQ(std::stod(value.value), 0.5 * 1e3 * kPeriod);
      }
    }
    return timed;
  };
  EXPECT_TRUE(host.cycle_until(reported));
}

TEST(Plugin, ReverseWhereAllowed) {
  ros::param::set(ns("Reverse") + "min_vel_x", -0.3);
  ros::param::set(ns("Reverse") + "critics", "PathDist, GoalDist, BaseObstacle");
  Host host("Reverse");
  ASSERT_TRUE(host.plan_ahead(-2.0));
  EXPECT_TRUE(host.cycle_until([](const Host::Cycle& c) { return c.success && c.command.linear.x < -0.25; }));
  EXPECT_GE(host.cycle().command.linear.x, -0.3 - 1e-9);
}

TEST(Plugin, NoReverseByDefault) {
  ros::param::set(ns("Forward") + "critics", "PathDist, GoalDist, BaseObstacle");
  Host host("Forward");
  ASSERT_TRUE(host.plan_ahead(-2.0));
  for (int i = 0; i < 20; ++i) EXPECT_GE(host.cycle().command.linear.x, 0.0);
}

TEST(Plugin, ParametersOfTheServerStay) {
  const std::string at = ns("Stays");
  ros::param::set(at + "max_vel_x", 0.31);
  ros::param::set(at + "critics", std::vector<std::string>{"PathDist", "GoalDist"});
  ros::param::set(at + "mode", false);  // what YAML makes of off
  ros::param::set(at + "PathDist/scale", 16);
  Host host("Stays");
  EXPECT_EQ(ros::param::param(at + "max_vel_x", 0.0), 0.31);
  EXPECT_EQ(ros::param::param<std::string>(at + "critics", ""), "PathDist, GoalDist");
  EXPECT_EQ(ros::param::param<std::string>(at + "mode", ""), "off");
  EXPECT_EQ(ros::param::param(at + "PathDist_scale", 0.0), 16.0);
  EXPECT_FALSE(ros::param::has(at + "PathDist/scale"));
  ASSERT_TRUE(host.plan_ahead(2.0));
  ASSERT_TRUE(host.cycle_until([](const Host::Cycle& c) { return c.command.linear.x > 0.3; }));
  EXPECT_LE(host.cycle().command.linear.x, 0.31 + 1e-9);
}

TEST(Plugin, SaysUnknownKeysWithTheLikelyOne) {
  const LogListener log;
  ros::param::set(ns("Unknown") + "max_vel_xx", 0.2);
  Host host("Unknown");
  EXPECT_TRUE(wait_for([&] { return log.said("max_vel_xx: it has no effect; do you mean max_vel_x?"); }));
}

TEST(Plugin, SaysASmallMapAndAShortHorizon) {
  const LogListener log;
  ros::param::set(ns("Short") + "sim_time", 0.1);
  Host host("Short");
  EXPECT_TRUE(wait_for([&] { return log.said("raise sim_time to 0.30 s"); }));
  ros::param::set(ns("Far") + "sim_time", 10.0);
  Host far("Far");
  EXPECT_TRUE(wait_for([&] { return log.said("set its width and height"); }));
}

/// The first evaluation of a planner that drives 2 m ahead that is `ready`.
Evaluation evaluation_of(Host& host, const std::string& name, const std::function<bool(const Evaluation&)>& ready) {
  Evaluation evaluation;
  ros::NodeHandle node("~/" + name);
  std::mutex mutex;
  const ros::Subscriber subscriber =
      node.subscribe<Evaluation>("evaluation", 1, [&](const Evaluation::ConstPtr& message) {
        const std::lock_guard<std::mutex> lock(mutex);
        evaluation = *message;
      });
  EXPECT_TRUE(host.plan_ahead(2.0));
  EXPECT_TRUE(host.cycle_until([&](const Host::Cycle&) {
    const std::lock_guard<std::mutex> lock(mutex);
    return !evaluation.twists.empty() && ready(evaluation);
  }));
  const std::lock_guard<std::mutex> lock(mutex);
  return evaluation;
}

/// How many candidates it rejected in that cycle.
std::size_t rejections_by(const std::string& critic, const hidwa_local_planner::Cycle& report) {
  const std::vector<std::string>& names = report.rejection_names;
  const auto name = std::find(names.begin(), names.end(), critic);
  return name == names.end() ? 0 : report.rejection_counts[static_cast<std::size_t>(name - names.begin())];
}

TEST(Plugin, TakesCriticsOfOtherPackages) {
  const std::string at = ns("Example");
  ros::param::set(at + "critics", "PathDist, GoalDist, hidwa_example_critics/TurnLimit");
  ros::param::set(at + "TurnLimit/limit", 0.25);
  ros::param::set(at + "TurnLimit/scale", 3.0);
  Host host("Example");
  const Evaluation evaluation =
      evaluation_of(host, "Example", [&host](const Evaluation&) { return !host.report().rejection_names.empty(); });
  int rejected = 0;
  for (const hidwa_local_planner::TrajectoryScore& twist : evaluation.twists) {
    const double omega = std::abs(twist.traj.velocity.angular.z);
    EXPECT_EQ(twist.refused_by == "hidwa_example_critics/TurnLimit", omega > 0.25) << omega;
    if (!twist.refused_by.empty()) {
      EXPECT_EQ(twist.reason, "turns too fast");
      ++rejected;
      continue;
    }
    const auto term = std::find_if(twist.scores.begin(), twist.scores.end(),
                                   [](const auto& score) { return score.name == "hidwa_example_critics/TurnLimit"; });
    ASSERT_NE(term, twist.scores.end());
    EXPECT_DOUBLE_EQ(term->raw_score, omega);
    EXPECT_DOUBLE_EQ(term->scale, 3.0);
  }
  EXPECT_GT(rejected, 0);
  EXPECT_GT(rejections_by("hidwa_example_critics/TurnLimit", host.report()), 0u);
}

// The others stay: it drives, no faster than they are.
TEST(Plugin, ScoresThatAreNoNumbersRejectTheirCandidatesAlone) {
  const std::string critic = "hidwa_broken_critics/HalfNotANumber";
  ros::param::set(ns("Half") + "critics", "PathDist, GoalDist, " + critic);
  Host host("Half");
  hidwa_local_planner::Cycle report;  // of the same cycle
  const Evaluation evaluation = evaluation_of(host, "Half", [&](const Evaluation& newest) {
    report = host.report();
    return report.header.stamp == newest.header.stamp && report.command.linear.x > 0.15;
  });
  EXPECT_EQ(report.outcome, hidwa_local_planner::Cycle::DRIVE);
  EXPECT_LE(report.command.linear.x, 0.2 + 1e-9);
  std::size_t fast = 0;
  for (const hidwa_local_planner::TrajectoryScore& twist : evaluation.twists) {
    const bool no_number = twist.traj.velocity.linear.x > 0.2;
    EXPECT_EQ(twist.refused_by, no_number ? critic : "") << twist.traj.velocity.linear.x;
    fast += no_number ? 1 : 0;
  }
  EXPECT_GT(fast, 0u);
  EXPECT_LT(fast, evaluation.twists.size());
  EXPECT_EQ(rejections_by(critic, report), fast);
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
  const Evaluation evaluation = evaluation_of(host, "Lists", [](const Evaluation&) { return true; });
  int on_path = 0, beside = 0;
  for (const hidwa_local_planner::TrajectoryScore& twist : evaluation.twists) {
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

TEST(Plugin, AParameterOfAnotherTypeIsNamedAndNothingDrives) {
  const LogListener log;
  ros::param::set(ns("Typed") + "critics", "PathDist, SlowNear");
  ros::param::set(ns("Typed") + "SlowNear/speeds", "fast");
  Host host("Typed");
  EXPECT_TRUE(wait_for([&] { return log.said("SlowNear/speeds: expected a list of numbers, found fast"); }));
  ASSERT_TRUE(host.plan_ahead(2.0));
  for (int i = 0; i < 20; ++i) EXPECT_EQ(host.cycle().command.linear.x, 0.0);
  EXPECT_FALSE(host.cycle().success);
}

TEST(Plugin, ACriticsShortNameWillDo) {
  ros::param::set(ns("Brief") + "critics", std::vector<std::string>{"PathDist", "GoalDist", "TurnLimit"});
  Host host("Brief");
  ASSERT_TRUE(host.plan_ahead(2.0));
  EXPECT_TRUE(drives(host)) << host.report().fault;
}

TEST(Plugin, AnUnknownCriticIsSaidWithWhatThereIsAndNothingDrives) {
  const LogListener log;
  ros::param::set(ns("NoSuch") + "critics", "PathDist, NoSuchCritic");
  Host host("NoSuch");
  ASSERT_TRUE(host.plan_ahead(2.0));
  for (int i = 0; i < 20; ++i) EXPECT_EQ(host.cycle().command.linear.x, 0.0);
  EXPECT_FALSE(host.cycle().success);
  EXPECT_TRUE(wait_for([&] { return log.said("NoSuchCritic"); }));
  EXPECT_TRUE(log.said("TurnLimit"));
}

/// A critic that cannot be used, and what is to be said of it.
struct BrokenCritic {
  const char* name;
  const char* reason;
  const char* fault;
};

class ABrokenCritic : public ::testing::TestWithParam<BrokenCritic> {};

TEST_P(ABrokenCritic, IsSaidAndNothingDrives) {
  const BrokenCritic& broken = GetParam();
  const LogListener log;
  const std::string name = std::string("With") + broken.name;
  ros::param::set(ns(name) + "critics", std::string("PathDist, hidwa_broken_critics/") + broken.name);
  Host host(name);
  EXPECT_TRUE(wait_for([&] { return log.said(broken.reason) && log.said(broken.fault); }));
  ASSERT_TRUE(host.plan_ahead(2.0));
  // Until the first odometry comes, standing still counts as braking.
  EXPECT_TRUE(host.cycle_until([](const Host::Cycle& c) {
    EXPECT_EQ(c.command.linear.x, 0.0);
    return !c.success;
  }));
  EXPECT_TRUE(wait_for([&] { return host.report().fault.find("are not valid") != std::string::npos; }));
}

INSTANTIATE_TEST_SUITE_P(
    All, ABrokenCritic,
    ::testing::Values(BrokenCritic{"NotInTheLibrary",
                                   "the critic hidwa_broken_critics/NotInTheLibrary cannot be loaded",
                                   "critics: hidwa_broken_critics/NotInTheLibrary is declared, but"},
                      BrokenCritic{"NoLibrary", "the critic hidwa_broken_critics/NoLibrary cannot be loaded",
                                   "critics: hidwa_broken_critics/NoLibrary is declared, but"},
                      BrokenCritic{"CannotBeMade", "no memory of its own",
                                   "critics: hidwa_broken_critics/CannotBeMade is declared, but"},
                      BrokenCritic{"CannotBeConfigured", "its table is missing", "cannot use its parameters"}),
    [](const auto& critic) { return std::string(critic.param.name); });

}  // namespace
}  // namespace hidwa_plugin_tests

int main(int argc, char** argv) {
  ros::init(argc, argv, "plugin_test");
  ros::NodeHandle node;
  ::testing::InitGoogleTest(&argc, argv);
  return RUN_ALL_TESTS();
}
