// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "hidwa_local_planner/core/parameters.hpp"
#include "input/stop_reading.hpp"

namespace hidwa_local_planner::input {

/// Whether the operator stops the robot: by button, by pulling the stick back, or in words (a topic).
///
/// A stop is easy to ask for and hard to end. A stop by mistake only costs time; a stop that is missed may cost an
/// accident.
///
/// Each sender (a node, and the kind of device that it sends for) has a stop of its own. It begins with any message
/// that asks for it, however faulty or late the rest of it is. It ends with a message of the same sender that takes it
/// back and is in order; silence does not end it. Where the sender died, somebody must dismiss() it.
///
/// A button counts from its first message on. A stick that is pulled back when it is first seen is one that
/// lies on its side: it must be seen otherwise once.
class StopRequest {
 public:
  /// A message of the node `name` with the device `device` arrived at `time` [s]. `in_order`: it is well-formed and not
  /// late.
  void take(const std::string& device, const std::string& name, const StopReading& reading, bool in_order,
            const Parameters& parameters, double time);
  /// In words: a stop for as long as it is true.
  void request(bool stop) { requested_ = stop; }
  /// Dismisses all stops. Each ends once its sender no longer asks for it; end_dismissed() finds that out.
  void dismiss();
  /// Ends the stops that are dismissed and were not asked for by any message for longer than `silence` [s] until
  /// `now` [s]. Says which, in words; empty where there is none.
  std::string end_dismissed(double now, double silence);
  /// Other parameters read the sticks. A stop by pulling goes on until it is seen otherwise.
  void demand_neutral();
  /// The clock was set back to `now` [s]: stops go on.
  void set_back(double now);

  bool requested() const;
  /// Names a sender whose stop goes on though none of its messages asked for it for longer than `silence` [s], with
  /// the remedy; empty where there is none.
  std::string advice(double now, double silence) const;

  template <typename Self, typename Archive>
  static void archive(Self& self, Archive& io) {
    io(self.requested_, self.senders_);
  }

 private:
  struct Sender {
    std::string device;
    std::string name;
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
      io(self.device, self.name, self.armed, self.button, self.pulled, self.dismissed, self.asked_at, self.axes,
         self.buttons);
    }
  };
  Sender& find(const std::string& device, const std::string& name);

  bool requested_ = false;  // in words
  std::vector<Sender> senders_;
};

}  // namespace hidwa_local_planner::input
