// SPDX-License-Identifier: BSD-3-Clause
// The planner's cycle. Each step is a part with its own state.
//
// 1. StartEstimator finds what the cycle starts from: reference velocity, pending motion, pose of now. MoverCheck finds
//    what moves near the robot.
// 2. Evaluation makes candidates, samples of the dynamic window rolled out (Candidates), rejects those that collide or
//    cannot brake, as far as the choice needs it (Obstacles, LazyChecks), and scores the rest (Scores).
// 3. Arbiter decides which legal candidate is driven.
// 4. Autonomy is told what is driven, and judges whether the robot gets on.
//
// Explanation says what became of the candidates.
#pragma once

#include <string>
#include <vector>

#include "core/autonomy/arbiter.hpp"
#include "core/autonomy/autonomy.hpp"
#include "core/collision/blind_motion.hpp"
#include "core/cycle/conclusion.hpp"
#include "core/cycle/cycle.hpp"
#include "core/cycle/start_estimator.hpp"
#include "core/evaluation/critic_set.hpp"
#include "core/evaluation/evaluation.hpp"
#include "core/intent/goalless_intent.hpp"
#include "core/movers/accelerations.hpp"
#include "core/movers/explained_cells.hpp"
#include "core/movers/hidden_places.hpp"
#include "core/planner/explanation.hpp"
#include "hidwa_local_planner/core/planner.hpp"

namespace hidwa_local_planner {

struct Planner::Impl {
  explicit Impl(CriticRegistry registry);

  std::vector<std::string> configure(const Parameters& given, const SourceFor& source_for);
  void set_footprint(const Polygon& given);
  const Decision& plan(const Situation& measured, const GridView& grid, const OperatorIntent& intent,
                       const Sampling& sampling);

  Parameters parameters;
  VelocityLimits limits;
  Polygon outline;
  Footprint footprint;
  CriticSet critics;
  SensorSectors declared_sectors;  // by the parameter
  StartEstimator start_estimator;
  BlindMotion blind;
  Evaluation evaluation;
  Autonomy autonomy;
  Arbiter arbiter;
  GoallessIntent goalless;
  MoverCheck movers;
  HiddenPlaces hidden_places;
  MoverCheck hidden;
  Accelerations accelerations;
  ExplainedCells explained;
  Explanation explanation;
  Decision decision;  // the output: written, never read

 private:
  const SensorSectors& sectors_in_force(const Situation& measured) const;
  bool uses_movers(const Situation& measured) const;
  const Accelerations* update_accelerations(const Situation& measured, bool use_movers);
  MoverCheck* prepare_mover_check(const Situation& measured, const CycleStart& start, bool use_movers);
  MoverCheck* prepare_hidden(const SensorSectors& sectors, const CycleStart& start, const GridView& grid);
  Conclusion conclude(const Cycle& cycle);
  Conclusion drive(const Cycle& cycle);
  Steering find_steering(const Cycle& cycle);
  Conclusion follow_choice(const Cycle& cycle, const Proposal& proposal);
  Autonomy::Driven driven(const Cycle& cycle, const Arbiter::Choice& choice, const Conclusion& conclusion,
                          bool autonomous);
};

}  // namespace hidwa_local_planner
