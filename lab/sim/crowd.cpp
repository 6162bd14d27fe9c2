// SPDX-License-Identifier: BSD-3-Clause
#include "sim/crowd.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "sim/polygon.hpp"
#include "sim/silhouettes.hpp"
#include "sim/social_force.hpp"

namespace hidwa_local_planner {
namespace sim {
namespace {

constexpr double kCrowdStep = 0.01;  // [s]
constexpr double kShoulders = 0.20;  // [m], nearer to a wall nobody comes
constexpr double kPursuit = 0.8;     // [m] ahead along the way people head for
constexpr double kArrived = 0.6;     // [m] from a place
constexpr double kStuck = 8.0;       // [s] without coming further: they go somewhere else
constexpr double kTogether = 0.9;    // [m] from the middle of a group nobody feels drawn to it
constexpr double kLeads = 1.2;       // [m] ahead of the middle of a group people wait for it
constexpr double kTurning = 2.5;     // [rad/s], of heading

void check_crowd(const CrowdSetup& s) {
  if (!s.ways) throw std::invalid_argument("a crowd needs places and ways");
  if (s.people < 0) throw std::invalid_argument("the number of people must not be negative");
  if (!(s.max_speed > 0.0 && s.max_acc > 0.0)) throw std::invalid_argument("the bounds of people must be positive");
  if (!(s.radius > 0.0)) throw std::invalid_argument("the radius of people must be positive");
  for (const std::vector<std::size_t>& tour : s.tours) {
    for (const std::size_t stop : tour) {
      if (stop >= s.ways->places()) throw std::invalid_argument("a tour leads to a place that is not there");
    }
  }
}

}  // namespace

Crowd::Crowd(const CrowdSetup& setup) : setup_(setup), random_(setup.seed) {
  check_crowd(setup_);
  const auto count = static_cast<std::size_t>(setup_.people);
  movers_.resize(count);
  walkers_.resize(count);
  make_groups();
  for (std::size_t k = 0; k < count; ++k) {
    Walker& walker = walkers_[k];
    walker.speed = std::clamp(setup_.speed + setup_.speed_deviation * random_.normal(), 0.4 * setup_.max_speed,
                              0.9 * setup_.max_speed);
    walker.yields = random_.uniform() < setup_.yielding;
    movers_[k].id = static_cast<std::uint32_t>(k + 1);
    movers_[k].radius = setup_.radius;
    movers_[k].body = setup_.body;
    movers_[k].heading = walker.faces = 2.0 * M_PI * random_.uniform();
    movers_[k].gait = 2.0 * M_PI * random_.uniform();
  }
  for (Group& group : groups_) {
    for (const std::size_t member : group.members) {
      walkers_[member].speed = walkers_[group.members.front()].speed;
      place(member);
    }
    set_out(group, 0.0);
  }
}

// Who has a tour walks alone.
void Crowd::make_groups() {
  for (std::size_t k = 0; k < walkers_.size();) {
    Group group;
    if (k < setup_.tours.size()) group.tour = setup_.tours[k];
    std::size_t size = 1;
    if (group.tour.empty() && random_.uniform() < setup_.in_groups) size = random_.uniform() < 0.6 ? 2 : 3;
    for (size = std::min(size, walkers_.size() - k); size > 0; --size, ++k) {
      walkers_[k].group = groups_.size();
      group.members.push_back(k);
    }
    groups_.push_back(group);
  }
}

// The first of a tour at its first place, others beside the first of their group, the rest on some way.
void Crowd::place(std::size_t person) {
  const Group& group = groups_[walkers_[person].group];
  const auto fits = [&](const Eigen::Vector2d& point) {
    if (setup_.ways->wall_distance(point) < setup_.radius) return false;
    if ((point - setup_.robot.position).norm() < CrowdSetup::kClear) return false;
    if (setup_.ways->way(point, 0).empty()) return false;
    return std::none_of(movers_.begin(), movers_.begin() + static_cast<std::ptrdiff_t>(person),
                        [&](const Mover& m) { return (m.position - point).norm() < 2.0 * setup_.radius; });
  };
  if (!group.tour.empty()) {
    movers_[person].position = setup_.ways->place(group.tour.front());
    return;
  }
  constexpr int kTries = 1000;
  for (int tries = 0; tries < kTries; ++tries) {
    Eigen::Vector2d point;
    if (person != group.members.front()) {
      const double angle = 2.0 * M_PI * random_.uniform();
      point = movers_[group.members.front()].position + 0.8 * Eigen::Vector2d(std::cos(angle), std::sin(angle));
    } else {
      const auto places = static_cast<double>(setup_.ways->places());
      const auto from = static_cast<std::size_t>(places * random_.uniform());
      const auto to = static_cast<std::size_t>(places * random_.uniform());
      const Route way = setup_.ways->way(setup_.ways->place(from), to);
      if (way.empty()) continue;
      point = way[static_cast<std::size_t>(static_cast<double>(way.size()) * random_.uniform())];
    }
    if (!fits(point) && tries + 1 < kTries) continue;
    if (!fits(point)) break;
    movers_[person].position = point;
    return;
  }
  throw std::invalid_argument("there is no room for " + std::to_string(setup_.people) +
                              " people: take fewer, or a larger map");
}

// To the next place of the tour, or to another one at random.
void Crowd::set_out(Group& group, double now) {
  if (!group.tour.empty()) {
    group.stop = (group.stop + 1) % group.tour.size();
    group.place = group.tour[group.stop];
  } else {
    group.place = static_cast<std::size_t>(static_cast<double>(setup_.ways->places()) * random_.uniform());
  }
  group.strolls_until = now - setup_.mean_stroll * std::log(1.0 - random_.uniform());
  for (const std::size_t member : group.members) find_way(member, now);
}

void Crowd::find_way(std::size_t person, double now) {
  Walker& walker = walkers_[person];
  walker.way = setup_.ways->way(movers_[person].position, groups_[walker.group].place);
  walker.next = 0;
  walker.progress = now;
}

void Crowd::advance(double time, const RobotSeen& robot) {
  while (time_ + 1e-9 < time) {
    const double dt = std::min(kCrowdStep, time - time_);
    time_ += dt;
    step(time_, dt, robot);
  }
}

void Crowd::step(double now, double dt, const RobotSeen& robot) {
  for (Group& group : groups_) plan(group, now);
  std::vector<Eigen::Vector2d> next(movers_.size());
  for (std::size_t k = 0; k < movers_.size(); ++k) {
    const Eigen::Vector2d wanted = wanted_velocity(k, now);
    const Eigen::Vector2d& velocity = movers_[k].velocity;
    next[k] = within_bounds(velocity, forces(k, wanted, robot), dt);
    // Braking straight on from the last velocity was found free before.
    if (!can_stop(movers_[k].position, next[k], dt)) {
      next[k] = velocity * std::max(0.0, 1.0 - setup_.max_acc * dt / std::max(1e-9, velocity.norm()));
    }
  }
  for (std::size_t k = 0; k < movers_.size(); ++k) {
    movers_[k].velocity = next[k];
    movers_[k].position += next[k] * dt;
    movers_[k].gait = std::fmod(movers_[k].gait + 2.0 * M_PI * next[k].norm() * dt / kStride, 2.0 * M_PI);
    turn(movers_[k], walkers_[k], dt);
  }
}

// Whether the group has arrived, stops on its way, or goes on.
void Crowd::plan(Group& group, double now) {
  if (now < group.waits_until) return;
  const Eigen::Vector2d& place = setup_.ways->place(group.place);
  const bool stuck = std::any_of(group.members.begin(), group.members.end(),
                                 [&](std::size_t member) { return now > walkers_[member].progress + kStuck; });
  const bool arrived = std::any_of(group.members.begin(), group.members.end(), [&](std::size_t member) {
    return walkers_[member].way.empty() || (movers_[member].position - place).norm() < kArrived;
  });
  if (arrived) {
    set_out(group, now);
    group.waits_until = now + setup_.longest_stay * random_.uniform();
  } else if (stuck) {
    set_out(group, now);
    return;
  } else if (now > group.strolls_until) {
    group.waits_until = now + 1.0 + 2.0 * random_.uniform();
    group.strolls_until = group.waits_until - setup_.mean_stroll * std::log(1.0 - random_.uniform());
  } else {
    return;
  }
  for (const std::size_t member : group.members) {
    walkers_[member].faces = movers_[member].heading + M_PI * (2.0 * random_.uniform() - 1.0);
    walkers_[member].progress = group.waits_until;
  }
}

// Along the way, to a point some way ahead; slower where the group is behind.
Eigen::Vector2d Crowd::wanted_velocity(std::size_t person, double now) {
  Walker& walker = walkers_[person];
  const Group& group = groups_[walker.group];
  const Eigen::Vector2d& here = movers_[person].position;
  if (now < group.waits_until || walker.way.empty()) return {0.0, 0.0};
  while (walker.next + 1 < walker.way.size() && (walker.way[walker.next] - here).norm() < kPursuit) {
    ++walker.next;
    walker.progress = now;
  }
  const Eigen::Vector2d to = walker.way[walker.next] - here;
  const Eigen::Vector2d ahead = to / std::max(1e-9, to.norm());
  Eigen::Vector2d middle(0.0, 0.0);
  for (const std::size_t member : group.members)
    middle += movers_[member].position / static_cast<double>(group.members.size());
  const double speed = (here - middle).dot(ahead) > kLeads ? 0.4 * walker.speed : walker.speed;
  return speed * ahead;
}

Eigen::Vector2d Crowd::forces(std::size_t person, const Eigen::Vector2d& wanted, const RobotSeen& robot) const {
  const Mover& me = movers_[person];
  Eigen::Vector2d sum = drive_force(me.velocity, wanted) + towards_group(person);
  const auto from = [&](const Eigen::Vector2d& away, const Eigen::Vector2d& velocity) {
    const Eigen::Vector2d force = repulsion(away, velocity);
    sum += sight(wanted, force) * force;
  };
  constexpr double kMatters = 4.0;  // [m]
  for (std::size_t k = 0; k < movers_.size(); ++k) {
    const Eigen::Vector2d away = me.position - movers_[k].position;
    if (k != person && away.squaredNorm() < kMatters * kMatters) from(away, movers_[k].velocity);
  }
  if (walkers_[person].yields && robot.radius > 0.0) {
    // From rim to rim: nobody touches a robot that stands.
    const Eigen::Vector2d away = me.position - robot.position;
    const double distance = away.norm(), radii = robot.radius + me.radius;
    if (distance < kMatters + radii) {
      from(away * std::max(0.05, distance - radii) / std::max(1e-9, distance), robot.velocity);
    }
  }
  return sum + wall_force_on(person, wanted);
}

// Ways keep clear of walls. So door posts push aside who walks between them, and do not hold them back: the force of
// Helbing and Molnar is stronger before a narrow door than the drive of who walks slowly, who would stand there for
// ever.
Eigen::Vector2d Crowd::wall_force_on(std::size_t person, const Eigen::Vector2d& wanted) const {
  const Eigen::Vector2d& here = movers_[person].position;
  Eigen::Vector2d force = wall_force(setup_.ways->wall_distance(here), setup_.ways->away_from_wall(here));
  if (wanted.squaredNorm() > 0.0) {
    const Eigen::Vector2d ahead = wanted.normalized();
    force -= std::min(0.0, force.dot(ahead)) * ahead;
  }
  return force;
}

// Helbing and Molnar's attraction, of constant strength.
Eigen::Vector2d Crowd::towards_group(std::size_t person) const {
  constexpr double kPull = 1.0;  // [m/s^2]
  const Group& group = groups_[walkers_[person].group];
  if (group.members.size() < 2) return {0.0, 0.0};
  Eigen::Vector2d middle(0.0, 0.0);
  for (const std::size_t member : group.members)
    middle += movers_[member].position / static_cast<double>(group.members.size());
  const Eigen::Vector2d to = middle - movers_[person].position;
  return to.norm() > kTogether ? Eigen::Vector2d(kPull * to.normalized()) : Eigen::Vector2d(0.0, 0.0);
}

// The velocity after dt. Cutting it at the largest speed changes it no more than it would have changed without:
// the projection onto a disc brings points of the plane no farther apart.
Eigen::Vector2d Crowd::within_bounds(const Eigen::Vector2d& velocity, const Eigen::Vector2d& acceleration,
                                     double dt) const {
  const double size = acceleration.norm();
  const double share = size > setup_.max_acc ? setup_.max_acc / size : 1.0;
  Eigen::Vector2d next = velocity + share * dt * acceleration;
  if (next.norm() > setup_.max_speed) next *= setup_.max_speed / next.norm();
  return next;
}

// Whether a step with this velocity and braking after it, straight on, ends before a wall. Who is too near to a wall
// already may go where they do not come nearer.
bool Crowd::can_stop(const Eigen::Vector2d& from, const Eigen::Vector2d& velocity, double dt) const {
  const double speed = velocity.norm();
  if (speed <= 0.0) return true;
  const double room = std::min(kShoulders, setup_.ways->wall_distance(from));
  const double way = speed * dt + 0.5 * speed * (speed / setup_.max_acc + dt);
  constexpr double kApart = 0.04;  // [m]
  const int points = std::max(1, static_cast<int>(std::ceil(way / kApart)));
  for (int k = 1; k <= points; ++k) {
    if (setup_.ways->wall_distance(from + velocity * (way * k / points / speed)) < room) return false;
  }
  return true;
}

// People face where they walk; who stands turns to what catches their eye.
void Crowd::turn(Mover& mover, const Walker& walker, double dt) const {
  constexpr double kWalks = 0.2;  // [m/s]
  const double aim = mover.velocity.norm() > kWalks ? std::atan2(mover.velocity.y(), mover.velocity.x()) : walker.faces;
  const double most = kTurning * dt;
  mover.heading = normalized(mover.heading + std::clamp(normalized(aim - mover.heading), -most, most));
}

}  // namespace sim
}  // namespace hidwa_local_planner
