// SPDX-License-Identifier: BSD-3-Clause
#include "sensors.hpp"

namespace hidwa_attack {

std::optional<Twist2> Sensors::odometry(int now) {
  const Twist2 true_one = at(0).velocity;
  switch (spec_.odometry) {
    case Odometry::exact:
      return true_one;
    case Odometry::noisy:
      return noisy(true_one);
    case Odometry::outliers:
      return outlier(true_one);
    case Odometry::slips:
      return slipped(true_one);
    case Odometry::delayed:
      return at(spec_.latency).velocity;
    case Odometry::silent:
      return silent(now) ? std::nullopt : std::optional<Twist2>(true_one);
    case Odometry::flickers:
      return flickers() ? std::nullopt : std::optional<Twist2>(true_one);
    case Odometry::dead:
      if (dead_from_ == 0) dead_from_ = random_.whole(1000, 8000);
      return now >= dead_from_ ? Twist2{} : true_one;
  }
  return true_one;
}

Twist2 Sensors::noisy(const Twist2& true_one) {
  const double v = true_one.v * random_.in(0.95, 1.05) + random_.in(-0.01, 0.01);
  return {v, true_one.omega * random_.in(0.95, 1.05) + random_.in(-0.02, 0.02)};
}

// Either axis, or both.
Twist2 Sensors::outlier(const Twist2& true_one) {
  if (!random_.chance(0.01)) return true_one;
  const int which = random_.whole(1, 3);
  Twist2 reading = true_one;
  if ((which & 1) != 0) reading.v = random_.in(-10.0, 10.0);
  if ((which & 2) != 0) reading.omega = random_.in(-20.0, 20.0);
  return reading;
}

// One reading, or two in a row: three are believed.
Twist2 Sensors::slipped(const Twist2& true_one) {
  if (wrong_ == 0 && right_ > 0 && random_.chance(0.02)) wrong_ = random_.whole(1, 2);
  if (wrong_ == 0) {
    ++right_;
    return true_one;
  }
  --wrong_;
  right_ = 0;
  const int which = random_.whole(1, 3);
  const double share = random_.of({0.0, -1.0, random_.in(-1.0, 1.0)});
  return {((which & 1) != 0 ? share : 1.0) * true_one.v, ((which & 2) != 0 ? share : 1.0) * true_one.omega};
}

bool Sensors::flickers() {
  if (silent_cycles_ == 0 && random_.chance(0.15)) silent_cycles_ = random_.whole(1, 3);
  return silent_cycles_ > 0 && silent_cycles_-- > 0;
}

bool Sensors::silent(int now) {
  if (now >= silent_until_ && random_.chance(0.01)) silent_until_ = now + random_.whole(300, 1500);
  return now < silent_until_;
}

}  // namespace hidwa_attack
