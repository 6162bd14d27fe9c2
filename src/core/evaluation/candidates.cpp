// SPDX-License-Identifier: BSD-3-Clause
#include "core/evaluation/candidates.hpp"

#include <cmath>
#include <limits>
#include <vector>

namespace hidwa_local_planner {

void Candidates::make(const Cycle& cycle, const VelocityLimits& window_limits, const Steering& steering,
                      const ComfortTurn& comfort, double sim_time) {
  const Parameters& parameters = cycle.parameters;
  const Sampling& sampling = cycle.sampling;
  SampleRequest request;
  request.previous = cycle.situation.last_command;
  request.operator_command = steering.active ? &cycle.intent.u_h : nullptr;
  request.blended = steering.active && !(steering.target == cycle.intent.u_h) ? &steering.target : nullptr;
  request.vx_samples = sampling.vx_samples > 0 ? sampling.vx_samples : parameters.vx_samples;
  request.vth_samples = sampling.vth_samples > 0 ? sampling.vth_samples : parameters.vth_samples;
  // Where somebody may step out, other speeds may all be too fast.
  if (cycle.hidden != nullptr) request.creep = parameters.blind_speed;
  VelocityLimits limits = window_limits;
  limits.theta = comfort.widest(limits.theta, cycle.start.reference.omega);
  sampler_.make(parameters, limits, cycle.start, request);
  rollout_.run(parameters, cycle.start, sampler_.samples(), comfort, sim_time);
}

bool Candidates::is_operator_command(std::size_t candidate) const {
  return sampler_.samples()[candidate].kind == SampleKind::operator_command;
}

// It is one of the last: those of the grid come first.
int Candidates::operator_command(const Twist2& u_h) const {
  const std::vector<Sample>& samples = sampler_.samples();
  for (std::size_t c = samples.size(); c-- > 0 && samples[c].kind != SampleKind::grid;) {
    if (is_operator_command(c)) return static_cast<int>(c);
  }
  return nearest_to(u_h);
}

int Candidates::nearest_to(const Twist2& u) const {
  int nearest = -1;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t c = 0; c < sampler_.samples().size(); ++c) {
    const double off = std::abs(sample(c).v - u.v) + std::abs(sample(c).omega - u.omega);
    if (off < least) {
      least = off;
      nearest = static_cast<int>(c);
    }
  }
  return nearest;
}

}  // namespace hidwa_local_planner
