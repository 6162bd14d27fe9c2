// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "tracking/track.hpp"

namespace hidwa_local_planner {
namespace tracking {

/// Gives each segment to the track that it fits best: of all pairs within the gate the one with the least mismatch
/// first (global nearest neighbour), confirmed tracks before the others. A track takes one body, the pieces of one, or
/// two legs.
class Association {
 public:
  /// Sets Segment::track and the segments of each track. Tracks are at the time of the scan.
  void assign(const Beams& beams, const TrackerSettings& settings, std::vector<Segment>& segments,
              std::vector<Track>& tracks);
  /// After assign(): whether the pair may hold the legs of two people. A leg that belongs to no pair is near one of
  /// them then.
  bool may_mix_legs(const Track& pair, const std::vector<Segment>& segments, const std::vector<Track>& tracks) const;

 private:
  struct Pair {
    double mismatch;
    std::size_t track;
    std::size_t segment;
    bool confirmed;
  };
  std::vector<Pair> pairs_;
  std::vector<BodyFit> fits_;  // of the segments
};

}  // namespace tracking
}  // namespace hidwa_local_planner
