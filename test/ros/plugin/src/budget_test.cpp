// SPDX-License-Identifier: BSD-3-Clause
// Cycles that take longer than the budget: the samples are thinned and that is said, and they come back.
#include <diagnostic_msgs/DiagnosticArray.h>
#include <gtest/gtest.h>

#include "change.hpp"
#include "stage.hpp"

namespace hidwa_plugin_tests {
namespace {

std::string ns(const std::string& name) { return ros::this_node::getName() + "/" + name + "/"; }

Change samples(int count) { return Change().set("vx_samples", count).set("vth_samples", count); }

Change budget(double seconds) { return Change().set("cycle_budget", seconds); }

/// Cycles until reports say `vx` x `vth` samples.
bool reaches(Host& host, unsigned vx, unsigned vth) {
  return host.cycle_until([&](const Host::Cycle&) {
    const hidwa_local_planner::Cycle report = host.report();
    return report.vx_samples == vx && report.vth_samples == vth;
  });
}

/// Whether /diagnostics warns of thinned samples at the moment; the newest message decides.
class Warning {
 public:
  explicit Warning(const std::string& name) : name_(ros::this_node::getName().substr(1) + ": " + name) {
    subscriber_ = ros::NodeHandle().subscribe<diagnostic_msgs::DiagnosticArray>(
        "/diagnostics", 10, [this](const diagnostic_msgs::DiagnosticArray::ConstPtr& message) {
          for (const diagnostic_msgs::DiagnosticStatus& status : message->status) {
            if (status.name != name_) continue;
            heard_ = true;
            on_ = status.level == diagnostic_msgs::DiagnosticStatus::WARN &&
                  status.message.find("samples thinned") != std::string::npos;
          }
        });
  }
  bool on() const { return heard_ && on_; }
  bool off() const { return heard_ && !on_; }

 private:
  std::string name_;
  std::atomic<bool> heard_{false}, on_{false};
  ros::Subscriber subscriber_;
};

TEST(Budget, TooManySamplesAreThinnedAndFewerAreAllThereAgain) {
  const LogListener log;
  ros::param::set(ns("Many") + "vx_samples", 400);
  ros::param::set(ns("Many") + "vth_samples", 400);
  ros::param::set(ns("Many") + "cycle_budget", 1e-3);  // 160000 candidates in it would be 6 ns each
  Host host("Many");
  const Warning warning("Many");
  ASSERT_TRUE(host.plan_ahead(20.0));
  ASSERT_TRUE(host.cycle_until(
      [&](const Host::Cycle&) { return host.report().vx_samples > 0 && host.report().vx_samples < 400; }));
  EXPECT_TRUE(wait_for([&] { return log.said("samples thinned from 400 x 400 to"); }));
  EXPECT_TRUE(host.cycle_until([&](const Host::Cycle& c) { return warning.on() && c.success; }));
  // Fewer samples are all there at once, though thinned ones need 40 cycles a step; with room they stay.
  ASSERT_TRUE(samples(10).set("cycle_budget", 10.0).send(host));
  EXPECT_TRUE(reaches(host, 10, 10));
  EXPECT_TRUE(host.cycle_until([&](const Host::Cycle& c) { return warning.off() && c.success; }));
}

TEST(Budget, SamplesComeBackWhereThereIsRoomAgain) {
  const LogListener log;
  ros::param::set(ns("Tight") + "vx_samples", 10);
  ros::param::set(ns("Tight") + "vth_samples", 9);
  ros::param::set(ns("Tight") + "cycle_budget", 1e-6);
  Host host("Tight");
  ASSERT_TRUE(host.plan_ahead(20.0));
  EXPECT_TRUE(reaches(host, 6, 5));
  EXPECT_TRUE(host.cycle().success);
  ASSERT_TRUE(budget(10.0).send(host));
  // Two steps, 8 x 7 and all, of 40 cycles each.
  EXPECT_TRUE(reaches(host, 8, 7));
  EXPECT_TRUE(reaches(host, 10, 9));
  EXPECT_TRUE(wait_for([&] { return log.said("all 10 x 9 samples are tried"); }));
}

TEST(Budget, ANegativeOneThinsNothing) {
  ros::param::set(ns("Never") + "cycle_budget", 1e-6);
  ros::param::set(ns("Never") + "vx_samples", 20);
  ros::param::set(ns("Never") + "vth_samples", 20);
  Host host("Never");
  ASSERT_TRUE(host.plan_ahead(20.0));
  ASSERT_TRUE(reaches(host, 6, 6));
  ASSERT_TRUE(budget(-1.0).send(host));
  ASSERT_TRUE(reaches(host, 20, 20));
  for (int i = 0; i < 10; ++i) host.cycle();
  EXPECT_TRUE(reaches(host, 20, 20));
}

}  // namespace
}  // namespace hidwa_plugin_tests

int main(int argc, char** argv) {
  ros::init(argc, argv, "budget_test");
  ros::NodeHandle node;
  ::testing::InitGoogleTest(&argc, argv);
  return RUN_ALL_TESTS();
}
