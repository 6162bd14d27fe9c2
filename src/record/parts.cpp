// SPDX-License-Identifier: BSD-3-Clause
#include "record/parts.hpp"

#include <utility>

namespace hidwa_local_planner {
namespace record {

PartReader::PartReader(const std::uint8_t* data, std::size_t size) {
  ArchiveReader read(data, size);
  while (!read.failed() && !read.complete()) {
    Part part;
    read(part.name, part.critical, part.bytes);
    if (read.failed()) break;
    for (const Part& before : parts_) {
      if (before.name == part.name) blame("the record is damaged: it has the part '" + part.name + "' twice");
    }
    parts_.push_back(std::move(part));
  }
  if (read.failed()) blame("the record is cut short");
}

const PartReader::Part* PartReader::take(const std::string& name) {
  for (Part& part : parts_) {
    if (part.name != name) continue;
    part.taken = true;
    return &part;
  }
  return nullptr;
}

std::vector<std::string> PartReader::unknown() const {
  std::vector<std::string> names;
  for (const Part& part : parts_) {
    if (part.critical && !part.taken) names.push_back(part.name);
  }
  return names;
}

}  // namespace record
}  // namespace hidwa_local_planner
