// SPDX-License-Identifier: BSD-3-Clause
// What the host is told where no way leads on: how far the robot would come, and what is in its way there.
#pragma once

#include <string>

#include "core/search/way_search.hpp"

namespace hidwa_local_planner {

class NoWayReport {
 public:
  /// Empty where nothing is to be told. Valid until the next call of another function.
  const std::string& problem() const { return problem_; }
  void clear() { problem_.clear(); }
  /// From now on this is told. `end`: where the search came to.
  void tell(const char* what, const WaySearch::End& end);
  void tell(const char* what);

  /// That a search takes long is told in one cycle, and again only elsewhere or after 20 s: a host that plans anew
  /// each time, and begins afresh then, would be told again and again. `long_search`: the search takes long now, from
  /// `start`.
  bool tells_late(bool long_search, const Pose2& start, double now);
  /// Another search begins.
  void begin_search() { told_late_ = false; }

  template <typename Self, typename Archive>
  static void archive(Self& self, Archive& io) {
    io(self.problem_, self.told_late_, self.told_at_time_, self.told_at_);
  }

 private:
  std::string problem_;
  bool told_late_ = false;      // in the last cycle
  double told_at_time_ = -1e9;  // the last time [s]
  Pose2 told_at_;
};

}  // namespace hidwa_local_planner
