// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace hidwa_local_planner {
namespace study {

/// What one simulated person is like. docs/use/study.md has the distributions' sources.
struct Participant {
  double reaction_time = 0.0;    // [s], from seeing to moving a hand
  double decision_period = 0.0;  // [s]
  double look_ahead = 0.0;       // [s], how far ahead regions on the robot's way are seen
  double region_margin = 0.0;    // [m], kept from regions
  double release_margin = 0.0;   // [m], more margin to let go than to take the stick
  double stick_noise = 0.0;      // standard deviation of a stick position
  double hand_noise = 0.0;       // [m], standard deviation of a hand's position (SG)

  // With a button (SW).
  double button_time = 0.0;               // [s], from the intention to the press
  double give_back_pause = 0.0;           // [s], content for this time before control is given back
  double notice_time = 0.0;               // [s], until an error is seen
  double forget_probability = 0.0;        // to let go of the stick without giving control back
  double double_press_probability = 0.0;  // to press twice
  double early_stick_probability = 0.0;   // to deflect the stick without taking control
  double round_gate = 0.0;                // 0: both axes reach 1 together; 1: the stick moves in a circle
};

/// How a trait is spread over people.
struct Spread {
  enum class Kind { fixed, uniform, log_uniform, normal };
  Kind kind = Kind::fixed;
  double low = 0.0, high = 0.0;  // nobody is beyond; fixed: low
  double mean = 0.0, sd = 0.0;   // normal only
};

/// One trait of the model.
struct Trait {
  std::string name;
  double Participant::*member;
  Spread spread;
  double least = 0.0, greatest = 0.0;  // what may be set
};

/// All traits, in the order in which they are drawn.
const std::vector<Trait>& traits();

/// The participant with this number, drawn from the spreads.
Participant draw_participant(std::uint64_t study_seed, int participant);

/// Gives a trait the same value for whoever it is. Returns the fault in words, empty when it was set.
std::string set_trait(Participant& participant, const std::string& name, double value);

}  // namespace study
}  // namespace hidwa_local_planner
