// SPDX-License-Identifier: BSD-3-Clause
// Has autonomy get out of the way of what moves, in good time.
//
// One velocity kept for sim_time cannot say "wait, then go" or "back off now": what autonomy chooses by that may lead
// to where the robot will be touched at rest. So its choice stays only if ways begin with it that are about as good as
// any (EvasionSearch). Else the legal candidate is taken that is nearest to where the best way begins.
//
// Why it is safe: it takes legal candidates only, and each of them passes the last checks.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "core/planner/candidates.hpp"
#include "core/planner/cycle.hpp"
#include "core/planner/lazy_checks.hpp"
#include "core/search/evasion_search.hpp"
#include "core/search/plan_guide.hpp"

namespace hidwa_local_planner {

class Evasion {
 public:
  /// Whether another motion is clearly better than `own`, autonomy's choice [m/s, rad/s].
  /// `comfort`: how it turns where that is enough to stay untouched. `goes_back`: `own` leads away from the goal on
  /// purpose, and is left only where it would be touched.
  bool wanted(const Cycle& cycle, const CollisionChecker& checker, const Twist2& own, const ComfortTurn& comfort,
              bool goes_back);
  /// The better motions turn no faster than `comfort` said.
  bool gently() const { return gently_; }
  /// The candidate that begins the best way that begins with a legal one; -1 where none is better than the choice.
  int choose(const Cycle& cycle, const Candidates& candidates, LazyChecks& checks);

  /// After each cycle: whether the command was its choice. To go on it asks for less than to begin.
  void note(bool chose) { goes_on_ = chose; }
  /// What it remembers: written only where there is anything.
  bool goes_on() const { return goes_on_; }
  template <typename Self, typename Archive>
  static void archive(Self& self, Archive& io) {
    io(self.goes_on_, self.motion_);
  }

 private:
  bool stays(const Cycle& cycle, const EvasionSearch::Scene& scene, const Twist2& own, bool goes_back);
  double better_by() const;
  int nearest_legal(const Cycle& cycle, const Candidates& candidates, LazyChecks& checks, const Twist2& motion);

  EvasionSearch search_;
  PlanGuide guide_;
  std::vector<Twist2> own_;  // autonomy's choice, and where it goes on the motion that it has chosen [m/s, rad/s]
  bool gently_ = false;
  bool goes_on_ = false;                                // it has chosen in the cycle before
  Twist2 motion_;                                       // that [m/s, rad/s]
  std::vector<EvasionSearch::Branch> better_;           // cheapest first
  std::vector<std::pair<double, std::uint32_t>> near_;  // candidates, by how far they are from a motion
};

}  // namespace hidwa_local_planner
