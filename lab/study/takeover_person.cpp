// SPDX-License-Identifier: BSD-3-Clause
#include "study/takeover_person.hpp"

#include <algorithm>
#include <cmath>

namespace hidwa_local_planner {
namespace study {
namespace {

constexpr double kPress = 0.15;    // [s], that a press of the button lasts
constexpr double kBetween = 0.15;  // [s], between two presses at the least

}  // namespace

sim::Controls TakeoverPerson::update(double time, const sim::Stick& wanted) {
  step(time, wanted.left != 0.0);
  while (!presses_.empty() && presses_.front().to <= time) presses_.pop_front();
  sim::Controls controls;
  controls.toggle = !presses_.empty() && presses_.front().from <= time;
  const bool thinks_they_drive = phase_ == Phase::driving || phase_ == Phase::leaving || phase_ == Phase::misled;
  if (thinks_they_drive) controls.stick = driving_stick(wanted);
  return controls;
}

void TakeoverPerson::step(double time, bool wants) {
  switch (phase_) {
    case Phase::watching:
      if (wants) watch(time);
      break;
    case Phase::reaching:
      if (!wants) {
        phase_ = Phase::watching;  // passed by itself
      } else if (time >= next_) {
        take_control(time);
      }
      break;
    case Phase::misled:
      if (time < next_) break;
      phase_ = wants ? Phase::reaching : Phase::watching;
      next_ = time + participant_.button_time;
      break;
    case Phase::driving:
    case Phase::leaving:
      drive_on(time, wants);
      break;
    case Phase::forgotten:
      if (time < next_) break;
      press(time);
      phase_ = Phase::watching;
      break;
  }
}

// Something must be done: press the button, or else believe to have done so.
void TakeoverPerson::watch(double time) {
  const bool misled = errs(participant_.early_stick_probability);
  phase_ = misled ? Phase::misled : Phase::reaching;
  next_ = time + (misled ? participant_.notice_time : participant_.button_time);
}

void TakeoverPerson::take_control(double time) {
  press(time);
  content_since_ = std::numeric_limits<double>::quiet_NaN();
  if (!errs(participant_.double_press_probability)) {
    phase_ = Phase::driving;
    return;
  }
  press(time);
  phase_ = Phase::misled;
  next_ = time + participant_.notice_time;
}

void TakeoverPerson::drive_on(double time, bool wants) {
  if (wants) {
    content_since_ = std::numeric_limits<double>::quiet_NaN();
    phase_ = Phase::driving;
    return;
  }
  if (std::isnan(content_since_)) content_since_ = time;
  if (phase_ == Phase::driving && time >= content_since_ + participant_.give_back_pause) {
    const bool forgets = errs(participant_.forget_probability);
    phase_ = forgets ? Phase::forgotten : Phase::leaving;
    next_ = time + (forgets ? participant_.notice_time : participant_.button_time);
  } else if (phase_ == Phase::leaving && time >= next_) {
    press(time);
    phase_ = Phase::watching;
  }
}

// As soon as the finger is ready again.
void TakeoverPerson::press(double time) {
  const double from = presses_.empty() ? time : std::max(time, presses_.back().to + kBetween);
  presses_.push_back({from, from + kPress});
}

bool TakeoverPerson::errs(double probability) {
  const bool error = random_.uniform() < probability;
  if (error) ++errors_;
  return error;
}

sim::Stick TakeoverPerson::driving_stick(const sim::Stick& wanted) const {
  const double within = std::sqrt(std::max(0.0, 1.0 - wanted.left * wanted.left));
  return {wanted.left, 1.0 + participant_.round_gate * (within - 1.0)};
}

}  // namespace study
}  // namespace hidwa_local_planner
