// SPDX-License-Identifier: BSD-3-Clause
#include "benchmark/cycle_case.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "support/random.hpp"

namespace hidwa_local_planner::test {

// vx_samples times vth_samples (and one for omega = 0), less (0, 0), and up to three: braking, the person's
// and the last command.
const std::vector<Load>& loads() {
  static const std::vector<Load> kLoads{{"419", 20, 20},         {"819", 20, 40},    {"2000", 26, 76},
                                        {"2400", 40, 60},        {"10000", 73, 136}, {"100000", 216, 462},
                                        {"2000x56", 26, 76, 2.6}};
  return kLoads;
}

const Load& load(const std::string& name) {
  for (const Load& one : loads()) {
    if (one.name == name) return one;
  }
  throw std::out_of_range("no load named " + name);
}

CycleCase::CycleCase(const Load& load, const Setting& setting) : scenes_(situations(setting)) {
  for (Scene& scene : scenes_) {
    scene.parameters.vx_samples = load.vx_samples;
    scene.parameters.vth_samples = load.vth_samples;
    scene.parameters.sim_time = load.sim_time;
  }
  const std::vector<std::string> faults = planner_.configure(scenes_.front().parameters);
  if (!faults.empty()) throw std::runtime_error(faults.front());
  planner_.set_footprint(scenes_.front().outline);
}

void CycleCase::let_drive() {
  for (Scene& scene : scenes_) scene.intent = OperatorIntent{};
}

// On the map, no nearer than 1 m.
void CycleCase::add_people(std::size_t count) {
  Random random(20);
  for (Scene& scene : scenes_) {
    const Pose2& robot = scene.situation.pose;
    const double half = 0.5 * scene.size_x * scene.resolution;
    for (std::size_t k = 0; k < count; ++k) {
      const double bearing = random.uniform(-M_PI, M_PI), off = random.uniform(1.0, half);
      const double course = random.uniform(-M_PI, M_PI), speed = random.uniform(0.0, 1.3);
      MovingObstacleEstimate person;
      person.id = static_cast<std::uint32_t>(k);
      person.position = {robot.x + off * std::cos(bearing), robot.y + off * std::sin(bearing)};
      person.velocity = {speed * std::cos(course), speed * std::sin(course)};
      person.radius = 0.3;
      person.position_deviation = 0.03;
      person.velocity_deviation = 0.1;
      scene.situation.moving_obstacles.push_back(person);
    }
  }
}

CycleCase::Size CycleCase::measure() {
  plan(0);
  Size size;
  for (const CandidateReport& record : planner_.candidates()) {
    ++size.candidates;
    size.poses += record.poses.size() - 1;
  }
  return size;
}

double CycleCase::legal_part() {
  watch();
  double legal = 0.0, candidates = 0.0;
  for (std::size_t k = 0; k < size(); ++k) {
    const Decision& decision = plan(k);
    legal += static_cast<double>(decision.legal);
    candidates += static_cast<double>(decision.candidates);
  }
  return legal / std::max(candidates, 1.0);
}

}  // namespace hidwa_local_planner::test
