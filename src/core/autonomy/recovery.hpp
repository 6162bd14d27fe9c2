// SPDX-License-Identifier: BSD-3-Clause
// Gets autonomy going again that has stalled, where a way leads on. Its phases:
//
//   idle         The cheapest candidate decides.
//   looks_ahead  Likewise. Before a tight place a search begins while the robot drives on: one that cannot drive
//                backwards may come to where no way leads on. A way that is found is followed at once.
//   stops        The robot comes to rest, to search from there.
//   searches     The robot rests. A way that is found is followed once its patience is over.
//   follows      The way (WayFollower). At its end the phase is idle; where the robot stalls, stops.
//   waits        There is no way. The cycle fails and says why, and the robot searches again after two seconds. Where
//                only moving obstacles block the way, it waits for them instead, for 30 s, and the cheapest candidate
//                may move up to them: people who give way to robots see that it wants to pass. Who waits may be waiting
//                for the robot: after step_back_after it goes back where it has come from (StepBack).
//
// A search that takes long makes one cycle fail, so that the host may make another plan, and continues. At the goal's
// position a turn is left. Where the robot cannot turn there, it searches a way to the goal's pose.
//
// Why it is safe: it takes legal candidates only. It must see all of them, so all are checked while it is active().
#pragma once

#include <cstdint>

#include "core/autonomy/no_way_report.hpp"
#include "core/autonomy/proposal.hpp"
#include "core/autonomy/stall_watch.hpp"
#include "core/autonomy/step_back.hpp"
#include "core/autonomy/way_finder.hpp"
#include "core/autonomy/way_follower.hpp"
#include "hidwa_local_planner/core/util/condition_timer.hpp"

namespace hidwa_local_planner {

class Recovery {
 public:
  /// It waits no longer for moving obstacles that alone block the way [s].
  static constexpr double kLongestWait = 30.0;

  void reserve() { finder_.reserve(); }
  void reset();
  /// The robot rests at the goal's position and cannot turn there: it searches a way to the goal's pose. `now` [s].
  void begin_at_goal(double now);
  /// The robot stands in collision: what leads out of it comes first.
  void interrupt(double now);

  /// What it would have the robot do, with all candidates checked and scored.
  struct Step {
    Proposal proposal;
    WayFollower::Step way;  // where it follows one
  };
  Step propose(const Cycle& cycle, Evaluation& evaluated) const;
  void commit(const Step& step, StallWatch& stall, double now);
  /// After each cycle of autonomy. `tight`: see Outlook.
  void observe(const Cycle& cycle, bool stands, bool tight);
  /// What is known of the time to come.
  struct Outlook {
    bool impatient = false;  // the robot has rested long enough
    bool tight = false;      // it will soon be near an obstacle
    Pose2 soon;              // where it is when the next command takes effect, costmap frame
  };
  /// Changes the phase. Call it after observe(), unless the robot is trapped in collision.
  void advance(const Cycle& cycle, const StallWatch& stall, const Outlook& outlook);

  /// It may decide what is driven: all candidates must be checked.
  bool active() const { return holds_ || phase_ == Phase::follows; }
  bool follows() const { return phase_ == Phase::follows; }
  /// It follows the way back, to let out who blocks the plan.
  bool goes_back() const { return follows() && goes_back_; }
  /// It follows a way that was found while the robot drove.
  bool drives_on() const { return follows() && follower_.found_while_driving(); }
  /// It searches or follows a way to the goal's pose.
  bool leads_to_goal() const { return to_goal_; }
  /// A way was found in this cycle, and is followed from the next one on.
  bool begins_way() const { return follows() && follower_.begins(); }
  /// It waits for moving obstacles, and now and then searches whether they are gone.
  bool waiting() const;
  /// It is not known yet whether a way leads on.
  bool undecided() const;
  /// Why no way leads on; empty where that is not known. Valid until the next call of another function.
  const char* problem() const { return report_.problem().c_str(); }

  template <typename Self, typename Archive>
  static void archive(Self& self, Archive& io) {
    io(self.phase_, self.since_, self.holds_, self.to_goal_, self.goes_back_, self.searched_ahead_, self.renewed_,
       self.finder_, self.follower_, self.wait_, self.back_, self.report_);
  }

 private:
  enum class Phase : std::uint8_t { idle, looks_ahead, stops, searches, follows, waits };

  void enter(Phase phase, double now);
  WayFinder::Target target() const;
  bool blocked_by_movers(const Cycle& cycle, bool stands) const;
  void change_phase(const Cycle& cycle, const StallWatch& stall, const Outlook& outlook);
  void step_back(const Cycle& cycle);
  void begin_search(const Cycle& cycle, Phase phase, const Pose2& start);
  bool late(double now) const;
  bool searches_in_vain(const Cycle& cycle, bool stands);
  void follow_way(double now, bool while_driving);
  void search_back(const Cycle& cycle, bool stands);
  void search(const Cycle& cycle, bool may_follow);
  void follow_found_way(const Cycle& cycle, bool may_follow);
  void renew(const Cycle& cycle, const StallWatch& stall, const Pose2& start);
  void fail(double now, const char* why);
  void wait_for_movers(double now);

  Phase phase_ = Phase::idle;
  double since_ = 0.0;           // when the phase began [s]
  bool holds_ = false;           // the robot stands for the search, whatever is cheapest
  bool to_goal_ = false;         // what is searched or followed is a way to the goal's pose,
  bool goes_back_ = false;       // or the way back
  double searched_ahead_ = 0.0;  // the last search while driving began [s]
  double renewed_ = 0.0;         // the last search for a better way began [s]
  WayFinder finder_;
  WayFollower follower_;
  Way other_;            // that may take the place of the one that is followed; of this cycle alone
  ConditionTimer wait_;  // moving obstacles alone block the way
  StepBack back_;
  NoWayReport report_;
};

}  // namespace hidwa_local_planner
