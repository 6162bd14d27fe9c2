// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "hidwa_local_planner/core/critic.hpp"
#include "hidwa_local_planner/core/critic_registry.hpp"
#include "hidwa_local_planner/core/decision.hpp"
#include "hidwa_local_planner/core/footprint.hpp"
#include "hidwa_local_planner/core/grid_view.hpp"
#include "hidwa_local_planner/core/operator_intent.hpp"
#include "hidwa_local_planner/core/parameters.hpp"
#include "hidwa_local_planner/core/situation.hpp"
#include "hidwa_local_planner/core/types.hpp"

namespace hidwa_local_planner {

struct VelocityLimits;

/// HI-DWA without ROS: samples, rolls out, rejects, scores and selects. Deterministic: the same input gives the
/// same bits. Not thread-safe; one call at a time. plan() never throws.
class Planner {
 public:
  explicit Planner(CriticRegistry registry);
  ~Planner();
  Planner(Planner&&) noexcept;
  Planner& operator=(Planner&&) noexcept;

  using SourceFor = hidwa_local_planner::SourceFor;

  /// Takes a set of parameters. Returns every fault (validate() and unknown critics). With any fault nothing changes.
  std::vector<std::string> configure(const Parameters& parameters, const SourceFor& source_for = {});
  /// The parameters in force.
  const Parameters& parameters() const;
  /// The velocities and accelerations that these allow.
  const VelocityLimits& limits() const;

  /// The robot's outline without parameters().footprint_padding, which is added here.
  void set_footprint(const Polygon& outline);
  const Polygon& outline() const;  // as it was given
  const Footprint& footprint() const;

  /// A new goal: critics forget what they latched.
  void reset();

  /// The velocity to believe when odometry reads `measured` between two cycles [m/s, rad/s]. A reading that the recent
  /// commands do not explain is doubted: then it is the last command. Once plan() believes such readings, it is the
  /// reading.
  Twist2 believed(const Twist2& measured) const;

  /// The robot cannot turn where it reached the goal's position: it searches or follows a way to the goal's pose, which
  /// may lead away from the goal first.
  bool leads_to_goal() const;

  /// All that the planner and its critics remember from cycle to cycle. A planner with the same parameters and outline
  /// that loads it decides the next cycle alike, to the bit. load() returns false for bytes that save() did not write.
  void save(Bytes& state) const;
  bool load(const Bytes& state);

  /// One cycle. `grid` must stay unchanged during the call. The decision stays valid until the next call.
  const Decision& plan(const Situation& situation, const GridView& grid, const OperatorIntent& intent,
                       const Sampling& sampling = {});
  /// A cycle in which the host sends a command of its own, as while an input is missing: the planner remembers what was
  /// sent until then, and when. Only the situation's time, period, last command and `resumed` count.
  void skip(const Situation& situation);

  /// Every candidate of the last plan(), in the order of the samples; empty where nothing was scored. Sampling::report
  /// says how much is known of each. With Report::chosen, candidates that the choice did not need were not checked for
  /// collision.
  std::vector<CandidateReport> candidates() const;
  /// Indices into candidates(): the chosen one, the worst legal one, and the one of the operator command or nearest to
  /// it. -1 where there is none.
  struct Marked {
    int best = -1;
    int worst = -1;
    int operator_command = -1;
  };
  Marked marked() const;

  /// J of every candidate of the last plan(), infinite where it is known to be rejected; empty where nothing was
  /// scored.
  const std::vector<double>& totals() const;

  /// How the last choice was made.
  const ChoiceReport& choice() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace hidwa_local_planner
