// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <memory>
#include <string>

#include "hidwa_local_planner/core/critic.hpp"

namespace hidwa_local_planner {

/// A critic of another package, which may be wrong. Where it throws, all candidates of that cycle are rejected in its
/// name: the robot brakes within its limits, then stands. The next cycle asks it anew. Where it keeps a cycle waiting
/// it is named. Only configure() throws: a std::runtime_error that names the critic.
class GuardedCritic : public Critic {
 public:
  GuardedCritic(std::string name, std::shared_ptr<Critic> critic);

  double configure(const Parameters& parameters, const ParameterSource& own) override;
  void prepare(const CycleView& cycle) override;
  void score(const CycleView& cycle, const Tile& tile, TileScores& scores) override;
  void debrief(const CycleView& cycle, const Twist2& command) override;
  void reset() override;
  void save(ArchiveWriter& state) const override;
  void load(ArchiveReader& state) override;

 private:
  template <typename Call>
  bool succeeds(const char* what, Call call) const;
  bool due() const;
  void complain_of_numbers(TileScores& scores) const;
  template <typename Call>
  bool succeeds_in_time(const char* what, Call call);

  const std::string name_;
  const std::shared_ptr<Critic> critic_;
  bool prepared_ = true;
  double spent_ = 0.0;                                          // in this cycle [s]
  mutable std::chrono::steady_clock::time_point silent_until_;  // says nothing more before
};

}  // namespace hidwa_local_planner
