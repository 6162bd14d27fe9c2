// SPDX-License-Identifier: BSD-3-Clause
// The planner's cycle, step by step. Each step is a part with its own state.
//
// 1. StartEstimator finds what the cycle starts from: reference velocity, pending motion, pose of now. MoverCheck finds
//    what moves near the robot.
// 2. Evaluation makes candidates, samples of the dynamic window rolled out (Candidates),
// 3. rejects those that collide or cannot brake, as far as the choice needs it (Obstacles, LazyChecks), and
// 4. scores the rest (Scores).
// 5. Selection takes the cheapest legal candidate. Where autonomy is stuck, Recovery takes another legal one.
//
// Then Recovery judges whether the robot gets on, and Explanation says what became of the candidates.
#pragma once

#include <string>
#include <vector>

#include "core/movers/accelerations.hpp"
#include "core/movers/explained_cells.hpp"
#include "core/planner/conclusion.hpp"
#include "core/planner/critic_set.hpp"
#include "core/planner/cycle.hpp"
#include "core/planner/evaluation.hpp"
#include "core/planner/evasion.hpp"
#include "core/planner/explanation.hpp"
#include "core/planner/recovery.hpp"
#include "core/planner/selection.hpp"
#include "core/planner/start_estimator.hpp"

namespace hidwa_local_planner {

struct Planner::Impl {
  explicit Impl(CriticRegistry registry);

  std::vector<std::string> configure(const Parameters& given, const SourceFor& source_for);
  void set_footprint(const Polygon& given);
  void forget_movers();
  const Decision& plan(const Situation& measured, const GridView& grid, const OperatorIntent& intent,
                       const Sampling& sampling);

  Parameters parameters;
  VelocityLimits limits;
  Polygon outline;
  Footprint footprint;
  CriticSet critics;
  StartEstimator start_estimator;
  Evaluation evaluation;
  Selection selection;
  MoverCheck movers;
  Accelerations accelerations;
  ExplainedCells explained;
  Recovery recovery;
  Evasion evasion;
  Explanation explanation;
  Decision decision;  // the output: written, never read

 private:
  struct Choice {
    int candidate = -1;
    ChoiceReport::Rule rule = ChoiceReport::Rule::none;
  };
  bool movers_count(const CycleStart& start) const;
  const Accelerations* watch_movers(const CycleStart& start, bool count);
  MoverCheck* look_at_movers(const CycleStart& start, bool count);
  Conclusion conclude(const Cycle& cycle);
  Conclusion drive(const Cycle& cycle);
  Steering find_steering(const Cycle& cycle);
  bool drives_itself(const Cycle& cycle, const Steering& steering) const;
  Evaluation::Mode mode(const Cycle& cycle, bool autonomous, const ComfortTurn& comfort) const;
  double time_to_goal(const Cycle& cycle) const;
  ComfortTurn comfort_of(const Cycle& cycle, const Steering& steering) const;
  bool gives_way(const Cycle& cycle, const Choice& choice) const;
  Choice choose(const Cycle& cycle, bool autonomous);
  bool evades(const Cycle& cycle, const Choice& choice, bool autonomous);
  void evade(const Cycle& cycle, const Steering& steering, Evaluation::Result& evaluated, Choice& choice);
  int cheapest(const Cycle& cycle);
  Conclusion follow_choice(const Cycle& cycle, const Choice& choice);
  Recovery::Course course_of(const Cycle& cycle, const Choice& choice, const Conclusion& chosen,
                             const Steering& steering);
  bool trapped(const Choice& choice, const Twist2& sample);
  bool yields(const Cycle& cycle, const Choice& choice, const Twist2& sample);
};

}  // namespace hidwa_local_planner
