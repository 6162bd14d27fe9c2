// SPDX-License-Identifier: BSD-3-Clause
// An operator's devices, what moves, and the host's requests, as messages in any order: each message is taken or
// refused in words, and every cycle ends with a finite command inside the limits.
#include <algorithm>
#include <cstdint>
#include <string>

#include "control/prediction.hpp"
#include "fuzz/input.hpp"
#include "fuzz/mover.hpp"
#include "fuzz/require.hpp"
#include "fuzz/small_world.hpp"
#include "hidwa_local_planner/critics/built_in.hpp"
#include "input/gesture_source.hpp"
#include "input/operator_state_machine.hpp"
#include "input/stick_reading.hpp"
#include "input/twist_source.hpp"

namespace hidwa_local_planner::fuzz {
namespace {

constexpr double kPeriod = 0.05;  // [s]

class Drive {
 public:
  explicit Drive(const Input& input) : input_(input), loop_(critics::built_in()) {
    reconfigure();
    loop_.set_footprint(SmallWorld::outline());
    loop_.set_plan(SmallWorld::plan(), "map", now_, kPeriod);
  }

  void run() {
    for (int step = 0; step < 200 && input_.left() > 0; ++step) act();
    cycle();
  }

 private:
  void act() {
    switch (input_.integer(0, 11)) {
      case 0:
        return take_stick();
      case 1:
        return take_twist();
      case 2:
        return take_hand();
      case 3:
        return machine_.stop(input_.flag());
      case 4:
        return machine_.take_control(input_.flag());
      case 5:
        return machine_.heartbeat(input_.number(now_ - 1.0, now_ + 0.1));
      case 6:
        return reconfigure();
      case 7:
        return replan();
      case 8:
        now_ = input_.integer(0, 7) == 7 ? input_.number(-100.0, 100.0) : now_ + input_.within(0.0, 1.0);
        if (!(std::abs(now_) < 1e9)) now_ = 0.0;  // the host's clock is a number
        return;
      default:
        return cycle();
    }
  }

  template <typename Message>
  Message stamped(Message message) {
    message.stamp = input_.number(now_ - 2.0, now_ + 0.5);
    message.received = now_;
    message.sender = input_.flag() ? "/one" : "/other";
    return message;
  }
  // A fault is told in words, and none of them is a control character.
  void give(const input::OperatorMessage& message) {
    const std::string fault = machine_.receive(message);
    require(fault.size() < 1000, "a fault of a thousand words");
  }
  void take_stick() {
    input::StickMessage stick;
    for (int k = input_.integer(0, 8); k > 0; --k) stick.axes.push_back(static_cast<float>(input_.number(-1.0, 1.0)));
    for (int k = input_.integer(0, 12); k > 0; --k)
      stick.buttons.push_back(input_.integer(0, 31) == 31 ? -7 : input_.integer(0, 1));
    give(stamped(stick));
  }
  void take_twist() {
    input::TwistMessage twist;
    twist.u = {input_.number(-1.0, 1.0), input_.number(-2.0, 2.0)};
    give(stamped(twist));
  }
  void take_hand() {
    input::HandMessage hand;
    for (int k = 0; k < 3; ++k) hand.position[k] = input_.number(-0.5, 0.5);
    for (int k = 0; k < 4; ++k) hand.orientation[k] = input_.number(-1.0, 1.0);
    give(stamped(hand));
  }

  void reconfigure() {
    Parameters p;
    p.vx_samples = 3;
    p.vth_samples = 5;
    p.search_poses = 50;
    p.sim_time = 1.0;
    const unsigned choices = static_cast<unsigned>(input_.integer(0, 65535));
    p.mode = static_cast<OperatorMode>(choices % 4);
    p.linear = static_cast<LinearPolicy>(choices / 4 % 3);
    p.on_input_lost = static_cast<OnInputLost>(choices / 16 % 3);
    p.method = (choices & 64U) != 0 ? Method::paper : Method::hidwa;
    p.guard = (choices & 128U) != 0 ? Guard::none : Guard::nearest;
    if ((choices & 256U) != 0) p.twist_topic = "twist";
    if ((choices & 512U) != 0) p.enable_button = 1;
    if ((choices & 1024U) != 0) p.stop_button = 2;
    if ((choices & 2048U) != 0) p.clutch_axis = {3, true};
    if ((choices & 4096U) != 0) p.min_vel_x = -0.3;
    if ((choices & 8192U) != 0) p.input_timeout = 0.0;
    if ((choices & 16384U) != 0) p.require_neutral = false;
    p.axis_angular = {input_.integer(0, 5)};
    p.axis_linear = {input_.integer(0, 5)};
    p.authority = input_.within(0.0, 1.0);
    p.exponent = input_.within(0.1, 10.0);
    p.dead_zone = input_.within(0.0, 0.99);
    p.gesture_range = input_.within(0.01, 2.0);
    require(loop_.configure(p).empty(), "a valid set is refused");
    machine_.configure(p);
    parameters_ = p;
  }

  void replan() {
    if (input_.integer(0, 3) == 0) return loop_.drop_plan(now_, kPeriod);
    std::vector<Pose2> plan = SmallWorld::plan();
    if (input_.flag()) {
      plan.clear();
      for (int k = input_.integer(1, 12); k > 0; --k) {
        plan.push_back({input_.number(-2.0, 2.0), input_.number(-2.0, 2.0), input_.number(-4.0, 4.0)});
      }
    }
    loop_.set_plan(plan, input_.flag() ? "map" : "odom", now_, kPeriod);
  }

  void add_movers(MovingObstacleEstimates& movers) {
    for (int k = input_.integer(0, 3); k > 0; --k) {
      MovingObstacleEstimate mover = mover_of(input_, 2.0, 0.2);
      const double x = input_.number(-2.0, 2.0), y = input_.number(-2.0, 2.0);
      mover.points = {mover.position, {x, y}};
      movers.push_back(mover);
    }
  }

  void cycle() {
    const double interval = std::max(0.0, now_ - before_);
    control::Observation seen = world_.observe(now_, kPeriod, last_);
    seen.timing.interval = interval;
    seen.timing.jumped_back = now_ < before_;
    before_ = now_;
    if (input_.integer(0, 7) == 7) seen.velocity = Twist2{input_.number(-1.0, 1.0), input_.number(-2.0, 2.0)};
    if (input_.integer(0, 7) == 7)
      seen.pose = {input_.number(-1.0, 1.0), input_.number(-1.0, 1.0), input_.number(-4.0, 4.0)};
    if (input_.integer(0, 7) == 7)
      seen.from_plan.origin = {input_.number(-1.0, 1.0), input_.number(-1.0, 1.0), input_.number(-4.0, 4.0)};
    if (input_.integer(0, 7) == 7) seen.fault = "something is missing";
    if (!seen.fault.empty() && input_.flag()) seen.velocity.reset();
    seen.host_stops = input_.integer(0, 15) == 15;
    if (input_.integer(0, 3) == 3) add_movers(seen.moving_obstacles);
    if (!seen.fault.empty() || loop_.has_plan()) step(seen);
    now_ += kPeriod;
  }
  void step(const control::Observation& seen) {
    if (input_.flag()) loop_.goal_reached(seen, machine_.manual());
    if (loop_.goal_begins()) machine_.new_goal();
    const control::Result result = loop_.step(seen, machine_.update(now_));
    machine_.debrief(now_, result.feedback);
    require(is_finite(result.intent.u_h), "the operator command is not a number");
    require_within_limits(result.command, last_, parameters_);
    last_ = result.command;
    prediction_.update(loop_, seen, result);
    for (const auto& pose : prediction_.poses()) require(is_finite(pose.pose), "a predicted pose is not a number");
    require(machine_.advice().size() < 4000, "advice of four thousand characters");
    machine_.take_warnings();
  }

  Input input_;
  SmallWorld world_;
  input::OperatorStateMachine machine_;
  control::ControlLoop loop_;
  control::Prediction prediction_;
  Parameters parameters_;
  Twist2 last_;
  double now_ = 10.0, before_ = 9.95;  // [s]
};

}  // namespace
}  // namespace hidwa_local_planner::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace hidwa_local_planner::fuzz;
  Drive(Input(data, size)).run();
  return 0;
}
