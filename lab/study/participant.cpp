// SPDX-License-Identifier: BSD-3-Clause
#include "study/participant.hpp"

#include <cmath>

#include "core/util/words.hpp"
#include "sim/random.hpp"
#include "study/seed.hpp"

namespace hidwa_local_planner {
namespace study {
namespace {

Spread uniform(double low, double high) { return {Spread::Kind::uniform, low, high, 0.0, 0.0}; }
Spread log_uniform(double low, double high) { return {Spread::Kind::log_uniform, low, high, 0.0, 0.0}; }
Spread fixed(double value) { return {Spread::Kind::fixed, value, value, 0.0, 0.0}; }
Spread normal(double mean, double sd, double low, double high) { return {Spread::Kind::normal, low, high, mean, sd}; }

std::vector<Trait> all() {
  using P = Participant;
  return {
      // Choice reactions to what is seen, of adults: 0.35 to 0.6 s for most (Woods et al. 2015).
      {"reaction_time", &P::reaction_time, normal(0.48, 0.08, 0.30, 0.80), 0.0, 5.0},
      // Perceive, think, move: 0.24 s, 0.105 to 0.47 s (Card, Moran and Newell 1983, Model Human Processor).
      {"decision_period", &P::decision_period, normal(0.24, 0.06, 0.105, 0.47), 0.05, 5.0},
      // Assumed: in view down a corridor, but not thought of before it matters.
      {"look_ahead", &P::look_ahead, uniform(3.0, 6.0), 0.5, 30.0},
      // Assumed. The lower end is the margin of people who walk through a gap, 8 % of their width on either
      // side (Warren and Whang 1987), for a robot of 0.6 m.
      {"region_margin", &P::region_margin, uniform(0.05, 0.25), 0.0, 2.0},
      // Assumed.
      {"release_margin", &P::release_margin, uniform(0.0, 0.10), 0.0, 2.0},
      // Motor noise of about -20 to -25 dB of the movement (Kleinman, Baron and Levison 1970), for half a
      // deflection.
      {"stick_noise", &P::stick_noise, uniform(0.03, 0.05), 0.0, 1.0},
      // The same share of a displacement of 0.15 m; a millimetre for the tracking is assumed.
      {"hand_noise", &P::hand_noise, uniform(0.010, 0.016), 0.0, 1.0},
      // A keystroke: 0.2 s, 0.08 s of the best (Card, Moran and Newell 1980, Keystroke-Level Model).
      {"button_time", &P::button_time, normal(0.20, 0.05, 0.08, 0.50), 0.0, 10.0},
      // Between a reaction and a mental preparation, 1.35 s (Card, Moran and Newell 1980).
      {"give_back_pause", &P::give_back_pause, uniform(0.40, 1.35), 0.0, 10.0},
      // Assumed: around a mental preparation and a reaction.
      {"notice_time", &P::notice_time, uniform(1.0, 3.0), 0.0, 60.0},
      // A routine, highly practised, rapid task with little skill: 0.02, 0.007 to 0.045 (Williams 1988, HEART).
      {"forget_probability", &P::forget_probability, log_uniform(0.007, 0.045), 0.0, 1.0},
      {"double_press_probability", &P::double_press_probability, log_uniform(0.007, 0.045), 0.0, 1.0},
      {"early_stick_probability", &P::early_stick_probability, log_uniform(0.007, 0.045), 0.0, 1.0},
      // The paper lets the stick reach [-1, 1] x [-1, 1].
      {"round_gate", &P::round_gate, fixed(0.0), 0.0, 1.0},
  };
}

double drawn(const Spread& spread, sim::Random& random) {
  switch (spread.kind) {
    case Spread::Kind::uniform:
      return spread.low + (spread.high - spread.low) * random.uniform();
    case Spread::Kind::log_uniform:
      return spread.low * std::pow(spread.high / spread.low, random.uniform());
    case Spread::Kind::normal: {
      double value = 0.0;
      do {
        value = spread.mean + spread.sd * random.normal();
      } while (value < spread.low || value > spread.high);
      return value;
    }
    case Spread::Kind::fixed:
      break;
  }
  return spread.low;
}

}  // namespace

const std::vector<Trait>& traits() {
  static const std::vector<Trait> list = all();
  return list;
}

Participant draw_participant(std::uint64_t study_seed, int number) {
  Participant participant;
  for (const Trait& trait : traits()) {
    // A generator for each: another spread of one trait leaves the others as they were.
    sim::Random random(seed_for(study_seed, number, "trait " + trait.name));
    participant.*trait.member = drawn(trait.spread, random);
  }
  return participant;
}

std::string set_trait(Participant& participant, const std::string& name, double value) {
  std::string known;
  for (const Trait& trait : traits()) {
    if (trait.name == name) {
      if (value >= trait.least && value <= trait.greatest) {
        participant.*trait.member = value;
        return {};
      }
      return "participant." + name + " must be within " + shortest(trait.least) + " to " + shortest(trait.greatest);
    }
    known += (known.empty() ? "" : ", ") + trait.name;
  }
  return "there is no participant." + name + "; there are " + known;
}

}  // namespace study
}  // namespace hidwa_local_planner
