// SPDX-License-Identifier: BSD-3-Clause
#include "hidwa_local_planner/input/transition.hpp"

#include <gtest/gtest.h>

namespace hidwa_local_planner::input {
namespace {

using State = OperatorStateId;

// One row: from, lost, active, blocked, holding, at_goal -> to. 'x' stands for both.
struct Row {
  State from;
  const char* facts;
  State to;
};

const Row kTable[] = {
    {State::autonomy, "x 0 x 0 x", State::autonomy}, {State::autonomy, "x x x x 1", State::autonomy},
    {State::autonomy, "x 1 0 x 0", State::shared},   {State::autonomy, "x 0 x 1 0", State::hold},
    {State::shared, "0 1 0 x 0", State::shared},     {State::shared, "0 1 1 x 0", State::blocked},
    {State::shared, "1 x x x x", State::lost},       {State::shared, "0 0 x 1 0", State::hold},
    {State::shared, "0 0 x 0 x", State::autonomy},   {State::shared, "0 x x x 1", State::autonomy},
    {State::blocked, "0 1 1 x 0", State::blocked},   {State::blocked, "0 1 0 x 0", State::shared},
    {State::blocked, "1 x x x x", State::lost},      {State::blocked, "0 0 x 1 0", State::hold},
    {State::blocked, "0 0 x 0 x", State::autonomy},  {State::blocked, "0 x x x 1", State::autonomy},
    {State::hold, "x 1 0 x 0", State::shared},       {State::hold, "x 0 x 1 0", State::hold},
    {State::hold, "x 0 x 0 x", State::autonomy},     {State::hold, "x x x x 1", State::autonomy},
    {State::lost, "1 x x x x", State::lost},         {State::lost, "0 1 0 x 0", State::shared},
    {State::lost, "0 0 x 1 0", State::hold},         {State::lost, "0 0 x 0 x", State::autonomy},
    {State::lost, "0 x x x 1", State::autonomy},
};

bool matches(char wanted, bool value) { return wanted == 'x' || (wanted == '1') == value; }

bool matches(const Row& row, State from, const Facts& f) {
  return row.from == from && matches(row.facts[0], f.lost) && matches(row.facts[2], f.active) &&
         matches(row.facts[4], f.blocked) && matches(row.facts[6], f.holding) &&
         matches(row.facts[8], f.at_goal);
}

// Every reachable combination is in the table, and every row that matches says the same.
TEST(Transition, Table) {
  for (const State from : {State::autonomy, State::shared, State::hold, State::lost, State::blocked}) {
    for (unsigned bits = 0; bits < 32; ++bits) {
      Facts f;
      f.enabled = true;
      f.lost = (bits & 1U) != 0;
      f.active = (bits & 2U) != 0;
      f.blocked = (bits & 4U) != 0;
      f.holding = (bits & 8U) != 0;
      f.at_goal = (bits & 16U) != 0;
      const bool steering = from == State::shared || from == State::blocked;
      if (f.lost && f.active) continue;                  // input that counts is not lost
      if (f.blocked && f.active && !steering) continue;  // only a steered robot is blocked
      int rows = 0;
      for (const Row& row : kTable) {
        if (!matches(row, from, f)) continue;
        ++rows;
        EXPECT_STREQ(to_string(next_state(from, f)), to_string(row.to))
            << to_string(from) << " bits " << bits;
      }
      EXPECT_GE(rows, 1) << to_string(from) << " bits " << bits;
      f.enabled = false;
      EXPECT_EQ(next_state(from, f), State::autonomy);
    }
  }
}

}  // namespace
}  // namespace hidwa_local_planner::input
