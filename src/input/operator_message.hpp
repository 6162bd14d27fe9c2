// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <memory>
#include <string>

namespace hidwa_local_planner::input {

/// How many axes and buttons a device has: a message with other numbers comes from another device.
struct DeviceShape {
  std::size_t axes = 0;
  std::size_t buttons = 0;
};

/// What every message of an input device has. Each kind of device derives its own message from it, as plain values.
struct OperatorMessage {
  virtual ~OperatorMessage() = default;
  virtual DeviceShape shape() const { return {}; }

  double stamp = 0.0;                      // header stamp [s]; 0 where the sender leaves it empty
  double received = 0.0;                   // when it arrived [s]
  std::string sender;                      // who sent it, where known: another sender is another device
  std::shared_ptr<const void> connection;  // another: the sender connected anew, and nothing of before is on its way

 protected:
  OperatorMessage() = default;
  OperatorMessage(const OperatorMessage&) = default;
  OperatorMessage(OperatorMessage&&) = default;
  OperatorMessage& operator=(const OperatorMessage&) = default;
  OperatorMessage& operator=(OperatorMessage&&) = default;
};

}  // namespace hidwa_local_planner::input
