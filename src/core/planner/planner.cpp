// SPDX-License-Identifier: BSD-3-Clause
// The public face of the planner; planner_impl.cpp has the cycle.
#include "hidwa_local_planner/core/planner.hpp"

#include <utility>

#include "core/planner/planner_impl.hpp"

namespace hidwa_local_planner {
namespace {

// The number of the layout of save(), which is the planner's state alone. Whoever changes that layout changes this
// number: then load() refuses what was written before. The other parts of a record count under kFormat
// (cycle_record.hpp).
constexpr std::uint32_t kLayout = 20261201;

}  // namespace

Planner::Planner(CriticRegistry registry) : impl_(std::make_unique<Impl>(std::move(registry))) {
  configure(Parameters{});
}
Planner::~Planner() = default;
Planner::Planner(Planner&&) noexcept = default;
Planner& Planner::operator=(Planner&&) noexcept = default;

const Parameters& Planner::parameters() const { return impl_->parameters; }
const VelocityLimits& Planner::limits() const { return impl_->limits; }
const Footprint& Planner::footprint() const { return impl_->footprint; }
const Polygon& Planner::outline() const { return impl_->outline; }

std::vector<std::string> Planner::configure(const Parameters& parameters, const SourceFor& source_for) {
  return impl_->configure(parameters, source_for);
}

void Planner::set_footprint(const Polygon& outline) { impl_->set_footprint(outline); }

void Planner::reset() {
  impl_->critics.reset();
  impl_->autonomy.reset();
  impl_->goalless.forget();
  impl_->movers.forget();
  impl_->accelerations.forget();
}

Twist2 Planner::believed(const Twist2& measured) const {
  return impl_->start_estimator.believed(measured, impl_->parameters);
}

bool Planner::leads_to_goal() const { return impl_->autonomy.recovery().leads_to_goal(); }

void Planner::save(Bytes& state) const {
  ArchiveWriter write(state);
  write(kLayout, impl_->start_estimator, impl_->goalless, impl_->movers, impl_->accelerations);
  impl_->critics.save(write);
  write(impl_->autonomy);
}

bool Planner::load(const Bytes& state) {
  ArchiveReader read(state);
  std::uint32_t layout = 0;
  read(layout);
  if (layout != kLayout) {
    reset();
    return false;
  }
  impl_->critics.reset();
  read(impl_->start_estimator, impl_->goalless, impl_->movers, impl_->accelerations);
  impl_->critics.load(read);
  read(impl_->autonomy);  // a search that is under way here already is gone on with
  if (!read.complete()) reset();
  return read.complete();
}

const Decision& Planner::plan(const Situation& situation, const GridView& grid, const OperatorIntent& intent,
                              const Sampling& sampling) {
  return impl_->plan(situation, grid, intent, sampling);
}

void Planner::skip(const Situation& situation) { impl_->start_estimator.skip(situation, impl_->limits); }

std::vector<CandidateReport> Planner::candidates() const { return impl_->explanation.candidates(); }
Planner::Marked Planner::marked() const { return impl_->explanation.marked(); }
const ChoiceReport& Planner::choice() const { return impl_->explanation.choice(); }
const std::vector<double>& Planner::totals() const { return impl_->evaluation.scores().totals(); }

}  // namespace hidwa_local_planner
