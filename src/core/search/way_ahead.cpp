// SPDX-License-Identifier: BSD-3-Clause
#include "core/search/way_ahead.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <tuple>

#include "hidwa_local_planner/core/util/vector_clones.hpp"

namespace hidwa_local_planner {
namespace {

using Parts = WayAhead::Parts;
constexpr std::size_t kLanes = std::tuple_size<Parts::Each>::value;
static_assert(sizeof(Four) == sizeof(Parts::Each));

// Memory is kept for four times so many parts.
constexpr std::size_t kUsualFours = 64;

void take(const Parts::Each& each, Four& four) { std::memcpy(&four, each.data(), sizeof(four)); }

// Way::place_on(), of each part.
HIDWA_VECTOR_CLONES
double least_remaining(const std::vector<Parts>& all, double pose_x, double pose_y, double room) {
  Four least = Four{} + std::numeric_limits<double>::infinity();
  const Four one = Four{} + 1.0, none = Four{}, rooms = Four{} + room;
  for (const Parts& parts : all) {
    Four a_x, a_y, dx, dy, turn, squared, left, passes, turned;
    take(parts.x, a_x);
    take(parts.y, a_y);
    take(parts.dx, dx);
    take(parts.dy, dy);
    take(parts.turn, turn);
    take(parts.squared, squared);
    take(parts.left, left);
    take(parts.passes, passes);
    take(parts.turned, turned);
    const Four x = pose_x - a_x, y = pose_y - a_y;
    Four share = (x * dx + y * dy + turned * turn) / squared;
    share = share < none ? none : (one < share ? one : share);
    const Four ox = x - share * dx, oy = y - share * dy, ot = turned - share * turn;
    Four off = ox * ox + oy * oy + ot * ot;
    for (std::size_t lane = 0; lane < kLanes; ++lane) off[lane] = std::sqrt(off[lane]);
    const Four within = rooms < off ? rooms : off;
    const Four back = within / Way::kBackSpeed + (off - within) / Way::kSlowBackSpeed;
    const Four remaining = left + share * passes + back;
    least = remaining < least ? remaining : least;
  }
  double smallest = least[0];
  for (std::size_t lane = 1; lane < kLanes; ++lane) smallest = std::min(smallest, least[lane]);
  return smallest;
}

void set(Parts& parts, std::size_t lane, const Way::Station& a, const Way::Station& b) {
  const double dx = b.pose.x - a.pose.x, dy = b.pose.y - a.pose.y;
  const double turn = Way::kRadianLength * wrap_angle(b.pose.theta - a.pose.theta);
  const double squared = dx * dx + dy * dy + turn * turn;
  parts.x[lane] = a.pose.x;
  parts.y[lane] = a.pose.y;
  parts.heading[lane] = a.pose.theta;
  parts.dx[lane] = dx;
  parts.dy[lane] = dy;
  parts.turn[lane] = turn;
  parts.squared[lane] = squared > 0.0 ? squared : 1.0;
  parts.left[lane] = a.left;
  parts.passes[lane] = b.left - a.left;
}

}  // namespace

WayAhead::WayAhead() { parts_.reserve(kUsualFours); }

void WayAhead::look(const Way& way, std::size_t from, std::size_t end, double room) {
  const std::vector<Way::Station>& stations = way.stations();
  const std::size_t last = stations.size() - 1;
  from = std::min(from, last);
  end = std::clamp(end, from + 1, stations.size());
  room_ = room;
  parts_.resize((end - from + kLanes - 1) / kLanes);
  for (std::size_t i = 0; i < parts_.size() * kLanes; ++i) {
    const std::size_t part = std::min(from + i, end - 1);
    set(parts_[i / kLanes], i % kLanes, stations[part], stations[std::min(part + 1, last)]);
  }
}

double WayAhead::remaining(const Pose2& pose) {
  for (Parts& parts : parts_) {
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
      parts.turned[lane] = Way::kRadianLength * wrap_angle(pose.theta - parts.heading[lane]);
    }
  }
  return least_remaining(parts_, pose.x, pose.y, room_);
}

}  // namespace hidwa_local_planner
