// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include <console_bridge/console.h>

namespace hidwa_local_planner::robot {

/// Takes the errors that urdfdom logs on this thread, while it lives; what other threads log goes where it
/// went.
class UrdfLog : public console_bridge::OutputHandler {
 public:
  UrdfLog();
  ~UrdfLog() override;
  UrdfLog(const UrdfLog&) = delete;
  UrdfLog& operator=(const UrdfLog&) = delete;

  /// The first errors in one line; empty where there were none.
  std::string errors() const;

  void log(const std::string& text, console_bridge::LogLevel level, const char* file, int line) override;

 private:
  std::unique_lock<std::mutex> alone_;  // of all UrdfLogs
  console_bridge::OutputHandler* before_;
  std::thread::id thread_;
  std::vector<std::string> errors_;
};

}  // namespace hidwa_local_planner::robot
