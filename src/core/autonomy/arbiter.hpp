// SPDX-License-Identifier: BSD-3-Clause
// Decides which candidate is driven. Autonomy asks these rules:
//
//   rule      when it is asked                               what it takes
//   escape    the robot stands in collision, and it follows  what ends least deep; a turn towards a way out
//             no way or an escape is active
//   rest      escape is not asked, and recovery needs rest   rest
//             for its search
//   way       neither is asked, and recovery follows a way   what gets farthest along the way; the cheapest candidate
//             that it has found                              if it gets nearly as far
//   cheapest  none of these takes anything; in collision     the least total
//             only while escape and recovery are idle
//   evasion   after these, outside of collision: moving      what begins the best way that is not touched; where there
//             obstacles are near, and what was taken is      is none, the choice stays
//             touched or costs much more
//
// With an operator, and at the goal's position, only the cheapest candidate counts.
//
// Candidates are evaluated with gentle turns first. Where that leaves nothing but rest, or evasion needs more, they are
// evaluated again with all turns that the limits allow.
#pragma once

#include "core/autonomy/autonomy.hpp"
#include "core/autonomy/proposal.hpp"
#include "core/evaluation/evaluation.hpp"
#include "core/evaluation/selection.hpp"

namespace hidwa_local_planner {

class Arbiter {
 public:
  /// Both outlive it.
  Arbiter(Evaluation& evaluation, Autonomy& autonomy)
      : evaluation_(evaluation),
        autonomy_(autonomy),
        selection_(evaluation.candidates(), evaluation.scores(), evaluation.checks()) {}

  struct Choice {
    Proposal proposal;
    Evaluation::Result evaluated;  // how the candidates were evaluated
    Autonomy::Steps steps;
  };
  /// `autonomous`: see Autonomy::drives().
  Choice choose(const Cycle& cycle, const Steering& steering, bool autonomous);
  /// The sample of the cheapest candidate if nobody steered; zero where there is none [m/s, rad/s].
  Twist2 cheapest_alone(const Cycle& cycle, const Twist2& u_h);

 private:
  void propose(const Cycle& cycle, const Steering& steering, bool autonomous, const ComfortTurn& comfort,
               Choice& choice);
  Evaluation::Mode mode(const Cycle& cycle, bool autonomous, const ComfortTurn& comfort) const;
  ComfortTurn comfort_of(const Cycle& cycle, const Steering& steering) const;
  bool gives_way(const Cycle& cycle, const Choice& choice) const;
  bool evades(const Cycle& cycle, const Choice& choice, bool autonomous);
  Proposal cheapest(const Cycle& cycle);
  const Twist2& sample(const Proposal& proposal) const;

  Evaluation& evaluation_;
  Autonomy& autonomy_;
  Selection selection_;
};

}  // namespace hidwa_local_planner
