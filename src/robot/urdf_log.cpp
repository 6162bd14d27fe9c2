// SPDX-License-Identifier: BSD-3-Clause
#include "urdf_log.hpp"

#include <algorithm>

namespace hidwa_local_planner::robot {
namespace {

std::mutex& only_one() {
  static std::mutex mutex;
  return mutex;
}

// A % as it is, or as a character's number ("&#37;", "&#x25;").
bool may_hold_format(const std::string& text) {
  return text.find('%') != std::string::npos || text.find("&#") != std::string::npos;
}

}  // namespace

UrdfLog::UrdfLog(const std::string& text)
    : alone_(only_one()),
      before_(console_bridge::getOutputHandler()),
      silent_(may_hold_format(text)),
      thread_(std::this_thread::get_id()) {
  if (silent_) {
    console_bridge::noOutputHandler();
  } else {
    console_bridge::useOutputHandler(this);
  }
}

UrdfLog::~UrdfLog() {
  console_bridge::useOutputHandler(before_);
  console_bridge::useOutputHandler(before_);  // nobody gets this one back as the handler before
}

std::string UrdfLog::errors() const {
  if (silent_) return "where is not known: urdfdom cannot report about a text with a % or a &#";
  if (errors_.empty()) return "no <robot> in it";
  constexpr std::size_t kMost = 3;
  std::string text;
  for (std::size_t i = 0; i < std::min(kMost, errors_.size()); ++i) text += (i == 0 ? "" : "; ") + errors_[i];
  return text;
}

void UrdfLog::log(const std::string& text, console_bridge::LogLevel level, const char* file, int line) {
  if (std::this_thread::get_id() != thread_) {
    if (before_ != nullptr) before_->log(text, level, file, line);
  } else if (level >= console_bridge::CONSOLE_BRIDGE_LOG_ERROR) {
    errors_.push_back(text);
  }
}

}  // namespace hidwa_local_planner::robot
