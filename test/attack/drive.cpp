// SPDX-License-Identifier: BSD-3-Clause
#include "drive.hpp"

#include <algorithm>
#include <cmath>
#include <ostream>
#include <stdexcept>

#include "command_watch.hpp"
#include "contact_watch.hpp"
#include "escape_watch.hpp"
#include "hidwa_local_planner/core/planner.hpp"
#include "hidwa_local_planner/critics/built_in.hpp"
#include "local_map.hpp"
#include "person.hpp"
#include "rhythm.hpp"
#include "route.hpp"
#include "sensors.hpp"
#include "start.hpp"
#include "told.hpp"

namespace hidwa_attack {
namespace {

namespace critics = hidwa_local_planner::critics;
using hidwa_local_planner::Decision;
using hidwa_local_planner::Influence;
using hidwa_local_planner::Outcome;
using hidwa_local_planner::Planner;
using hidwa_local_planner::Polygon;
using hidwa_local_planner::Situation;

constexpr int kAfterTouch = 1000;  // how long a drive goes on [ms]

double braking_x(const Parameters& p) { return p.decel_lim_x != 0.0 ? std::abs(p.decel_lim_x) : p.acc_lim_x; }
double braking_theta(const Parameters& p) {
  return p.decel_lim_theta != 0.0 ? std::abs(p.decel_lim_theta) : p.acc_lim_theta;
}

double size_of_world(const Spec& spec) { return spec.parameters.max_vel_x > 1.0 ? 14.0 : 9.0; }

// So large that no rollout and no manoeuvre leaves it.
double side_of_window(const Spec& spec) {
  const Parameters& p = spec.parameters;
  const double v = p.max_vel_x;
  return std::max(6.0, 2.0 * (1.2 * v * p.sim_time + 0.5 * v * v / braking_x(p) + v * p.control_latency + 1.2));
}

double towards_rest(double value, double step) {
  return std::abs(value) <= step ? 0.0 : value - std::copysign(step, value);
}

Base::Make make_of(const Spec& spec) {
  const Parameters& p = spec.parameters;
  Base::Make make;
  make.x = {p.acc_lim_x, spec.brakes * braking_x(p)};
  make.theta = {p.acc_lim_theta, spec.brakes * braking_theta(p)};
  make.period = 1e-3 * spec.period;
  make.latency = spec.latency;
  make.reaching = spec.reaching;
  return make;
}

// A robot, its host and its person in a world.
class Run {
 public:
  Run(const Spec& spec, std::uint64_t seed, std::ostream* trace)
      : spec_(spec),
        random_(seed ^ 0x5eedULL),
        shape_(shape_of(spec.outline)),
        padded_(padded(shape_, spec.parameters.footprint_padding)),
        scenery_(begin()),
        map_(scenery_.world, side_of_window(spec), inscribed()),
        base_(make_of(spec), scenery_.start, random_.bits()),
        sensors_(spec_, random_.bits()),
        rhythm_(spec, random_.bits()),
        person_(scenery_.world, random_.bits()),
        route_(scenery_.world, random_.bits()),
        contacts_(scenery_.world, padded_),
        escape_(scenery_.world, padded_, spec),
        parameters_(spec.parameters),
        trace_(trace) {
    put_in_force();
    Polygon outline;
    for (const Spot& corner : told_corners(shape_)) outline.emplace_back(corner.x, corner.y);
    planner_.set_footprint(outline);
    appears_at_ = spec.start == Start::appearing ? random_.whole(2000, 6000) : -1;
    if (trace_ != nullptr)
      *trace_ << "t,x,y,theta,v,omega,command_v,command_omega,odometry_v,odometry_omega,influence,u_h_v,u_h_omega,"
                 "outcome,escaping,cycle,depth\n";
  }

  DriveResult go() {
    sensors_.record(base_.pose(), base_.velocity());
    for (int now = 0; now < 1000 * spec_.seconds && !over(now); ++now) {
      if (now == appears_at_) change_world(now);
      const bool cycles = rhythm_.due(now);
      if (cycles) cycle(now);
      if (trace_ != nullptr && (cycles || now % 10 == 0)) write(now, cycles);
      base_.step(now);
      sensors_.record(base_.pose(), base_.velocity());
      contacts_.observe(now, base_.pose(), base_.velocity());
      if (stands_in()) escape_.observe(now, base_.pose(), base_.velocity());
    }
    return result();
  }

 private:
  Scenery begin() {
    Scenery scenery = build(spec_.place, size_of_world(spec_), spec_.resolution, padded_, random_);
    if (spec_.start == Start::grazing) scenery.start = grazing_pose(scenery.world, padded_, scenery.start, random_);
    if (spec_.start == Start::stray) put_stray_cells(scenery.world, padded_, scenery.start, random_);
    if (spec_.start == Start::stray) put_cells_around(scenery.world, padded_, scenery.start, random_);
    return scenery;
  }
  // As the costmap computes it, of the corners that it is told.
  double inscribed() const { return innermost({told_corners(shape_), 0.0}); }

  bool stands_in() const { return spec_.start != Start::free; }
  bool over(int now) const { return !stands_in() && contacts_.touched() && now > contacts_.touched_at() + kAfterTouch; }

  void put_in_force() {
    const std::vector<std::string> faults = planner_.configure(parameters_);
    if (!faults.empty()) throw std::logic_error(faults.front());
  }

  void change_world(int now) {
    put_stray_cells(scenery_.world, padded_, base_.pose(), random_);
    map_.renew(scenery_.world);
    escape_.world_changed(now);
  }

  void cycle(int now) {
    rhythm_.tick(now);
    ++result_.cycles;
    count_motion();
    if (spec_.limits_change && random_.chance(0.03)) change_limits();
    const Pose2 pose = sensors_.pose(spec_.pose_age);
    if (stands_in()) escape_.decide(now, base_.pose(), base_.velocity());
    if (route_.renew(now, pose)) planner_.reset();
    intent_ = person_.want(now, base_.pose(), parameters_);
    reading_ = sensors_.odometry(now);
    const Twist2 command = reading_ ? ask(now, pose) : brake_blindly();
    base_.send(now, command);
    last_ = command;
  }

  Twist2 ask(int now, const Pose2& pose) {
    situation_.pose = pose;
    situation_.velocity = *reading_;
    situation_.last_command = last_;
    route_.window(pose, parameters_, situation_.plan);
    situation_.goal = route_.goal();
    situation_.goal_latched = route_.latched();
    situation_.period = 1e-3 * spec_.period;
    situation_.time = 100.0 + 1e-3 * now;
    tell_times(situation_, rhythm_.longest(), spec_.age_told ? 1e-3 * spec_.pose_age : 0.0);
    GridView view = map_.around(pose);
    if (spec_.map_delay >= 0) map_.forget_beyond(sensors_.pose(spec_.map_delay), sight());
    const Decision& decision = planner_.plan(situation_, view, intent_);
    outcome_ = decision.outcome;
    escaping_ = decision.escaping;
    if (outcome_ == Outcome::fail) return {};
    commands_.observe(parameters_, situation_.period, last_, decision.command);
    return decision.command;
  }

  // Without odometry a host brakes from its last command.
  Twist2 brake_blindly() {
    outcome_ = Outcome::brake;
    escaping_ = false;
    const double period = 1e-3 * spec_.period;
    return {towards_rest(last_.v, braking_x(parameters_) * period),
            towards_rest(last_.omega, braking_theta(parameters_) * period)};
  }

  // A sensor that sees as far as the robot needs to stop, and 0.3 m.
  double sight() const {
    const Parameters& p = parameters_;
    return outermost(padded_) + 0.3 + stopping_distance(p.max_vel_x, p);
  }
  double stopping_distance(double v, const Parameters& p) const {
    return std::abs(v) * (p.control_latency + 1e-3 * spec_.period) + 0.5 * v * v / braking_x(p);
  }

  void change_limits() {
    parameters_.max_vel_x = random_.of({1.0, 0.6, 0.3}) * spec_.parameters.max_vel_x;
    put_in_force();
  }

  void count_motion() {
    const Twist2 u = base_.velocity();
    if (std::abs(u.v) < 0.05 && std::abs(u.omega) < 0.1) return;
    ++result_.moving;
    const double way = std::min(stopping_distance(u.v, parameters_), 1.0);
    if (deepest(scenery_.world, Placed(padded_, base_.pose()), way) > -way) ++result_.threatened;
  }

  void write(int now, bool cycles) {
    const Pose2 q = base_.pose();
    const Twist2 u = base_.velocity(), heard = reading_.value_or(Twist2{});
    *trace_ << 1e-3 * now << ',' << q.x << ',' << q.y << ',' << q.theta << ',' << u.v << ',' << u.omega << ','
            << last_.v << ',' << last_.omega << ',' << heard.v << ',' << heard.omega << ','
            << static_cast<int>(intent_.influence) << ',' << intent_.u_h.v << ',' << intent_.u_h.omega << ','
            << to_string(outcome_) << ',' << escaping_ << ',' << cycles << ','
            << deepest(scenery_.world, Placed(padded_, q), 0.3) << '\n';
  }

  DriveResult result() {
    result_.touched = contacts_.touched();
    result_.depth = contacts_.deepest_touch();
    result_.touched_at = contacts_.touched_at();
    result_.beyond = commands_.count();
    result_.beyond_worst = commands_.worst();
    result_.meetings = contacts_.meetings();
    result_.stood_in = stands_in();
    if (!stands_in()) return result_;
    result_.touched = escape_.broken();
    result_.depth = std::max({escape_.entered_depth(), escape_.neighbour_excess(), escape_.growth()});
    result_.came_out = escape_.out();
    result_.entered = escape_.entered();
    result_.excess = escape_.neighbour_excess();
    result_.growth = escape_.growth();
    result_.fastest_inside = escape_.fastest();
    result_.speed_bound = escape_.speed_bound();
    return result_;
  }

  const Spec& spec_;
  Random random_;
  Shape shape_, padded_;
  Scenery scenery_;
  LocalMap map_;
  Base base_;
  Sensors sensors_;
  Rhythm rhythm_;
  Person person_;
  Route route_;
  ContactWatch contacts_;
  EscapeWatch escape_;
  CommandWatch commands_;
  Parameters parameters_;  // in force
  Planner planner_{critics::built_in()};
  Situation situation_;
  std::ostream* trace_;
  int appears_at_ = -1;  // [ms]
  Twist2 last_;          // command [m/s, rad/s]
  OperatorIntent intent_;
  std::optional<Twist2> reading_;
  Outcome outcome_ = Outcome::hold;
  bool escaping_ = false;
  DriveResult result_;
};

}  // namespace

DriveResult drive(const Spec& spec, std::uint64_t seed, std::ostream* trace) {
  DriveResult result = Run(spec, seed, trace).go();
  result.seed = seed;
  return result;
}

}  // namespace hidwa_attack
