// SPDX-License-Identifier: BSD-3-Clause
#include "control/plan_choice.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

#include "crossing.hpp"
#include "enclosed_obstacle.hpp"

namespace hidwa_local_planner::control {
namespace {

// Plans are compared over this distance ahead [m].
constexpr double kSameWayFor = 6.0;

// A plan on the other side costs less than going on by at least this share: a fifth. A convention: what is nearer to
// each other is about the same, and plan_hysteresis_time bounds what it can cost.
constexpr double kClearlyCheaper = 0.2;

// navfn's: a cell costs 50 and 0.8 of its cost.
constexpr double kCostPerMetre = 0.8 / 50.0;

std::uint8_t cost_at(const GridView& grid, const Point& p) {
  return grid.holds(p) ? grid.at(grid.cell_at(p.x(), p.y())) : cost::kFree;
}

// From the robot to the end of a plan, from its pose that is nearest to the robot.
void lay_out(const std::vector<Pose2>& plan, const FrameTransform& from_plan, const Pose2& robot,
             std::vector<Point>& way) {
  way.clear();
  way.emplace_back(robot.x, robot.y);
  std::size_t nearest = 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < plan.size(); ++k) {
    const Pose2 pose = from_plan.apply(plan[k]);
    way.emplace_back(pose.x, pose.y);
    const double away = distance(pose, robot);
    if (away >= least) continue;
    least = away;
    nearest = k;
  }
  way.erase(way.begin() + 1, way.begin() + 1 + static_cast<std::ptrdiff_t>(nearest));
}

// The first points, those before the way leaves the map.
std::size_t points_on_map(const std::vector<Point>& way, const GridView& grid) {
  std::size_t count = 0;
  while (count < way.size() && grid.holds(way[count])) ++count;
  return count;
}

bool leads_through_obstacle(const std::vector<Point>& way, std::size_t count, const GridView& grid) {
  for (std::size_t k = 1; k < count; ++k) {
    if (crosses_obstacle(way[k - 1], way[k], grid)) return true;
  }
  return false;
}

double cost_of(const std::vector<Point>& way, const GridView& grid) {
  double sum = 0.0;
  for (std::size_t k = 1; k < way.size(); ++k) {
    const std::uint8_t c = cost_at(grid, way[k]);
    const double weight = c == cost::kUnknown ? 1.0 : 1.0 + kCostPerMetre * c;
    sum += weight * (way[k] - way[k - 1]).norm();
  }
  return sum;
}

}  // namespace

bool same_way(const std::vector<Pose2>& followed, std::size_t from, const std::vector<Pose2>& fresh, double apart) {
  // As far as the fresh plan is looked at, and some more: it may begin behind the robot, or ahead of it.
  std::size_t to = from;
  for (double arc = 0.0; to < followed.size() && arc <= kSameWayFor + 1.0; ++to) {
    if (to > from) arc += distance(followed[to - 1], followed[to]);
  }
  double arc = 0.0;
  for (std::size_t k = 0; k < fresh.size() && arc <= kSameWayFor; ++k) {
    if (k > 0) arc += distance(fresh[k - 1], fresh[k]);
    const auto begin = followed.begin() + static_cast<std::ptrdiff_t>(from);
    const auto end = followed.begin() + static_cast<std::ptrdiff_t>(to);
    if (std::none_of(begin, end, [&](const Pose2& pose) { return distance(pose, fresh[k]) <= apart; })) return false;
  }
  return true;
}

void PlanChoice::clear() {
  offered_.clear();
  waits_.reset();
  gives_way_ = false;
}

std::vector<Pose2> PlanChoice::take() {
  std::vector<Pose2> plan = std::move(offered_);
  clear();
  return plan;
}

bool PlanChoice::prefers_offer(const Context& context, const Parameters& parameters) {
  if (!context.autonomous || gives_way_ || parameters.method == Method::paper) return true;
  const GridView& grid = context.costmap;
  lay_out(context.followed, context.from_plan, context.robot, old_way_);
  lay_out(offered_, context.from_plan, context.robot, new_way_);
  const std::size_t old_points = points_on_map(old_way_, grid);
  const std::size_t new_points = points_on_map(new_way_, grid);
  outline_.assign(old_way_.begin(), old_way_.begin() + static_cast<std::ptrdiff_t>(old_points));
  outline_.insert(outline_.end(),
                  std::make_reverse_iterator(new_way_.begin() + static_cast<std::ptrdiff_t>(new_points)),
                  new_way_.rend());
  const bool waits = encloses_obstacle(outline_, grid) && !leads_through_obstacle(old_way_, old_points, grid) &&
                     !(cost_of(new_way_, grid) < (1.0 - kClearlyCheaper) * cost_of(old_way_, grid));
  waits_.observe(context.now, waits);
  return !waits || waits_.for_at_least(parameters.plan_hysteresis_time, context.now);
}

}  // namespace hidwa_local_planner::control
