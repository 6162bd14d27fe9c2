// SPDX-License-Identifier: BSD-3-Clause
#include "sim/pgm.hpp"

#include <algorithm>
#include <cstddef>
#include <fstream>
#include <istream>
#include <stdexcept>

namespace hidwa_local_planner {
namespace sim {
namespace {

// Of a map of 1000 x 1000 pixels.
constexpr std::size_t kReserved = 1000000;

[[noreturn]] void fail(const std::string& path, const std::string& what) {
  throw std::runtime_error("image '" + path + "': " + what);
}

/// The next number of the header; comments run from # to the end of a line.
int header_number(std::istream& in, const std::string& path) {
  in >> std::ws;
  while (in.peek() == '#') {
    std::string comment;
    std::getline(in, comment);
    in >> std::ws;
  }
  int number = 0;
  if (!(in >> number)) fail(path, "the PGM header is not complete");
  return number;
}

int binary_value(std::istream& in, bool two_bytes) {
  const int high = in.get();
  return two_bytes ? 256 * high + in.get() : high;
}

}  // namespace

GreyImage read_pgm(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  if (!in) fail(path, "cannot be opened");
  std::string magic(2, '\0');
  in.read(&magic[0], 2);
  if (magic != "P5" && magic != "P2") {
    fail(path, "is not a PGM image (P5 or P2); convert it, for example with ImageMagick: convert MAP.png MAP.pgm");
  }
  GreyImage image;
  image.width = header_number(in, path);
  image.height = header_number(in, path);
  const int white = header_number(in, path);
  if (image.width <= 0 || image.height <= 0 || white <= 0 || white > 65535) fail(path, "impossible size or depth");
  if (image.width > 100000 || image.height > 100000) fail(path, "is wider or higher than 100000 pixels");
  if (magic == "P5") in.get();  // one white space ends the header
  const std::size_t count = static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
  image.pixels.reserve(std::min(count, kReserved));  // a header may lie
  for (std::size_t i = 0; i < count; ++i) {
    int value = 0;
    if (magic == "P5") {
      value = binary_value(in, white > 255);
    } else {
      in >> value;
    }
    if (!in) fail(path, "ends before its last pixel");
    image.pixels.push_back(static_cast<double>(value) / white);
  }
  return image;
}

}  // namespace sim
}  // namespace hidwa_local_planner
