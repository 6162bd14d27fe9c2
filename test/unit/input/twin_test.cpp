// SPDX-License-Identifier: BSD-3-Clause
// One stick in the modes joystick and switching: neutral, silence, late and faulty messages, presses, stops, words,
// holds, blockages, goals, pauses of the planner. The tests beside this one hold what these stories lack: other devices
// and several senders, clocks that are set, parameters that change, and what is told in words.
#include "twin.hpp"

#include <algorithm>
#include <cstdio>
#include <limits>
#include <map>
#include <random>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

namespace hidwa_local_planner::input {
namespace {

/// Makes up a person, a link and a robot.
class Story {
 public:
  explicit Story(unsigned seed) : random_(seed) {}

  Parameters parameters() {
    Parameters p;
    p.mode = chance(0.5) ? OperatorMode::joystick : OperatorMode::switching;
    p.linear = chance(0.3) ? LinearPolicy::axis : chance(0.2) ? LinearPolicy::current : LinearPolicy::v_max;
    p.min_vel_x = chance(0.3) ? -0.2 : 0.0;
    p.on_input_lost = static_cast<OnInputLost>(random_() % 3);
    p.guard = chance(0.5) ? Guard::nearest : Guard::none;
    p.input_timeout = chance(0.2) ? 0.0 : 0.5;
    p.delta = chance(0.2) ? 0.3 : 2.0;
    p.blocked_time = chance(0.3) ? 0.1 : 0.6;
    p.require_neutral = chance(0.7);
    p.method = chance(0.3) ? Method::paper : Method::hidwa;
    p.toggle_button = 0;
    p.stop_button = 1;
    p.stop_pull = chance(0.3) ? 0.0 : 0.8;
    pulls_ = p.stop_pull > 0.0;
    return p;
  }

  std::vector<Event> events(int count) {
    stamps_ = chance(0.6);
    listens_ = chance(0.5);
    steady_ = chance(0.5);
    faulty_stop_ = chance(0.5);
    std::vector<Event> history;
    for (int i = 0; i < count; ++i) {
      now_ += chance(0.03) ? uniform(0.3, 3.0) : uniform(0.001, 0.06);
      Event event;
      event.time = now_;
      if (chance(0.02)) cut_ = chance(0.3);
      if (listens_ && chance(0.2)) {
        event.kind = Event::Kind::listens;
      } else if (chance(0.5) && !cut_) {
        event.kind = Event::Kind::message;
        event.message = message();
      } else if (chance(0.02)) {
        event.kind = Event::Kind::new_goal;
      } else if (chance(0.02)) {
        event.kind = Event::Kind::say_stop;
        event.said = chance(0.3);
      } else if (chance(0.03)) {
        event.kind = Event::Kind::say_control;
        event.said = chance(0.7);
      } else {
        event.feedback = feedback();
      }
      history.push_back(event);
    }
    return history;
  }

 private:
  bool chance(double probability) { return uniform(0.0, 1.0) < probability; }
  double uniform(double low, double high) { return low + (high - low) * static_cast<double>(random_()) / 4294967296.0; }
  float value() { return chance(0.3) ? 0.05F : static_cast<float>(uniform(-1.0, 1.0)); }

  StickMessage message() {
    if (chance(0.1)) deflected_ = !deflected_;
    if (chance(steady_ ? 0.02 : 0.03)) late_ = chance(0.5) ? 0.0 : steady_ ? uniform(0.5, 1.0) : uniform(0.0, 1.4);
    StickMessage m;
    m.received = now_;
    m.axes = {deflected_ ? value() : 0.0F, deflected_ ? value() : 0.0F};
    if (chance(pulled_ ? 0.3 : 0.02)) pulled_ = !pulled_;
    if (pulls_ && pulled_) m.axes[1] = -static_cast<float>(uniform(0.5, 1.0));
    if (chance(toggles_ ? 0.4 : 0.04)) toggles_ = !toggles_;
    if (chance(stops_ ? 0.3 : 0.01)) stops_ = !stops_;
    m.buttons = {toggles_ ? 1 : 0, stops_ ? 1 : 0};
    if (chance(0.01)) m.buttons.pop_back();
    if (chance(0.01)) m.buttons[0] = 2;
    if (chance(0.01)) m.axes[1] = 1.5F;
    if (chance(faulty_stop_ && (stops_ || pulled_) ? 0.8 : 0.03)) m.axes[0] = std::numeric_limits<float>::quiet_NaN();
    if (chance(0.03)) m.axes[0] = -1.5F;
    if (chance(0.03)) m.axes.clear();
    if (stamps_ && !chance(0.1)) {
      if (!chance(0.1)) stamp_ = std::max(stamp_, now_ - 3.0 - late_);  // the sender's clock is 3 s behind
      m.stamp = stamp_;
    }
    return m;
  }

  CycleFeedback feedback() {
    if (chance(0.1)) held_ = chance(0.4);
    if (chance(0.05)) latched_ = chance(0.2);
    CycleFeedback f;
    f.operator_command_rejected = held_ ? !chance(0.02) : chance(0.02);
    f.stands = held_ ? !chance(0.02) : chance(0.1);
    f.goal_latched = latched_;
    f.command = {uniform(0.0, 0.5), uniform(-1.0, 1.0)};
    return f;
  }

  std::mt19937 random_;
  double now_ = 100.0;
  double stamp_ = 1.0;
  double late_ = 0.0;
  bool stamps_ = false;
  bool steady_ = false;       // the link's delay seldom changes
  bool listens_ = false;      // the thread that takes messages says so
  bool cut_ = false;          // no message arrives
  bool faulty_stop_ = false;  // a stop comes with faults elsewhere
  bool deflected_ = false;
  bool toggles_ = false;
  bool stops_ = false;
  bool pulls_ = false;  // a pulled stick is part of the story
  bool pulled_ = false;
  bool held_ = false;
  bool latched_ = false;
};

using S = OperatorStateId;

TEST(OperatorTwin, EveryCycleOfRandomStories) {
  std::map<std::pair<S, S>, int> changes;
  std::uint32_t dropped = 0;
  std::size_t slower_links = 0, pauses = 0;
  for (unsigned seed = 1; seed <= 4000; ++seed) {
    Story story(seed);
    const Parameters p = story.parameters();
    const std::vector<Event> history = story.events(240);
    const Twin twin(history, p);
    const std::vector<OperatorIntent> expected = twin.intents();

    OperatorStateMachine machine;
    machine.configure(p);
    std::size_t cycle = 0;
    for (const Event& event : history) {
      if (event.kind == Event::Kind::message) machine.receive(event.message);
      if (event.kind == Event::Kind::listens) machine.heartbeat(event.time);
      if (event.kind == Event::Kind::new_goal) machine.new_goal();
      if (event.kind == Event::Kind::say_stop) machine.stop(event.said);
      if (event.kind == Event::Kind::say_control) machine.take_control(event.said);
      if (event.kind != Event::Kind::cycle) continue;
      const OperatorStateId before = machine.state();
      const OperatorIntent intent = machine.update(event.time);
      machine.debrief(event.time, event.feedback);
      const OperatorIntent& wanted = expected[cycle];
      ASSERT_STREQ(to_string(intent.state), to_string(wanted.state)) << "seed " << seed << " cycle " << cycle;
      ASSERT_EQ(static_cast<int>(intent.influence), static_cast<int>(wanted.influence)) << "seed " << seed;
      ASSERT_EQ(intent.u_h.v, wanted.u_h.v) << "seed " << seed << " cycle " << cycle;
      ASSERT_EQ(intent.u_h.omega, wanted.u_h.omega) << "seed " << seed << " cycle " << cycle;
      ASSERT_EQ(intent.guarded, wanted.guarded) << "seed " << seed << " cycle " << cycle;
      ASSERT_EQ(machine.state(), intent.state);
      ++changes[{before, intent.state}];
      ++cycle;
    }
    ASSERT_EQ(cycle, expected.size());
    ASSERT_EQ(machine.dropped(), twin.dropped()) << "seed " << seed;
    dropped += machine.dropped();
    slower_links += twin.slower_links();
    pauses += twin.pauses();
  }

  // The stories went through every change that there is.
  std::vector<std::pair<S, S>> all = {
      {S::autonomy, S::shared}, {S::autonomy, S::manual}, {S::shared, S::autonomy},  {S::shared, S::hold},
      {S::shared, S::lost},     {S::shared, S::blocked},  {S::blocked, S::autonomy}, {S::blocked, S::shared},
      {S::blocked, S::hold},    {S::blocked, S::lost},    {S::hold, S::autonomy},    {S::hold, S::shared},
      {S::lost, S::autonomy},   {S::lost, S::shared},     {S::lost, S::hold},        {S::lost, S::manual},
      {S::manual, S::autonomy}, {S::manual, S::lost},     {S::stopped, S::autonomy}, {S::stopped, S::shared},
      {S::stopped, S::manual},  {S::stopped, S::lost}};
  for (const S any : {S::autonomy, S::shared, S::hold, S::manual, S::stopped, S::lost, S::blocked}) {
    all.emplace_back(any, any);
    if (any != S::stopped) all.emplace_back(any, S::stopped);
  }
  for (const auto& [from, to] : all) {
    const int times = changes[{from, to}];
    std::printf("%s -> %s: %d\n", to_string(from), to_string(to), times);
    EXPECT_GE(times, 5) << to_string(from) << " -> " << to_string(to);
  }
  // And through none that there is not.
  for (const auto& [change, times] : changes) {
    const bool known = std::find(all.begin(), all.end(), change) != all.end();
    EXPECT_TRUE(known) << to_string(change.first) << " -> " << to_string(change.second) << ": " << times;
  }
  std::printf("dropped: %u\n", dropped);
  EXPECT_GT(dropped, 1000U);
  std::printf("slower links: %zu, pauses: %zu\n", slower_links, pauses);
  EXPECT_GT(slower_links, 100U);
  EXPECT_GT(pauses, 1000U);
}

}  // namespace
}  // namespace hidwa_local_planner::input
