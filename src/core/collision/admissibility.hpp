// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/collision/collision.hpp"
#include "core/collision/escape.hpp"
#include "core/collision/room_memo.hpp"
#include "core/motion/brake_manoeuvre.hpp"
#include "core/motion/pending_motion_set.hpp"
#include "hidwa_local_planner/core/parameters.hpp"
#include "hidwa_local_planner/core/tile.hpp"

namespace hidwa_local_planner {

/// Which candidates are free of collision, and which of them can still stop in free space. For a robot that already
/// stands in collision EscapeRule holds besides. Where no motion leads out of that, it may turn on the spot as far as
/// it goes no deeper; a person may always do so, and stand.
class AdmissibilityCheck {
 public:
  struct Setup {
    Pose2 start;                                // now
    Pose2 origin;                               // where what is pending begins: the pose as it was measured
    Twist2 reference;                           // [m/s, rad/s]
    const PendingMotionSet* pending = nullptr;  // until a command that is sent now takes effect
    double period = 0.05;                       // [s]
    double longest_period = 0.05;               // the next command comes no later [s]
    bool turn_out = false;                      // out of a collision that no motion leads out of, by turning first
    bool steered = false;                       // by a person
    EscapeRule* escape = nullptr;               // where it applies
  };
  /// How far the robot's centre gets at most in any manoeuvre of a command up to `fastest` [m/s], without the growth
  /// [m].
  static double reach_of_manoeuvres(const Setup& setup, const VelocityLimits& limits, double fastest);
  /// How far at most a robot with this reach can be from where a manoeuvre is rolled out [m], see
  /// ManoeuvreRoller::growth().
  static double most_growth(const Setup& setup, const VelocityLimits& limits, double radius, double reach);
  /// Once a cycle; `checker` must be prepared (EscapeRule::rest() where that applies) and everything must outlive the
  /// questions.
  void prepare(const Parameters& parameters, const VelocityLimits& limits, const CollisionChecker& checker,
               const Footprint& footprint, double resolution, const Setup& setup);

  /// Whether a look at the cells is enough for every rollout of a tile; sets the reasons of those that they refuse.
  bool cells_decide(const Tile& tile, const char** reasons) const;
  /// Candidates must be able to brake.
  bool checks_braking() const { return parameters_->admissibility == Admissibility::braking; }
  /// No candidate needs to be asked whether it can brake.
  bool all_can_brake() const { return all_clear_ && !escaping(); }
  /// Reasons for the candidates of a tile, nullptr where free: the rollout.
  void check_rollouts(const Tile& tile, const char** reasons);
  /// Whether the manoeuvre of a sample ends at rest in free space, however the base reaches its commands: at every pose
  /// the robot keeps the manoeuvre's growth as its distance; where it stands nearer to something, the distance it has
  /// now. Poses at most half a cell apart.
  bool can_brake(const Twist2& sample, std::size_t column);
  /// As can_brake, without gaps: poses a sixteenth of a cell apart or nearer, and half of that more distance.
  bool can_brake_surely(const Twist2& sample);
  /// The first command towards a sample.
  Twist2 command_for(const Twist2& sample) const;
  /// The robot overlaps something.
  bool escaping() const { return setup_.escape != nullptr && setup_.escape->overlaps(); }

 private:
  const char* fault_of_rollout(const Tile& tile, std::size_t c);
  bool rollout_free(const Tile& tile, std::size_t c);
  double room_at(const Tile& tile, std::size_t c, std::size_t k);
  bool between_free(const Tile& tile, std::size_t c, std::size_t k, double room_before, double room_after);
  bool rollout_escapes(const Tile& tile, std::size_t c) const;
  bool may_stay(const Tile& tile, std::size_t c) const;
  // Where what is under way leads to, looked at once a cycle.
  struct Arrival {
    std::optional<ManoeuvreRoller> roller;
    bool free = false;
    double room = 0.0;  // that is left there [m]
  };
  using Arrivals = std::array<Arrival, PendingMotionSet::kMost>;
  BrakeManoeuvre manoeuvre(std::size_t way, const Twist2& command, double hold) const;
  bool nothing_in_reach() const;
  bool manoeuvre_free(const Twist2& command);
  bool manoeuvre_surely_free(const Twist2& command);
  double longest_hold() const;
  double fine_spacing(double way) const;
  template <typename Look>
  bool free_in_time(const Twist2& command, bool surely, Arrivals& arrivals, Look&& look) const;
  template <typename Look>
  bool free_all_along(const BrakeManoeuvre& manoeuvre, bool surely, Arrival& arrival, Look&& look) const;
  // Likewise, for the heaps that it stands in.
  struct Sinking {
    std::optional<ManoeuvreRoller> roller;
    bool deeper = false;
    EscapeRule::Descent descent;
  };
  using Sinkings = std::array<Sinking, PendingMotionSet::kMost>;
  bool manoeuvre_deeper(const Twist2& command, double spacing, Sinkings& sinkings) const;
  bool goes_deeper(const BrakeManoeuvre& manoeuvre, double spacing, Sinking& sinking) const;

  const Parameters* parameters_ = nullptr;
  const VelocityLimits* limits_ = nullptr;
  const CollisionChecker* checker_ = nullptr;
  const Footprint* footprint_ = nullptr;
  TurnedPose start_;
  double resolution_ = 0.05;
  Setup setup_;
  double look(const Pose2& pose, const Rotation& heading, double needed = 0.0);
  double keep_ = 0.0;  // no more distance than this is asked for: what the robot has now [m]

  RoomMemo rooms_;            // of the footprint
  double most_turn_ = 0.0;    // between two poses of the tile, at most [rad]
  std::size_t last_hit_ = 0;  // step at which a candidate of the tile hit something; 0: none yet
  double margin_ = 0.0;       // around a clear position [m]
  bool all_clear_ = false;    // no manoeuvre can hit anything
  Twist2 brief_command_for(const Twist2& sample, std::size_t column);
  double sample_omega_ = 0.0, command_omega_ = 0.0;  // of the tile [rad/s]
  bool omega_known_ = false;
  struct Memo {
    Twist2 command;
    bool known = false, free = false;
    bool v_known = false;
    double sample_v = 0.0, command_v = 0.0;  // of the column [m/s]
  };
  std::vector<Memo> memo_;  // the last answer in each column of samples
  Arrivals arrivals_, sure_arrivals_;
  Sinkings sinkings_, sure_sinkings_;
};

}  // namespace hidwa_local_planner
