// SPDX-License-Identifier: BSD-3-Clause
// Cycles that take longer than the budget: the samples are thinned and that is said, and they come back.
#include <gtest/gtest.h>

#include "change.hpp"
#include "stage.hpp"

namespace hidwa_plugin_tests {
namespace {

using diagnostic_msgs::DiagnosticStatus;

void set_samples(const std::string& name, int vx, int vth, double budget) {
  ros::param::set(ns(name) + "vx_samples", vx);
  ros::param::set(ns(name) + "vth_samples", vth);
  ros::param::set(ns(name) + "cycle_budget", budget);
}

/// Cycles until reports say `vx` x `vth` samples.
bool reaches(Host& host, unsigned vx, unsigned vth) {
  return host.cycle_until([&](const Host::Cycle&) {
    const hidwa_local_planner::Cycle report = host.report();
    return report.vx_samples == vx && report.vth_samples == vth;
  });
}

TEST(Budget, TooManySamplesAreThinnedAndFewerAreAllThereAgain) {
  const LogListener log;
  set_samples("Many", 400, 400, 1e-3);  // 160000 candidates in it would be 6 ns each
  Host host("Many");
  const Diagnosis diagnosis("Many");
  ASSERT_TRUE(host.plan_ahead(20.0));
  ASSERT_TRUE(host.cycle_until(
      [&](const Host::Cycle&) { return host.report().vx_samples > 0 && host.report().vx_samples < 400; }));
  EXPECT_TRUE(wait_for([&] { return log.said("samples thinned from 400 x 400 to"); }));
  const auto warns = [&diagnosis] {
    return diagnosis.level() == DiagnosticStatus::WARN && diagnosis.says("samples thinned");
  };
  EXPECT_TRUE(host.cycle_until([&](const Host::Cycle& c) { return warns() && c.success; }));
  // Fewer samples are all there at once, though thinned ones need 40 cycles a step; with room they stay.
  ASSERT_TRUE(Change().set("vx_samples", 10).set("vth_samples", 10).set("cycle_budget", 10.0).send(host));
  EXPECT_TRUE(reaches(host, 10, 10));
  EXPECT_TRUE(host.cycle_until([&](const Host::Cycle& c) { return !warns() && c.success; }));
}

TEST(Budget, SamplesComeBackWhereThereIsRoomAgain) {
  const LogListener log;
  set_samples("Tight", 10, 9, 1e-6);
  Host host("Tight");
  ASSERT_TRUE(host.plan_ahead(20.0));
  EXPECT_TRUE(reaches(host, 6, 5));
  EXPECT_TRUE(host.cycle().success);
  ASSERT_TRUE(Change().set("cycle_budget", 10.0).send(host));
  // Two steps, 8 x 7 and all, of 40 cycles each.
  EXPECT_TRUE(reaches(host, 8, 7));
  EXPECT_TRUE(reaches(host, 10, 9));
  EXPECT_TRUE(wait_for([&] { return log.said("all 10 x 9 samples are tried"); }));
}

}  // namespace
}  // namespace hidwa_plugin_tests
