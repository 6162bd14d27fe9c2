// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "hidwa_local_planner/core/critic.hpp"
#include "hidwa_local_planner/core/critic_registry.hpp"
#include "hidwa_local_planner/core/footprint.hpp"
#include "hidwa_local_planner/core/grid_view.hpp"
#include "hidwa_local_planner/core/moving_obstacle.hpp"
#include "hidwa_local_planner/core/operator_intent.hpp"
#include "hidwa_local_planner/core/parameters.hpp"
#include "hidwa_local_planner/core/types.hpp"

namespace hidwa_local_planner {

/// What a cycle starts from. Poses are in the costmap frame.
struct Situation {
  Pose2 pose;                   // of the robot, as it was measured `pose_age` ago
  Twist2 velocity;              // measured by odometry [m/s, rad/s]
  double velocity_time = 0.0;   // when that was heard [s]; 0: in this cycle
  Twist2 last_command;          // what was sent last, in the cycle before [m/s, rad/s]
  std::vector<Pose2> plan;      // the window of the global plan around the robot, see PlanWindow
  Pose2 goal;                   // the last pose of the full plan
  bool goal_latched = false;    // the position of the goal was reached, see GoalChecker
  bool goal_next = true;        // false: more of the plan is to be driven before the goal counts, however near it is
  bool goalless = false;        // the operator drives without a goal: there is no plan, and `goal` is the pose
  bool turns_back = false;      // the window ends where the plan turns back: the robot is to get there first
  double period = 0.05;         // nominal, of the control cycle [s]
  double longest_period = 0.0;  // in the last seconds, see PeriodWatch: the next cycle comes no later [s]; 0: period
  double pose_age = 0.0;        // how old the pose is [s]; the planner adds the motion since then
  bool resumed = false;         // the host paused and others may have driven: last_command is the velocity of now
  double time = 0.0;            // [s]
  MovingObstacleEstimates moving_obstacles;
};

/// How much a cycle finds out about its candidates. Each level includes the one before. All levels give the same
/// command, to the bit.
enum class Report : std::uint8_t {
  chosen = 0,  // collision and braking are checked only as far as the choice needs it
  legality,    // they are checked for every candidate: what is said of who rejects it is complete
  full         // every critic is asked about every candidate, whoever has rejected it; takes several times as long, and
               // allocates
};

/// How much a cycle computes. It is an input of plan(), so that a recorded cycle can be repeated.
struct Sampling {
  int vx_samples = 0;    // 0: as in the parameters
  int vth_samples = 0;   // 0: as in the parameters
  int search_poses = 0;  // of a search for a way; 0: as in the parameters
  Report report = Report::chosen;
};

enum class Outcome { drive = 0, brake, fail, hold };
const char* to_string(Outcome outcome);

/// Names stay valid until the planner is configured anew.
struct RejectionCount {
  std::string_view name;  // "Collision", "Unknown cells", "Braking", "Moving obstacle" or a critic
  std::size_t count = 0;
};
using RefusalCount [[deprecated("is RejectionCount")]] = RejectionCount;

/// Why there was nothing to choose from.
enum class Problem {
  none = 0,
  input,     // what was given cannot be planned with
  off_map,   // no pose of the plan lies on the local map
  rejected,  // every candidate was rejected
  refused [[deprecated("is rejected")]] = rejected,
  stuck  // standing still is the best legal candidate, for too long
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
  // The checks count only the candidates that were checked. With Report::legality, and whenever nothing is
  // legal, these are all.
  std::vector<RejectionCount> rejections;  // per critic, in order; the checks first
  std::size_t candidates = 0;
  std::size_t legal = 0;             // not rejected
  double agreement = 1.0;            // 1: the command is the operator command, in [0, 1]
  std::string operator_rejected_by;  // what rejected the operator command; empty where it was legal
  bool escaping = false;             // the robot stands in collision
  bool recovering = false;           // autonomy is stuck: it searches or follows a way
  bool waiting = false;              // it stands for what moves, or waits for that to clear the only way
  Pose2 pose;                        // where the robot is taken to be, costmap frame
  Twist2 velocity;                   // what is believed of the measured one [m/s, rad/s]
  bool odometry_doubted = false;     // the commands do not explain a reading, and it is not believed
  bool odometry_fast = false;        // a faster one than they explain is believed: by the collision check and the goal
  Problem problem_kind = Problem::none;
  std::string problem;  // why there was nothing to choose from, in words; empty where there was
};

/// Who rejects a candidate, and why. Names stay valid until the planner is configured anew.
struct Rejection {
  std::string_view name;  // "Collision", "Braking", "Moving obstacle" or a critic
  const char* reason = "";
};

/// One candidate of a cycle, and what was found out about it.
struct CandidateReport {
  Twist2 sample;                      // [m/s, rad/s]
  bool operator_command = false;      // it is u_h itself, brought into the dynamic window
  std::vector<Pose2> poses;           // of its rollout, start pose first, costmap frame
  double step = 0.0;                  // time between two poses [s]
  std::vector<CriticTerm> terms;      // in the order of the critics, the deviation from the operator command last; of a
                                      // rejected candidate, without Report::full, what was scored before
  double total = 0.0;                 // J, infinite where it is rejected: the choice is the smallest
  std::vector<Rejection> rejections;  // the first one; with Report::full all of them: collision, braking, then critics
  bool legal() const { return rejections.empty(); }
  /// The sum of all terms, also of a rejected candidate.
  double sum() const {
    double sum = 0.0;
    for (const CriticTerm& term : terms) sum += term.raw * term.weight;
    return sum;
  }
};

/// By which rule the last cycle's command was chosen.
struct ChoiceReport {
  enum class Rule {
    none,      // nothing was chosen: a fault, a stop, no legal candidate, or u_h was passed through
    cheapest,  // the smallest total, ties by tie_break
    escape,    // autonomy stands in collision: it ends least deep, or turns towards a way out
    way,       // it gets farthest along the way that a search has found
    rest,      // the robot rests while a way is searched
    evasion    // it begins the best way that no moving obstacle touches
  };
  Rule rule = Rule::none;
  Twist2 target;         // what the deviation was measured from: u_h, or its blend with autonomy's choice [m/s, rad/s]
  bool steered = false;  // the deviation counted
};

/// HI-DWA without ROS: samples, rolls out, rejects, scores and selects. Deterministic: the same input gives the
/// same bits. Not thread-safe; one call at a time. plan() never throws.
class Planner {
 public:
  explicit Planner(CriticRegistry registry);
  ~Planner();
  Planner(Planner&&) noexcept;
  Planner& operator=(Planner&&) noexcept;

  /// Finds the parameters of critics of other packages; returned pointers must outlive the planner.
  using SourceFor = std::function<std::unique_ptr<ParameterSource>(const std::string& critic)>;

  /// Takes a set of parameters. Returns every fault (validate() and unknown critics). With any fault nothing changes.
  std::vector<std::string> configure(const Parameters& parameters, const SourceFor& source_for = {});
  /// The parameters in force: as they were given, except where make_safe() replaces a value that cannot be kept safe.
  const Parameters& parameters() const;

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
