// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "input/message_stream.hpp"
#include "input/operator_source.hpp"

namespace hidwa_local_planner::input {

using Sources = std::vector<std::unique_ptr<OperatorSource>>;

/// Every kind of input device of this package, in the order of their rank.
Sources built_in_sources();

/// A source by one set of parameters, for whoever subscribes to its messages.
struct ListedSource {
  SourceKind kind;
  SourceTopic topic;
  bool steers = false;
  bool listened_to = false;  // its messages are taken: it steers, or its buttons count
};

/// The sources of a machine. One of them steers: the last in the list that can. The others are listened to for their
/// buttons and stops alone, or not at all.
class SourceList {
 public:
  /// A source, and what is known of its messages apart from their content.
  struct Connection {
    std::unique_ptr<OperatorSource> source;
    MessageStream stream;
    std::string fault;  // of the last message; empty where it was taken
  };
  /// By which a new set of parameters differs from the one before.
  enum class Change { none, mapping, device };

  /// At least one.
  explicit SourceList(Sources sources);

  Change configure(const Parameters& parameters);
  /// All of them by `parameters`, which need not be in force.
  std::vector<ListedSource> listed(const Parameters& parameters) const;

  /// The source that takes the message; null where no source takes its kind.
  Connection* listener(const OperatorMessage& message);
  OperatorSource& steering() { return *connections_[steering_].source; }
  const OperatorSource& steering() const { return *connections_[steering_].source; }

  std::vector<Connection>& all() { return connections_; }
  /// The node whose device of what steers is in use; empty where none is.
  const std::string& sender() const { return connections_[steering_].stream.in_use().sender; }
  void reset();

  /// The fault of each source's last message, in sentences; else empty.
  std::string faults() const;
  /// What each link does to the messages, with the remedy; else empty.
  std::string link_advice() const;

  /// What each source saves, in their order.
  void save(ArchiveWriter& state) const;
  void load(ArchiveReader& state);

 private:
  std::size_t steering_by(const Parameters& parameters) const;

  std::vector<Connection> connections_;
  std::size_t steering_ = 0;
  Parameters parameters_;
};

/// Adds a sentence to a text.
void add_sentence(std::string& text, const std::string& sentence);

}  // namespace hidwa_local_planner::input
