// SPDX-License-Identifier: BSD-3-Clause
#include "record/cycle_replay.hpp"

#include <array>
#include <cmath>
#include <set>

#include <gtest/gtest.h>

#include "hidwa_local_planner/critics/built_in.hpp"
#include "support/effort.hpp"
#include "support/recorded_drive.hpp"

namespace hidwa_local_planner::record {
namespace {

using test::Random;
using test::RecordedDrive;
using Reading = CycleReplay::Reading;

constexpr OperatorMode kModes[] = {OperatorMode::off, OperatorMode::joystick, OperatorMode::switching};

std::vector<RecordedDrive::Cycle> drive(std::uint64_t seed, int cycles = 250) {
  return RecordedDrive(seed, kModes[seed % 3]).run(cycles);
}

// Whatever critics, generators and people: 21 drives, 5,250 cycles. Something of everything must have happened.
TEST(CycleReplay, EveryCycleOfARandomDriveIsRepeatedToTheBit) {
  std::array<int, 4> outcomes{};
  std::array<int, 7> states{};
  for (std::uint64_t seed = 0; seed < 21; ++seed) {
    CycleReplay replay(critics::built_in());
    int at = 0;
    for (const RecordedDrive::Cycle& cycle : drive(seed)) {
      ASSERT_EQ(replay.take(cycle.record), Reading::ready) << replay.fault();
      if (!cycle.costs.empty()) {
        ASSERT_EQ(replay.grid().costs, cycle.costs);
      }
      const ReplayedCycle repeated = replay.run();
      ASSERT_TRUE(identical(repeated.intent, cycle.intent)) << "seed " << seed << ", cycle " << at;
      ASSERT_TRUE(identical(repeated.decision, cycle.decision)) << "seed " << seed << ", cycle " << at;
      ASSERT_TRUE(repeated.identical);
      ++outcomes[static_cast<std::size_t>(cycle.decision.outcome)];
      ++states[static_cast<std::size_t>(cycle.intent.state)];
      ++at;
    }
  }
  for (std::size_t i = 0; i < outcomes.size(); ++i) EXPECT_GT(outcomes[i], 20) << "outcome " << i;
  for (std::size_t i = 0; i < states.size(); ++i) EXPECT_GT(states[i], 0) << "state " << i;
}

// Each alone: neither the cycle before it nor the order matters, only the map that patches lead to.
TEST(CycleReplay, ACycleIsRepeatedAloneAndAgain) {
  const std::vector<RecordedDrive::Cycle> cycles = drive(4);
  Random random(1);
  CycleReplay replay(critics::built_in());
  for (std::size_t k = 0; k < cycles.size(); ++k) {
    ASSERT_EQ(replay.take(cycles[k].record), Reading::ready);
    if (random.chance(0.7)) continue;
    EXPECT_TRUE(replay.run().identical);
    EXPECT_TRUE(replay.run().identical);  // what the first left behind does not matter
  }
}

// Without the recorded states some cycles come out differently: the records need them.
TEST(CycleReplay, TheRecordedStatesDecide) {
  const input::OperatorStateMachine fresh_machine;
  const control::ControlLoop fresh_loop(critics::built_in());
  int loop_matters = 0, operator_matters = 0;
  const auto differs = [](CycleReplay& replay, const CycleRecord& record) {
    Bytes bytes;
    encode(record, bytes);
    EXPECT_EQ(replay.take(bytes), Reading::ready) << replay.fault();
    return replay.run().identical ? 0 : 1;
  };
  for (std::uint64_t seed = 0; seed < test::effort<std::uint64_t>(6, 12); ++seed) {
    CycleReplay without_loop(critics::built_in()), without_operator(critics::built_in());
    for (const RecordedDrive::Cycle& cycle : drive(seed)) {
      CycleRecord record;
      ASSERT_EQ(decode(cycle.record, record), "");
      CycleRecord forgetful = record;
      forgetful.loop_state.clear();
      fresh_loop.save(forgetful.loop_state);
      loop_matters += differs(without_loop, forgetful);
      forgetful = record;
      forgetful.operator_state.clear();
      ArchiveWriter write(forgetful.operator_state);
      fresh_machine.save(write);
      operator_matters += differs(without_operator, forgetful);
    }
  }
  EXPECT_GT(loop_matters, 10);
  EXPECT_GT(operator_matters, 10);
}

TEST(CycleReplay, AfterAGapItWaitsForTheNextKeyRecord) {
  const std::vector<RecordedDrive::Cycle> cycles = drive(1);
  CycleReplay replay(critics::built_in());
  int waited = 0, repeated = 0;
  for (std::size_t k = 0; k < cycles.size(); ++k) {
    if (k < 10 || k == 120) continue;  // key records are 0, 100 and 200
    const Reading reading = replay.take(cycles[k].record);
    waited += reading == Reading::waits_for_key ? 1 : 0;
    if (reading != Reading::ready) continue;
    ++repeated;
    EXPECT_TRUE(replay.run().identical) << k;
  }
  EXPECT_EQ(waited, (100 - 10) + (200 - 121));
  EXPECT_EQ(repeated, (120 - 100) + (250 - 200));
}

TEST(CycleReplay, ADamagedRecordIsToldAndTheNextKeyRecordGoesOn) {
  std::vector<RecordedDrive::Cycle> cycles = drive(2);
  cycles[50].record.resize(40);
  CycleReplay replay(critics::built_in());
  for (std::size_t k = 0; k < cycles.size(); ++k) {
    const Reading reading = replay.take(cycles[k].record);
    EXPECT_EQ(reading, k == 50 ? Reading::damaged : k > 50 && k < 100 ? Reading::waits_for_key : Reading::ready) << k;
    EXPECT_EQ(replay.fault(), k == 50 ? "the record is cut short or damaged" : "");
  }
}

// As where another release remembered something else.
TEST(CycleReplay, AStateThatCannotBeReadIsToldWithTheReleaseThatReadsIt) {
  CycleRecord record;
  ASSERT_EQ(decode(drive(1, 1)[0].record, record), "");
  record.setup->version = "7.8.9";
  for (Bytes* state : {&record.loop_state, &record.operator_state}) {
    const Bytes whole = *state;
    for (const std::size_t size : {std::size_t{0}, whole.size() - 1, whole.size() + 1}) {
      state->resize(size);
      Bytes bytes;
      encode(record, bytes);
      CycleReplay replay(critics::built_in());
      EXPECT_EQ(replay.take(bytes), Reading::damaged);
      EXPECT_EQ(replay.fault(), "the state before the cycle cannot be read: replay it with release 7.8.9");
      *state = whole;
    }
  }
}

TEST(CycleReplay, NewParametersAreInForceFromTheirCycleOn) {
  RecordedDrive drive(7, OperatorMode::joystick);
  std::vector<RecordedDrive::Cycle> cycles = drive.run(40);
  Parameters parameters = drive.parameters();
  parameters.max_vel_x *= 0.5;
  parameters.delta = 2.0;
  drive.reconfigure(parameters);
  for (RecordedDrive::Cycle& cycle : drive.run(40)) cycles.push_back(cycle);
  CycleReplay replay(critics::built_in());
  for (std::size_t k = 0; k < cycles.size(); ++k) {
    ASSERT_EQ(replay.take(cycles[k].record), Reading::ready);
    EXPECT_TRUE(replay.run().identical) << k;
    EXPECT_EQ(replay.record().setup.has_value(), k == 0 || k == 40);
    EXPECT_EQ(replay.parameters().delta, k < 40 ? 0.4 : 2.0);
  }
}

TEST(CycleReplay, AChangedParameterChangesCyclesAndNoneChangesNone) {
  std::vector<std::vector<RecordedDrive::Cycle>> drives;
  for (std::uint64_t seed = 1; seed < 19; seed += 3) drives.push_back(drive(seed, test::effort(150, 400)));  // in SJ
  const auto differences = [&drives](const std::vector<ParameterChange>& changes) {
    int different = 0;
    for (const std::vector<RecordedDrive::Cycle>& cycles : drives) {
      CycleReplay replay(critics::built_in(), {}, changes);
      for (const RecordedDrive::Cycle& cycle : cycles) {
        EXPECT_EQ(replay.take(cycle.record), Reading::ready) << replay.fault();
        different += replay.run().identical ? 0 : 1;
      }
    }
    return different;
  };
  EXPECT_EQ(differences({}), 0);
  EXPECT_EQ(differences({{"odom_topic", "elsewhere"}}), 0);  // the core does not read it
  EXPECT_GT(differences({{"s_omega", "1"}}), 10);
  EXPECT_GT(differences({{"PathDist_scale", "500"}}), 10);
  EXPECT_GT(differences({{"vx_samples", "11"}}), 10);
  EXPECT_GT(differences({{"mode", "off"}}), 10);  // the person's part counts too
  EXPECT_GT(differences({{"delta", "0"}}), 0);
  EXPECT_GT(differences({{"forward_prune_distance", "1"}}), 0);  // so does the window
}

// Likes another velocity every cycle, and finds its weight among its own parameters.
class Moody : public Critic {
 public:
  double configure(const Parameters& /*parameters*/, const ParameterSource& own) override {
    return own.number("scale", 0.0);
  }
  void score(const CycleView& /*cycle*/, const Tile& tile, TileScores& scores) override {
    for (std::size_t c = 0; c < tile.count; ++c) scores.set(c, std::abs(tile.sample(c).v - 0.1 * (mood_ % 5)));
  }
  void debrief(const CycleView& /*cycle*/, const Twist2& /*command*/) override { ++mood_; }
  void save(ArchiveWriter& state) const override { state(mood_); }
  void load(ArchiveReader& state) override { state(mood_); }

 private:
  int mood_ = 0;
};

class Scale : public ParameterSource {
 public:
  explicit Scale(double scale) : scale_(scale) {}
  double number(const std::string& key, double fallback) const override { return key == "scale" ? scale_ : fallback; }

 private:
  double scale_;
};

CriticRegistry with_moody() {
  CriticRegistry registry = critics::built_in();
  registry.add("Moody", [] { return std::make_shared<Moody>(); });
  return registry;
}

TEST(CycleReplay, ACriticOfAnotherPackageRemembersAndFindsItsParameters) {
  const auto scaled = [](double scale) -> Planner::SourceFor {
    return [scale](const std::string&) { return std::make_unique<Scale>(scale); };
  };
  test::Scene scene = test::Scene::empty(81);
  scene.parameters.critics = "PathDist, Moody";
  scene.parameters.mode = OperatorMode::off;
  input::OperatorStateMachine nobody;
  control::ControlLoop loop(with_moody());
  ASSERT_TRUE(loop.configure(scene.parameters, scaled(500.0)).empty());
  nobody.configure(scene.parameters);
  loop.set_footprint(scene.outline);
  loop.set_plan({{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, {2.0, 0.0, 0.0}}, "map", 0.0, 0.05);
  CycleRecorder recorder;
  recorder.take("500");
  CycleReplay replay(with_moody(), [&scaled](const std::string& critics) { return scaled(std::stod(critics)); });
  control::Observation seen;
  seen.velocity = Twist2{};
  seen.costmap = scene.grid();
  std::set<double> speeds;
  for (int k = 0; k < 10; ++k) {
    seen.timing.now = 0.05 * k;
    recorder.operator_state().clear();
    ArchiveWriter write(recorder.operator_state());
    nobody.save(write);
    recorder.begin(loop, seen, {});
    const control::Result result = loop.step(seen, nobody.update(seen.timing.now));
    ASSERT_NE(result.decision, nullptr);
    speeds.insert(result.decision->sample.v);
    ASSERT_EQ(replay.take(recorder.finish(result, loop.planner())), Reading::ready) << replay.fault();
    EXPECT_TRUE(replay.run().identical) << k;
  }
  EXPECT_GE(speeds.size(), 3u);  // the moods mattered
}

TEST(CycleReplay, AChangeThatCannotBeIsTold) {
  const std::vector<RecordedDrive::Cycle> cycles = drive(1, 1);
  CycleReplay replay(critics::built_in(), {}, {{"s_omga", "1"}, {"max_vel_x", "fast"}});
  EXPECT_EQ(replay.take(cycles[0].record), Reading::damaged);
  EXPECT_EQ(replay.fault(), "there is no parameter 's_omga', max_vel_x needs a number, not 'fast'");
}

}  // namespace
}  // namespace hidwa_local_planner::record
