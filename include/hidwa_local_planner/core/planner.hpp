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
  Pose2 pose;                   // of the robot, as it was measured `pose_age` ago
  Twist2 velocity;              // measured by odometry [m/s, rad/s]
  Twist2 last_command;          // what was sent last [m/s, rad/s]
  std::vector<Pose2> plan;      // the window of the global plan around the robot, see PlanWindow
  Pose2 goal;                   // the last pose of the full plan
  bool goal_latched = false;    // the position of the goal was reached, see GoalChecker
  double period = 0.05;         // of the control cycle, as it is meant [s]
  double longest_period = 0.0;  // of late, see PeriodWatch: the next cycle comes no later [s]; 0: as period
  double pose_age = 0.0;        // how old the pose is [s]: the commands since then lead on from it
  bool resumed = false;         // the host paused and others may have driven: last_command is the velocity of now
  double time = 0.0;            // [s]
};

/// How much work a cycle is: an input of plan(), so that a recorded cycle can be repeated.
struct Sampling {
  int vx_samples = 0;      // 0: as in the parameters
  int vth_samples = 0;     // 0: as in the parameters
  bool check_all = false;  // look for collisions of all candidates, not only as far as the choice needs it: the command
                           // is the same, to the bit, and what is said of all candidates is complete
};

enum class Outcome { drive = 0, brake, fail, hold };
const char* to_string(Outcome outcome);

/// Names stay valid until the planner is configured anew.
struct RefusalCount {
  std::string_view name;  // "Collision", "Braking" or a critic
  std::size_t count = 0;
};

/// Why there was nothing to choose from.
enum class Problem {
  none = 0,
  input,    // what was given cannot be planned with
  off_map,  // no pose of the plan lies on the local map
  refused,  // every candidate was refused
  stuck     // standing still is the best legal candidate, for too long
};

struct CriticTerm {
  std::string_view name;
  double raw = 0.0;
  double weight = 0.0;  // adds raw * weight to the total
};

/// What one cycle decided, and why.
struct Decision {
  Outcome outcome = Outcome::fail;
  Twist2 command;                 // what to send [m/s, rad/s]
  Twist2 sample;                  // the chosen candidate's sample [m/s, rad/s]
  Twist2 reference;               // the velocity the cycle started from [m/s, rad/s]
  double total = 0.0;             // J of the chosen candidate
  std::vector<Pose2> trajectory;  // its rollout, start pose first; empty when none was chosen
  double step = 0.0;              // time between two of its poses [s]
  std::vector<CriticTerm> terms;  // of the chosen candidate, in the order of the critics
  // Collision and braking count those that were looked at: all with Sampling::check_all, and whenever nothing is legal.
  std::vector<RefusalCount> refusals;  // per critic, in order; collision and braking first
  std::size_t candidates = 0;
  std::size_t legal = 0;            // nobody refused them
  double agreement = 1.0;           // 1: the command is what the person wants, in [0, 1]
  std::string operator_refused_by;  // what refused the operator's own command; empty when it was legal
  bool escaping = false;            // the robot stands in collision
  Pose2 pose;                       // where the robot is taken to be, costmap frame
  Twist2 velocity;                  // what is believed of the measured one [m/s, rad/s]
  bool odometry_doubted = false;    // a reading was faster than the commands explain, and is not believed
  bool odometry_fast = false;       // so it was, and is believed: for collisions and the goal
  Problem problem_kind = Problem::none;
  std::string problem;  // why there was nothing to choose from, in words; empty where there was
};

/// One candidate as the evaluation topic shows it.
struct CandidateRecord {
  Twist2 sample;                  // [m/s, rad/s]
  std::vector<Pose2> poses;       // start pose first, costmap frame
  double step = 0.0;              // [s]
  std::vector<CriticTerm> terms;  // what was scored before a refusal
  double total = -1.0;            // -1 where it was refused
  std::string refused_by;         // empty where it is legal
  std::string reason;
};

/// What one critic says of one candidate.
struct CriticVerdict {
  std::string_view name;
  double raw = 0.0;
  double weight = 0.0;           // adds raw * weight to the total
  const char* reason = nullptr;  // why it refuses the candidate; null where it does not
};

/// What everybody says of one candidate, also of one that was refused before they were asked.
struct CandidateVerdict {
  Twist2 sample;                       // [m/s, rad/s]
  Pose2 end;                           // of its rollout, costmap frame
  const char* collision = nullptr;     // why the collision check refuses it; null where it does not
  bool can_brake = true;               // true too where admissibility is not `braking`
  std::vector<CriticVerdict> critics;  // in their order; the deviation from the person's wish last
  double sum = 0.0;                    // of all raw * weight, refused or not
  double total = 0.0;                  // J, infinite where it was refused: the choice is the smallest
  bool operator_own = false;           // u_h itself, brought into the window
  bool legal() const { return collision == nullptr && can_brake && !refused_by_critic(); }
  bool refused_by_critic() const {
    for (const CriticVerdict& critic : critics) {
      if (critic.reason != nullptr && critic.weight != 0.0) return true;
    }
    return false;
  }
};

/// By which rule the last cycle's command was chosen.
struct ChoiceReport {
  enum class Rule {
    none,      // nothing was chosen: a fault, a stop, no legal candidate, or u_h was passed through
    cheapest,  // the smallest total, ties by tie_break
    way_out    // what gets stuck autonomy going again, see WayOut
  };
  Rule rule = Rule::none;
  Twist2 wish;           // what the deviation was measured from [m/s, rad/s]
  bool steered = false;  // it counted
};

/// HI-DWA without ROS: samples, rolls out, refuses, scores and chooses. Deterministic: the same input gives the
/// same bits. Not thread-safe; one call at a time. plan() never throws.
class Planner {
 public:
  explicit Planner(CriticRegistry registry);
  ~Planner();
  Planner(Planner&&) noexcept;
  Planner& operator=(Planner&&) noexcept;

  /// Finds the parameters of critics of other packages; returned pointers must outlive the planner.
  using SourceFor = std::function<std::unique_ptr<ParameterSource>(const std::string& critic)>;

  /// Takes a set of parameters whole. Returns every fault (validate() and unknown critics); with any, nothing changes.
  std::vector<std::string> configure(const Parameters& parameters, const SourceFor& source_for = {});
  /// The parameters in force: as they were given, but with safe values where safe_values() says so.
  const Parameters& parameters() const;

  /// The robot's outline without parameters().footprint_padding, which is added here.
  void set_footprint(const Polygon& outline);
  const Polygon& outline() const;  // as it was given
  const Footprint& footprint() const;

  /// A new goal: critics forget what they latched.
  void reset();

  /// What is to be believed of a reading of odometry that comes between two cycles [m/s, rad/s]: one that is faster
  /// than the commands of the last cycle explain counts as the last command, until plan() has come to believe it.
  Twist2 believed(const Twist2& measured) const;

  /// What is remembered from cycle to cycle, the critics' part included: a planner with the same parameters and outline
  /// that loads it decides the next cycle to the same bits. load() is false where the bytes are none of save()'s.
  void save(Bytes& state) const;
  bool load(const Bytes& state);

  /// One cycle. `grid` must stay unchanged during the call. The decision stays valid until the next call.
  const Decision& plan(const Situation& situation, const GridView& grid, const OperatorIntent& intent,
                       const Sampling& sampling = {});

  /// Every candidate of the last plan(), in the order of the samples. Without Sampling::check_all those that the choice
  /// did not come to were not looked at for collisions.
  std::vector<CandidateRecord> evaluation() const;
  /// Index into evaluation() of the chosen, the worst legal and the operator's own candidate; -1 when there is none.
  struct Marked {
    int best = -1;
    int worst = -1;
    int operator_own = -1;
  };
  Marked marked() const;

  /// J of every candidate of the last plan(), infinite where it is known to be refused; empty where nothing was
  /// weighed.
  const std::vector<double>& totals() const;

  /// From now on plan() also asks every critic about every candidate, whoever has refused it. The decision is the same,
  /// to the bit; it takes several times as long and allocates.
  void set_thorough(bool thorough);
  /// What was said of every candidate of the last plan(), in the order of the samples; empty where nothing was weighed
  /// or the planner is not thorough.
  const std::vector<CandidateVerdict>& verdicts() const;
  /// How the last choice was made.
  const ChoiceReport& choice() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace hidwa_local_planner
