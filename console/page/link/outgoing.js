// SPDX-License-Identifier: BSD-3-Clause
// Every message of the page passes here: numbers are brought into the bounds that the server takes, and impossible times are
// replaced. The server ends the connection at one malformed message.

const UNIT = [-1, 1];
const METRES = [-100, 100];
const PLACE = [-1e5, 1e5];
const BOUNDS = {
  stick: { left: UNIT, forward: UNIT },
  hand: { left: METRES, forward: METRES, up: METRES },
  goal: { x: PLACE, y: PLACE, yaw: [-1e3, 1e3] },
};

/** Whether a value holds no number that JSON has not. */
function isPlain(value) {
  if (typeof value === 'number') return Number.isFinite(value);
  return value === null || typeof value !== 'object' || Object.values(value).every(isPlain);
}

/** The fields of a message of this type with its numbers in bounds; null where one of them is no number. */
export function bounded(type, fields) {
  if (!isPlain(fields)) return null;
  const result = { ...fields };
  for (const [name, [low, high]] of Object.entries(BOUNDS[type] || {})) {
    if (typeof result[name] === 'number') result[name] = Math.min(high, Math.max(low, result[name]));
  }
  return result;
}

const PERIOD = 50; // [ms] of the timer that shows whether the page is busy
const WAITS = 150; // [ms] for which an event may wait in a page that is not busy; to the server 300 ms are late
const AFTER = 1000; // [ms] within which the events come that waited while the page was busy

/**
 * Times of events [ms of performance.now()]. Not every browser gives them: some are 0, others count from another time. A time
 * is believed if it lies in the past, and if the event can have waited since then because the page was busy. Any other time is
 * replaced by the present.
 */
export class EventTimes {
  constructor() {
    this.turned = performance.now(); // the timer came
    this.waited = 0; // since when events may have waited that come until `until`
    this.until = 0;
    setInterval(() => this.turn(), PERIOD);
  }

  turn() {
    const now = performance.now();
    if (now - this.turned > PERIOD + WAITS) [this.waited, this.until] = [this.turned, now + AFTER];
    this.turned = now;
  }

  of(t) {
    const now = performance.now();
    const free = now < this.until ? Math.min(this.waited, this.turned) : this.turned; // when the page was last known not to be busy
    return t > 0 && t <= now && t >= free - WAITS ? t : now;
  }
}
