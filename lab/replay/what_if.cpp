// SPDX-License-Identifier: BSD-3-Clause
#include "what_if.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "options.hpp"
#include "words.hpp"

namespace hidwa_local_planner {
namespace replay {
namespace {

std::string csv_row(double time, bool same, const record::CycleRecord& was, const record::ReplayedCycle& is) {
  const record::DecisionRecord &a = was.decision, &b = is.decision;
  return format("%.3f,%d,%s,%s,%.9g,%.9g,%.9g,%.9g,%s,%s,%.9g,%.9g,%.9g,%.9g,%.9g,%.9g\n", time, same ? 0 : 1,
                to_string(a.outcome), to_string(b.outcome), a.command.v, a.command.omega, b.command.v, b.command.omega,
                to_string(was.intent.state), to_string(is.intent.state), was.intent.u_h.v, was.intent.u_h.omega,
                is.intent.u_h.v, is.intent.u_h.omega, a.total, b.total);
}

}  // namespace

WhatIf::WhatIf(const std::string& csv) {
  if (csv.empty()) return;
  csv_.open(csv);
  csv_ << "time,differs,outcome,new_outcome,v,omega,new_v,new_omega,state,new_state,wanted_v,wanted_omega,"
          "new_wanted_v,new_wanted_omega,total,new_total\n";
  if (!csv_) throw UsageError(csv + " cannot be written");
}

bool WhatIf::differs(const record::CycleRecord& recorded, const record::ReplayedCycle& replayed) const {
  if (replayed.identical || !csv_.is_open()) return !replayed.identical;
  const record::DecisionRecord &was = recorded.decision, &is = replayed.decision;
  return was.outcome != is.outcome || !(was.command == is.command) ||
         !record::identical(recorded.intent, replayed.intent);
}

void WhatIf::add(double time, const record::CycleRecord& recorded, const record::ReplayedCycle& replayed) {
  const bool different = differs(recorded, replayed);
  if (csv_.is_open()) csv_ << csv_row(time, !different, recorded, replayed);
  sums_ += !different && !replayed.identical ? 1 : 0;
  if (!different) return;
  const record::DecisionRecord &was = recorded.decision, &is = replayed.decision;
  outcomes_ += was.outcome != is.outcome ? 1 : 0;
  intents_ += record::identical(recorded.intent, replayed.intent) ? 0 : 1;
  commands_ += was.command == is.command ? 0 : 1;
  const double dv = std::abs(is.command.v - was.command.v), domega = std::abs(is.command.omega - was.command.omega);
  v_ += dv;
  omega_ += domega;
  most_v_ = std::max(most_v_, dv);
  most_omega_ = std::max(most_omega_, domega);
  if (differences_ == 0) std::puts("     t [s]  recorded                                replayed");
  if (differences_++ < kShown) {
    std::puts(
        format("%10.3f  %-38s  %-38s%s", time, in_words(was).c_str(), in_words(is).c_str(),
               was.command == is.command && was.outcome == is.outcome ? "  (other totals or operator commands)" : "")
            .c_str());
  }
}

std::string WhatIf::summary() const {
  const std::string sums = sums_ > 0 ? format("%ld more have other totals and the same command", sums_) : "";
  if (differences_ == 0) return sums;
  std::string text = differences_ > kShown ? format("      ...  and %ld more\n", differences_ - kShown) : "";
  const auto count = static_cast<double>(differences_);
  text += format("where they differ: %ld commands, by %.4f m/s and %.4f rad/s on average, %.4f and %.4f at most; ",
                 commands_, v_ / count, omega_ / count, most_v_, most_omega_);
  text += format("%ld outcomes, %ld operator commands", outcomes_, intents_);
  return text + (sums.empty() ? "" : "\n") + sums;
}

}  // namespace replay
}  // namespace hidwa_local_planner
