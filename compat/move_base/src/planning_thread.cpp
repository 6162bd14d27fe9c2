// SPDX-License-Identifier: BSD-3-Clause
#include <move_base/planning_thread.h>

#include <chrono>
#include <utility>

namespace move_base {

PlanningThread::PlanningThread(MakePlan make_plan, const Settings& settings)
    : make_plan_(std::move(make_plan)), settings_(settings), thread_(&PlanningThread::run, this) {}

PlanningThread::~PlanningThread() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    shutdown_ = true;
  }
  wake_.notify_all();
  thread_.join();
}

void PlanningThread::wake(bool at_once) {
  running_ = true;
  waiting_ = true;
  due_ = due_ || at_once;
  wake_.notify_all();
}

void PlanningThread::begin(const geometry_msgs::PoseStamped& goal) {
  const std::lock_guard<std::mutex> lock(mutex_);
  goal_ = goal;
  ++generation_;
  has_plan_ = gave_up_ = false;
  failures_ = 0;
  last_success_ = ros::Time::now();
  wake(true);
}

void PlanningThread::replan() {
  const std::lock_guard<std::mutex> lock(mutex_);
  gave_up_ = false;
  failures_ = 0;
  last_success_ = ros::Time::now();
  wake(true);
}

void PlanningThread::keepPlanning() {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (!gave_up_ && !has_plan_) wake(true);
}

void PlanningThread::halt() {
  const std::lock_guard<std::mutex> lock(mutex_);
  running_ = waiting_ = due_ = gave_up_ = has_plan_ = false;
  ++generation_;
}

bool PlanningThread::takePlan(Plan& plan) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (!has_plan_) return false;
  plan.swap(plan_);
  has_plan_ = false;
  return true;
}

bool PlanningThread::gaveUp() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return gave_up_;
}

void PlanningThread::store(bool found, Plan&& plan, unsigned int generation) {
  if (generation != generation_ || !running_) return;
  if (found) {
    plan_ = std::move(plan);
    has_plan_ = true;
    waiting_ = due_ = false;
    failures_ = 0;
    last_success_ = ros::Time::now();
    if (!(settings_.frequency > 0.0)) running_ = false;
  } else if (waiting_) {
    ++failures_;
    const bool out_of_time = ros::Time::now() > last_success_ + ros::Duration(settings_.patience);
    const bool out_of_tries = settings_.max_retries >= 0 && failures_ > settings_.max_retries;
    if (out_of_time || out_of_tries) {
      gave_up_ = true;
      running_ = due_ = false;
    }
  }
}

void PlanningThread::run() {
  // Simulated time may run at any speed or stand still: the period is watched in short waits.
  constexpr auto kGlance = std::chrono::milliseconds(5);
  std::unique_lock<std::mutex> lock(mutex_);
  ros::Time next;
  while (!shutdown_) {
    const bool periodic = running_ && settings_.frequency > 0.0;
    if (!running_) {
      wake_.wait(lock);
      continue;
    }
    if (!due_ && periodic && ros::Time::now() < next) {
      wake_.wait_for(lock, kGlance);
      continue;
    }
    due_ = false;
    const geometry_msgs::PoseStamped goal = goal_;
    const unsigned int generation = generation_;
    const ros::Time begun = ros::Time::now();
    lock.unlock();
    Plan plan;
    const bool found = make_plan_(goal, plan);
    lock.lock();
    store(found, std::move(plan), generation);
    if (settings_.frequency > 0.0) next = begun + ros::Duration(1.0 / settings_.frequency);
  }
}

}  // namespace move_base
