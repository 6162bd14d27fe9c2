// SPDX-License-Identifier: BSD-3-Clause
// Says what became of the candidates of a cycle, and why the chosen one was chosen. Changes nothing that is decided.
//
// The report of a candidate (candidates()) is made when it is asked for, from what is known then. With Report::full
// ask_all_critics() makes it in the cycle: after the choice, but before the critics hear of the command, so that they
// remember what they remembered when they scored.
#pragma once

#include <cstddef>
#include <vector>

#include "core/autonomy/proposal.hpp"
#include "core/evaluation/critic_set.hpp"
#include "core/evaluation/evaluation.hpp"
#include "hidwa_local_planner/core/planner.hpp"

namespace hidwa_local_planner {

class Explanation {
 public:
  /// Of what is evaluated with these critics; both outlive it.
  Explanation(const CriticSet& critics, Evaluation& evaluated) : critics_(critics), evaluated_(evaluated) {}

  /// A new cycle: nothing is chosen.
  void clear();
  /// What was chosen.
  void note_choice(const Proposal& proposal, const Steering& steering);

  /// Total, terms and trajectory of the chosen candidate.
  void describe_choice(Decision& decision) const;
  /// How near the chosen sample comes to the operator command, and what rejects that: its own candidate, or the one
  /// nearest to it.
  void judge_operator(const Cycle& cycle, const Twist2& chosen, Decision& decision);
  /// How many candidates are legal, and how many each one rejects. `why`: somebody will be told, so that it is worth
  /// the time to tell unknown cells from obstacles.
  void count_rejections(bool why, Decision& decision) const;
  /// Asks every critic about every candidate, whoever rejected it.
  void ask_all_critics(const CycleView& view);

  /// See Planner.
  std::vector<CandidateReport> candidates() const;
  Planner::Marked marked() const;
  const ChoiceReport& choice() const { return choice_; }

 private:
  CandidateReport report_of(const Tile& tile, std::size_t c) const;
  void list_terms(std::size_t candidate, std::vector<CriticTerm>& terms) const;
  double deviation(std::size_t candidate) const;
  bool meets_unknown(std::size_t candidate) const;
  bool mostly_meet_unknown() const;
  void check_all(const Tile& tile);
  void ask_critics(const CycleView& view, const Tile& tile);

  const CriticSet& critics_;
  Evaluation& evaluated_;
  Planner::Marked marked_;  // but for the worst
  ChoiceReport choice_;
  Steering steering_;
  std::vector<CandidateReport> full_;  // of the last cycle, with Report::full
};

}  // namespace hidwa_local_planner
