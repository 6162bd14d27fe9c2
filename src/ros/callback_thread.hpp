// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <future>

#include <ros/callback_queue.h>
#include <ros/node_handle.h>
#include <ros/spinner.h>
#include <boost/make_shared.hpp>

namespace hidwa_local_planner {

/// A callback queue with its own thread: its callbacks wait for no other queue. Must outlive every subscriber, server
/// and timer made with a handle that it serves; stop() it before they go.
class CallbackThread {
 public:
  CallbackThread() : spinner_(1, &queue_) {}
  ~CallbackThread() { stop(); }
  CallbackThread(const CallbackThread&) = delete;
  CallbackThread& operator=(const CallbackThread&) = delete;

  /// The same handle, its callbacks served by this thread.
  ros::NodeHandle serve(ros::NodeHandle handle) {
    handle.setCallbackQueue(&queue_);
    return handle;
  }
  void start() { spinner_.start(); }
  /// Waits until the callbacks that are due now have run, at most for `patience`. Not from one of them, and not while
  /// holding a lock that one of them needs.
  void catch_up(std::chrono::microseconds patience) {
    const auto mark = boost::make_shared<Mark>();
    const std::future<void> reached = mark->reached.get_future();
    queue_.addCallback(mark);
    reached.wait_for(patience);
  }
  /// No callback runs after it returns.
  void stop() {
    spinner_.stop();
    queue_.disable();
    queue_.clear();
  }

 private:
  struct Mark : ros::CallbackInterface {
    CallResult call() override {
      reached.set_value();
      return Success;
    }
    std::promise<void> reached;
  };

  ros::CallbackQueue queue_;
  ros::AsyncSpinner spinner_;
};

}  // namespace hidwa_local_planner
