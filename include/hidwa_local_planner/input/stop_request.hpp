// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "hidwa_local_planner/core/parameters.hpp"
#include "hidwa_local_planner/input/stick_source.hpp"

namespace hidwa_local_planner::input {

/// Whether the person wants the robot to stop: by button, by pulling the stick back, or in words (a topic).
///
/// Each sender has a stop of its own. It begins with any message that asks for it, however faulty or late the rest of
/// it is. It ends with a message of the same sender that takes it back and is in order; silence does not end it. Where
/// the sender died, somebody must dismiss() it.
///
/// A button counts from its first message on. A stick that is pulled back when it is first seen is one that
/// lies on its side: it must be seen otherwise once.
class StopRequest {
 public:
  /// A message of `sender` arrived at `time` [s]. `in_order`: it is well-formed and not late.
  void hear(const std::string& sender, const StopReading& reading, bool in_order, const Parameters& parameters,
            double time);
  void say(bool stop) { said_ = stop; }
  /// Every sender's stop ends once its sender does not ask for it any more, which check() finds out.
  void dismiss();
  /// Ends the stops that are dismissed and were not asked for by any message for longer than `silence` [s] until
  /// `now` [s]. Says which, in words; empty where there is none.
  std::string check(double now, double silence);
  /// Other parameters read the sticks. A stop by pulling goes on until it is seen otherwise.
  void demand_neutral();
  /// The clock was set back to `now` [s]: stops go on.
  void set_back(double now);
  void reset() { *this = StopRequest(); }

  bool requested() const;
  /// Names a sender whose stop goes on though none of its messages asked for it for longer than `silence` [s], with
  /// the remedy; empty where there is none.
  std::string advice(double now, double silence) const;

  template <typename Self, typename Archive>
  static void archive(Self& self, Archive& io) {
    io(self.said_, self.sources_);
  }

 private:
  struct Source {
    std::string sender;
    bool armed = false;  // the stick was seen not pulled
    bool button = false;
    bool pulled = false;
    bool dismissed = false;
    double asked_at = 0.0;   // newest message that asked for the stop [s]
    std::uint32_t axes = 0;  // so many the newest message in order had
    std::uint32_t buttons = 0;

    bool stops() const { return button || pulled; }
    bool unasked(double now, double silence) const { return stops() && now - asked_at > silence; }
    template <typename Self, typename Archive>
    static void archive(Self& self, Archive& io) {
      io(self.sender, self.armed, self.button, self.pulled, self.dismissed, self.asked_at, self.axes, self.buttons);
    }
  };
  Source& source_of(const std::string& sender);

  bool said_ = false;
  std::vector<Source> sources_;
};

}  // namespace hidwa_local_planner::input
