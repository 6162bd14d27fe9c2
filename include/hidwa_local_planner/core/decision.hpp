// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "hidwa_local_planner/core/types.hpp"

namespace hidwa_local_planner {

enum class Outcome { drive = 0, brake, fail, hold };
const char* to_string(Outcome outcome);

/// Names stay valid until the planner is configured anew.
struct RejectionCount {
  // "Collision", "Unknown cells", "Braking", "Moving obstacle", "Blind", "Occlusion" or a critic
  std::string_view name;
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
  std::string_view name;  // "Collision", "Braking", "Moving obstacle", "Blind", "Occlusion" or a critic
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
    cheapest,  // the smallest total, ties by the rule of `method`
    escape,    // autonomy stands in collision: it ends least deep, or turns towards a way out
    way,       // it gets farthest along the way that a search has found, or nearly as far and is the cheapest
    rest,      // the robot rests while a way is searched
    evasion    // it begins the best way that no moving obstacle touches
  };
  Rule rule = Rule::none;
  Twist2 target;         // what the deviation was measured from: u_h, or its blend with autonomy's choice [m/s, rad/s]
  bool steered = false;  // the deviation counted
};

}  // namespace hidwa_local_planner
