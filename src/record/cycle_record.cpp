// SPDX-License-Identifier: BSD-3-Clause
#include "record/cycle_record.hpp"

#include <algorithm>
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

// Stays as it is: digests of recorded cycles were made with these names.
std::string_view name_of(Problem problem) {
  switch (problem) {
    case Problem::none:
      break;
    case Problem::input:
      return "input";
    case Problem::off_map:
      return "off_map";
    case Problem::rejected:
      return "rejected";
    case Problem::stuck:
      return "stuck";
  }
  return "";
}

}  // namespace

DecisionRecord decision_record(const Decision& d, const std::vector<double>& totals) {
  DecisionRecord decision;
  decision.outcome = d.outcome;
  if (d.outcome != Outcome::fail) decision.command = d.command;
  decision.sample = d.sample;
  decision.reference = d.reference;
  decision.total = d.total;
  decision.agreement = d.agreement;
  decision.candidates = static_cast<std::uint32_t>(d.candidates);
  decision.legal = static_cast<std::uint32_t>(d.legal);
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
  for (const RejectionCount& rejection : d.rejections) {
    hash.add(rejection.name);
    hash.add(static_cast<std::uint64_t>(rejection.count));
  }
  hash.add(d.operator_rejected_by);
  hash.add(name_of(d.problem_kind));
  for (const double part : {d.pose.x, d.pose.y, d.pose.theta, d.velocity.v, d.velocity.omega}) hash.add(part);
  for (const bool said : {d.escaping, d.odometry_doubted, d.odometry_fast}) hash.add(std::uint64_t{said});
  decision.digest = hash.value();
  return decision;
}

DecisionRecord decision_record(const control::Result& result, const Planner& planner) {
  if (result.decision != nullptr) return decision_record(*result.decision, planner.totals());
  DecisionRecord decision;
  decision.outcome = result.outcome;
  decision.command = result.command;
  return decision;
}

bool identical(const DecisionRecord& a, const DecisionRecord& b) { return bytes_of(a) == bytes_of(b); }
bool identical(const OperatorIntent& a, const OperatorIntent& b) { return bytes_of(a) == bytes_of(b); }

namespace {

// More than parameters may ask for (validate()).
constexpr double kMostSamples = 200000.0;
constexpr int kMostSearchPoses = 1000000;
bool plausible(const Sampling& s) {
  const double samples =
      static_cast<double>(std::max(1, s.vx_samples)) * static_cast<double>(std::max(1, s.vth_samples));
  return samples <= kMostSamples && s.search_poses <= kMostSearchPoses;
}

// What ControlLoop::step() relies on.
std::string lacking(const CycleRecord& record) {
  if (record.setup && !record.plan) return "the record is damaged: it has parameters, but no plan";
  if (!plausible(record.sampling)) return "the record is damaged: no planner tries so many samples";
  if (!record.observation.fault.empty()) return "";
  if (!record.costmap) return "the record is damaged: it has no costmap, and no fault that explains it";
  if (!record.observation.velocity) return "the record is damaged: it has no velocity, and no fault that explains it";
  return "";
}

}  // namespace

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
    return "the record's format is " + std::to_string(format) + ", this release reads format " +
           std::to_string(kFormat) + ": replay it with the release that recorded it";
  }
  read(record);
  return read.complete() ? lacking(record) : "the record is cut short or damaged";
}

}  // namespace record
}  // namespace hidwa_local_planner
