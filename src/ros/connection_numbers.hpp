// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <deque>

#include <ros/datatypes.h>
#include <boost/shared_ptr.hpp>

namespace hidwa_local_planner {

/// Numbers of the connections of one subscriber. roscpp gives each connection a header of its own, and all messages of
/// a connection share it.
class ConnectionNumbers {
 public:
  using Header = boost::shared_ptr<ros::M_string>;
  static constexpr std::size_t kRemembered = 16;  // publishers of one topic at a time

  /// The number of the connection with this header, counted from 1; a header that is not among those seen last begins a
  /// new connection.
  std::uint64_t of(const Header& header) {
    const auto known = std::find_if(connections_.begin(), connections_.end(),
                                    [&](const Connection& connection) { return connection.header == header; });
    if (known != connections_.end()) return known->number;
    if (connections_.size() == kRemembered) connections_.pop_front();
    connections_.push_back({header, ++newest_});
    return newest_;
  }

 private:
  struct Connection {
    Header header;  // it is held, so that no later one lies at the same address
    std::uint64_t number;
  };
  std::deque<Connection> connections_;  // the oldest first
  std::uint64_t newest_ = 0;
};

}  // namespace hidwa_local_planner
