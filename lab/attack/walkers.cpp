// SPDX-License-Identifier: BSD-3-Clause
#include "walkers.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace hidwa_attack {
namespace {

constexpr double kClose = 1.0;            // of the moving robot: an encounter [m]
constexpr double kIdle = 0.6;             // at a robot at rest; then somebody else comes [s]
constexpr double kLingers = 4.0;          // likewise, who waits there for it to move off [s]
constexpr double kCreeps = 0.16;          // its outermost point, where it leaves somebody [m/s]
constexpr double kAdvances = 0.03;        // towards whom it leaves, at most [m/s]
constexpr double kAppears = 3.0;          // from the robot's centre, at least [m]
constexpr double kWidest = 0.4;           // the radius of the widest [m]
constexpr double kLost = 3.0;             // so much farther away than that somebody else comes [m]
constexpr std::size_t kRemembered = 200;  // steps
constexpr int kPoints = 32;               // of an outline

Spot operator+(const Spot& a, const Spot& b) { return {a.x + b.x, a.y + b.y}; }
Spot operator-(const Spot& a, const Spot& b) { return {a.x - b.x, a.y - b.y}; }
Spot operator*(const Spot& a, double f) { return {a.x * f, a.y * f}; }
double length(const Spot& a) { return std::hypot(a.x, a.y); }
Spot unit(const Spot& a) { return length(a) > 1e-12 ? a * (1.0 / length(a)) : Spot{1.0, 0.0}; }
Spot capped(const Spot& a, double most) { return length(a) > most ? unit(a) * most : a; }

struct Nearest {
  Spot at;
  double away = 1e9;  // negative inside
};

// The place on a polygon's sides that is nearest to a point.
Nearest nearest_on(const std::vector<Spot>& corners, const Spot& p) {
  Nearest nearest;
  bool in = false;
  for (std::size_t i = 0, j = corners.size() - 1; i < corners.size(); j = i++) {
    const Spot a = corners[j], b = corners[i], d = b - a, f = p - a;
    const double t = std::clamp((f.x * d.x + f.y * d.y) / (d.x * d.x + d.y * d.y), 0.0, 1.0);
    if (length(f - d * t) < nearest.away) nearest = {a + d * t, length(f - d * t)};
    if ((a.y > p.y) != (b.y > p.y) && p.x < (b.x - a.x) * (p.y - a.y) / (b.y - a.y) + a.x) in = !in;
  }
  if (in) nearest.away = -nearest.away;
  return nearest;
}

}  // namespace

Walkers::Walkers(int count, const Bounds& bounds, const Shape& robot, const Pose2& pose, std::uint64_t seed)
    : bounds_(bounds), robot_(robot), outermost_(outermost(robot)), random_(seed), pose_(pose) {
  walkers_.resize(static_cast<std::size_t>(count));
  for (Walker& walker : walkers_) place(walker);
}

void Walkers::step(const Pose2& pose, const Twist2& velocity) {
  pose_ = pose;
  velocity_ = velocity;
  for (Walker& walker : walkers_) move(walker);
  look();
}

const Walker& Walkers::nearest() const {
  return *std::min_element(walkers_.begin(), walkers_.end(),
                           [this](const Walker& a, const Walker& b) { return gap(a) < gap(b); });
}

double Walkers::gap(const Walker& walker) const {
  const Spot own = seen(walker);
  return (robot_.corners.empty() ? length(own) - robot_.radius : nearest_on(robot_.corners, own).away) - walker.radius;
}

// In the robot's frame.
Spot Walkers::seen(const Walker& walker) const {
  const double c = std::cos(pose_.theta), s = std::sin(pose_.theta);
  const double x = walker.p.x - pose_.x, y = walker.p.y - pose_.y;
  return {c * x + s * y, -s * x + c * y};
}

// How fast the place of the robot's edge that is nearest to a walker moves towards him [m/s].
double Walkers::advance(const Walker& walker) const {
  const Spot own = seen(walker);
  const Spot at = robot_.corners.empty() ? unit(own) * robot_.radius : nearest_on(robot_.corners, own).at;
  const Spot to = unit(own - at);
  return (velocity_.v - velocity_.omega * at.y) * to.x + velocity_.omega * at.x * to.y;
}

// As docs/understand/safety.md allows it: he has stood at the robot for a second since it rested (an estimate may be
// old), it creeps, and does not move into him.
bool Walkers::is_left(const Walker& walker) const {
  return walker.stood >= 1.0 - bounds_.oldest && speed_of_edge() <= kCreeps && advance(walker) <= kAdvances;
}

// Out of sight of what the robot does until it rests.
void Walkers::place(Walker& walker) {
  const Spot robot{pose_.x, pose_.y};
  Walker fresh;
  fresh.id = ++ids_;
  fresh.p = robot + anywhere(appears() + random_.in(0.0, 1.5));
  fresh.v = capped({random_.in(-1.0, 1.0), random_.in(-1.0, 1.0)}, bounds_.speed);
  fresh.radius = random_.in(0.15, kWidest);
  fresh.way = random_.chance(bounds_.lingering)
                  ? Walker::Way::linger
                  : random_.of({Walker::Way::chase, Walker::Way::intercept, Walker::Way::pounce, Walker::Way::wait,
                                Walker::Way::cut});
  fresh.nearest = random_.in(0.0, 0.12);
  fresh.stroll = unit(robot - fresh.p) * random_.in(0.3, bounds_.speed);
  walker = fresh;
}

double Walkers::appears() const { return std::max(kAppears, bounds_.appear + outermost_ + kWidest); }

double Walkers::error(double third) { return 3.0 * third * (random_.chance(0.5) ? 1.0 : random_.in(0.0, 1.0)); }

Spot Walkers::anywhere(double by) {
  const double angle = random_.in(-M_PI, M_PI);
  return Spot{std::cos(angle), std::sin(angle)} * by;
}

MovingObstacleEstimates Walkers::told(const World* map) {
  MovingObstacleEstimates estimates;
  for (const Walker& walker : walkers_) {
    const auto steps = static_cast<std::size_t>(random_.in(0.0, bounds_.oldest) / kStep);
    const std::size_t back = walker.past.empty() ? 0 : std::min(steps, walker.past.size() - 1);
    const Spot truly = walker.past.empty() ? walker.p : walker.past[back][0];
    const Spot p = truly + anywhere(error(bounds_.position_error));
    const Spot v = (walker.past.empty() ? walker.v : walker.past[back][1]) + anywhere(error(bounds_.velocity_error));
    estimates.emplace_back();
    hidwa_local_planner::MovingObstacleEstimate& one = estimates.back();
    one.id = walker.id;
    one.position = {p.x, p.y};
    one.velocity = {v.x, v.y};
    one.radius = walker.radius;
    one.position_deviation = bounds_.told_errors * bounds_.position_error;
    one.velocity_deviation = bounds_.told_errors * bounds_.velocity_error;
    one.age = static_cast<double>(back) * kStep;
    for (int k = 0; map != nullptr && k < kPoints; ++k) {
      const double angle = 2.0 * M_PI * k / kPoints;
      const Spot point = truly + Spot{std::cos(angle), std::sin(angle)} * walker.radius;
      if (!map->lethal(map->cell(point.x), map->cell(point.y))) one.points.emplace_back(point.x, point.y);
    }
  }
  return estimates;
}

Spot Walkers::wish_of(const Walker& walker) const {
  const Spot robot{pose_.x, pose_.y}, to = robot - walker.p;
  const Spot drives{velocity_.v * std::cos(pose_.theta), velocity_.v * std::sin(pose_.theta)};
  switch (walker.way) {
    case Walker::Way::chase:
      return unit(to) * bounds_.speed;
    case Walker::Way::intercept:
      return unit(to + drives * (length(to) / bounds_.speed)) * bounds_.speed;
    case Walker::Way::pounce:
      return gap(walker) > 0.9 ? walker.stroll : unit(to + drives * 0.3) * bounds_.speed;
    case Walker::Way::wait:
      return gap(walker) > 0.8 ? Spot{} : unit(to + drives * 0.2) * bounds_.speed;
    case Walker::Way::cut:
      return (robot + unit(drives) * (outermost_ + walker.radius + 0.25) - walker.p) * 3.0;
    case Walker::Way::linger:  // stands at it for a second; once it moves then, goes for where it moves to
      if (walker.steps_in) return unit(to + drives * 2.0) * bounds_.speed;
      return unit(to) * std::sqrt(bounds_.acc * std::max(0.0, gap(walker) - walker.nearest));
  }
  return {};
}

// As hard as the bounds allow.
void Walkers::move(Walker& walker) {
  const Spot change = capped(capped(wish_of(walker), bounds_.speed) - walker.v, bounds_.acc * kStep);
  walker.p = walker.p + walker.v * kStep + change * (0.5 * kStep);
  walker.v = walker.v + change;
  walker.past.push_front({walker.p, walker.v});
  if (walker.past.size() > kRemembered) walker.past.pop_back();
}

void Walkers::look() {
  const bool moves = speed_of_edge() > kMoves;
  // Where a set can be around the robot: both errors twice, and what a step allows.
  const double band = 6.0 * (bounds_.position_error + bounds_.oldest * bounds_.velocity_error) + 0.05;
  for (Walker& walker : walkers_) {
    const double apart = gap(walker);
    const bool stands = apart < band && (!moves || walker.stood > 0.0);
    walker.stood = stands ? walker.stood + kStep : 0.0;
    walker.steps_in = stands && (walker.steps_in || (moves && walker.stood > 1.0));
    if (apart <= kClose && moves && !walker.close) ++encounters_.met;
    walker.close = (walker.close || moves) && apart <= kClose;
    if (apart <= 0.0 && !walker.touches) {
      if (!moves) ++encounters_.at_rest;
      if (moves) {
        ++(is_left(walker) ? encounters_.leaving : encounters_.moving);
        encounters_.fastest = std::max(encounters_.fastest, speed_of_edge());
      }
    }
    // Who touches a robot at rest touches it still when it sets off: counted once.
    walker.touches = apart <= 0.0;
    walker.idle = apart <= 0.5 && !moves ? walker.idle + kStep : 0.0;
    const double patience = walker.way == Walker::Way::linger ? kLingers : kIdle;
    if (walker.idle > patience || walker.touches || apart > appears() + kLost) place(walker);
  }
}

}  // namespace hidwa_attack
