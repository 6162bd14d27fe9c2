// SPDX-License-Identifier: BSD-3-Clause
// What moves, as a search of ways sees it.
#include <algorithm>
#include <cmath>

#include "core/search/evasion_search.hpp"

namespace hidwa_local_planner {
namespace {

constexpr double kUnsure = 0.1;    // how fast D grows for everything that moves [m/s]
constexpr double kTouches = 0.03;  // what is nearer counts as touched [m]

// A robot that is slower rests [m/s].
constexpr double kRests = 0.03;

}  // namespace

bool EvasionSearch::look(const Start& scene, const MovingObstacleEstimates& movers) {
  movers_.clear();
  const Parameters& p = scene.cycle.parameters;
  horizon_ = p.evasion_time;
  bends_for_ = p.evasion_acceleration_time;
  fastest_ = scene.limits.x.fastest();
  const double whole = scene.delay + horizon_;
  for (const MovingObstacleEstimate& mover : movers) {
    const Point now = mover.position_now();
    const double grows = kUnsure + mover.velocity_deviation;
    const Point bend = scene.cycle.accelerations != nullptr ? scene.cycle.accelerations->of(mover.id) : Point(0.0, 0.0);
    const double off = std::hypot(now.x() - scene.from.pose.x, now.y() - scene.from.pose.y);
    const double closes = (fastest_ + mover.velocity.norm() + bends_for_ * bend.norm() + grows) * whole;
    const double radius = mover.radius + mover.position_deviation;
    if (off > closes + radius + p.evasion_distance + scene.cycle.footprint.circumscribed_radius()) continue;
    movers_.push_back({now.x(), now.y(), mover.velocity.x(), mover.velocity.y(), radius, p.evasion_distance, grows,
                       bend.x(), bend.y()});
  }
  if (movers_.empty()) return false;
  plan_spans(scene);
  return true;
}

// By how much an acceleration of 1 m/s^2 moves something until then [m].
double EvasionSearch::bend(double time) const {
  const double bends = std::min(time, bends_for_);
  return bends * (time - 0.5 * bends);
}

// What may come near within a span, from here.
void EvasionSearch::find_near(const Start& scene, const State& from, const Span& span) {
  near_.clear();
  const double length = span.length(), end = span.end();
  const double own = scene.cycle.footprint.circumscribed_radius() + length * fastest_;
  const double middle = span.from + 0.5 * length, bent = bend(middle);
  const Stopping stops = stopping(scene, fastest_);
  for (const Mover& mover : movers_) {
    // To where it is in the middle of the span.
    const double dx = mover.x_at(middle, bent) - from.x;
    const double dy = mover.y_at(middle, bent) - from.y;
    const double speed =
        std::abs(mover.vx) + std::abs(mover.vy) + bends_for_ * (std::abs(mover.ax) + std::abs(mover.ay));
    const double half = 0.5 * length * speed;
    const double stopping_way = std::abs(stops.way) + stops.room + stops.time * speed;
    const double most = own + half + mover.radius + std::max(mover.kept + mover.kept_grows * end, stopping_way);
    if (dx * dx + dy * dy < most * most) near_.push_back(mover);
  }
  walls_ = !scene.checker.clear_around(from.x, from.y, length * fastest_);
}

// Until a command takes effect, two periods, and half of the braking: the robot is half as fast then.
EvasionSearch::Stopping EvasionSearch::stopping(const Start& scene, double v) {
  const double speed = std::abs(v);
  if (speed < kRests) return {};
  const Parameters& p = scene.cycle.parameters;
  const double time = p.control_latency + 2.0 * scene.cycle.start.period + 0.5 * speed / scene.limits.x.braking;
  return {time, 0.5 * v * time, 0.5 * p.moving_obstacle_acc * time * time};
}

// Whether something that moves may be where the robot is when it has stopped.
bool EvasionSearch::must_stop(const Start& scene, const State& state, double time) const {
  if (near_.empty()) return false;
  const Stopping stops = stopping(scene, state.v);
  if (stops.time <= 0.0) return false;
  const double own = scene.cycle.footprint.circumscribed_radius() + stops.room, then = time + stops.time,
               bent = bend(then);
  const double x = state.x + stops.way * state.heading.c, y = state.y + stops.way * state.heading.s;
  return std::any_of(near_.begin(), near_.end(), [&](const Mover& mover) {
    const double dx = mover.x_at(then, bent) - x;
    const double dy = mover.y_at(then, bent) - y;
    const double most = own + mover.radius;
    if (dx * dx + dy * dy >= most * most) return false;
    const Point seen = state.heading.undo({dx, dy});
    return scene.cycle.footprint.distance_to(seen) < mover.radius + stops.room;
  });
}

// At `time`. What ends the way sets `touched`.
double EvasionSearch::nearness(const Start& scene, const State& state, double time, bool& touched) const {
  const double own = scene.cycle.footprint.circumscribed_radius(), bent = bend(time);
  double sum = 0.0;
  for (const Mover& mover : near_) {
    const double kept = mover.kept + mover.kept_grows * time, most = own + mover.radius + kept;
    const double dx = mover.x_at(time, bent) - state.x, dy = mover.y_at(time, bent) - state.y;
    if (dx * dx + dy * dy >= most * most) continue;
    const Point seen = state.heading.undo({dx, dy});
    const double gap = scene.cycle.footprint.distance_to(seen) - mover.radius;
    if (gap >= kept) continue;
    touched = touched || gap < kTouches;
    const double share = 1.0 - std::max(0.0, gap) / kept;
    sum += share * share;
  }
  return sum;
}

// How long before the end it is touched if it goes straight on from where it is at `time`, as a disc [s].
double EvasionSearch::touched_early(const Start& scene, const State& state, double time) const {
  const double rest = scene.delay + horizon_ - time;
  if (rest <= 0.0) return 0.0;
  const double own = scene.cycle.footprint.inscribed_radius() + kTouches;
  const double bends = std::min(time, bends_for_), bent = bend(time);
  double first = rest;
  for (const Mover& mover : movers_) {
    const double dx = mover.x_at(time, bent) - state.x;
    const double dy = mover.y_at(time, bent) - state.y;
    const double vx = mover.vx + mover.ax * bends - state.v * state.heading.c;
    const double vy = mover.vy + mover.ay * bends - state.v * state.heading.s;
    const double closes = -(dx * vx + dy * vy), radius = own + mover.radius;
    const double off = dx * dx + dy * dy - radius * radius;
    if (closes <= 0.0 || off <= 0.0) continue;  // never, or it is looked at already
    const double speed = vx * vx + vy * vy, root = closes * closes - speed * off;
    if (root > 0.0) first = std::min(first, (closes - std::sqrt(root)) / speed);
  }
  return rest - first;
}

}  // namespace hidwa_local_planner
