// SPDX-License-Identifier: BSD-3-Clause
#include "control/plan_window.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "crossing.hpp"

namespace hidwa_local_planner {
namespace {

// How far ahead of the progress a nearer stretch of the plan may be found [m]: more than a cycle's travel and a
// replan's offset, less than the way round a loop.
constexpr double kSearchAhead = 2.0;

// Poses that are no farther apart need none between them [m]: on cells of 0.1 m those of a diagonal are 0.14 m apart.
constexpr double kSpacing = 0.15;

// A plan has no more poses put in than about so many, however far apart its poses are.
constexpr double kMostPoses = 1e5;

// Rounding in a spacing: what was put in needs nothing more put in.
constexpr double kRounding = 1e-6;

// The plan comes near itself where the way along it is so many times the straight line.
constexpr double kDetour = 2.0;

// A turn is reached within this share of the tolerance, and no nearer than this [m], about a cell.
constexpr double kWithinTolerance = 0.7;
constexpr double kNearest = 0.08;

// A place of the plan within this distance may be one to which the robot was steered [m].
constexpr double kPasses = 0.5;

// Whose heading is within this angle of the plan's goes on in its direction [rad].
constexpr double kSameDirection = M_PI / 3.0;

double reach_of(double tolerance) { return std::max(kWithinTolerance * tolerance, kNearest); }

}  // namespace

std::vector<Pose2> with_poses_between(const std::vector<Pose2>& plan) {
  double length = 0.0;
  for (std::size_t i = 1; i < plan.size(); ++i) {
    const double gap = distance(plan[i - 1], plan[i]);
    if (std::isfinite(gap)) length += gap;
  }
  const double spacing = std::max(kSpacing, length / kMostPoses);
  std::vector<Pose2> dense;
  dense.reserve(plan.size());
  for (std::size_t i = 0; i < plan.size(); ++i) {
    // The first pose has none before it, and looks to the next one.
    const Pose2& from = plan[i > 0 ? i - 1 : 0];
    const Pose2& to = plan[i > 0 ? i : std::min<std::size_t>(1, plan.size() - 1)];
    const double dx = to.x - from.x, dy = to.y - from.y, gap = distance(from, to);
    const double along = std::atan2(dy, dx);
    const double parts = i > 0 && std::isfinite(gap) ? std::ceil(gap / spacing - kRounding) : 1.0;
    for (double part = 1.0; part < parts; part += 1.0) {
      dense.push_back({from.x + part / parts * dx, from.y + part / parts * dy, along});
    }
    dense.push_back(plan[i]);
    if (std::isnan(plan[i].theta)) dense.back().theta = along;
  }
  return dense;
}

void PlanWindow::set_plan(std::vector<Pose2> plan) {
  left_before_ = -1.0;
  plan_ = std::move(plan);
  arc_.assign(plan_.size(), 0.0);
  for (std::size_t i = 1; i < plan_.size(); ++i) arc_[i] = arc_[i - 1] + distance(plan_[i - 1], plan_[i]);
  progress_ = -1.0;
  passed_ = 0.0;
  turn_ = kNone;
}

void PlanWindow::replace_plan(std::vector<Pose2> plan) {
  const double left = plan_.empty() || progress_ < 0.0 ? left_before_ : length() - progress_;
  set_plan(std::move(plan));
  left_before_ = left;
}

double PlanWindow::heading(std::size_t segment) const {
  const Pose2 &a = plan_[segment], &b = plan_[segment + 1];
  return std::atan2(b.y - a.y, b.x - a.x);
}

PlanWindow::Projection PlanWindow::project(std::size_t segment, const Pose2& robot) const {
  const Pose2 &a = plan_[segment], &b = plan_[segment + 1];
  const double dx = b.x - a.x;
  const double dy = b.y - a.y;
  const double length2 = dx * dx + dy * dy;
  double t = 0.0;
  if (length2 > 0.0) t = std::clamp(((robot.x - a.x) * dx + (robot.y - a.y) * dy) / length2, 0.0, 1.0);
  const double ex = a.x + t * dx - robot.x;
  const double ey = a.y + t * dy - robot.y;
  return {arc_[segment] + t * (arc_[segment + 1] - arc_[segment]), ex * ex + ey * ey, segment};
}

PlanWindow::Projection PlanWindow::nearest(const Pose2& robot, double from, double to) const {
  Projection best{from, kNone, 0};
  for (std::size_t i = 0; i + 1 < plan_.size() && arc_[i] <= to; ++i) {
    if (arc_[i + 1] < from) continue;
    const Projection place = project(i, robot);
    if (place.distance2 < best.distance2 - 1e-12) best = place;
  }
  best.arc = std::max(from, std::min(best.arc, to));
  return best;
}

// The nearest place of each stretch that stays `within` [m] of the robot, from arc length `from` on. `visit` returns
// true to end.
template <typename Visit>
void PlanWindow::visit_projections(const Pose2& robot, double from, double within, Visit&& visit) const {
  Projection best;
  bool near = false;
  for (std::size_t i = 0; i + 1 < plan_.size(); ++i) {
    if (arc_[i + 1] < from) continue;
    Projection place = project(i, robot);
    place.arc = std::max(place.arc, from);
    if (place.distance2 > within * within) {
      if (near && visit(best)) return;
      near = false;
    } else if (!near || place.distance2 < best.distance2 - 1e-12) {
      best = place;
      near = true;
    }
  }
  if (near) visit(best);
}

// A host may hand over a plan that starts behind the robot.
double PlanWindow::first_place(const Pose2& robot, const PlanOrder& order) const {
  const Projection any = nearest(robot, 0.0, length());
  double chosen = any.arc;
  int places = 0;
  visit_projections(robot, 0.0, std::sqrt(any.distance2) + order.tolerance, [&](const Projection& place) {
    const auto off = [this](double arc) { return std::abs(length() - arc - left_before_); };
    if (++places == 1 || off(place.arc) < off(chosen)) chosen = place.arc;
    return left_before_ < 0.0;
  });
  return chosen;
}

void PlanWindow::advance(const Pose2& robot, const PlanOrder* order) {
  if (plan_.empty()) return;
  if (progress_ < 0.0) {
    progress_ = order != nullptr ? first_place(robot, *order) : nearest(robot, 0.0, length()).arc;
  } else {
    progress_ = nearest(robot, progress_, std::min(progress_ + kSearchAhead, turn_)).arc;
  }
  if (order == nullptr) {
    turn_ = kNone;
    return;
  }
  if (order->steered) pass_by_steering(robot, order->tolerance);
  if (turn_ == kNone) return;
  const double reach = reach_of(order->tolerance);
  if (distance(turn(), robot) <= reach || (order->steered && progress_ >= turn_ - reach)) pass_turn();
}

void PlanWindow::pass_by_steering(const Pose2& robot, double tolerance) {
  const double away = std::sqrt(nearest(robot, progress_, length()).distance2);
  if (away > kPasses) return;
  visit_projections(robot, progress_, std::min(away + tolerance, kPasses), [&](const Projection& place) {
    if (std::abs(wrap_angle(heading(place.segment) - robot.theta)) > kSameDirection) return false;
    progress_ = std::max(progress_, place.arc);
    return true;
  });
  if (progress_ > turn_) pass_turn();
}

void PlanWindow::pass_turn() {
  if (turn_ != kNone) passed_ = turn_;
  turn_ = kNone;
}

// The first place that comes near to one before it tells how long the way round the turn is: where so long a way leads
// nearest to itself the turn is in its middle.
void PlanWindow::find_turn(double ahead, const PlanOrder& order, const PlanGround& ground) {
  if (plan_.empty()) return;
  const auto point = [&](std::size_t i) {
    const Pose2 pose = ground.from_plan.apply(plan_[i]);
    return Point(pose.x, pose.y);
  };
  const auto blocked = [&](std::size_t from, std::size_t to) {
    return control::crosses_obstacle(point(from), point(to), ground.costmap);
  };
  const auto index = [this](double arc) {
    return static_cast<std::size_t>(std::lower_bound(arc_.begin(), arc_.end(), arc) - arc_.begin());
  };
  // The last place up to the turn that can be reached.
  const auto keep_free = [&] {
    std::size_t i = std::min(index(turn_), plan_.size() - 1);
    while (i > next_pose() && blocked(i, i)) turn_ = arc_[--i];
  };
  if (turn_ != kNone) return keep_free();
  // What is shorter than this does not get out of reach.
  const double least = kDetour * reach_of(order.tolerance) / kWithinTolerance;
  const std::size_t first = index(std::max(progress_, passed_));
  for (std::size_t to = first; to < plan_.size() && arc_[to] <= progress_ + ahead; ++to) {
    for (std::size_t from = first; from < to && arc_[to] - arc_[from] >= least;) {
      const double more = kDetour * distance(plan_[from], plan_[to]) - (arc_[to] - arc_[from]);
      if (more <= 0.0 && !blocked(from, to)) {
        turn_ = middle_of_turn(from, arc_[to] - arc_[from]);
        keep_free();
        if (turn_ - progress_ <= reach_of(order.tolerance)) pass_turn();
        return;
      }
      // A step along the plan brings the two nearer to each other by no more than its length.
      from = std::max(from + 1, index(arc_[from] + more / (kDetour + 1.0)));
    }
  }
}

// Of a way of length `round` [m] that begins at the pose `from` or up to half as far on.
double PlanWindow::middle_of_turn(std::size_t from, double round) const {
  double least = kNone, begin = arc_[from];
  for (std::size_t i = from; arc_[i] <= arc_[from] + 0.5 * round && arc_[i] + round <= length() + kRounding; ++i) {
    const double apart = distance(plan_[i], at(arc_[i] + round));
    if (apart >= least - kRounding) continue;
    least = apart;
    begin = arc_[i];
  }
  return begin + 0.5 * round;
}

PlanWindow::Range PlanWindow::range(double behind, double ahead) const {
  if (plan_.empty()) return {};
  Range range{plan_.size() - 1, plan_.size(), progress_ + ahead >= turn_};
  const double from = std::max(progress_ - behind, std::min(passed_, progress_));
  const double to = std::min(progress_ + ahead, turn_);
  const auto begin = std::lower_bound(arc_.begin(), arc_.end(), from - 1e-9);
  const auto end = std::upper_bound(arc_.begin(), arc_.end(), to + 1e-9);
  range.begin = std::min(static_cast<std::size_t>(begin - arc_.begin()), plan_.size() - 1);
  range.end = std::max(static_cast<std::size_t>(end - arc_.begin()), range.begin + 1);
  return range;
}

Pose2 PlanWindow::at(double arc) const {
  const auto after = static_cast<std::size_t>(std::lower_bound(arc_.begin(), arc_.end(), arc) - arc_.begin());
  if (after == 0) return plan_.front();
  if (after >= plan_.size()) return plan_.back();
  const Pose2 &a = plan_[after - 1], &b = plan_[after];
  const double t = (arc - arc_[after - 1]) / (arc_[after] - arc_[after - 1]);
  return {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y), a.theta};
}

bool PlanWindow::leads_to_end(double tolerance) const {
  if (plan_.empty() || progress_ < 0.0) return false;
  if (length() - progress_ <= 2.0 * tolerance) return true;
  return std::all_of(plan_.begin() + static_cast<std::ptrdiff_t>(next_pose()), plan_.end(),
                     [&](const Pose2& pose) { return distance(pose, plan_.back()) <= tolerance; });
}

std::size_t PlanWindow::next_pose() const {
  return static_cast<std::size_t>(std::lower_bound(arc_.begin(), arc_.end(), progress_ - 1e-9) - arc_.begin());
}

}  // namespace hidwa_local_planner
