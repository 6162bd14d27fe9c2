// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include <console_bridge/console.h>

namespace hidwa_local_planner::robot {

/// Takes the errors that urdfdom logs on this thread about a text, while it lives; what other threads log goes where it
/// went.
///
/// urdfdom gives what it reports, names of the text included, to printf as the format: "%s" in a name ends the program.
/// Of a text that could hold a format nothing is logged at all, by no thread.
class UrdfLog : public console_bridge::OutputHandler {
 public:
  explicit UrdfLog(const std::string& text);
  ~UrdfLog() override;
  UrdfLog(const UrdfLog&) = delete;
  UrdfLog& operator=(const UrdfLog&) = delete;

  /// The first errors in one line, or why there are none.
  std::string errors() const;

  void log(const std::string& text, console_bridge::LogLevel level, const char* file, int line) override;

 private:
  std::unique_lock<std::mutex> alone_;  // of all UrdfLogs
  console_bridge::OutputHandler* before_;
  bool silent_;
  std::thread::id thread_;
  std::vector<std::string> errors_;
};

}  // namespace hidwa_local_planner::robot
