// SPDX-License-Identifier: BSD-3-Clause
#include "core/evaluation/critic_set.hpp"

#include <algorithm>
#include <limits>
#include <utility>

namespace hidwa_local_planner {
namespace {

constexpr std::size_t kMostCritics = 200;
static_assert(kFirstCritic + kMostCritics <= std::numeric_limits<Rejecter>::max());

}  // namespace

std::vector<std::string> CriticSet::faults_of(const std::vector<std::string>& names) const {
  std::vector<std::string> faults;
  for (const std::string& name : names) {
    if (registry_.knows(name)) continue;
    std::string known;
    for (const std::string& other : registry_.names()) known += " " + other;
    faults.push_back("critics: no critic named " + name + "; there are" + known);
  }
  if (names.size() > kMostCritics) {
    faults.push_back("critics: more than " + std::to_string(kMostCritics) + "; name fewer");
  }
  return faults;
}

const CriticSet::Entry* CriticSet::find(const std::string& name) const {
  const auto found =
      std::find_if(entries_.begin(), entries_.end(), [&](const Entry& entry) { return entry.name == name; });
  return found == entries_.end() ? nullptr : &*found;
}

std::vector<std::string> CriticSet::configure(const std::vector<std::string>& names, const Parameters& parameters,
                                              const SourceFor& source_for) {
  std::vector<Entry> entries;
  std::vector<std::string> faults;
  for (const std::string& name : names) {
    const Entry* kept = find(name);
    const bool twice =
        std::any_of(entries.begin(), entries.end(), [&](const Entry& entry) { return entry.name == name; });
    Entry entry;
    entry.name = name;
    entry.critic = kept != nullptr && !twice ? kept->critic : registry_.make(name);
    if (!entry.critic) return {"critics: " + name + " is known but could not be made: look at its package's library"};
    if (source_for) entry.source = source_for(name);
    if (!entry.source) entry.source = std::make_unique<ParameterSource>();
    entry.weight = entry.critic->configure(parameters, *entry.source);
    for (const std::string& fault : entry.source->faults()) faults.push_back(fault);
    entries.push_back(std::move(entry));
  }
  if (faults.empty()) entries_ = std::move(entries);
  return faults;
}

std::string_view CriticSet::name_of(Rejecter rejecter) const {
  constexpr std::string_view kNames[] = {"", "Collision", "Braking", "Moving obstacle", "Blind", "Occlusion"};
  if (rejecter < kFirstCritic) return kNames[rejecter];
  return entries_[static_cast<std::size_t>(rejecter - kFirstCritic)].name;
}

void CriticSet::prepare(const CycleView& view) const {
  for (const Entry& entry : entries_) {
    if (entry.weight != 0.0) entry.critic->prepare(view);
  }
}

void CriticSet::debrief(const CycleView& view, const Twist2& command) const {
  for (const Entry& entry : entries_) {
    if (entry.weight != 0.0) entry.critic->debrief(view, command);
  }
}

void CriticSet::reset() const {
  for (const Entry& entry : entries_) entry.critic->reset();
}

void CriticSet::save(ArchiveWriter& state) const {
  state(static_cast<std::uint32_t>(entries_.size()));
  for (const Entry& entry : entries_) {
    Bytes own;
    ArchiveWriter write_own(own);
    entry.critic->save(write_own);
    state(entry.name, own);
  }
}

void CriticSet::load(ArchiveReader& state) const {
  std::uint32_t count = 0;
  state(count);
  for (std::uint32_t i = 0; i < count && !state.failed(); ++i) {
    std::string name;
    Bytes own;
    state(name, own);
    const Entry* entry = find(name);
    if (entry == nullptr) continue;
    ArchiveReader read_own(own);
    entry->critic->load(read_own);
  }
}

}  // namespace hidwa_local_planner
