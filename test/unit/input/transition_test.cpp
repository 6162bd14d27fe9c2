// SPDX-License-Identifier: BSD-3-Clause
#include "input/transition.hpp"

#include <array>
#include <iterator>

#include <gtest/gtest.h>

namespace hidwa_local_planner::input {
namespace {

using State = OperatorStateId;

// One row: from; stop, manual, lost, active, blocked, holding, at_goal; to. 'x' stands for both.
struct Row {
  State from;
  const char* facts;
  State to;
};

const Row kTable[] = {
    {State::autonomy, "1 x x x x x x", State::stopped},  {State::autonomy, "0 1 x 0 0 0 x", State::manual},
    {State::autonomy, "0 0 x 0 x 0 x", State::autonomy}, {State::autonomy, "0 0 x x x x 1", State::autonomy},
    {State::autonomy, "0 0 x 1 0 x 0", State::shared},   {State::autonomy, "0 0 x 0 x 1 0", State::hold},

    {State::shared, "1 x x x x x x", State::stopped},    {State::shared, "0 0 1 x x x x", State::lost},
    {State::shared, "0 0 0 1 0 x 0", State::shared},     {State::shared, "0 0 0 1 1 x 0", State::blocked},
    {State::shared, "0 0 0 0 x 1 0", State::hold},       {State::shared, "0 0 0 0 x 0 x", State::autonomy},
    {State::shared, "0 0 0 x x x 1", State::autonomy},

    {State::blocked, "1 x x x x x x", State::stopped},   {State::blocked, "0 0 1 x x x x", State::lost},
    {State::blocked, "0 0 0 1 1 x 0", State::blocked},   {State::blocked, "0 0 0 1 0 x 0", State::shared},
    {State::blocked, "0 0 0 0 x 1 0", State::hold},      {State::blocked, "0 0 0 0 x 0 x", State::autonomy},
    {State::blocked, "0 0 0 x x x 1", State::autonomy},

    {State::hold, "1 x x x x x x", State::stopped},      {State::hold, "0 0 x 1 0 x 0", State::shared},
    {State::hold, "0 0 x 0 x 1 0", State::hold},         {State::hold, "0 0 x 0 x 0 x", State::autonomy},
    {State::hold, "0 0 x x x x 1", State::autonomy},

    {State::manual, "1 x x x x x x", State::stopped},    {State::manual, "0 1 1 0 0 0 x", State::lost},
    {State::manual, "0 1 0 0 0 0 x", State::manual},     {State::manual, "0 0 0 0 0 0 x", State::autonomy},

    {State::stopped, "1 x x x x x x", State::stopped},   {State::stopped, "0 x 1 x x x x", State::lost},
    {State::stopped, "0 1 0 0 0 0 x", State::manual},    {State::stopped, "0 0 0 1 0 0 0", State::shared},
    {State::stopped, "0 0 0 0 x 0 x", State::autonomy},  {State::stopped, "0 0 0 x x 0 1", State::autonomy},

    {State::lost, "1 x x x x x x", State::stopped},      {State::lost, "0 x 1 x x x x", State::lost},
    {State::lost, "0 1 0 0 0 0 x", State::manual},       {State::lost, "0 0 0 1 0 x 0", State::shared},
    {State::lost, "0 0 0 0 x 1 0", State::hold},         {State::lost, "0 0 0 0 x 0 x", State::autonomy},
    {State::lost, "0 0 0 x x x 1", State::autonomy},
};

bool matches(char wanted, bool value) { return wanted == 'x' || (wanted == '1') == value; }

bool matches(const Row& row, State from, const Facts& f) {
  return row.from == from && matches(row.facts[0], f.stop) && matches(row.facts[2], f.manual) &&
         matches(row.facts[4], f.lost) && matches(row.facts[6], f.active) && matches(row.facts[8], f.blocked) &&
         matches(row.facts[10], f.holding) && matches(row.facts[12], f.at_goal);
}

bool reachable(State from, const Facts& f) {
  const bool steering = from == State::shared || from == State::blocked;
  const bool shares = steering || from == State::hold;   // states of shared control; MANUAL is of switching
  if (f.lost && f.active) return false;                  // input that counts is not lost
  if (f.blocked && f.active && !steering) return false;  // only a steered robot is blocked
  if (f.manual && shares) return false;                  // another mode starts from AUTONOMY
  if ((f.manual || from == State::manual) && (f.active || f.blocked || f.holding)) return false;
  if (from == State::manual && f.lost && !f.manual) return false;  // what was given back cannot be lost
  return from != State::stopped || !f.holding;                     // a stop ends the hold
}

// Every reachable combination is in the table, and every row that matches says the same.
TEST(Transition, Table) {
  std::array<int, std::size(kTable)> used{};
  for (const State from :
       {State::autonomy, State::shared, State::hold, State::manual, State::stopped, State::lost, State::blocked}) {
    for (unsigned bits = 0; bits < 128; ++bits) {
      Facts f;
      f.enabled = true;
      f.stop = (bits & 1U) != 0;
      f.manual = (bits & 2U) != 0;
      f.lost = (bits & 4U) != 0;
      f.active = (bits & 8U) != 0;
      f.blocked = (bits & 16U) != 0;
      f.holding = (bits & 32U) != 0;
      f.at_goal = (bits & 64U) != 0;
      if (!reachable(from, f)) continue;
      int rows = 0;
      for (std::size_t i = 0; i < std::size(kTable); ++i) {
        const Row& row = kTable[i];
        if (!matches(row, from, f)) continue;
        ++rows;
        ++used[i];
        EXPECT_STREQ(to_string(next_state(from, f)), to_string(row.to)) << to_string(from) << " bits " << bits;
      }
      EXPECT_GE(rows, 1) << to_string(from) << " bits " << bits;
      f.enabled = false;
      EXPECT_EQ(next_state(from, f), f.stop ? State::stopped : State::autonomy);
    }
  }
  for (std::size_t i = 0; i < used.size(); ++i) EXPECT_GT(used[i], 0) << "row " << i << " is of no use";
}

}  // namespace
}  // namespace hidwa_local_planner::input
