// SPDX-License-Identifier: BSD-3-Clause
#include "ros/operator_markers.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <string>
#include <tuple>
#include <vector>

#include <gtest/gtest.h>

#include "hidwa_local_planner/core/operator_intent.hpp"

namespace hidwa_local_planner {
namespace {

using visualization_msgs::Marker;
using visualization_msgs::MarkerArray;

constexpr std::uint8_t kStates = 7;

OperatorState state_of(std::uint8_t id) {
  OperatorState state;
  state.state = id;
  state.state_name = to_string(static_cast<OperatorStateId>(id));
  state.command.linear.x = 0.4;
  state.command.angular.z = -0.5;
  return state;
}

OperatorState steered() {
  OperatorState state = state_of(OperatorState::SHARED);
  state.active = true;
  state.wanted.linear.x = 0.5;
  state.wanted.angular.z = 1.0;
  return state;
}

/// The markers of a group; the test fails where there are none.
std::vector<Marker> group(const MarkerArray& all, const std::string& name) {
  std::vector<Marker> some;
  std::copy_if(all.markers.begin(), all.markers.end(), std::back_inserter(some),
               [&](const Marker& m) { return m.ns == name; });
  EXPECT_FALSE(some.empty()) << name;
  return some;
}

bool shown(const std::vector<Marker>& markers, bool wanted) {
  const auto action = wanted ? Marker::ADD : Marker::DELETE;
  return std::all_of(markers.begin(), markers.end(), [&](const Marker& m) { return m.action == action; });
}

using Colour = std::tuple<float, float, float>;
Colour colour_of(const Marker& m) { return {m.color.r, m.color.g, m.color.b}; }

double apart(const Colour& a, const Colour& b) {
  return std::abs(std::get<0>(a) - std::get<0>(b)) + std::abs(std::get<1>(a) - std::get<1>(b)) +
         std::abs(std::get<2>(a) - std::get<2>(b));
}

TEST(OperatorMarkers, TheStateIsWrittenInAColourOfItsOwn) {
  std::map<std::string, Colour> colours;
  for (std::uint8_t id = 0; id < kStates; ++id) {
    const OperatorState state = state_of(id);
    const Marker text = group(to_operator_markers(state, "base_link"), "state").front();
    EXPECT_EQ(text.type, Marker::TEXT_VIEW_FACING);
    EXPECT_EQ(text.action, Marker::ADD);
    EXPECT_EQ(text.text.substr(0, text.text.find('\n')), state.state_name);
    EXPECT_EQ(text.color.a, 1.0F);
    EXPECT_GT(text.scale.z, 0.0);
    // Fixed: whatever else is in the message.
    OperatorState other = steered();
    other.state = id;
    other.state_name = state.state_name;
    other.refused_by = "Collision";
    EXPECT_EQ(colour_of(group(to_operator_markers(other, "base_link"), "state").front()), colour_of(text));
    for (const auto& [name, colour] : colours)
      EXPECT_GT(apart(colour, colour_of(text)), 0.2) << name << ", " << state.state_name;
    colours[state.state_name] = colour_of(text);
  }
  EXPECT_EQ(colours.size(), kStates);
}

TEST(OperatorMarkers, ThatThereIsNoGoalIsWrittenBelowTheState) {
  OperatorState state = state_of(OperatorState::MANUAL);
  const auto written = [&] { return group(to_operator_markers(state, "base_link"), "state").front().text; };
  EXPECT_EQ(written(), "MANUAL\n\n\n");
  state.without_goal = true;
  // The lines hang in the middle: as many below the last word as above the robot's centre keep it off the robot.
  EXPECT_EQ(written(), "MANUAL\nno goal\n\n\n\n");
}

TEST(OperatorMarkers, WhatRejectedTheOwnCommandIsWrittenAndTakenAway) {
  OperatorState state = steered();
  state.refused_by = "ObstacleFootprint";
  const std::vector<Marker> written = group(to_operator_markers(state, "base_link"), "rejection");
  EXPECT_TRUE(shown(written, true));
  EXPECT_NE(written.front().text.find("rejected by ObstacleFootprint"), std::string::npos);
  state.refused_by = "";
  const std::vector<Marker> taken_away = group(to_operator_markers(state, "base_link"), "rejection");
  EXPECT_TRUE(shown(taken_away, false));
  EXPECT_EQ(taken_away.front().id, written.front().id);
}

TEST(OperatorMarkers, WantedAndExecutedDifferInColourAndWidth) {
  const MarkerArray all = to_operator_markers(steered(), "base_link");
  const std::vector<Marker> wanted = group(all, "wanted");
  const std::vector<Marker> executed = group(all, "executed");
  ASSERT_EQ(wanted.size(), executed.size());
  EXPECT_TRUE(shown(wanted, true));
  EXPECT_TRUE(shown(executed, true));
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    EXPECT_EQ(wanted[i].type, executed[i].type);
    EXPECT_GT(apart(colour_of(wanted[i]), colour_of(executed[i])), 0.5);
    EXPECT_GE(executed[i].scale.x, 1.5 * wanted[i].scale.x);
    EXPECT_EQ(wanted[i].color.a, 1.0F);
    EXPECT_EQ(executed[i].color.a, 1.0F);
  }
  // The wish is left, the command right; both lead ahead, and the wish is drawn above.
  const auto end = [](const std::vector<Marker>& way) { return way.front().points.back(); };
  EXPECT_GT(end(wanted).x, 0.3);
  EXPECT_GT(end(wanted).y, 0.2);
  EXPECT_GT(end(executed).x, 0.3);
  EXPECT_LT(end(executed).y, -0.2);
  EXPECT_GT(end(wanted).z, end(executed).z);
}

// The nose of a robot on a circle: v / omega is its radius.
TEST(OperatorMarkers, AWayIsThatOfTheNose) {
  const std::vector<Marker> wanted = group(to_operator_markers(steered(), "base_link"), "wanted");
  const auto& points = wanted.front().points;
  ASSERT_GT(points.size(), 5U);
  const double nose = points.front().x;
  EXPECT_GT(nose, 0.0);
  EXPECT_EQ(points.front().y, 0.0);
  for (const auto& p : points) EXPECT_NEAR(std::hypot(p.x, p.y - 0.5), std::hypot(nose, 0.5), 1e-9);
}

TEST(OperatorMarkers, WithoutAWishItsWayIsDeleted) {
  const MarkerArray with = to_operator_markers(steered(), "base_link");
  OperatorState state = steered();
  state.active = false;
  const MarkerArray without = to_operator_markers(state, "base_link");
  EXPECT_TRUE(shown(group(without, "wanted"), false));
  EXPECT_TRUE(shown(group(without, "executed"), true));
  // Everything that was drawn is drawn anew or deleted: nothing of before stays.
  std::vector<std::pair<std::string, int>> before, after;
  for (const Marker& m : with.markers) before.emplace_back(m.ns, m.id);
  for (const Marker& m : without.markers) after.emplace_back(m.ns, m.id);
  EXPECT_EQ(before, after);
}

TEST(OperatorMarkers, AWishToStandIsNoWay) {
  OperatorState state = steered();
  state.wanted = geometry_msgs::Twist();
  state.command = geometry_msgs::Twist();
  const MarkerArray all = to_operator_markers(state, "base_link");
  EXPECT_TRUE(shown(group(all, "wanted"), false));
  EXPECT_TRUE(shown(group(all, "executed"), false));
}

TEST(OperatorMarkers, TheyGoWithTheRobot) {
  for (const Marker& m : to_operator_markers(steered(), "robot/base").markers) {
    EXPECT_EQ(m.header.frame_id, "robot/base");
    EXPECT_TRUE(m.frame_locked);
    EXPECT_EQ(m.pose.orientation.w, 1.0);
  }
}

}  // namespace
}  // namespace hidwa_local_planner
