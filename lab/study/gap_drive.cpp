// SPDX-License-Identifier: BSD-3-Clause
#include "study/gap_drive.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <memory>
#include <stdexcept>
#include <utility>

#include "drive/outline.hpp"
#include "study/table.hpp"

namespace hidwa_local_planner {
namespace study {
namespace {

// The room: the wall with the gap stands across its middle, from wall to wall. Lengths in [m].
constexpr double kRoomLength = 4.4;
constexpr double kRoomWidth = 2.6;
constexpr double kOuterWall = 0.1;
constexpr double kWall = 0.2;
constexpr double kAway = 1.5;        // start and goal, from the wall's middle
constexpr double kFineCell = 0.005;  // of the true map
constexpr double kPlanCell = 0.05;

constexpr double kCentimetre = 0.01;
constexpr double kGapPatience = 6.0;    // [s]
constexpr double kGapTimeLimit = 60.0;  // [s]

// A sixteenth: no face of the gap lies on a cell's edge.
constexpr double kBesidePhase = 1.0 / 16.0;

sim::OccupancyMap room(double cell) {
  const int length = static_cast<int>(std::lround(kRoomLength / cell));
  const int width = static_cast<int>(std::lround(kRoomWidth / cell));
  return sim::make_map(length, width, cell, -0.5 * length * cell, -0.5 * width * cell);
}

// Closed all round: who arrives came through the gap.
sim::OccupancyMap room_with_gap(double gap) {
  sim::OccupancyMap map = room(kFineCell);
  for (int row = 0; row < map.height; ++row) {
    for (int column = 0; column < map.width; ++column) {
      const double x = std::abs(map.center_x(column)), y = std::abs(map.center_y(row));
      const bool outer = x > 0.5 * kRoomLength - kOuterWall || y > 0.5 * kRoomWidth - kOuterWall;
      const bool across = x < 0.5 * kWall && y > 0.5 * gap;
      if (outer || across) map.cells[map.index(column, row)] = sim::Cell::kOccupied;
    }
  }
  return map;
}

// The plan leads straight on along the x axis, whatever stands there: which gaps the robot gets through shall depend on
// it alone.
std::shared_ptr<const sim::GridRoute> straight_route() {
  static const auto route = [] {
    sim::OccupancyMap map = room(kPlanCell);
    map.origin_y -= 0.5 * kPlanCell * ((map.height + 1) % 2);  // a row's centres lie on the axis
    return std::make_shared<const sim::GridRoute>(map, sim::RouteClearance{}, Eigen::Vector2d(kAway, 0.0));
  }();
  return route;
}

struct GapOutline {
  double half_length = 0.0, half_width = 0.0;  // [m]
  double radius = 0.0;                         // [m], of a circle
};

const GapOutline& gap_outline(const std::string& name) {
  static const std::map<std::string, GapOutline> all{
      {"circle", {0.0, 0.0, 0.30}}, {"square", {0.25, 0.25, 0.0}}, {"long", {0.45, 0.20, 0.0}}};
  return all.at(name);
}

sim::Polygon corners_of(const GapOutline& outline, double padding) {
  if (outline.radius > 0.0) return drive::circle_outline(outline.radius, padding);
  const double x = outline.half_length, y = outline.half_width;
  return drive::padded_outline({{x, y}, {-x, y}, {-x, -y}, {x, -y}}, padding);
}

bool through(const drive::DriveResult& result) { return result.arrived && result.contacts == 0; }

}  // namespace

void assign_gap(GapSubject& subject, const Assignment& assignment) {
  struct Entry {
    double* member;
    double least, greatest;
  };
  const std::map<std::string, Entry> entries{{"costmap.resolution", {&subject.resolution, 0.01, 0.2}},
                                             {"costmap.footprint_padding", {&subject.padding, 0.0, 0.5}},
                                             {"laser.noise", {&subject.noise, 0.0, 0.2}}};
  const auto found = entries.find(assignment.name);
  if (found == entries.end()) return assign(subject.subject, assignment);
  const Entry& entry = found->second;
  *entry.member = number_within(assignment.name, assignment.value, entry.least, entry.greatest);
}

const std::vector<std::string>& gap_outlines() {
  static const std::vector<std::string> names{"circle", "square", "long"};
  return names;
}

double width_of(const std::string& outline) {
  return 2.0 * std::max(gap_outline(outline).half_width, gap_outline(outline).radius);
}

drive::DriveResult drive_gap(const GapSubject& subject, const std::string& outline, double width, double phase,
                             std::uint64_t seed) {
  const double beside = (phase + kBesidePhase) * subject.resolution;
  drive::DriveSetup setup;
  setup.ground = std::make_shared<drive::Ground>(std::make_shared<sim::OccupancyMap>(room_with_gap(width)));
  setup.route = straight_route();
  setup.start = {-kAway - beside, -beside, 0.0};  // a corner of the costmap's cells lies there
  setup.goal = {kAway, 0.0, 0.0};
  setup.footprint = corners_of(gap_outline(outline), 0.0);
  setup.outline = corners_of(gap_outline(outline), subject.padding);
  setup.limits.latency = 0.05;
  setup.laser.noise = subject.noise;
  setup.laser_pose = {0.0, 0.0, 0.0};
  setup.costmap.resolution = subject.resolution;
  setup.parameters = subject.subject.parameters;
  setup.laser_seed = seed;
  setup.patience = kGapPatience;
  setup.time_limit = kGapTimeLimit;
  setup.end_at_contact = true;
  return drive::drive(setup);
}

Narrowest narrowest_gap(const GapSubject& subject, const std::string& outline, double phase, std::uint64_t seed) {
  Narrowest found;
  const double widest = width_of(outline) + 2.0 * subject.padding + 4.0 * subject.resolution + 6.0 * subject.noise;
  int fails = static_cast<int>(std::floor(width_of(outline) / kCentimetre + 1e-6));
  int passes = static_cast<int>(std::ceil(widest / kCentimetre)) + 1;
  const auto drives_through = [&](int centimetres) {
    ++found.drives;
    drive::DriveResult result = drive_gap(subject, outline, centimetres * kCentimetre, phase, seed);
    if (!through(result)) return false;
    found.result = std::move(result);
    return true;
  };
  for (; !drives_through(passes); ++passes) {
    if (passes * kCentimetre > kRoomWidth) throw std::runtime_error("no gap is wide enough for the " + outline);
  }
  while (passes - fails > 1) {
    const int middle = (passes + fails) / 2;
    (drives_through(middle) ? passes : fails) = middle;
  }
  found.width = passes * kCentimetre;
  return found;
}

}  // namespace study
}  // namespace hidwa_local_planner
