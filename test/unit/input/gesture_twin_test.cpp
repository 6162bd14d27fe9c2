// SPDX-License-Identifier: BSD-3-Clause
// Random stories of a hand and its clutch against a twin that goes through the whole history for every cycle.
#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <random>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "person.hpp"

namespace hidwa_local_planner::input {
namespace {

constexpr double kTimeout = 0.5;  // input_timeout [s]
constexpr double kRange = 0.3;    // gesture_range [m]
constexpr double kJump = 0.3;     // [m] between two poses

struct Event {
  enum class Kind { clutch, hand, cycle };
  Kind kind = Kind::cycle;
  double time = 0.0;    // [s]
  bool held = false;    // the clutch
  bool tracked = true;  // the hand
  double y = 0.0;       // of the hand [m]
};

/// What the person asks for at the end of a history.
struct Asked {
  std::optional<double> omega;  // steering so [rad/s]
  bool lost = false;            // steered when the hand or its clutch were lost
};

// |p| <= 0.1: nothing; else p^2 sgn(p), with p = displacement / range, at most 1.
std::optional<double> omega_of(double displacement) {
  const float p = static_cast<float>(displacement / kRange);
  if (std::abs(p) <= 0.1F) return std::nullopt;
  const double size = std::min(1.0, std::abs(static_cast<double>(p)));
  return std::copysign(size * size, displacement);
}

Asked asked(const std::vector<Event>& history, std::size_t end) {
  // The press: the first held message after the last released one.
  std::size_t press = end;
  bool released_before = false;
  for (std::size_t e = end; e-- > 0 && !released_before;) {
    if (history[e].kind != Event::Kind::clutch) continue;
    if (history[e].held) {
      press = e;
    } else {
      released_before = true;
    }
  }
  if (press == end || !released_before) return {};
  // What became of the hand since.
  std::optional<double> origin, omega;
  double y = 0.0, clutch_heard = 0.0, hand_heard = 0.0;
  for (std::size_t e = press; e <= end; ++e) {
    const Event& event = history[e];
    if (event.kind == Event::Kind::clutch) {
      clutch_heard = event.time;
      continue;
    }
    const bool clutch_silent = event.time - clutch_heard > kTimeout;
    const bool hand_silent = origin && event.time - hand_heard > kTimeout;
    const bool hand = event.kind == Event::Kind::hand;
    const bool jumped = hand && origin && std::abs(event.y - y) > kJump;
    if (clutch_silent || hand_silent || jumped || (hand && !event.tracked)) return {{}, omega.has_value()};
    if (!hand) continue;
    y = event.y;
    hand_heard = event.time;
    if (!origin) origin = y;
    omega = omega_of(y - *origin);
  }
  return {omega, false};
}

std::vector<Event> story(unsigned seed) {
  std::mt19937 random(seed);
  const auto uniform = [&random](double low, double high) {
    return low + (high - low) * static_cast<double>(random()) / 4294967296.0;
  };
  const auto chance = [&uniform](double probability) { return uniform(0.0, 1.0) < probability; };
  std::vector<Event> history;
  double now = 100.0, y = 0.0;
  bool held = false, clutch_cut = false, hand_cut = false;
  for (int i = 0; i < 300; ++i) {
    Event event;
    event.time = now += chance(0.01) ? uniform(0.3, 2.0) : uniform(0.001, 0.05);
    if (chance(0.02)) clutch_cut = chance(0.3);
    if (chance(0.02)) hand_cut = chance(0.3);
    if (chance(0.04)) held = !held;
    y += uniform(-0.06, 0.06);
    const double kind = uniform(0.0, 1.0);
    if (kind < 0.33 && !clutch_cut) {
      event.kind = Event::Kind::clutch;
      event.held = held;
    } else if (kind < 0.67 && !hand_cut) {
      event.kind = Event::Kind::hand;
      if (chance(0.02)) y += chance(0.5) ? 1.0 : -1.0;
      event.tracked = !chance(0.01);
      event.y = y;
    }
    history.push_back(event);
  }
  return history;
}

TEST(GestureTwin, EveryCycleOfRandomStories) {
  Parameters p = in_mode(OperatorMode::gesture);
  p.delta = 0.0;  // no hold: the hand alone
  p.on_input_lost = OnInputLost::autonomy;
  std::map<std::pair<State, State>, int> changes;
  for (unsigned seed = 1; seed <= 1000; ++seed) {
    const std::vector<Event> history = story(seed);
    Person person(p);
    State before = State::autonomy;
    for (std::size_t e = 0; e < history.size(); ++e) {
      const Event& event = history[e];
      if (event.kind == Event::Kind::clutch) {
        person.machine.receive(event.held ? button_at(event.time, kClutch) : stick_at(event.time, 0.0F));
        continue;
      }
      if (event.kind == Event::Kind::hand) {
        HandMessage message = hand_at(event.time, 1.0, event.y, 1.0);
        if (!event.tracked) message.orientation.setZero();
        person.machine.receive(message);
        continue;
      }
      const OperatorIntent intent = person.cycle(event.time);
      const Asked wanted = asked(history, e);
      const bool loses = wanted.lost && (before == State::shared || before == State::lost);
      const State state = wanted.omega ? State::shared : loses ? State::lost : State::autonomy;
      ASSERT_STREQ(to_string(intent.state), to_string(state)) << "seed " << seed << " event " << e;
      ASSERT_EQ(intent.u_h.v, wanted.omega ? p.max_vel_x : 0.0);
      ASSERT_NEAR(intent.u_h.omega, wanted.omega.value_or(0.0), 1e-12) << "seed " << seed << " event " << e;
      ++changes[{before, state}];
      before = state;
    }
  }
  for (const auto& [from, to] : {std::pair{State::autonomy, State::shared},
                                 {State::shared, State::autonomy},
                                 {State::shared, State::lost},
                                 {State::lost, State::autonomy},
                                 {State::lost, State::lost},
                                 {State::shared, State::shared}}) {
    EXPECT_GE((changes[{from, to}]), 50) << to_string(from) << " -> " << to_string(to);
  }
}

}  // namespace
}  // namespace hidwa_local_planner::input
