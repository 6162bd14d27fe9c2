// SPDX-License-Identifier: BSD-3-Clause
#include "drive/drive.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

#include "control/control_loop.hpp"
#include "hidwa_local_planner/core/footprint.hpp"
#include "hidwa_local_planner/critics/built_in.hpp"
#include "input/operator_state_machine.hpp"
#include "operator_link.hpp"
#include "recorder.hpp"
#include "sensing.hpp"

namespace hidwa_local_planner {
namespace drive {
namespace {

constexpr double kStep = 0.01;       // [s], of the simulation
constexpr double kFirstStamp = 1.0;  // [s]; 0 would mean "no time" to those who read stamps

Pose2 planar(const sim::Pose& pose) { return {pose.x, pose.y, pose.theta}; }

/// True every 1/rate seconds, rounded to whole steps.
class Every {
 public:
  explicit Every(double rate, double phase = 0.0)
      : steps_(std::max(1L, std::lround(1.0 / (rate * kStep)))), phase_(std::lround(phase / kStep) % steps_) {}
  bool operator()(long step) const { return step % steps_ == phase_; }
  double period() const { return static_cast<double>(steps_) * kStep; }  // [s]

 private:
  long steps_;
  long phase_;
};

sim::WorldSetup world_setup(const DriveSetup& setup) {
  if (!setup.ground) throw std::invalid_argument("a drive needs a ground");
  if (setup.outline.size() < 3) throw std::invalid_argument("the outline needs three corners or more");
  if (!(setup.link_delay >= 0.0)) throw std::invalid_argument("the link's delay must not be negative");
  sim::WorldSetup world;
  world.map = setup.ground->map();
  world.discs = setup.ground->discs();
  world.people = setup.people;
  world.regions = setup.regions;
  world.footprint = setup.footprint;
  world.limits = setup.limits;
  world.odometry_noise = setup.odometry_noise;
  world.start = setup.start;
  world.seed = setup.odometry_seed;
  return world;
}

/// Poses along a route to the goal; each heads the way that the route takes from two points before it to two
/// points after it.
std::vector<Pose2> poses_along(const sim::Route& route, const sim::Pose& goal) {
  constexpr std::size_t kReach = 2;
  std::vector<Pose2> poses;
  poses.reserve(route.size());
  for (std::size_t i = 0; i < route.size(); ++i) {
    const Eigen::Vector2d along = route[std::min(route.size() - 1, i + kReach)] - route[i - std::min(i, kReach)];
    poses.push_back({route[i].x(), route[i].y(), std::atan2(along.y(), along.x())});
  }
  if (!poses.empty()) poses.back() = planar(goal);
  return poses;
}

// By which a navfn plans on the setup's costmap.
sim::RouteClearance route_clearance(const DriveSetup& setup) {
  const double radius = setup.plan_radius > 0.0 ? setup.plan_radius : Footprint(setup.outline).inscribed_radius();
  return navfn_clearance(radius, setup.costmap.inflation.cost_scaling_factor);
}

class Run {
 public:
  Run(const DriveSetup& setup, const Observer& observer)
      : setup_(setup),
        observer_(observer),
        control_due_(setup.rates.control),
        scan_due_(setup.rates.scan),
        costmap_due_(setup.rates.costmap, setup.rates.costmap_phase),
        plan_due_(setup.rates.plan),
        stick_due_(setup.rates.stick),
        world_(world_setup(setup)),
        sensing_(setup),
        loop_(critics::built_in()),
        link_(setup, machine_),
        clearance_(route_clearance(setup)),
        route_(setup.explore ? nullptr
               : setup.route ? setup.route
                             : make_route(setup)),
        recorder_(setup) {
    const std::vector<std::string> faults = loop_.configure(setup.parameters);
    if (!faults.empty()) throw std::invalid_argument(faults.front());
    machine_.configure(setup.parameters);
    loop_.set_footprint(setup.outline);
  }

  DriveResult run() {
    sensing_.scan(world_);
    sensing_.update_costmap(world_);  // the host waits for its costmap
    const long last = std::lround(setup_.time_limit / kStep);
    for (long step = 0; step < last && !ended_; ++step) {
      if (scan_due_(step)) sensing_.scan(world_);
      if (costmap_due_(step)) sensing_.update_costmap(world_);
      if (plan_due_(step)) plan_wanted_ = true;
      if (stick_due_(step)) link_.send({now(), world_.pose(), world_.velocity()});
      link_.deliver(now());
      if (control_due_(step)) control();
      if (!ended_) world_.advance(kStep);
      if (setup_.end_at_contact && touched()) end(Ending::contact);
    }
    return recorder_.finish(world_, ended_ ? ending_ : Ending::out_of_time);
  }

 private:
  double now() const { return world_.time() + kFirstStamp; }  // [s]
  Pose2 pose() const { return planar(world_.odometry().pose()); }
  Twist2 velocity() const { return {world_.odometry().velocity().v, world_.odometry().velocity().omega}; }
  // Localisation is perfect and takes up the odometry's drift.
  sim::Pose map_in_odometry() const { return sim::compose(world_.odometry().pose(), sim::inverse(world_.pose())); }

  bool touched() const { return world_.contacts() > 0 || !world_.watch().touches().empty(); }

  void end(Ending ending) {
    ending_ = ending;
    ended_ = true;
  }

  // The host's control cycle.
  void control() {
    if (plan_wanted_) replan();
    if (!loop_.has_plan()) {
      end(Ending::no_plan);
    } else if (goal_reached()) {
      end(Ending::arrived);
    } else if (cycle()) {
      last_success_ = world_.time();
    } else if (world_.time() > last_success_ + setup_.patience) {
      end(Ending::given_up);
    } else {
      plan_wanted_ = true;
    }
  }

  // Where there is no new plan the old one stays.
  void replan() {
    plan_wanted_ = false;
    const Eigen::Vector2d here(world_.pose().x, world_.pose().y);
    if (setup_.explore)
      route_ = std::make_shared<sim::GridRoute>(sensing_.seen().map(), clearance_, goal_point(), here);
    const sim::Route route = route_->from(here);
    if (route.empty()) return;
    loop_.set_plan(poses_along(route, setup_.goal), "map", now(), control_due_.period());
    if (setup_.person) setup_.person->set_plan(route);
  }

  Eigen::Vector2d goal_point() const { return {setup_.goal.x, setup_.goal.y}; }

  bool goal_reached() {
    const double left = (goal_point() - Eigen::Vector2d(world_.pose().x, world_.pose().y)).norm();
    if (setup_.goal_radius > 0.0) return left <= setup_.goal_radius;
    return loop_.goal_reached(observe(), machine_.manual());
  }

  // The plugin's cycle; false when there is nothing to send.
  bool cycle() {
    const control::Observation observation = observe();
    const auto begin = std::chrono::steady_clock::now();
    if (loop_.goal_begins()) machine_.new_goal();
    const OperatorIntent intent = machine_.update(now());
    const control::Result result = loop_.step(observation, intent, setup_.sampling);
    machine_.debrief(now(), result.feedback);
    const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - begin;
    const Cycle seen{world_.time(),
                     loop_.situation(),
                     observation.costmap,
                     result.intent,
                     *result.decision,
                     loop_.planner(),
                     world_,
                     loop_,
                     observation,
                     result};
    recorder_.add(seen, result.command, control_due_.period(), spent.count());
    if (observer_) observer_(seen);
    world_.command({result.command.v, result.command.omega});
    return result.outcome != Outcome::fail;
  }

  control::Observation observe() const {
    control::Observation observation;
    observation.timing.now = now();
    observation.timing.period = control_due_.period();
    observation.pose = pose();
    observation.velocity = velocity();
    observation.from_plan.origin = planar(map_in_odometry());
    observation.costmap = sensing_.costmap();
    observation.moving_obstacles = sensing_.moving_obstacles(world_, map_in_odometry());
    observation.sensor_sectors = sensing_.sensor_sectors();
    return observation;
  }

  const DriveSetup& setup_;
  const Observer& observer_;
  const Every control_due_, scan_due_, costmap_due_, plan_due_, stick_due_;
  sim::World world_;
  Sensing sensing_;
  input::OperatorStateMachine machine_;
  control::ControlLoop loop_;
  OperatorLink link_;
  const sim::RouteClearance clearance_;
  std::shared_ptr<const sim::GridRoute> route_;
  double last_success_ = 0.0;  // [s], since the start
  bool plan_wanted_ = true;
  bool ended_ = false;
  Ending ending_ = Ending::out_of_time;
  Recorder recorder_;
};

}  // namespace

DriveResult drive(const DriveSetup& setup, const Observer& observer) { return Run(setup, observer).run(); }

std::shared_ptr<const sim::GridRoute> make_route(const DriveSetup& setup) {
  return std::make_shared<sim::GridRoute>(*setup.ground->map(), route_clearance(setup),
                                          Eigen::Vector2d(setup.goal.x, setup.goal.y));
}

}  // namespace drive
}  // namespace hidwa_local_planner
