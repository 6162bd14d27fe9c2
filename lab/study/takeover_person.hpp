// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <deque>
#include <limits>

#include "sim/operator_device.hpp"
#include "sim/random.hpp"
#include "study/participant.hpp"

namespace hidwa_local_planner {
namespace study {

/// SW, with a person's times and errors: takes control by a press of the button, drives at full speed where
/// they want to go, gives control back once content. Now and then they deflect the stick without having taken
/// control, press twice so that control is gone again, or let go without giving control back, so that the
/// robot stands; each lasts until it is noticed.
class TakeoverPerson : public sim::OperatorDevice {
 public:
  TakeoverPerson(const Participant& participant, std::uint64_t seed) : participant_(participant), random_(seed) {}

  sim::Controls update(double time, const sim::Stick& wanted) override;

  int errors() const { return errors_; }  // so far

 private:
  enum class Phase {
    watching,  // the robot drives
    reaching,  // for the button, to take control at next_
    misled,    // believes to drive until next_
    driving,
    leaving,   // for the button, to give control back at next_
    forgotten  // let go, believes that the robot drives until next_
  };

  void step(double time, bool wants);
  void watch(double time);
  void take_control(double time);
  void drive_on(double time, bool wants);
  void press(double time);
  bool errs(double probability);
  sim::Stick driving_stick(const sim::Stick& wanted) const;

  struct Press {
    double from, to;  // [s]
  };

  Participant participant_;
  sim::Random random_;
  Phase phase_ = Phase::watching;
  double next_ = 0.0;                                                // [s], when the phase ends
  double content_since_ = std::numeric_limits<double>::quiet_NaN();  // [s], while driving; NaN: not
  std::deque<Press> presses_;
  int errors_ = 0;
};

}  // namespace study
}  // namespace hidwa_local_planner
