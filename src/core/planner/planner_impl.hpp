// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// What the planner's own source files share.
#include <cmath>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "core/collision/admissibility.hpp"
#include "core/collision/cell_classes.hpp"
#include "core/collision/collision.hpp"
#include "core/collision/escape.hpp"
#include "core/distance/plan_grids.hpp"
#include "core/motion/command_history.hpp"
#include "core/motion/odometry_belief.hpp"
#include "core/motion/rollout.hpp"
#include "core/motion/samples.hpp"
#include "core/motion/velocity_limits.hpp"
#include "core/planner/choice.hpp"
#include "core/planner/sum_kernel.hpp"
#include "core/planner/tile_surroundings.hpp"
#include "core/planner/way_out.hpp"
#include "hidwa_local_planner/core/planner.hpp"
#include "hidwa_local_planner/core/util/lasting.hpp"

namespace hidwa_local_planner {

// Who refused a candidate: nobody, the collision check, the braking check, or critic number (value - kFirstCritic).
inline constexpr std::uint8_t kLegal = 0;
inline constexpr std::uint8_t kCollision = 1;
inline constexpr std::uint8_t kBraking = 2;
inline constexpr std::uint8_t kFirstCritic = 3;

inline constexpr const char* kCannotBrake = "cannot stop in free space";

// Slower than this the robot rests [m/s, rad/s].
inline constexpr double kAtRest = 1e-3;

inline bool at_rest(const Twist2& u) { return std::abs(u.v) < kAtRest && std::abs(u.omega) < kAtRest; }

inline double longest_period(const Situation& s) {  // [s]
  return s.longest_period > s.period && std::isfinite(s.longest_period) ? s.longest_period : s.period;
}

// Makes room with some to spare: the number of candidates changes by a few from cycle to cycle.
template <typename T>
void make_room(std::vector<T>& values, std::size_t count) {
  if (values.capacity() < count) values.reserve(count + count / 8 + 16);
}
template <typename T>
void fit(std::vector<T>& values, std::size_t count) {
  make_room(values, count);
  values.resize(count);
}

struct NamedCritic {
  std::string name;
  std::shared_ptr<Critic> critic;
  double weight = 0.0;
  std::unique_ptr<ParameterSource> source;
};

// What is known of a tile.
struct TileCheck {
  std::size_t column = 0;  // of its first candidate among those of the same omega
  double lowest = 0.0;     // total, at most: candidates that a closer look refuses may have had it
  bool done = false;       // nobody needs a closer look any more
};

// A candidate and its total.
using Queued = std::pair<double, std::uint32_t>;

struct Planner::Impl {
  CriticRegistry registry;
  Parameters parameters;
  VelocityLimits limits;
  std::vector<NamedCritic> critics;
  Polygon outline;
  Footprint footprint;

  // One cycle's work, kept for its memory and for evaluation().
  Sampler sampler;
  Rollout rollout;
  CollisionChecker collision;
  CellClasses classes;
  TileSurroundings surroundings;
  EscapeRule escape;
  AdmissibilityCheck admissibility;
  PlanGrids grids;
  std::vector<double> totals;                 // [candidates]; infinite where refused
  std::vector<std::uint8_t> refused_by;       // [candidates]
  std::vector<const char*> reasons;           // [candidates]
  std::vector<std::vector<double>> raw;       // [critics][candidates]
  std::vector<kernel::WeighedScores> scored;  // of the tile, by the critics that have scored any candidate ...
  std::size_t scored_count = 0;               // ... so many
  std::vector<Queued> queue;                  // see choose_next()
  std::vector<std::uint32_t> equals;          // candidates, see choose_next()
  std::vector<TileCheck> checks;              // [tiles]
  std::vector<const char*> found;             // [candidates of a tile] while it is checked
  double reach = 0.0;                         // of all rollouts and manoeuvres [m]
  OperatorIntent intent;                      // of the last cycle
  bool steered = false;                       // in this pass the deviation from `wish` counts
  Twist2 wish;                                // u_h, or with authority below 1 what is blended of it and of autonomy
  Decision decision;
  Marked marked;
  CommandHistory commands;
  OdometryBelief odometry;
  Pose2 origin;           // of what is pending: the pose as it was measured
  PendingMotion pending;  // until this cycle's command takes effect
  Situation advanced;     // the cycle's, with the pose of now
  WayOut way_out;
  Lasting caught;               // in collision, and no motion leads out
  Lasting unturned;             // at the goal's position it stands at another heading
  bool unturned_reset = false;  // the critics were reset for that
  bool thorough = false;
  std::vector<CandidateVerdict> verdicts;  // of the last cycle, where thorough
  ChoiceReport report;

  const char* fault_of(const Situation& situation, const GridView& grid) const;
  void begin(const Situation& situation);
  void make_room_for_words();
  Twist2 brake_start() const;
  double brake_period(const Situation& situation) const;
  void give_up(const Situation& situation, Problem kind, const char* problem);
  const Situation& advance(const Situation& situation);
  void find_reference(const Situation& situation);
  void judge_axis(const Situation& situation, double Twist2::*axis, const AxisLimits& limits, AxisBelief& belief);
  void make_candidates(const Situation& situation, const Sampling& sampling);
  void prepare_checks(const Situation& situation, const GridView& grid);
  void score_tile(const CycleView& cycle, std::size_t t, bool check);
  void list_checks();
  void check_cells(const Tile& tile, TileCheck& check);
  void check_closely(const Tile& tile, TileCheck& check);
  void check_tile(std::size_t t);
  void check_all_tiles();
  bool stays_legal(std::size_t candidate);
  void ask_critics(const CycleView& cycle, const Tile& tile);
  void sum_up(const Tile& tile);
  void strike_refused(const Tile& tile);
  double deviation_of(const Twist2& sample) const;
  std::uint8_t not_a_number(std::size_t candidate) const;
  int choose(const Situation& situation);
  int choose_next(const TieRule& tie);
  std::uint32_t pick_equals(const TieRule& tie);
  void refuse(std::size_t candidate, std::uint8_t refuser, const char* reason);
  bool moves_out();
  void watch_collision(const Situation& situation);
  void watch_rest(const Situation& situation, bool autonomous);
  void watch_last_turn(const Situation& situation);
  void reset_critics() {
    for (NamedCritic& named : critics) named.critic->reset();
  }
  void describe(int best);
  void count_refusals();
  void judge_operator();
  int find_operator_own() const;
  std::string_view name_of(std::uint8_t refuser) const;
  Twist2 sample_at(std::size_t candidate) const { return sampler.samples()[candidate].u; }
  void list_terms(std::size_t candidate, std::vector<CriticTerm>& terms) const;
  void clear_decision();
  const Decision& drive(const Situation& situation, const GridView& grid, const Sampling& sampling);
  void hear_everybody(const CycleView& cycle);
  void hear_critics(const CycleView& cycle, const Tile& tile);
  void aim(const Situation& situation, const GridView& grid, const Sampling& sampling);
  CycleView weigh(const Situation& situation, const GridView& grid, const Sampling& sampling);
  void pass_through(const Situation& situation);
};

}  // namespace hidwa_local_planner
