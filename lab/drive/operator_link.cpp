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
  const sim::Stick stick = setup_.person->update(seen);
  sim::Controls controls;
  controls.stick = stick;
  if (setup_.device) controls = setup_.device->update(seen.time, stick);
  Sent sent;
  sent.stick.axes = {static_cast<float>(controls.stick.left), static_cast<float>(controls.stick.up)};
  sent.stick.buttons = {controls.toggle || controls.clutch ? 1 : 0};
  sent.stick.stamp = sent.hand.stamp = seen.time;
  sent.stick.received = sent.hand.received = seen.time + setup_.link_delay;
  sent.hand.position = kRest + Eigen::Vector3d(0.0, controls.hand_left, 0.0);
  sent.hand.orientation = {0.0, 0.0, 0.0, 1.0};
  in_transit_.push_back(std::move(sent));
}

void OperatorLink::deliver(double now) {
  for (; !in_transit_.empty() && in_transit_.front().stick.received <= now + kSlack; in_transit_.pop_front()) {
    machine_.receive(in_transit_.front().stick);
    // Dropped without a word where the mode is not gesture.
    machine_.receive(in_transit_.front().hand);
  }
}

}  // namespace drive
}  // namespace hidwa_local_planner
