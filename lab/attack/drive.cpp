// SPDX-License-Identifier: BSD-3-Clause
#include "drive.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <ostream>
#include <stdexcept>

#include "braking.hpp"
#include "command_watch.hpp"
#include "contact_watch.hpp"
#include "control/control_loop.hpp"
#include "control/period_watch.hpp"
#include "device.hpp"
#include "escape_watch.hpp"
#include "hidwa_local_planner/critics/built_in.hpp"
#include "input/operator_state_machine.hpp"
#include "local_map.hpp"
#include "person.hpp"
#include "rhythm.hpp"
#include "route.hpp"
#include "sensors.hpp"
#include "stand_watch.hpp"
#include "start.hpp"

namespace hidwa_attack {
namespace {

namespace control = hidwa_local_planner::control;
namespace critics = hidwa_local_planner::critics;
using hidwa_local_planner::Influence;
using hidwa_local_planner::MovingObstacleEstimates;
using hidwa_local_planner::Outcome;
using hidwa_local_planner::Polygon;

constexpr int kAfterTouch = 1000;  // how long a drive goes on [ms]
constexpr int kWalkers = 2;        // between two steps of walkers [ms]

// The velocity that leads from one pose to another on an arc; `time` [s].
Twist2 velocity_between(const Pose2& from, const Pose2& to, double time) {
  const double turn = std::remainder(to.theta - from.theta, 2.0 * M_PI), heading = from.theta + 0.5 * turn;
  return {((to.x - from.x) * std::cos(heading) + (to.y - from.y) * std::sin(heading)) / time, turn / time};
}

double size_of_world(const Spec& spec) { return spec.parameters.max_vel_x > 1.0 ? 14.0 : 9.0; }

// So large that no rollout and no manoeuvre leaves it.
double side_of_window(const Spec& spec) {
  const Parameters& p = spec.parameters;
  const double v = p.max_vel_x;
  return std::max(6.0, 2.0 * (1.2 * v * p.sim_time + 0.5 * v * v / braking_x(p) + v * p.control_latency + 1.2));
}

Base::Make make_of(const Spec& spec) {
  const Parameters& p = spec.parameters;
  Base::Make make;
  make.x = {p.acc_lim_x, spec.brakes * braking_x(p)};
  make.theta = {p.acc_lim_theta, spec.brakes * braking_theta(p)};
  make.period = 1e-3 * spec.period;
  make.latency = spec.latency;
  make.latency_varies = spec.latency_varies;
  make.reaching = spec.reaching;
  make.slip = spec.slip;
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
        base_(make_of(spec), scenery_.start, random_.bits()),
        sensors_(spec_, random_.bits()),
        rhythm_(spec, random_.bits()),
        walkers_(spec.walkers, spec.bounds, shape_, scenery_.start, spec.walkers > 0 ? random_.bits() : 0),
        person_(scenery_.world, walkers_, spec.steering, spec.relentless, random_.bits()),
        route_(scenery_.world, random_.bits()),
        contacts_(scenery_.world, padded_),
        stand_(scenery_.world, outermost(padded_)),
        escape_(scenery_.world, padded_, spec),
        parameters_(spec.parameters),
        device_(spec.link, machine_, random_.bits()),
        trace_(trace) {
    put_in_force();
    if (rhythm_.before() > 0.0) periods_.observe(seconds(0), rhythm_.before());
    make_maps();
    Polygon outline;
    for (const Spot& corner : told_corners(shape_)) outline.emplace_back(corner.x, corner.y);
    loop_.set_footprint(outline);
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
      if (spec_.walkers > 0 && now % kWalkers == 0) walkers_.step(base_.pose(), base_.velocity());
      sensors_.record(base_.pose(), base_.velocity());
      contacts_.observe(now, base_.pose(), base_.velocity());
      if (stands_in()) escape_.observe(now, base_.pose(), base_.velocity());
      driven_ = 1e-3 * (now + 1);
    }
    return result();
  }

 private:
  Scenery begin() {
    Scenery scenery = spec_.ground ? cut(*spec_.ground, size_of_world(spec_), padded_, random_)
                                   : build(spec_.place, size_of_world(spec_), spec_.resolution, padded_, random_);
    if (spec_.start == Start::grazing) scenery.start = grazing_pose(scenery.world, padded_, scenery.start, random_);
    if (spec_.start == Start::stray) put_stray_cells(scenery.world, padded_, scenery.start, random_);
    if (spec_.start == Start::stray) put_cells_around(scenery.world, padded_, scenery.start, random_);
    return scenery;
  }
  // As the costmap computes it, of the corners that it is told.
  double inscribed() const { return innermost({told_corners(shape_), 0.0}); }

  bool stands_in() const { return spec_.start != Start::free; }
  bool over(int now) const { return !stands_in() && contacts_.touched() && now > contacts_.touched_at() + kAfterTouch; }

  // What is seen of the world: where cells flicker another picture in each cycle, in which more is lethal, never less.
  void make_maps() {
    constexpr int kPictures = 4;
    for (int k = 0; k < (spec_.flicker > 0.0 ? kPictures : 1); ++k) {
      World seen = scenery_.world;
      if (spec_.flicker > 0.0) add_flicker(scenery_.world, seen);
      maps_.emplace_back(seen, side_of_window(spec_), inscribed());
    }
  }

  void add_flicker(const World& world, World& seen) {
    for (int j = 0; j < world.rows(); ++j) {
      for (int i = 0; i < world.columns(); ++i) {
        const bool beside =
            world.lethal(i - 1, j) || world.lethal(i + 1, j) || world.lethal(i, j - 1) || world.lethal(i, j + 1);
        if (beside && random_.chance(spec_.flicker)) seen.set(i, j, true);
      }
    }
  }

  LocalMap& map() {
    return maps_[maps_.size() > 1 ? static_cast<std::size_t>(random_.whole(0, static_cast<int>(maps_.size()) - 1)) : 0];
  }

  void put_in_force() {
    const std::vector<std::string> faults = loop_.configure(parameters_);
    if (!faults.empty()) throw std::logic_error(faults.front());
    machine_.configure(parameters_);
  }

  void change_world(int now) {
    put_stray_cells(scenery_.world, padded_, base_.pose(), random_);
    for (LocalMap& map : maps_) map.renew(scenery_.world);
    escape_.world_changed(now);
  }

  void cycle(int now) {
    rhythm_.tick(now);
    set_back_ = spec_.clock_set && random_.chance(0.05);
    if (set_back_) set_by_ -= random_.in(0.1, 20.0);
    if (last_cycle_ >= 0) periods_.observe(seconds(now), 1e-3 * (now - last_cycle_));
    ++result_.cycles;
    count_motion();
    if (spec_.limits_change && random_.chance(0.03)) change_limits();
    const Pose2 pose = sensors_.pose(spec_.pose_age);
    if (stands_in()) escape_.decide(now, base_.pose(), base_.velocity());
    const bool goal_begins = route_.renew(now, pose);
    intent_ = person_.want(now, base_.pose(), parameters_);
    reading_ = sensors_.odometry(now);
    const Twist2 command = plan(now, pose, goal_begins);
    stand_.observe(now, {base_.pose(), base_.velocity()}, wants_to_drive(), route_.points());
    base_.send(now, command);
    last_ = command;
    rhythm_.plan_next(now, rests(now));
    last_cycle_ = now;
    told_ = pose;
  }

  // No command is on its way either.
  bool rests(int now) {
    const Twist2 u = base_.velocity();
    if (u.v != 0.0 || u.omega != 0.0 || last_.v != 0.0 || last_.omega != 0.0) rests_from_ = now + spec_.latency + 1;
    return now >= rests_from_;
  }

  // Nobody steers, and the host was not told that there is no way.
  bool wants_to_drive() const {
    return intent_.influence == Influence::none && !goalless_ && !route_.latched() && outcome_ != Outcome::fail;
  }

  // As a plugin: the whole control loop, and a person who steers by messages.
  Twist2 plan(int now, const Pose2& pose, bool goal_begins) {
    const double time = seconds(now);
    const bool had_goal = !goalless_;
    if (spec_.goalless >= 1.0) {
      goalless_ = true;
    } else if (spec_.goalless > 0.0 && random_.chance(0.02)) {
      goalless_ = !goalless_;
    }
    machine_.set_goalless(goalless_);
    if (goal_begins || (!had_goal && !goalless_)) loop_.set_plan(route_.points(), "map", time, 1e-3 * spec_.period);
    device_.send(time, intent_, parameters_);
    control::Observation observation;
    observation.goalless = goalless_;
    observation.timing.now = time;
    observation.timing.period = 1e-3 * spec_.period;
    observation.timing.longest_period = longest();
    observation.timing.jumped_back = set_back_;
    observation.timing.interval = last_cycle_ < 0 ? 0.0 : 1e-3 * (now - last_cycle_);
    if (reading_) observation.velocity = *reading_;
    if (!reading_) observation.fault = "no odometry";
    observation.pose = pose;
    observation.pose_age = spec_.age_told ? 1e-3 * spec_.pose_age : 0.0;
    observation.costmap = view(pose);
    if (spec_.walkers_told) observation.moving_obstacles = told_walkers();
    if (loop_.goal_begins()) machine_.new_goal();
    const control::Result result = loop_.step(observation, machine_.update(time));
    machine_.debrief(time, result.feedback);
    outcome_ = result.outcome;
    escaping_ = result.decision != nullptr && result.decision->escaping;
    intent_ = result.intent;
    return judged(result.command, last_cycle_ < 0 ? last_ : velocity_between(told_, pose, 1e-3 * (now - last_cycle_)));
  }

  MovingObstacleEstimates told_walkers() { return walkers_.told(spec_.points_told ? &scenery_.world : nullptr); }

  GridView view(const Pose2& pose) {
    LocalMap& map = this->map();
    GridView view = map.around(pose);
    if (spec_.map_delay >= 0) map.forget_beyond(sensors_.pose(spec_.map_delay), sight());
    return view;
  }

  double seconds(int now) const { return 100.0 + set_by_ + 1e-3 * now; }  // by the host's clock
  // As the plugin measures it: the planner's own watch is attacked too.
  double longest() const { return periods_.longest(1e-3 * spec_.period); }

  // On failure the host sends zero, and the robot must be at rest by then. `other`: what a cycle may start from instead
  // of a reading that it doubts, the velocity between the last two poses.
  Twist2 judged(const Twist2& planned, const Twist2& other) {
    const Twist2 command = outcome_ == Outcome::fail ? Twist2{} : planned;
    commands_.observe(parameters_, 1e-3 * spec_.period, last_, command);
    commands_.judge_acceleration(parameters_, longest(), last_, reading_.value_or(last_), other, command);
    return command;
  }

  // A sensor that sees as far as the robot needs to stop, and 0.3 m.
  double sight() const {
    const Parameters& p = parameters_;
    return outermost(padded_) + 0.3 + stopping_distance(p.max_vel_x, p);
  }
  double stopping_distance(double v, const Parameters& p) const {
    return std::abs(v) * (p.control_latency + 1e-3 * spec_.period) + 0.5 * v * v / braking_x(p);
  }

  // What its outermost point moves while it stops turning.
  double turning_distance(double omega, const Parameters& p) const {
    const double angle =
        std::abs(omega) * (p.control_latency + 1e-3 * spec_.period) + 0.5 * omega * omega / braking_theta(p);
    return outermost(padded_) * angle;
  }

  void change_limits() {
    parameters_.max_vel_x = random_.of({1.0, 0.6, 0.3}) * spec_.parameters.max_vel_x;
    parameters_.max_vel_theta = random_.of({1.0, 0.6, 0.3}) * spec_.parameters.max_vel_theta;
    using hidwa_local_planner::OperatorMode;
    parameters_.mode = random_.of({OperatorMode::joystick, OperatorMode::switching, spec_.parameters.mode});
    parameters_.s_v = random_.in(0.0, 5.0);
    parameters_.s_omega = random_.in(0.0, 5.0);
    parameters_.BaseObstacle_scale = random_.in(0.0, 0.1);
    put_in_force();
  }

  void count_motion() {
    const Twist2 u = base_.velocity();
    if (std::abs(u.v) < 0.05 && std::abs(u.omega) < 0.1) return;
    ++result_.moving;
    const double way = std::min(stopping_distance(u.v, parameters_) + turning_distance(u.omega, parameters_), 1.0);
    const bool walker = spec_.walkers > 0 && walkers_.gap(walkers_.nearest()) < way;
    if (walker || deepest(scenery_.world, Placed(padded_, base_.pose()), way) > -way) ++result_.threatened;
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
    result_.hard = commands_.hard();
    result_.seconds = driven_;
    result_.stood = stand_.longest();
    result_.encounters = walkers_.encounters();
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
  std::vector<LocalMap> maps_;
  Base base_;
  Sensors sensors_;
  Rhythm rhythm_;
  Walkers walkers_;
  Person person_;
  Route route_;
  ContactWatch contacts_;
  StandWatch stand_;
  EscapeWatch escape_;
  CommandWatch commands_;
  Parameters parameters_;  // in force
  hidwa_local_planner::input::OperatorStateMachine machine_;
  control::ControlLoop loop_{critics::built_in()};
  Device device_;
  hidwa_local_planner::PeriodWatch periods_;
  double set_by_ = 0.0;    // the clock [s]
  bool goalless_ = false;  // the host has no goal
  bool set_back_ = false;  // in this cycle
  int last_cycle_ = -1;    // [ms]
  int rests_from_ = 0;     // [ms]
  double driven_ = 0.0;    // [s]
  std::ostream* trace_;
  int appears_at_ = -1;  // [ms]
  Twist2 last_;          // command [m/s, rad/s]
  OperatorIntent intent_;
  std::optional<Twist2> reading_;
  Pose2 told_;  // in the last cycle
  Outcome outcome_ = Outcome::hold;
  bool escaping_ = false;
  DriveResult result_;
};

}  // namespace

DriveResult drive(const Spec& spec, std::uint64_t seed, std::ostream* trace) { return Run(spec, seed, trace).go(); }

}  // namespace hidwa_attack
