// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <geometry_msgs/PoseStamped.h>
#include <ros/time.h>

#include <condition_variable>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace move_base {

/// Makes global plans on a thread of its own: at once when asked, and then every 1/frequency while it runs.
class PlanningThread {
 public:
  typedef std::vector<geometry_msgs::PoseStamped> Plan;
  typedef std::function<bool(const geometry_msgs::PoseStamped& goal, Plan& plan)> MakePlan;

  struct Settings {
    double frequency = 0.0;  // [Hz] 0: only when asked
    double patience = 5.0;   // [s] without a plan before giving up
    int max_retries = -1;    // attempts before giving up; -1: no limit
  };

  PlanningThread(MakePlan make_plan, const Settings& settings);
  ~PlanningThread();
  PlanningThread(const PlanningThread&) = delete;
  PlanningThread& operator=(const PlanningThread&) = delete;

  /// Plans for a new goal; what was planned for an older one is dropped. Failures count from now.
  void begin(const geometry_msgs::PoseStamped& goal);
  /// The controller cannot go on without a new plan: plans at once, failures count from now.
  void replan();
  /// The controller still waits.
  void keepPlanning();
  /// No more plans until asked.
  void halt();

  /// The newest plan not yet taken; false when there is none.
  bool takePlan(Plan& plan);
  /// True once no plan was found within patience or retries while the controller was waiting; the thread then
  /// rests.
  bool gaveUp() const;

 private:
  void run();
  void wake(bool at_once);
  void store(bool found, Plan&& plan, unsigned int generation);

  const MakePlan make_plan_;
  const Settings settings_;

  mutable std::mutex mutex_;
  std::condition_variable wake_;
  geometry_msgs::PoseStamped goal_;
  unsigned int generation_ = 0;  // of the goal
  bool running_ = false;
  bool due_ = false;      // plan without waiting for the period to pass
  bool waiting_ = false;  // the controller has no plan to follow
  bool gave_up_ = false;
  bool shutdown_ = false;
  bool has_plan_ = false;
  Plan plan_;
  ros::Time last_success_;
  int failures_ = 0;
  std::thread thread_;
};

}  // namespace move_base
