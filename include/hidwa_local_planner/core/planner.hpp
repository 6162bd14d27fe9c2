// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "hidwa_local_planner/core/critic.hpp"
#include "hidwa_local_planner/core/critic_registry.hpp"
#include "hidwa_local_planner/core/footprint.hpp"
#include "hidwa_local_planner/core/grid_view.hpp"
#include "hidwa_local_planner/core/operator_intent.hpp"
#include "hidwa_local_planner/core/parameters.hpp"
#include "hidwa_local_planner/core/types.hpp"

namespace hidwa_local_planner {

/// The world as one cycle finds it. Poses are in the costmap frame.
struct Situation {
  Pose2 pose;                   // of the robot
  Twist2 velocity;              // measured by odometry [m/s, rad/s]
  Twist2 last_command;          // what was sent last [m/s, rad/s]
  std::vector<Pose2> plan;      // the window of the global plan around the robot, see PlanWindow
  Pose2 goal;                   // the last pose of the full plan
  bool goal_latched = false;    // the position of the goal was reached, see GoalChecker
  double period = 0.05;         // of the control cycle [s]
  double time = 0.0;            // [s]
};

/// Which samples are tried: an input of plan(), so that a recorded cycle can be repeated.
struct Sampling {
  int vx_samples = 0;   // 0: as in the parameters
  int vth_samples = 0;  // 0: as in the parameters
};

enum class Outcome { drive = 0, brake, fail, hold };
const char* to_string(Outcome outcome);

/// Names stay valid until the planner is configured anew.
struct RefusalCount {
  std::string_view name;    // "Collision", "Braking" or a critic
  std::size_t count = 0;
};

struct CriticTerm {
  std::string_view name;
  double raw = 0.0;
  double weight = 0.0;  // adds raw * weight to the total
};

/// What one cycle decided, and why.
struct Decision {
  Outcome outcome = Outcome::fail;
  Twist2 command;                        // what to send [m/s, rad/s]
  Twist2 sample;                         // the chosen candidate's sample [m/s, rad/s]
  Twist2 reference;                      // the velocity the cycle started from [m/s, rad/s]
  double total = 0.0;                    // J of the chosen candidate
  std::vector<Pose2> trajectory;         // its rollout, start pose first; empty when none was chosen
  double step = 0.0;                     // time between two of its poses [s]
  std::vector<CriticTerm> terms;         // of the chosen candidate, in the order of the critics
  std::vector<RefusalCount> refusals;    // per critic, in order; collision and braking first
  std::size_t candidates = 0;
  std::size_t legal = 0;
  double agreement = 1.0;                // 1: the command is what the person wants, in [0, 1]
  std::string operator_refused_by;       // what refused the operator's own command; empty when it was legal
  bool escaping = false;                 // the robot stands in collision
  std::string problem;                   // why there was nothing to choose from, in words; empty where there was
};

/// One candidate as the evaluation topic shows it.
struct CandidateRecord {
  Twist2 sample;                     // [m/s, rad/s]
  std::vector<Pose2> poses;          // start pose first, costmap frame
  double step = 0.0;                 // [s]
  std::vector<CriticTerm> terms;     // what was scored before a refusal
  double total = -1.0;               // -1 where it was refused
  std::string refused_by;            // empty where it is legal
  std::string reason;
};

/// HI-DWA without ROS: samples, rolls out, refuses, scores and chooses. Deterministic: the same input gives the
/// same bits. Not thread-safe; one call at a time. plan() never throws.
class Planner {
 public:
  explicit Planner(CriticRegistry registry = CriticRegistry::with_built_in());
  ~Planner();
  Planner(Planner&&) noexcept;
  Planner& operator=(Planner&&) noexcept;

  /// Finds the parameters of critics of other packages; returned pointers must outlive the planner.
  using SourceFor = std::function<std::unique_ptr<ParameterSource>(const std::string& critic)>;

  /// Takes a set of parameters whole. Returns every fault (validate() and unknown critics); with any, nothing changes.
  std::vector<std::string> configure(const Parameters& parameters, const SourceFor& source_for = {});
  const Parameters& parameters() const;

  /// The robot's outline without parameters().footprint_padding, which is added here.
  void set_footprint(const Polygon& outline);
  const Footprint& footprint() const;

  /// A new goal: critics forget what they latched.
  void reset();

  /// One cycle. `grid` must stay unchanged during the call. The decision stays valid until the next call.
  const Decision& plan(const Situation& situation, const GridView& grid, const OperatorIntent& intent,
                       const Sampling& sampling = {});

  /// Every candidate of the last plan(), in the order of the samples.
  std::vector<CandidateRecord> evaluation() const;
  /// Index into evaluation() of the chosen, the worst legal and the operator's own candidate; -1 when there is none.
  struct Marked {
    int best = -1;
    int worst = -1;
    int operator_own = -1;
  };
  Marked marked() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace hidwa_local_planner
