// SPDX-License-Identifier: BSD-3-Clause
// Messages of other packages as bytes, without their packages.
#pragma once

#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

#include "hidwa_local_planner/core/types.hpp"

namespace hidwa_local_planner::test {

// ROS's wire format: little-endian; texts and lists begin with their length.
class WireBytes {
 public:
  template <typename Number>
  WireBytes& add(Number number) {
    const std::size_t at = bytes_.size();
    bytes_.resize(at + sizeof number);
    std::memcpy(bytes_.data() + at, &number, sizeof number);
    return *this;
  }
  WireBytes& count(std::size_t n) { return add(static_cast<std::uint32_t>(n)); }
  WireBytes& text(const std::string& text) {
    count(text.size());
    bytes_.insert(bytes_.end(), text.begin(), text.end());
    return *this;
  }
  WireBytes& numbers(const std::vector<double>& numbers) {
    for (const double number : numbers) add(number);
    return *this;
  }
  WireBytes& header(const std::string& frame, std::uint32_t seconds) {
    return add(std::uint32_t{0}).add(seconds).add(std::uint32_t{0}).text(frame);
  }
  WireBytes& person(const std::string& name, double x, double y, double vx, double vy) {
    text(name).numbers({x, y, 0.0, vx, vy, 0.0, 0.75});
    return count(1).text("tag").count(2).text("").text("value");
  }
  WireBytes& obstacle(std::int64_t id, const std::vector<Point>& vertices, double radius, double vx, double vy,
                      const std::vector<double>& variances) {
    header("", 0).count(vertices.size());
    for (const Point& p : vertices) add(static_cast<float>(p.x())).add(static_cast<float>(p.y())).add(0.0F);
    add(radius).add(id).numbers({0.0, 0.0, 0.0, 1.0}).numbers({vx, vy, 0.0, 0.0, 0.0, 0.0});
    std::vector<double> covariance(36, 0.0);
    covariance[0] = variances[0];
    covariance[1] = covariance[6] = variances[1];
    covariance[7] = variances[2];
    return numbers(covariance);
  }
  std::vector<std::uint8_t>& all() { return bytes_; }

 private:
  std::vector<std::uint8_t> bytes_;
};

}  // namespace hidwa_local_planner::test
