// SPDX-License-Identifier: BSD-3-Clause
// Gets autonomy going again that stands, creeps, or moves and gets nowhere, though a way may lead on.
//
// 1. Where it stands, a search begins (WaySearch): for a way of the outline to the plan 1.5 m to 2.5 m ahead, through a
//    snapshot of the local map. It goes on for some poses a cycle. If ordinary scoring drives on meanwhile, it ends.
//    A robot that creeps or gets nowhere for some patience stands first.
// 2. After the patience the way that was found is followed: the legal candidate is taken that ends with the least
//    remaining time, followed for some tenths of a second and then braked. What critics reject is not taken.
// 3. That ends at the way's end, or where the cheapest candidate has led on as well for a second. If the remaining time
//    stops falling, the robot stands and searches anew.
// 4. If there is no way, the cycle fails and says why. It searches again after two seconds. Where only what moves is in
//    the way, it waits for that instead (MoverWait), and ordinary scoring may move up to it: who gives way to robots
//    sees so that it wants to pass. A search that takes long makes one cycle fail, so that the host
//    may make another plan, and goes on. Who waits may be waiting for the robot: after step_back_after it goes back the
//    way it has come (StepBack), once or twice.
// 5. At the goal's position a turn is left. Where the robot cannot turn there, a way to the goal's pose is searched,
//    out of the tolerance and back, if need be.
// 6. Before a tight place the search begins while the robot drives on. Where it finds a way the robot follows that, in
//    good time: one that cannot drive backwards may come to where no way leads on.
//
// While the cheapest candidate gains nearly as much on the way as the best, it is the one that is taken.
//
// In collision EscapeTurn acts instead. Why it is safe: it takes legal candidates only, and each of them passes the
// braking check without gaps. It must see all of them, so every candidate is checked before (Evaluation::evaluate()).
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/planner/cycle.hpp"
#include "core/planner/escape_turn.hpp"
#include "core/planner/mover_wait.hpp"
#include "core/planner/novelty.hpp"
#include "core/planner/step_back.hpp"
#include "core/search/way_search.hpp"
#include "hidwa_local_planner/core/util/condition_timer.hpp"

namespace hidwa_local_planner {

class RecoveryMotion {
 public:
  /// One cycle with all candidates scored; where it is active(), all of them checked.
  struct Scene {
    const Cycle& cycle;
    const Rollout& rollout;
    const std::vector<double>& totals;  // of each candidate, infinite where it is rejected
    const CollisionChecker& collision;  // prepared with the map of now
    AdmissibilityCheck& admissibility;
    EscapeRule& escape;
  };

  /// The memory of its search.
  void reserve() {
    search_.reserve();
    way_back_.reserve(StepBack::kMostPoses);
  }
  void reset();
  /// The candidate that leads on; -1 where there is none, or no need of one.
  int choose(const Scene& scene);
  /// How autonomy fared in a cycle, by its choice or since nothing was legal.
  struct Course {
    bool autonomous = false;  // nothing of the rest counts otherwise
    bool stands = false;
    bool creeps = false;   // turns on the spot so slowly that it gains nothing
    bool trapped = false;  // in collision, and no motion leads out
    bool yields = false;   // to what moves: that it gets nowhere does not count
    bool tight = false;    // it comes near to something soon
    Pose2 soon;            // where it will be once a command takes effect, costmap frame
  };
  /// After each cycle. `patience` [s]: for how long the robot may rest before it begins to recover; negative: for ever.
  /// True when the critics must forget: what they forbid may be what gets the robot going.
  bool watch(const Cycle& cycle, const Course& course, double patience);

  /// The robot stands at the goal's position, and cannot turn there: from now on it is not at its goal, and leads
  /// there.
  void begin_at_goal(double now);
  bool leads_to_goal() const { return to_goal_; }

  /// It decides what is driven.
  bool active() const { return escape_.active() || holds_ || phase_ == Phase::follows; }
  /// It follows a way: candidates are rolled out no farther than that needs.
  bool follows() const { return phase_ == Phase::follows; }
  /// That is the one back, to let out who blocks the plan.
  bool goes_back() const { return follows() && goes_back_; }
  /// It does, and has found it while it drove.
  bool drives_on() const { return follows() && ahead_; }
  /// It is not known yet whether a way leads on, or it waits for what moves to go.
  bool undecided() const {
    return phase_ == Phase::stops || waiting() || (problem_.empty() && phase_ == Phase::searches);
  }
  /// A way was found in this cycle, and is followed from the next one on.
  bool begins_way() const;
  /// It waits for what moves, and now and then searches whether it is gone. After some time it fails instead.
  bool waiting() const {
    return problem_.empty() && wait_.waits() && (phase_ == Phase::waits || phase_ == Phase::searches);
  }
  /// Why no way leads on, or in one cycle that the search takes long; empty where that is not known. Valid until the
  /// next call of another function.
  const char* problem() const { return problem_.c_str(); }
  /// For how long autonomy has stood [s].
  double standing_time(double now) const { return stands_.time(now); }

  template <typename Self, typename Archive>
  static void archive(Self& self, Archive& io) {
    io(self.phase_, self.holds_, self.stands_, self.rests_, self.novelty_, self.escape_, self.since_, self.search_,
       self.way_, self.part_, self.least_, self.least_left_, self.agrees_, self.ahead_, self.tight_, self.looked_,
       self.problem_, self.hopeless_, self.hopeless_at_, self.room_, self.narrower_, self.blocked_, self.renewed_,
       self.wait_, self.back_, self.goes_back_, self.to_goal_, self.told_, self.told_time_, self.told_at_);
  }

 private:
  enum class Phase : std::uint8_t {
    idle,         // ordinary scoring decides
    looks_ahead,  // likewise, while it searches
    stops,        // to search from where it stands
    searches,     // it stands
    follows,      // the way
    waits         // there is none
  };
  void enter(Phase phase, double now);
  void advance(const Cycle& cycle, const Course& course);
  bool blocked_by_movers(const Cycle& cycle, bool stands) const;
  void step_back(const Cycle& cycle);
  void search_back(const Cycle& cycle);
  bool searches_in_vain(const Cycle& cycle);
  void start_way();
  void begin_search(const Cycle& cycle, Phase phase, const Pose2& start);
  void recall();
  void set_task(const Cycle& cycle, const Pose2& start);
  void search(const Cycle& cycle, bool may_follow);
  void look_ahead(const Cycle& cycle);
  void renew(const Cycle& cycle, const Pose2& start);
  void watch_room(const Way::Place& here, double room);
  WaySearch::State run(const Cycle& cycle, Way& way);
  bool leads_better(const Pose2& start) const;
  bool still_leads(const Cycle& cycle) const;
  void say_that_it_takes_long(const Cycle& cycle);
  bool late(double now) const;
  void follow_way(double now);
  void fail(double now, const char* how);
  void conclude_no_way(const Cycle& cycle);
  void wait_for_movers(double now);
  void describe_end(const char* how, std::string& text);
  bool gets_nowhere(const Cycle& cycle) const;
  int stand(const Scene& scene) const;
  int follow(const Scene& scene);
  int cheapest_legal(const Scene& scene) const;
  bool gets_on(const Way::Place& here, double now);

  Phase phase_ = Phase::idle;
  bool holds_ = false;             // it stands for the search, whatever ordinary scoring prefers
  double since_ = 0.0;             // when the phase began, or the remaining time fell last [s]
  ConditionTimer stands_, rests_;  // it stands; it stands or creeps
  Novelty novelty_;
  EscapeTurn escape_;
  SearchTask task_;  // to be filled
  WaySearch search_;
  Way way_;
  Way renewal_;              // to take the place of it; of this cycle alone
  std::uint32_t part_ = 0;   // of the way, that the robot is on
  double least_ = 0.0;       // remaining time on it so far [s]
  double least_left_ = 0.0;  // likewise, from the nearest place on it [s]
  ConditionTimer agrees_;    // ordinary scoring would lead on as well, and nothing is near
  bool ahead_ = false;       // the way was found while the robot drove
  bool tight_ = false;       // something is near
  double room_ = -1.0;       // the clearance along the way when it was found; negative: not looked at yet [m]
  bool narrower_ = false;    // now it is much less
  bool blocked_ = false;     // now there is none
  bool impatient_ = false;   // the patience is over
  double looked_ = 0.0;      // ahead, at last [s]
  double renewed_ = 0.0;     // a search for a way instead of this one began at last [s]
  std::string problem_;
  MoverWait wait_;
  StepBack back_;
  bool goes_back_ = false;       // what is searched or followed is the way back
  bool to_goal_ = false;         // likewise, a way to the goal's pose
  std::vector<Pose2> way_back_;  // as a plan
  std::string hopeless_;         // what a search ahead has come to, that found no way
  Pose2 hopeless_at_;            // from there
  bool told_ = false;            // in the last cycle: that the search takes long
  double told_time_ = -1e9;      // at last [s]
  Pose2 told_at_;
};

}  // namespace hidwa_local_planner
