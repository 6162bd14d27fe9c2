// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#if __cplusplus < 201703L
#error "hidwa_local_planner needs C++17: set(CMAKE_CXX_STANDARD 17) in the package that includes this"
#endif

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "hidwa_local_planner/core/grid_view.hpp"
#include "hidwa_local_planner/core/moving_obstacle.hpp"
#include "hidwa_local_planner/core/parameters.hpp"
#include "hidwa_local_planner/core/tile.hpp"
#include "hidwa_local_planner/core/types.hpp"
#include "hidwa_local_planner/core/util/archive.hpp"

namespace hidwa_local_planner {

class Footprint;

/// What all critics may look at in one cycle. Everything is in the costmap frame and lives as long as the cycle.
struct CycleView {
  Pose2 pose;                     // of the robot
  Twist2 velocity;                // measured [m/s, rad/s]
  Twist2 last_command;            // what was sent in the last cycle [m/s, rad/s]
  Pose2 goal;                     // the last pose of the full plan
  double time = 0.0;              // of the cycle [s]
  bool steered = false;           // the operator's input counts (gamma = 1)
  bool operator_decides = false;  // direct control, or steered where the goal's position is reached; or a way leads
                                  // from there to the goal's heading: a critic rejects what is unsafe then, and
                                  // nothing for the sake of autonomy
  bool person_decides = false;    // the former name of operator_decides; it goes with the next release
  bool goal_next = true;          // false: more of the plan is to be driven before the goal counts, however near it is
  const std::vector<Pose2>* plan = nullptr;  // the window of the plan around the robot
  const GridView* grid = nullptr;
  const Footprint* footprint = nullptr;
  Surroundings* surroundings = nullptr;
  const MovingObstacleEstimates* moving_obstacles = nullptr;  // that count
  // Discs in which somebody may stand whom an obstacle hides, and from where he may step out; only near the robot, and
  // as `occlusion` says. Empty or null: there are none.
  const std::vector<Point>* hidden_places = nullptr;  // their centres [m]
  double hidden_radius = 0.0;                         // of each [m]

  /// False where no pose of the plan lies on the local map: then no distance is known.
  bool plan_on_map() const { return surroundings->plan_on_map(); }
  /// For Critic::prepare: announces that this distance will be asked for. Without it the answers are the same, but
  /// slower.
  void expect(const PlanDistance& distance) const { surroundings->expect(distance); }
};

/// What a critic says of the candidates of one tile. A rejection is a value, never an exception.
class TileScores {
 public:
  TileScores(double* raw, const char** reason, std::size_t count) : raw_(raw), reason_(reason), count_(count) {}
  std::size_t count() const { return count_; }
  /// The candidate is rejected already: it needs no score.
  bool rejected(std::size_t c) const { return reason_[c] != nullptr; }
  void set(std::size_t c, double raw_score) {
    if (!any_set_) std::fill_n(set_all(), count_, 0.0);
    raw_[c] = raw_score;
  }
  /// All raw scores [count], for loops that set every one, rejected candidates included.
  double* set_all() {
    any_set_ = true;
    return raw_;
  }
  /// Rejects a candidate; `reason` must outlive the cycle (a string literal).
  void reject(std::size_t c, const char* reason) {
    reason_[c] = reason;
    any_rejected_ = true;
  }
  /// True once a candidate was rejected through this object.
  bool any_rejected() const { return any_rejected_; }
  /// True once a score was set through this object.
  bool any_set() const { return any_set_; }

  [[deprecated("is rejected()")]] bool refused(std::size_t c) const { return rejected(c); }
  [[deprecated("is reject()")]] void refuse(std::size_t c, const char* reason) { reject(c, reason); }
  [[deprecated("is any_rejected()")]] bool any_refused() const { return any_rejected(); }

 private:
  double* raw_;          // [count], zero where some are set and others are not
  const char** reason_;  // [count], nullptr while legal
  std::size_t count_;
  bool any_rejected_ = false;
  bool any_set_ = false;
};

/// Where a critic of another package finds its own parameters: `<planner>/<critic>/<key>`. It asks for all of them in
/// Critic::configure: a key that it does not ask for is reported as unknown. It gets `fallback` where there is no
/// value. It also gets `fallback` for a value of another type; that is a fault, and the whole set of parameters is not
/// taken. This class itself knows no values.
class ParameterSource {
 public:
  virtual ~ParameterSource() = default;
  virtual double number(const std::string& /*key*/, double fallback) const { return fallback; }
  virtual bool flag(const std::string& /*key*/, bool fallback) const { return fallback; }
  virtual std::string word(const std::string& /*key*/, const std::string& fallback) const { return fallback; }
  virtual std::vector<double> numbers(const std::string& /*key*/, const std::vector<double>& fallback) const {
    return fallback;
  }
  virtual std::vector<std::string> words(const std::string& /*key*/, const std::vector<std::string>& fallback) const {
    return fallback;
  }
  /// What was asked for and is of another type, each in words.
  virtual std::vector<std::string> faults() const { return {}; }
};

/// Scores candidates. The life of a critic: configure once and on every change of parameters; then in each cycle
/// prepare, score for every tile, and debrief; reset on a new goal. A cycle may prepare and score up to three
/// times before debrief: with an authority between 0 and 1 once for autonomy alone, once with the operator; where
/// autonomy finds no way on that is gentle, once more with all turns; where evasion needs other turns, once more. None
/// may wait or log, and only configure may throw; after the first cycle prepare and score should not allocate. A
/// rejection is for what is unsafe. A critic that rejects for the sake of autonomy (it should slow down at the goal,
/// not go back and forth, keep to the plan) must not do so while CycleView::operator_decides.
class Critic {
 public:
  virtual ~Critic() = default;

  /// Takes its parameters and returns its weight; 0 turns it off, rejections included. With values that it cannot work
  /// with it throws a std::exception: the set of parameters is not taken, and what() is logged.
  virtual double configure(const Parameters& parameters, const ParameterSource& own) = 0;
  /// Once a cycle, before any score: what all candidates share.
  virtual void prepare(const CycleView& /*cycle*/) {}
  /// Sets the raw score of the candidates of a tile, or rejects them. Adds weight * raw score to the total.
  virtual void score(const CycleView& cycle, const Tile& tile, TileScores& scores) = 0;
  /// What was sent in the end.
  virtual void debrief(const CycleView& /*cycle*/, const Twist2& /*command*/) {}
  /// A new goal.
  virtual void reset() {}
  /// What the critic remembers from one cycle to the next (what prepare, debrief and reset change), for a record of the
  /// cycle to come: load() of the same bytes, after configure(), makes it decide the same. A critic that remembers
  /// something and does not save it here is replayed as if after reset().
  virtual void save(ArchiveWriter& /*state*/) const {}
  virtual void load(ArchiveReader& /*state*/) {}

 protected:
  Critic() = default;
  Critic(const Critic&) = default;
  Critic& operator=(const Critic&) = default;
};

}  // namespace hidwa_local_planner
