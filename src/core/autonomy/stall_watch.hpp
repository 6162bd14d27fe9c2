// SPDX-License-Identifier: BSD-3-Clause
// Whether autonomy gets on. It stalls where it stands, where it turns on the spot so slowly that it gains nothing, and
// where it moves to and fro between poses that it was at before.
#pragma once

#include "core/autonomy/novelty.hpp"
#include "core/cycle/cycle.hpp"
#include "hidwa_local_planner/core/util/condition_timer.hpp"

namespace hidwa_local_planner {

class StallWatch {
 public:
  /// What a cycle shows.
  struct Motion {
    bool stands = false;
    bool creeps = false;  // it turns on the spot so slowly that it gains nothing
    bool yields = false;  // to what moves: that is no stall
  };
  void reset() { observe_rest(false, 0.0); }
  /// Nobody asks whether autonomy gets on. Only how long it has stood still counts.
  void observe_rest(bool stands, double now) {
    stands_.observe(now, stands);
    rests_.reset();
    novelty_.reset();
  }
  /// Once a cycle in which autonomy drives. `pose`: costmap frame, `now` [s].
  void observe(const Motion& motion, const Pose2& pose, double now);
  /// It comes to new poses from now on.
  void forget_poses() { novelty_.reset(); }

  bool stands() const { return stands_.holds(); }
  double standing_time(double now) const { return stands_.time(now); }  // [s]
  /// It has stood until the last command took effect.
  bool settled(const Cycle& cycle) const;
  /// It has stood or crept for `patience` [s].
  bool impatient(double patience, double now) const { return rests_.for_at_least(patience, now); }
  /// It has come to no new pose for three times the time that its limits need to come to one.
  bool gets_nowhere(const Cycle& cycle) const;

  template <typename Self, typename Archive>
  static void archive(Self& self, Archive& io) {
    io(self.stands_, self.rests_, self.novelty_);
  }

 private:
  ConditionTimer stands_, rests_;  // it stands; it stands or creeps
  Novelty novelty_;
};

}  // namespace hidwa_local_planner
