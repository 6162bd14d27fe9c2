// SPDX-License-Identifier: BSD-3-Clause
// Where a stick rests. A worn one rests beside 0, and elsewhere after each push; a device that is no stick may stand anywhere.
// So the resting place of each axis is learnt, and a deflection is measured from there.

const FARTHEST = 0.3; // no stick rests farther out: what stands there is held, or is no stick, until it was seen nearer
const DEADBAND = 0.08; // a deflection below this is a centred stick
const STILL = 0.02; // a stick that nobody holds moves less
const SETTLED = 1000; // [ms] a stick that stays still and hardly deflected for this long rests there
const WORN = 0.15; // hardly deflected

/** A reading in [-1, 1]; what is no number is no deflection. */
const clean = (value) => (Number.isFinite(value) ? Math.min(1, Math.max(-1, value)) : 0);

/** The deflection of a reading, in [-1, 1]; none between 0 and the resting place. */
function deflection(value, rest) {
  if (rest === null) return 0;
  const [low, high] = [Math.min(0, rest), Math.max(0, rest)];
  if (value > high) return (value - high) / (1 - high);
  return value < low ? (value - low) / (1 + low) : 0;
}

export class Rest {
  constructor() {
    this.at = [null, null]; // of each axis; null: not known yet
    this.still = null; // the reading from which the stick has not moved
    this.since = 0; // [ms]
  }

  /** {left, forward, held} of a reading at the time t [ms]. */
  read(left, forward, t) {
    const raw = [clean(left), clean(forward)];
    this.at = this.at.map((rest, i) => (rest === null && Math.abs(raw[i]) <= FARTHEST ? raw[i] : rest));
    if (this.settled(raw, t)) this.at = this.at.map((rest, i) => (rest !== null && Math.abs(raw[i]) <= FARTHEST ? raw[i] : rest));
    const [x, y] = raw.map((value, i) => deflection(value, this.at[i]));
    return { left: x, forward: y, held: Math.hypot(x, y) > DEADBAND };
  }

  settled(raw, t) {
    if (!this.still || raw.some((value, i) => Math.abs(value - this.still[i]) > STILL)) {
      this.still = raw;
      this.since = t;
    }
    const size = Math.hypot(...raw.map((value, i) => deflection(value, this.at[i])));
    return t - this.since >= SETTLED && size <= WORN;
  }
}
