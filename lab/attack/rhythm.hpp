// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <deque>

#include "random.hpp"
#include "spec.hpp"

namespace hidwa_attack {

/// When the control cycles are, and what a host measures of that.
class Rhythm {
 public:
  Rhythm(const Spec& spec, std::uint64_t seed)
      : period_(spec.period),
        share_(spec.late_share),
        most_(spec.late_most),
        catches_up_(spec.catches_up),
        surprises_(spec.surprises),
        again_(spec.late_again),
        random_(seed) {
    // The host has run before, and was late.
    if (share_ > 0.0 || again_) cycles_ = {-latest(), 0};
  }

  bool due(int now) const { return now >= next_; }
  /// A cycle takes place at `now` [ms].
  void tick(int now) {
    if (cycles_.empty() || now > cycles_.back()) cycles_.push_back(now);
    while (cycles_.front() < now - kMemory) cycles_.pop_front();
  }
  /// When the next one is. A host that catches up keeps to its grid until it is a whole period behind. Where the
  /// robot does not rest the next one is no later than longest(), unless the spec asks for surprises.
  void plan_next(int now, bool rests) {
    const bool keeps = catches_up_ && now - grid_ <= period_;
    if (again_) return plan_again(now);
    grid_ = (keeps ? grid_ : now) + period_;
    next_ = std::max(grid_ + lateness(), now + 1);
    if (!surprises_ && !rests) next_ = std::min(next_, now + static_cast<int>(std::lround(1e3 * longest())));
  }
  /// The larger of the period and the longest interval of the last 3 s, which counts up to three periods [s].
  double longest() const {
    int most = period_;
    for (std::size_t k = 1; k < cycles_.size(); ++k) most = std::max(most, cycles_[k] - cycles_[k - 1]);
    return 1e-3 * std::min(most, 3 * period_);
  }

  /// What the host measured before the first cycle [s]; 0 where it was on time.
  double before() const { return share_ > 0.0 || again_ ? 1e-3 * latest() : 0.0; }

 private:
  static constexpr int kMemory = 3000;  // [ms]
  int latest() const { return static_cast<int>((1.0 + most_) * period_); }
  // A late cycle counts for 3 s and for the period after them: the last cycle that knows of it is followed by the next.
  void plan_again(int now) {
    const bool last_to_know = now + period_ > late_at_ + kMemory + period_;
    next_ = now + (last_to_know ? latest() : period_);
    if (last_to_know) late_at_ = next_;
  }
  int lateness() { return random_.chance(share_) ? static_cast<int>(random_.in(0.0, most_) * period_) : 0; }

  int period_;  // [ms]
  double share_, most_;
  bool catches_up_, surprises_, again_;
  Random random_;
  int grid_ = 0, next_ = 0;  // when the cycle should be, and when it is [ms]
  int late_at_ = 0;          // the last cycle that was as late as it may be [ms]
  std::deque<int> cycles_;   // [ms]
};

}  // namespace hidwa_attack
