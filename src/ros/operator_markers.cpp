// SPDX-License-Identifier: BSD-3-Clause
#include "ros/operator_markers.hpp"

#include <algorithm>
#include <cmath>

#include "ros/conversions.hpp"

namespace hidwa_local_planner {
namespace {

// Capitals are 0.7 of the height: in a view of 10 m they stand at 1/20 of it and more.
constexpr double kLetters = 0.8;       // height [m]
constexpr double kSmallLetters = 0.4;  // [m]
constexpr double kTextHeight = 1.3;    // above the floor [m]
constexpr double kNose = 0.45;         // from the robot's centre [m]
constexpr double kShown = 1.6;         // duration of the paths shown [s]
constexpr int kParts = 16;             // of a path
constexpr double kStill = 0.02;        // shorter paths are not shown [m]

std_msgs::ColorRGBA colour(int red, int green, int blue) {
  std_msgs::ColorRGBA c;
  c.r = static_cast<float>(red) / 255.0F;
  c.g = static_cast<float>(green) / 255.0F;
  c.b = static_cast<float>(blue) / 255.0F;
  c.a = 1.0F;
  return c;
}

// Told apart by people who see few colours too (after Okabe and Ito), and by how dark they are.
std_msgs::ColorRGBA colour_of(std::uint8_t state) {
  switch (state) {
    case OperatorState::AUTONOMY:
      return colour(70, 110, 150);
    case OperatorState::SHARED:
      return colour(0, 130, 95);
    case OperatorState::HOLD:
      return colour(60, 170, 220);
    case OperatorState::MANUAL:
      return colour(190, 100, 0);
    case OperatorState::STOPPED:
      return colour(20, 20, 20);
    case OperatorState::LOST:
      return colour(150, 70, 150);
    default:
      return colour(200, 30, 20);  // BLOCKED
  }
}

visualization_msgs::Marker marker(const std::string& base_frame, const std::string& group, int type) {
  visualization_msgs::Marker m;
  m.header.frame_id = base_frame;  // stamp 0: at the newest transform
  m.ns = group;
  m.type = type;
  m.action = visualization_msgs::Marker::ADD;
  m.pose.orientation.w = 1.0;
  m.frame_locked = 1;
  return m;
}

visualization_msgs::Marker text(const std::string& base_frame, const std::string& group, const std::string& words,
                                double height, double above, const std_msgs::ColorRGBA& c) {
  visualization_msgs::Marker m = marker(base_frame, group, visualization_msgs::Marker::TEXT_VIEW_FACING);
  m.text = words;
  m.scale.z = height;
  m.pose.position.z = above;
  m.color = c;
  if (words.empty()) m.action = visualization_msgs::Marker::DELETE;
  return m;
}

// Where the nose is after `time` [s] at a constant velocity (the unicycle's arc).
geometry_msgs::Point nose_after(const Twist2& u, double time, double height) {
  const double turn = u.omega * time;
  const double forward = u.v * time;
  const double half = 0.5 * turn;
  const double chord = std::abs(half) < 1e-9 ? forward : forward * std::sin(half) / half;
  geometry_msgs::Point p;
  p.x = chord * std::cos(half) + kNose * std::cos(turn);
  p.y = chord * std::sin(half) + kNose * std::sin(turn);
  p.z = height;
  return p;
}

struct Style {
  double width;   // [m]
  double height;  // above the floor [m]
  std_msgs::ColorRGBA colour;
};

void add_path(visualization_msgs::MarkerArray& all, const std::string& base_frame, const std::string& group,
              const Twist2& u, bool shown, const Style& style) {
  visualization_msgs::Marker line = marker(base_frame, group, visualization_msgs::Marker::LINE_STRIP);
  line.scale.x = style.width;
  line.color = style.colour;
  for (int i = 0; i <= kParts; ++i) line.points.push_back(nose_after(u, kShown * i / kParts, style.height));
  visualization_msgs::Marker head = marker(base_frame, group, visualization_msgs::Marker::ARROW);
  head.id = 1;
  head.color = style.colour;
  head.scale.x = style.width;
  head.scale.y = 3.0 * style.width;
  head.scale.z = 3.0 * style.width;
  const geometry_msgs::Point tip = line.points.back();
  const geometry_msgs::Point before = line.points[line.points.size() - 2];
  const double step = std::hypot(tip.x - before.x, tip.y - before.y);
  const bool moves = shown && step * kParts > kStill;
  if (moves) {
    geometry_msgs::Point end = tip;
    const double length = 4.0 * style.width;
    end.x += length * (tip.x - before.x) / step;
    end.y += length * (tip.y - before.y) / step;
    head.points = {tip, end};
  } else {
    line.points.clear();
    line.action = head.action = visualization_msgs::Marker::DELETE;
  }
  all.markers.push_back(line);
  all.markers.push_back(head);
}

}  // namespace

visualization_msgs::MarkerArray to_operator_markers(const OperatorState& state, const std::string& base_frame) {
  visualization_msgs::MarkerArray all;
  const std_msgs::ColorRGBA c = colour_of(state.state);
  // A place beside the robot in its own frame would turn with it, so the text hangs above its centre; line breaks
  // keep it off the robot in a view from above.
  const std::string name = state.state_name + (state.without_goal != 0 ? "\nno goal\n" : "");
  all.markers.push_back(text(base_frame, "state", name + "\n\n\n", kLetters, kTextHeight, c));
  const std::string rejected = state.refused_by.empty() ? "" : "\n\n\n\n\nrejected by " + state.refused_by;
  all.markers.push_back(text(base_frame, "rejection", rejected, kSmallLetters, kTextHeight, colour(200, 30, 20)));
  const bool commanded = state.active != 0;
  add_path(all, base_frame, "executed", to_twist(state.command), true, {0.09, 0.1, colour(30, 30, 30)});
  add_path(all, base_frame, "wanted", to_twist(state.wanted), commanded, {0.045, 0.2, colour(225, 0, 140)});
  return all;
}

}  // namespace hidwa_local_planner
