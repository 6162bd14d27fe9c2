// SPDX-License-Identifier: BSD-3-Clause
#include "ros/evaluation_message.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "ros/conversions.hpp"

namespace hidwa_local_planner {
namespace {

TrajectoryScore to_score(const CandidateReport& candidate) {
  TrajectoryScore score;
  score.traj.velocity = to_message(candidate.sample);
  score.traj.poses.reserve(candidate.poses.size());
  score.traj.time_offsets.reserve(candidate.poses.size());
  for (std::size_t k = 0; k < candidate.poses.size(); ++k) {
    geometry_msgs::Pose2D pose;
    pose.x = candidate.poses[k].x;
    pose.y = candidate.poses[k].y;
    pose.theta = candidate.poses[k].theta;
    score.traj.poses.push_back(pose);
    score.traj.time_offsets.push_back(static_cast<double>(k) * candidate.step);
  }
  for (const CriticTerm& term : candidate.terms) {
    CriticScore critic;
    critic.name = term.name;
    critic.raw_score = term.raw;
    critic.scale = term.weight;
    score.scores.push_back(std::move(critic));
  }
  score.total = candidate.legal() ? candidate.total : -1.0;
  if (!candidate.legal()) {
    score.refused_by = candidate.rejections.front().name;
    score.reason = candidate.rejections.front().reason;
  }
  return score;
}

std_msgs::ColorRGBA colour(double r, double g, double b, double a) {
  std_msgs::ColorRGBA c;
  c.r = static_cast<float>(r);
  c.g = static_cast<float>(g);
  c.b = static_cast<float>(b);
  c.a = static_cast<float>(a);
  return c;
}

struct Line {
  const char* group;
  std_msgs::ColorRGBA colour;
  double width;   // [m]
  double height;  // above the ground, so that marked lines lie on top [m]
};

visualization_msgs::Marker to_line(const CandidateReport& candidate, const Line& line, int id, const std::string& frame,
                                   const ros::Time& stamp) {
  visualization_msgs::Marker marker;
  marker.header.frame_id = frame;
  marker.header.stamp = stamp;
  marker.ns = line.group;
  marker.id = id;
  marker.type = visualization_msgs::Marker::LINE_STRIP;
  marker.action = visualization_msgs::Marker::ADD;
  marker.pose.orientation.w = 1.0;
  marker.scale.x = line.width;
  marker.color = line.colour;
  marker.points.reserve(candidate.poses.size());
  for (const Pose2& pose : candidate.poses) {
    geometry_msgs::Point point;
    point.x = pose.x;
    point.y = pose.y;
    point.z = line.height;
    marker.points.push_back(point);
  }
  // RViz draws no line of one point.
  if (marker.points.size() == 1) marker.points.push_back(marker.points.front());
  return marker;
}

struct Range {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();
  /// 0 for the cheapest, 1 for the dearest.
  double share(double total) const { return high > low ? (total - low) / (high - low) : 0.0; }
};

Range range_of(const std::vector<CandidateReport>& candidates) {
  Range range;
  for (const CandidateReport& candidate : candidates) {
    if (!candidate.legal()) continue;
    range.low = std::min(range.low, candidate.total);
    range.high = std::max(range.high, candidate.total);
  }
  return range;
}

bool exists(int index, const std::vector<CandidateReport>& candidates) {
  return index >= 0 && static_cast<std::size_t>(index) < candidates.size();
}

}  // namespace

Evaluation to_evaluation(const std::vector<CandidateReport>& candidates, const Planner::Marked& marked,
                         const std::string& frame, const ros::Time& stamp) {
  Evaluation message;
  message.header.frame_id = frame;
  message.header.stamp = stamp;
  message.twists.reserve(candidates.size());
  for (const CandidateReport& candidate : candidates) message.twists.push_back(to_score(candidate));
  message.best_index = marked.best >= 0 ? static_cast<std::uint32_t>(marked.best) : Evaluation::NONE;
  message.worst_index = marked.worst >= 0 ? static_cast<std::uint32_t>(marked.worst) : Evaluation::NONE;
  return message;
}

visualization_msgs::MarkerArray to_markers(const std::vector<CandidateReport>& candidates,
                                           const Planner::Marked& marked, const std::string& frame,
                                           const ros::Time& stamp) {
  visualization_msgs::MarkerArray message;
  message.markers.resize(1);
  message.markers[0].header.frame_id = frame;
  message.markers[0].header.stamp = stamp;
  message.markers[0].action = visualization_msgs::Marker::DELETEALL;
  const Range range = range_of(candidates);
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    const bool legal = candidates[i].legal();
    const double share = legal ? range.share(candidates[i].total) : 0.0;
    const Line line = legal ? Line{"legal", colour(share, 1.0 - share, 0.0, 0.6), 0.01, 0.01}
                            : Line{"rejected", colour(0.5, 0.5, 0.5, 0.25), 0.005, 0.0};
    message.markers.push_back(to_line(candidates[i], line, static_cast<int>(i), frame, stamp));
  }
  const auto mark = [&](int index, const Line& line) {
    if (!exists(index, candidates)) return;
    message.markers.push_back(to_line(candidates[static_cast<std::size_t>(index)], line, 0, frame, stamp));
  };
  mark(marked.operator_command, {"operator", colour(0.1, 0.4, 1.0, 1.0), 0.03, 0.02});
  mark(marked.best, {"chosen", colour(1.0, 1.0, 1.0, 1.0), 0.03, 0.03});
  return message;
}

}  // namespace hidwa_local_planner
