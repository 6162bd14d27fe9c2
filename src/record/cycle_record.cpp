// SPDX-License-Identifier: BSD-3-Clause
#include "hidwa_local_planner/record/cycle_record.hpp"

#include <cstring>
#include <string_view>

namespace hidwa_local_planner {
namespace record {
namespace {

// http://www.isthe.com/chongo/tech/comp/fnv: FNV-1a, by words of 64 bits where there are such.
class Hash {
 public:
  void add(std::uint64_t word) { value_ = (value_ ^ word) * 0x100000001b3U; }
  void add(double number) {
    std::uint64_t bits = 0;
    std::memcpy(&bits, &number, sizeof(bits));
    add(bits);
  }
  void add(std::string_view text) {
    for (const char c : text) add(static_cast<std::uint64_t>(static_cast<unsigned char>(c)));
    add(std::uint64_t{256});  // no character: where one text ends
  }
  std::uint64_t value() const { return value_; }

 private:
  std::uint64_t value_ = 0xcbf29ce484222325U;
};

template <typename T>
Bytes bytes_of(const T& value) {
  Bytes bytes;
  ArchiveWriter write(bytes);
  write(value);
  return bytes;
}

}  // namespace

Verdict verdict_of(const Decision& d, const std::vector<double>& totals) {
  Verdict verdict;
  verdict.outcome = d.outcome;
  if (d.outcome != Outcome::fail) verdict.command = d.command;
  verdict.sample = d.sample;
  verdict.reference = d.reference;
  verdict.total = d.total;
  verdict.agreement = d.agreement;
  verdict.candidates = static_cast<std::uint32_t>(d.candidates);
  verdict.legal = static_cast<std::uint32_t>(d.legal);
  Hash hash;
  for (const double total : totals) hash.add(total);
  for (const Pose2& pose : d.trajectory) {
    hash.add(pose.x);
    hash.add(pose.y);
    hash.add(pose.theta);
  }
  hash.add(d.step);
  for (const CriticTerm& term : d.terms) {
    hash.add(term.name);
    hash.add(term.raw);
    hash.add(term.weight);
  }
  for (const RefusalCount& refusal : d.refusals) {
    hash.add(refusal.name);
    hash.add(static_cast<std::uint64_t>(refusal.count));
  }
  hash.add(d.operator_refused_by);
  hash.add(d.problem);
  for (const double part : {d.pose.x, d.pose.y, d.pose.theta, d.velocity.v, d.velocity.omega}) hash.add(part);
  for (const bool said : {d.escaping, d.odometry_doubted, d.odometry_fast}) hash.add(std::uint64_t{said});
  verdict.digest = hash.value();
  return verdict;
}

Verdict verdict_of(Outcome outcome, const Twist2& command) {
  Verdict verdict;
  verdict.outcome = outcome;
  verdict.command = command;
  return verdict;
}

bool identical(const Verdict& a, const Verdict& b) { return bytes_of(a) == bytes_of(b); }
bool identical(const OperatorIntent& a, const OperatorIntent& b) { return bytes_of(a) == bytes_of(b); }

void encode(const CycleRecord& record, Bytes& bytes) {
  bytes.clear();
  ArchiveWriter write(bytes);
  write(kFormat, record);
}

std::string decode(const Bytes& bytes, CycleRecord& record) {
  ArchiveReader read(bytes);
  std::uint16_t format = 0;
  read(format);
  if (read.failed()) return "the record is empty";
  if (format != kFormat) {
    return "the record's format is " + std::to_string(format) + ", this program reads " + std::to_string(kFormat) +
           ": use the release that recorded it";
  }
  record = CycleRecord();
  read(record);
  return read.complete() ? "" : "the record is damaged";
}

}  // namespace record
}  // namespace hidwa_local_planner
