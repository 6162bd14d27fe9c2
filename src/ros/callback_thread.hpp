// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/callback_queue.h>
#include <ros/node_handle.h>
#include <ros/spinner.h>

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
  /// No callback runs after it returns.
  void stop() {
    spinner_.stop();
    queue_.disable();
    queue_.clear();
  }

 private:
  ros::CallbackQueue queue_;
  ros::AsyncSpinner spinner_;
};

}  // namespace hidwa_local_planner
