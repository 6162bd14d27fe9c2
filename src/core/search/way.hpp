// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "hidwa_local_planner/core/types.hpp"

namespace hidwa_local_planner {

class CollisionChecker;

/// A way that was found: poses, and how long it takes from each of them to the end.
///
/// The remaining time from a pose beside it is that from the nearest point of it, and the time to get there: the way is
/// a line through (x, y, heading), on which a radian is as long as 0.4 m.
class Way {
 public:
  /// Within the room that a way has the robot gets back to it at this speed [m/s].
  static constexpr double kBackSpeed = 0.1;

  struct Station {
    Pose2 pose;         // costmap frame
    double left = 0.0;  // to the end [s]
    template <typename Self, typename Archive>
    static void archive(Self& self, Archive& io) {
      io(self.pose, self.left);
    }
  };
  struct Projection {
    std::size_t part = 0;  // from this station to the next
    double left = 0.0;     // from there to the end [s]
    double off = 0.0;      // the distance to it [m]
    double back = 0.0;     // the time to get there [s]
    /// From the pose that was asked about [s].
    double remaining() const { return left + back; }
  };

  void clear() { stations_.clear(); }
  void reserve(std::size_t count) { stations_.reserve(count); }
  void add(const Station& station) { stations_.push_back(station); }
  /// Turns the order of the stations round.
  void reverse();
  /// A station between two parts that drive in the same direction goes to the mean of its neighbours and, twice,
  /// itself, where `may_go(from, to)`, of two poses, allows it. Times stay as they are.
  template <typename MayGo>
  void smooth(const MayGo& may_go);

  bool empty() const { return stations_.empty(); }
  const std::vector<Station>& stations() const { return stations_; }
  double duration() const { return stations_.empty() ? 0.0 : stations_.front().left; }  // [s]
  /// The projection with the least remaining time among the parts from `from` on, before `end`. The robot gets back to
  /// its way at kBackSpeed within the `room` [m] that the way has, and at 0.04 m/s where nothing is known to be free:
  /// the lower that is, the closer it keeps to it. The way must not be empty.
  Projection nearest(const Pose2& pose, std::size_t from, std::size_t end, double room) const;
  /// How long it takes from its beginning to the first station that is so `near` [m] to a pose, whatever the heading;
  /// all of its duration where none is [s].
  double time_until_near(const Pose2& pose, double near) const;
  /// Up to which part the way counts for a robot on part `from`: up to `ahead` [s] later, and up to where it turns
  /// back, forwards to backwards or the other way round, until the robot is within `near` [m] of there.
  std::size_t end_of_parts(const Pose2& pose, std::size_t from, double ahead, double near) const;
  /// The smallest clearance of the stations that come up to three seconds after station `part`, on the map that
  /// `collision` is prepared with; at most a cell, `cell` [m].
  double room_ahead(std::size_t part, const CollisionChecker& collision, double cell) const;
  /// How the robot drives next from part `from` on: 1 forwards, -1 backwards, 0 not at all.
  int direction_from(std::size_t from) const;

  template <typename Self, typename Archive>
  static void archive(Self& self, Archive& io) {
    io(self.stations_);
  }

 private:
  int direction_of(std::size_t part) const;
  bool lies_between(const Pose2& before, std::size_t k, bool stayed) const;
  static int direction_between(const Pose2& a, const Pose2& b);
  static Pose2 mean_of(const Pose2& before, const Pose2& own, const Pose2& next);
  Projection project(const Pose2& pose, std::size_t part, double room) const;

  std::vector<Station> stations_;
};

template <typename MayGo>
void Way::smooth(const MayGo& may_go) {
  Pose2 before;  // where the last one was
  bool stayed = true;
  for (std::size_t k = 0; k + 1 < stations_.size(); ++k) {
    const Pose2 own = stations_[k].pose;
    const bool between = k > 0 && lies_between(before, k, stayed);
    const Pose2 to = between ? mean_of(before, own, stations_[k + 1].pose) : own;
    stayed = !between || !may_go(own, to);
    if (!stayed) stations_[k].pose = to;
    before = own;
  }
}

}  // namespace hidwa_local_planner
