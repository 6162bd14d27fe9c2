// SPDX-License-Identifier: BSD-3-Clause
#include "device.hpp"

#include <algorithm>
#include <limits>

namespace hidwa_attack {
namespace {

using hidwa_local_planner::Influence;
using hidwa_local_planner::OperatorIntent;
using hidwa_local_planner::OperatorMode;

constexpr double kCentred = 0.3;  // at first: devices must be seen neutral [s]
constexpr double kLate = 1.0;     // [s]

float deflection(double wanted, double most) {
  return most > 0.0 ? static_cast<float>(std::clamp(wanted / most, -1.0, 1.0)) : 0.0F;
}

}  // namespace

void Device::send(double now, const OperatorIntent& wish, const Parameters& limits) {
  if (begun_ < 0.0) begun_ = now;
  machine_.heartbeat(now);
  say(wish, limits);
  StickMessage message;
  message.axes = {0.0F, 0.0F};
  message.buttons = {0};
  message.stamp = message.received = now;
  const bool steers = wish.influence == Influence::shared || wish.influence == Influence::direct;
  if (steers && now >= begun_ + kCentred) {
    message.axes = {deflection(wish.u_h.omega, limits.max_vel_theta), deflection(wish.u_h.v, limits.max_vel_x)};
  }
  spoil(now, message);
  deliver(now);
}

// What is no deflection.
void Device::say(const OperatorIntent& wish, const Parameters& limits) {
  const bool stops = wish.influence == Influence::stop, manual = wish.influence == Influence::direct;
  if (stops != stops_) machine_.stop(stops);
  if (limits.mode == OperatorMode::switching && manual != manual_) machine_.take_control(manual);
  stops_ = stops;
  manual_ = manual;
}

void Device::spoil(double now, StickMessage& message) {
  constexpr float kNaN = std::numeric_limits<float>::quiet_NaN(), kInfinity = std::numeric_limits<float>::infinity();
  if (link_ == Link::frozen) {
    if (now >= frozen_until_ && random_.chance(0.02)) {
      frozen_until_ = now + random_.in(0.5, 3.0);
      frozen_ = message;
    }
    if (now < frozen_until_) message = frozen_;  // its stamp too
    message.received = now;
  } else if (link_ == Link::silent) {
    if (now >= silent_until_ && random_.chance(0.02)) silent_until_ = now + random_.in(0.1, 2.0);
    if (now < silent_until_) return;
  } else if (link_ == Link::nonsense && random_.chance(0.3)) {
    message.axes[static_cast<std::size_t>(random_.whole(0, 1))] =
        random_.of({kNaN, kInfinity, -kInfinity, 7.0F, -1e30F});
    if (random_.chance(0.2)) message.axes.resize(1);
    if (random_.chance(0.1)) message.axes.clear();
    if (random_.chance(0.1)) message.stamp = random_.of({0.0, -5.0, 1e18, std::numeric_limits<double>::quiet_NaN()});
  } else if (link_ == Link::late) {
    if (now >= late_until_ && random_.chance(0.02)) late_until_ = now + random_.in(0.5, 4.0);
    if (now < late_until_) message.received = now + kLate;
  }
  under_way_.push_back(message);
}

// In order, as a connection delivers them: one that is late holds up those behind it, which then come at once.
void Device::deliver(double now) {
  for (; !under_way_.empty() && under_way_.front().received <= now; under_way_.pop_front()) {
    StickMessage& message = under_way_.front();
    message.received = now;
    machine_.receive(message);
  }
}

}  // namespace hidwa_attack
