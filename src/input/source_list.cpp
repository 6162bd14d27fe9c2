// SPDX-License-Identifier: BSD-3-Clause
#include "input/source_list.hpp"

#include <utility>

namespace hidwa_local_planner::input {

SourceList::SourceList(Sources sources) {
  for (std::unique_ptr<OperatorSource>& source : sources) {
    connections_.emplace_back();
    connections_.back().source = std::move(source);
  }
}

SourceList::Change SourceList::configure(const Parameters& parameters) {
  Change change = Change::none;
  for (const Connection& connection : connections_) {
    const OperatorSource& source = *connection.source;
    if (!source.same_device(parameters, parameters_)) change = Change::device;
    if (change == Change::none && !source.same_mapping(parameters, parameters_)) change = Change::mapping;
  }
  parameters_ = parameters;
  steering_ = steering_by(parameters);
  for (std::size_t i = 0; i < connections_.size(); ++i) connections_[i].source->configure(parameters, i == steering_);
  return change;
}

std::vector<ListedSource> SourceList::listed(const Parameters& parameters) const {
  const bool off = parameters.mode == OperatorMode::off;
  const std::size_t steering = steering_by(parameters);
  std::vector<ListedSource> all;
  for (std::size_t i = 0; i < connections_.size(); ++i) {
    const OperatorSource& source = *connections_[i].source;
    ListedSource listed{source.kind(), source.topic(parameters)};
    listed.steers = !off && i == steering;
    listed.listened_to = listed.steers || (!off && listed.kind.has_buttons);
    all.push_back(std::move(listed));
  }
  return all;
}

SourceList::Connection* SourceList::listener(const OperatorMessage& message) {
  if (parameters_.mode == OperatorMode::off) return nullptr;
  for (std::size_t i = 0; i < connections_.size(); ++i) {
    const OperatorSource& source = *connections_[i].source;
    if (source.takes(message) && (i == steering_ || source.kind().has_buttons)) return &connections_[i];
  }
  return nullptr;
}

void SourceList::reset() {
  for (Connection& connection : connections_) {
    connection.source->reset();
    connection.stream.reset();
    connection.fault.clear();
  }
}

std::string SourceList::faults() const {
  std::string text;
  for (const Connection& connection : connections_) {
    if (!connection.fault.empty()) add_sentence(text, "The last message was dropped: " + connection.fault + ".");
  }
  return text;
}

std::string SourceList::link_advice() const {
  std::string text;
  for (const Connection& connection : connections_) {
    add_sentence(text, connection.stream.advice(connection.source->topic(parameters_).parameter));
  }
  return text;
}

void SourceList::save(ArchiveWriter& state) const {
  for (const Connection& connection : connections_) connection.source->save(state);
}

void SourceList::load(ArchiveReader& state) {
  for (Connection& connection : connections_) {
    connection.source->reset();  // a source may know more than it saves
    connection.source->load(state);
  }
}

std::size_t SourceList::steering_by(const Parameters& parameters) const {
  std::size_t steering = 0;
  for (std::size_t i = 0; i < connections_.size(); ++i) {
    if (connections_[i].source->can_steer(parameters)) steering = i;
  }
  return steering;
}

void add_sentence(std::string& text, const std::string& sentence) {
  if (!text.empty() && !sentence.empty()) text += ' ';
  text += sentence;
}

}  // namespace hidwa_local_planner::input
