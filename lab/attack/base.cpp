// SPDX-License-Identifier: BSD-3-Clause
#include "base.hpp"

#include <algorithm>
#include <cmath>

namespace hidwa_attack {

double time_between(const AxisPower& power, double from, double to) {
  if (from * to < 0.0) return std::abs(from) / power.dec + std::abs(to) / power.acc;
  return std::abs(to - from) / (std::abs(to) > std::abs(from) ? power.acc : power.dec);
}

double after(const AxisPower& power, double from, double to, double dt) {
  if (from * to < 0.0) {
    const double to_rest = std::abs(from) / power.dec;
    if (dt <= to_rest) return from - std::copysign(power.dec * dt, from);
    return after(power, 0.0, to, dt - to_rest);
  }
  const double rate = std::abs(to) > std::abs(from) ? power.acc : power.dec;
  const double step = std::min(rate * dt, std::abs(to - from));
  return from + std::copysign(step, to - from);
}

void AxisDrive::begin(double to, double period, double share) {
  from_ = now_;
  to_ = to;
  since_ = 0.0;
  period_ = std::max(period, time_between(power_, from_, to_));
  share_ = share;
}

// Between the way at the limits and the even one, but never so late that the limits would make it miss the period's
// end.
double AxisDrive::wanted() const {
  if (since_ >= period_) return to_;
  const double even = from_ + (to_ - from_) * since_ / period_;
  const double mixture = (1.0 - share_) * after(power_, from_, to_, since_) + share_ * even;
  const double latest = after({power_.dec, power_.acc}, to_, from_, period_ - since_);  // the way back in time
  return to_ >= from_ ? std::max(mixture, latest) : std::min(mixture, latest);
}

void AxisDrive::step(double dt) {
  since_ += dt;
  now_ = after(power_, now_, wanted(), dt);
}

double Base::share() {
  switch (make_.reaching) {
    case Reaching::evenly:
      return 1.0;
    case Reaching::at_limit:
      return 0.0;
    case Reaching::anyhow:
      return random_.chance(0.3) ? random_.of({0.0, 1.0}) : random_.in(0.0, 1.0);
    case Reaching::either:
      return random_.of({0.0, 1.0});
  }
  return 1.0;
}

void Base::send(int now, const Twist2& command) {
  const int latency = make_.latency_varies ? random_.whole(0, make_.latency) : make_.latency;
  const int earliest = pending_.empty() ? now : pending_.back().effect;
  pending_.push_back({std::max(now + latency, earliest), command});
}

void Base::take_up(const Twist2& command) {
  x_.begin(command.v, make_.period, share());
  theta_.begin(command.omega, make_.period, share());
}

void Base::step(int now) {
  constexpr double kStep = 1e-3;  // [s]
  for (; !pending_.empty() && pending_.front().effect <= now; pending_.pop_front()) take_up(pending_.front().command);
  const Twist2 before = velocity();
  x_.step(kStep);
  theta_.step(kStep);
  slip(now);
  const double way = 0.5 * (before.v + x_.now()) * kStep * slips_x_;
  const double turn = 0.5 * (before.omega + theta_.now()) * kStep * slips_theta_;
  pose_.x += way * std::cos(pose_.theta + 0.5 * turn);
  pose_.y += way * std::sin(pose_.theta + 0.5 * turn);
  pose_.theta += turn;
}

void Base::slip(int now) {
  constexpr int kAnew = 500;  // [ms]
  if (make_.slip <= 0.0 || now % kAnew != 0) return;
  slips_x_ = 1.0 + random_.in(-make_.slip, make_.slip);
  slips_theta_ = 1.0 + random_.in(-make_.slip, make_.slip);
}

}  // namespace hidwa_attack
