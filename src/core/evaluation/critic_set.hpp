// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "core/evaluation/rejection.hpp"
#include "hidwa_local_planner/core/critic_registry.hpp"

namespace hidwa_local_planner {

/// The critics that the parameter `critics` names, in its order, each with its weight. A critic of weight 0 is never
/// asked.
class CriticSet {
 public:
  struct Entry {
    std::string name;
    std::shared_ptr<Critic> critic;
    double weight = 0.0;
    std::unique_ptr<ParameterSource> source;  // lives as long as the critic may ask it
  };

  explicit CriticSet(CriticRegistry registry) : registry_(std::move(registry)) {}

  /// What is wrong with these names; empty where nothing is.
  std::vector<std::string> faults_of(const std::vector<std::string>& names) const;
  /// Makes and configures the critics; one that stays keeps what it remembers. With any fault nothing changes.
  std::vector<std::string> configure(const std::vector<std::string>& names, const Parameters& parameters,
                                     const SourceFor& source_for);

  std::size_t size() const { return entries_.size(); }
  const Entry& operator[](std::size_t i) const { return entries_[i]; }
  std::vector<Entry>::const_iterator begin() const { return entries_.begin(); }
  std::vector<Entry>::const_iterator end() const { return entries_.end(); }
  /// "Collision", "Braking", "Moving obstacle", "Blind", "Occlusion" or a critic's name; empty for nobody.
  std::string_view name_of(Rejecter rejecter) const;

  void prepare(const CycleView& view) const;
  void debrief(const CycleView& view, const Twist2& command) const;
  void reset() const;
  void save(ArchiveWriter& state) const;
  /// Critics that are not in the bytes stay as they are.
  void load(ArchiveReader& state) const;

 private:
  const Entry* find(const std::string& name) const;

  CriticRegistry registry_;
  std::vector<Entry> entries_;
};

}  // namespace hidwa_local_planner
