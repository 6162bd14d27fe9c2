// SPDX-License-Identifier: BSD-3-Clause
#include "hidwa_local_planner/drive/drive.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

#include "hidwa_local_planner/core/footprint.hpp"
#include "hidwa_local_planner/core/goal_checker.hpp"
#include "hidwa_local_planner/core/plan_window.hpp"
#include "hidwa_local_planner/input/operator_state_machine.hpp"
#include "operator_link.hpp"
#include "recorder.hpp"
#include "sensing.hpp"

namespace hidwa_local_planner {
namespace drive {
namespace {

constexpr double kStep = 0.01;       // [s], of the simulation
constexpr double kFirstStamp = 1.0;  // [s]; 0 would mean "no time" to those who read stamps

Pose2 planar(const sim::Pose& pose) { return {pose.x, pose.y, pose.theta}; }
sim::Pose planar(const Pose2& pose) { return {pose.x, pose.y, pose.theta}; }

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
        link_(setup, person_),
        clearance_(route_clearance(setup)),
        route_(setup.explore ? nullptr
               : setup.route ? setup.route
                             : make_route(setup)),
        recorder_(setup) {
    const std::vector<std::string> faults = planner_.configure(setup.parameters);
    if (!faults.empty()) throw std::invalid_argument(faults.front());
    planner_.set_footprint(setup.outline);
    person_.configure(setup.parameters);
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
      if (setup_.end_at_contact && world_.contacts() > 0) end(Ending::contact);
    }
    return recorder_.finish(world_, ended_ ? ending_ : Ending::out_of_time);
  }

 private:
  double now() const { return world_.time() + kFirstStamp; }  // [s]
  Pose2 pose() const { return planar(world_.odometry().pose()); }
  Twist2 velocity() const { return {world_.odometry().velocity().v, world_.odometry().velocity().omega}; }
  // Localisation is perfect and takes up the odometry's drift.
  sim::Pose map_in_odometry() const { return sim::compose(world_.odometry().pose(), sim::inverse(world_.pose())); }
  Pose2 goal() const { return planar(sim::compose(map_in_odometry(), setup_.goal)); }

  void end(Ending ending) {
    ending_ = ending;
    ended_ = true;
  }

  // The host's control cycle.
  void control() {
    if (plan_wanted_) replan();
    if (plan_.empty()) {
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
    plan_.set_plan(poses_along(route, setup_.goal));
    if (setup_.person) setup_.person->set_plan(route);
  }

  Eigen::Vector2d goal_point() const { return {setup_.goal.x, setup_.goal.y}; }

  bool goal_reached() {
    const double left = (goal_point() - Eigen::Vector2d(world_.pose().x, world_.pose().y)).norm();
    if (setup_.goal_radius > 0.0) return left <= setup_.goal_radius;
    if (person_.state() == OperatorStateId::manual) return false;
    return check_goal(pose(), velocity(), goal());
  }

  // Where the robot was carried or driven away from the goal, what was latched there is true no more.
  bool check_goal(const Pose2& robot, const Twist2& velocity, const Pose2& goal) {
    const bool latched = goal_checker_.latched();
    const bool reached = goal_checker_.update(robot, velocity, goal, planner_.parameters());
    if (latched && !goal_checker_.latched()) begin_goal();
    return reached;
  }

  // The plugin's cycle; false when there is nothing to send.
  bool cycle() {
    const double time = now();
    const OperatorIntent intent = person_.update(time);
    observe(time);
    const GridView grid = sensing_.costmap();
    const auto begin = std::chrono::steady_clock::now();
    const Decision& decision = planner_.plan(situation_, grid, intent);
    const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - begin;
    const bool failed = decision.outcome == Outcome::fail;
    const Twist2 sent = failed ? Twist2{} : decision.command;  // the host stops the robot
    const Cycle seen{world_.time(), situation_, grid, intent, decision, planner_, world_};
    recorder_.add(seen, sent, control_due_.period(), spent.count());
    if (observer_) observer_(seen);
    world_.command({sent.v, sent.omega});
    last_command_ = sent;
    debrief(time, !decision.operator_refused_by.empty());
    return !failed;
  }

  void observe(double time) {
    situation_.pose = pose();
    situation_.velocity = velocity();
    situation_.last_command = last_command_;
    situation_.goal = goal();
    situation_.period = control_due_.period();
    situation_.time = time;
    take_plan_window();
    check_goal(situation_.pose, situation_.velocity, situation_.goal);
    situation_.goal_latched = goal_checker_.latched();
  }

  void take_plan_window() {
    const Parameters& p = planner_.parameters();
    const double least = p.forward_prune_auto ? 1.2 * p.max_vel_x * p.sim_time : 0.0;
    const double ahead = std::max(p.forward_prune_distance, least);
    const PlanWindow::Range range = plan_.around(planar(world_.pose()), p.prune_distance, ahead);
    const sim::Pose map = map_in_odometry();
    situation_.plan.clear();
    for (std::size_t i = range.begin; i < range.end; ++i) {
      situation_.plan.push_back(planar(sim::compose(map, planar(plan_.plan()[i]))));
    }
  }

  void begin_goal() {
    planner_.reset();
    goal_checker_.reset();
    person_.new_goal();
  }

  void debrief(double time, bool own_command_refused) {
    const Parameters& p = planner_.parameters();
    input::CycleFeedback feedback;
    feedback.command = last_command_;
    feedback.velocity = situation_.velocity;
    feedback.at_rest = last_command_ == Twist2{} && std::abs(feedback.velocity.v) <= p.trans_stopped_velocity &&
                       std::abs(feedback.velocity.omega) <= p.rot_stopped_velocity;
    feedback.own_command_refused = own_command_refused;
    feedback.goal_latched = goal_checker_.latched();
    person_.debrief(time, feedback);
  }

  const DriveSetup& setup_;
  const Observer& observer_;
  const Every control_due_, scan_due_, costmap_due_, plan_due_, stick_due_;
  sim::World world_;
  Sensing sensing_;
  input::OperatorStateMachine person_;
  OperatorLink link_;
  const sim::RouteClearance clearance_;
  std::shared_ptr<const sim::GridRoute> route_;
  Planner planner_;
  GoalChecker goal_checker_;
  PlanWindow plan_;            // map frame
  Situation situation_;        // kept for its memory
  Twist2 last_command_;        // [m/s, rad/s]
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
