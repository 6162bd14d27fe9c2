// SPDX-License-Identifier: BSD-3-Clause
#include "ros/evaluation_message.hpp"

#include <limits>

#include <gtest/gtest.h>

namespace hidwa_local_planner {
namespace {

CandidateReport candidate(double v, double total) {
  CandidateReport report;
  report.sample = {v, 0.1};
  report.poses = {{0.0, 0.0, 0.0}, {v, 0.0, 0.1}};
  report.step = 0.5;
  report.terms = {{"PathDist", 2.0, 3.0}};
  report.total = total;
  return report;
}

CandidateReport rejected(double v) {
  CandidateReport report = candidate(v, std::numeric_limits<double>::infinity());
  report.rejections = {{"Collision", "hits"}, {"Braking", "cannot stop"}};
  return report;
}

const std::vector<CandidateReport> kThree = {candidate(0.1, 6.0), candidate(0.2, 2.0), rejected(0.3)};

TEST(EvaluationMessage, HoldsEveryCandidate) {
  Planner::Marked marked;
  marked.best = 1;
  marked.worst = 0;
  const Evaluation message = to_evaluation(kThree, marked, "odom", ros::Time(7.0));
  ASSERT_EQ(message.twists.size(), 3u);
  EXPECT_EQ(message.header.frame_id, "odom");
  EXPECT_EQ(message.best_index, 1u);
  EXPECT_EQ(message.worst_index, 0u);
  EXPECT_EQ(message.twists[0].traj.velocity.linear.x, 0.1);
  ASSERT_EQ(message.twists[0].traj.poses.size(), 2u);
  ASSERT_EQ(message.twists[0].traj.time_offsets.size(), 2u);
  EXPECT_EQ(message.twists[0].traj.time_offsets[1], 0.5);
  EXPECT_EQ(message.twists[0].scores[0].name, "PathDist");
  EXPECT_EQ(message.twists[0].scores[0].raw_score, 2.0);
  EXPECT_EQ(message.twists[0].scores[0].scale, 3.0);
  EXPECT_EQ(message.twists[0].total, 6.0);
  EXPECT_EQ(message.twists[0].refused_by, "");
  EXPECT_EQ(message.twists[2].refused_by, "Collision");
  EXPECT_EQ(message.twists[2].reason, "hits");
  EXPECT_EQ(message.twists[2].total, -1.0);
}

TEST(EvaluationMessage, NothingChosen) {
  EXPECT_EQ(to_evaluation(kThree, Planner::Marked(), "odom", ros::Time(7.0)).best_index, Evaluation::NONE);
}

TEST(EvaluationMessage, MarksTheChosenAndTheOperators) {
  Planner::Marked marked;
  marked.best = 1;
  marked.operator_command = 2;
  const visualization_msgs::MarkerArray message = to_markers(kThree, marked, "odom", ros::Time(7.0));
  // One that deletes what was drawn before, three candidates, two marked ones.
  ASSERT_EQ(message.markers.size(), 6u);
  EXPECT_EQ(message.markers[0].action, visualization_msgs::Marker::DELETEALL);
  EXPECT_FLOAT_EQ(message.markers[1].color.r, 1.0f);  // the dearest
  EXPECT_FLOAT_EQ(message.markers[2].color.g, 1.0f);  // the cheapest
  EXPECT_EQ(message.markers[3].ns, "rejected");
  EXPECT_EQ(message.markers[4].ns, "operator");
  EXPECT_EQ(message.markers[5].ns, "chosen");
  EXPECT_EQ(message.markers[5].points[1].x, 0.2);
}

}  // namespace
}  // namespace hidwa_local_planner
