// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "hidwa_local_planner/core/parameters.hpp"
#include "hidwa_local_planner/input/stick_source.hpp"

namespace hidwa_local_planner::input {

/// Whether the person wants the robot to stop: by button, by pulling the stick back, or in words (a topic).
/// It lasts until a message takes it back: silence does not.
///
/// A button counts from its first message on. A stick that is pulled back when it is first seen is one that
/// lies on its side: it must be seen otherwise once.
class StopRequest {
 public:
  void take(const StickReading& reading, const Parameters& parameters);
  void say(bool stop) { said_ = stop; }
  /// Another stick, or the same one read in another way. A stop by pulling goes on until it is seen otherwise.
  void demand_neutral() { armed_ = pulled_; }
  void reset() { *this = StopRequest(); }

  bool requested() const { return button_ || pulled_ || said_; }

  template <typename Self, typename Archive>
  static void archive(Self& self, Archive& io) {
    io(self.armed_, self.button_, self.pulled_, self.said_);
  }

 private:
  bool armed_ = false;  // the stick was seen not pulled
  bool button_ = false;
  bool pulled_ = false;
  bool said_ = false;
};

}  // namespace hidwa_local_planner::input
