// SPDX-License-Identifier: BSD-3-Clause
#include "ways/summary.hpp"

#include <algorithm>

namespace hidwa_ways {

void Summary::add(const Result& result) {
  ++scenes;
  contacts += result.touched ? 1 : 0;
  worst_cycle = std::max(worst_cycle, result.worst_cycle);
  switch (result.answer) {
    case Class::sure:
      ++sure;
      nearer += result.nearer() ? 1 : 0;
      through += result.through() ? 1 : 0;
      unverified += result.verified ? 0 : 1;
      break;
    case Class::none:
      ++none;
      failed += result.failed_late || result.through_at >= 0.0 ? 0 : 1;
      none_through += result.through_at >= 0.0 ? 1 : 0;
      break;
    case Class::open:
      ++open;
      open_through += result.through() ? 1 : 0;
      break;
  }
}

bool Summary::held() const {
  return contacts == 0 && unverified == 0 && none_through == 0 && failed == none && nearer >= 0.999 * sure &&
         through >= 0.995 * sure;
}

std::vector<Summary> summaries_of(const std::vector<Result>& results) {
  std::vector<Summary> summaries;
  Summary all;
  all.kind = all.body = "all";
  for (const Result& result : results) {
    auto found = std::find_if(summaries.begin(), summaries.end(),
                              [&](const Summary& s) { return s.kind == result.kind && s.body == result.body; });
    if (found == summaries.end()) {
      summaries.emplace_back();
      found = summaries.end() - 1;
      found->kind = result.kind;
      found->body = result.body;
    }
    found->add(result);
    all.add(result);
  }
  summaries.push_back(all);
  return summaries;
}

}  // namespace hidwa_ways
