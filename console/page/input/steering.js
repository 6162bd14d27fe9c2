// SPDX-License-Identifier: BSD-3-Clause
// What every stick-like input goes through: which one steers, how often its position is sent, and above all how steering
// ends. It ends with exactly one message, then silence. After a cut (tab hidden, focus lost ...) every input must be seen in
// neutral once before it steers again. left and forward are in [-1, 1], left and forward positive.

const REPEAT = 50; // [ms] while held
const SPACING = 12; // [ms] between two changes: the server takes 120 messages a second
const NEUTRAL = 0.08; // a deflection below this is a centred stick

export class Steering {
  /** send(type, fields, t): to the server, t the time of the cause [ms of performance.now()]. */
  constructor(send) {
    this.send = send;
    this.inputs = new Map(); // of the inputs that are held: their position
    this.blocked = new Set(); // must be seen in neutral first
    this.active = null; // the input that steers
    this.manual = false; // the operator has control: a centred stick is repeated too
    this.quiet = false; // the page is hidden or unfocused
    this.listeners = [];
    this.sent = 0;
    setInterval(() => this.repeat(), REPEAT);
  }

  /** Calls back with {left, forward, held} whenever the position changes. */
  onChange(listener) {
    this.listeners.push(listener);
  }

  get position() {
    return this.inputs.get(this.active) || { left: 0, forward: 0 };
  }

  get held() {
    return this.active !== null;
  }

  /** An input's position. held: somebody touches it, also if it is centred. */
  set(input, left, forward, t, held = Math.hypot(left, forward) > NEUTRAL) {
    if (this.blocked.has(input)) {
      if (!held) this.blocked.delete(input);
      return;
    }
    if (!held) {
      this.let(input, t);
      return;
    }
    const before = this.inputs.get(input);
    if (before && before.left === left && before.forward === forward) return;
    this.inputs.set(input, { left, forward });
    this.active = input;
    this.quiet = false;
    this.changed(t);
  }

  /** An input was let go. If another one is held still, that one steers. */
  let(input, t) {
    if (!this.inputs.delete(input)) return;
    if (this.active !== input) return;
    const rest = [...this.inputs.keys()];
    this.active = rest.length ? rest[rest.length - 1] : null;
    if (this.active) this.changed(t);
    else this.released(t);
  }

  changed(t) {
    this.tell();
    clearTimeout(this.later);
    const wait = this.sent + SPACING - performance.now();
    if (wait <= 0) this.emit(t);
    else this.later = setTimeout(() => this.emit(t), wait);
  }

  released(t) {
    clearTimeout(this.later);
    this.tell();
    this.emit(t);
  }

  emit(t) {
    this.sent = performance.now();
    const { left, forward } = this.position;
    this.send('stick', { left, forward, held: this.held }, t);
  }

  repeat() {
    if (this.quiet || !(this.held || this.manual)) return;
    if (performance.now() - this.sent >= REPEAT * 0.7) this.emit(performance.now());
  }

  /**
   * Everything is let go at once, because the page cannot know any longer what the person does: one release, then silence.
   * Says whether something was held.
   */
  cut(why) {
    const steered = this.held || (this.manual && !this.quiet);
    for (const input of this.inputs.keys()) this.blocked.add(input);
    this.inputs.clear();
    this.active = null;
    this.quiet = true;
    clearTimeout(this.later);
    if (steered) this.send('release', { why }, performance.now());
    this.tell();
    return steered;
  }

  /** The page is looked at again. */
  wake() {
    this.quiet = false;
  }

  /** Shows the server a centred stick, as it asks for once after a cut; not while one is held. */
  centre() {
    if (!this.held) this.emit(performance.now());
  }

  tell() {
    for (const listener of this.listeners) listener({ ...this.position, held: this.held });
  }
}
