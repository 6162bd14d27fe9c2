// SPDX-License-Identifier: BSD-3-Clause
#include "operator_link.hpp"

#include <utility>

namespace hidwa_local_planner {
namespace drive {
namespace {

// Where the hand rests in its tracker's frame [m]: before the person, on the armrest's height.
const Eigen::Vector3d kRest{0.35, -0.2, 0.9};

constexpr double kSlack = 1e-9;  // [s], of rounding between two times that are meant to be equal

}  // namespace

void OperatorLink::send(const sim::Observation& seen) {
  if (!setup_.person) return;
  const sim::Stick wanted = setup_.person->update(seen);
  sim::Controls controls;
  controls.stick = wanted;
  if (setup_.device) controls = setup_.device->update(seen.time, wanted);
  Sent sent;
  sent.stick.axes = {static_cast<float>(controls.stick.left), static_cast<float>(controls.stick.up)};
  sent.stick.buttons = {controls.toggle || controls.clutch ? 1 : 0};
  sent.stick.stamp = sent.hand.stamp = seen.time;
  sent.stick.received = sent.hand.received = seen.time + setup_.link_delay;
  sent.hand.position = kRest + Eigen::Vector3d(0.0, controls.hand_left, 0.0);
  sent.hand.orientation = {0.0, 0.0, 0.0, 1.0};
  under_way_.push_back(std::move(sent));
}

void OperatorLink::deliver(double now) {
  for (; !under_way_.empty() && under_way_.front().stick.received <= now + kSlack; under_way_.pop_front()) {
    listener_.receive(under_way_.front().stick);
    // Where nobody steers by hand, nobody listens to it.
    listener_.receive(under_way_.front().hand);
  }
}

}  // namespace drive
}  // namespace hidwa_local_planner
