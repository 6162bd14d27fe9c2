// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "ways/result.hpp"

namespace hidwa_ways {

/// Of the scenes of one kind and one outline, or of all.
struct Summary {
  std::string kind, body;
  int scenes = 0;
  int sure = 0, nearer = 0, through = 0, unverified = 0;
  int none = 0, failed = 0, none_through = 0;  // without a way: said so in time; got through nevertheless
  int open = 0, open_through = 0;
  int contacts = 0;
  double worst_cycle = 0.0;  // [s]

  void add(const Result& result);
  /// The bars: no contact, 99.9 % nearer, 99.5 % through, and all without a way say so.
  bool held() const;
};

/// One of each kind and outline, in the order of their first result; the last one is of all.
std::vector<Summary> summaries_of(const std::vector<Result>& results);

}  // namespace hidwa_ways
