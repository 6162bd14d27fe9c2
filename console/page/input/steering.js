// SPDX-License-Identifier: BSD-3-Clause
// What every stick-like input goes through: which one steers, how often its position is sent, and above all how steering
// ends. It ends with exactly one message, then silence. After a cut (tab hidden, focus lost ...) every input must be seen in
// neutral once before it steers again. Of several that are held the one that was pressed or moved last steers; what lies
// still, trembles or creeps takes nothing from it. left and forward are in [-1, 1], left and forward positive.
import { Rest } from './rest.js';

const REPEAT = 50; // [ms] while held
const SPACING = 12; // [ms] between two changes: the server takes 120 messages a second
const MOVED = 0.2; // a larger change within WHILE is a movement by a person
const WHILE = 1000; // [ms]
const CENTRE = { left: 0, forward: 0 };

export class Steering {
  /** send(type, fields, t): to the server, t the time of the cause [ms of performance.now()]. */
  constructor(send) {
    this.send = send;
    this.inputs = new Map(); // of the inputs that are held: their position, and `from` where they moved since a time [ms]
    this.rests = new Map(); // of the inputs that do not feel who touches them
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
    const { left, forward } = this.inputs.get(this.active) || CENTRE;
    return { left, forward };
  }

  get held() {
    return this.active !== null;
  }

  /**
   * An input's position at the time t [ms]. held: somebody touches it, also if it is centred; an input that does not feel that
   * leaves it out, and its position is measured from where it rests.
   */
  set(input, left, forward, t, held) {
    if (held === undefined) this.place(input, this.rest(input).read(left, forward, performance.now()), CENTRE, t);
    else this.place(input, { left, forward, held }, null, t);
  }

  rest(input) {
    if (!this.rests.has(input)) this.rests.set(input, new Rest());
    return this.rests.get(input);
  }

  /** begin: where an input counts as having been before it was held; null: it was pressed now. */
  place(input, { left, forward, held }, begin, t) {
    if (this.blocked.has(input)) {
      if (!held) this.blocked.delete(input);
      return;
    }
    if (!held) {
      this.let(input, t);
      return;
    }
    const before = this.inputs.get(input) || { from: begin, since: performance.now() };
    if (before.left === left && before.forward === forward) return;
    const one = { left, forward, from: before.from, since: before.since };
    this.inputs.set(input, one);
    if (this.active !== input && !this.takes(one)) return;
    this.active = input;
    for (const each of this.inputs.values()) settle(each);
    this.quiet = false;
    this.changed(t);
  }

  /** Whether an input that does not steer was moved, so that it steers now. */
  takes(one) {
    if (this.active === null || one.from === null) return true;
    if (Math.hypot(one.left - one.from.left, one.forward - one.from.forward) > MOVED) return true;
    if (performance.now() - one.since > WHILE) settle(one);
    return false;
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

  /** A device is gone. If it steers, that is a cut; what else is held must be centred first, too. */
  gone(input) {
    this.rests.delete(input);
    if (this.active === input) {
      this.cut('device');
      this.wake();
    }
    this.inputs.delete(input);
    this.blocked.delete(input);
  }

  /** Shows the server a centred stick, as it asks for once after a cut; not while one is held. */
  centre() {
    if (!this.held) this.emit(performance.now());
  }

  tell() {
    for (const listener of this.listeners) listener({ ...this.position, held: this.held });
  }
}

/** From here on an input's moves are counted anew. */
function settle(one) {
  one.from = { left: one.left, forward: one.forward };
  one.since = performance.now();
}
