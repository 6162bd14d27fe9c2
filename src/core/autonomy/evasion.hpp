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

#include "core/cycle/cycle.hpp"
#include "core/evaluation/evaluation.hpp"
#include "core/search/evasion_search.hpp"
#include "core/search/plan_guide.hpp"

namespace hidwa_local_planner {

class Evasion {
 public:
  /// Whether another motion is clearly better than `own`, what autonomy would do otherwise [m/s, rad/s].
  /// `comfort`: how it turns where that is enough to stay untouched. `goes_back`: `own` leads away from the goal on
  /// purpose, and is left only where it would be touched.
  bool wanted(const Cycle& cycle, const CollisionChecker& checker, const Twist2& own, const ComfortTurn& comfort,
              bool goes_back);
  /// The better motions turn no faster than `comfort` said.
  bool gently() const { return gently_; }
  /// What a cycle proposes.
  struct Step {
    int candidate = -1;  // it begins the best way that begins with a legal one; -1 where none is better than the own
    Twist2 motion;       // the first of that way [m/s, rad/s]
  };
  /// Where it is wanted, of the candidates that are evaluated now.
  Step propose(const Cycle& cycle, Evaluation& evaluated);
  /// Once a cycle: what it had the robot do, if anything. To go on it asks for less than to begin.
  void commit(const Step& step);

  template <typename Self, typename Archive>
  static void archive(Self& self, Archive& io) {
    io(self.goes_on_, self.motion_);
  }

 private:
  bool stays(const EvasionSearch::Start& scene, const Twist2& own, bool goes_back);
  double better_by() const;
  int nearest_legal(const Cycle& cycle, Evaluation& evaluated, const Twist2& motion);

  bool goes_on_ = false;  // the robot did in the cycle before what it proposed
  Twist2 motion_;         // that [m/s, rad/s]

  // Scratch of this cycle, which wanted() and propose() write; reused, to avoid allocation.
  EvasionSearch search_;
  PlanGuide guide_;
  bool gently_ = false;
  std::vector<Twist2> own_;                    // autonomy's choice, and where it goes on the motion before [m/s, rad/s]
  std::vector<EvasionSearch::Branch> better_;  // cheapest first
  std::vector<std::pair<double, std::uint32_t>> near_;  // candidates, by how far they are from a motion
};

}  // namespace hidwa_local_planner
