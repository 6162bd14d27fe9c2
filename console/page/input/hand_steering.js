// SPDX-License-Identifier: BSD-3-Clause
// Steering by a hand (SG) and by a headset's thumbsticks (SJ), out of what hand.js reads each frame. The first hand that grips
// or pinches steers; a second hand that pinches stops the robot as long as it does. A hand that is no longer tracked is
// released at once, and must open before it steers again.

const SPACING = 12; // [ms] between two places of a hand: a headset has up to 144 frames a second, the server takes 120 messages

export class HandSteering {
  /** send as in Steering; steering, stop: of this folder; toggle(): takes or gives back control. */
  constructor(send, steering, stop, toggle) {
    this.send = send;
    this.steering = steering;
    this.stop = stop;
    this.toggle = toggle;
    this.clear();
  }

  clear() {
    this.hand = null; // the key of the hand that steers
    this.gripped = new Set();
    this.mustOpen = new Set();
    this.buttons = {};
    this.sent = 0; // [ms]
  }

  /** The sources of one frame, and the time [ms]. */
  take(sources, t) {
    for (const source of sources) {
      if (!source.hand) this.takeController(source, t);
      this.takeGrip(source, t);
    }
    const gone = [...this.gripped].filter((key) => !sources.some((source) => source.key === key));
    for (const key of gone) this.lose(key);
  }

  takeController({ key, stick, stop, toggle }, t) {
    this.steering.set(`headset ${key}`, stick.left, stick.forward, t);
    this.edge(`stop ${key}`, stop, () => this.stop.hold(key, t), () => this.stop.unhold(key, t));
    this.edge(`toggle ${key}`, toggle, this.toggle, () => {});
  }

  takeGrip({ key, hand, grip, at }, t) {
    const gripped = this.gripped.has(key);
    if (!at) {
      if (grip || gripped) this.lose(key);
      return;
    }
    if (this.mustOpen.has(key)) {
      if (!grip) this.mustOpen.delete(key);
      return;
    }
    if (grip && !gripped) this.close(key, hand, t);
    if (!grip && gripped) this.open(key, at, t);
    if (!grip || this.hand !== key || t - this.sent < SPACING) return;
    this.sent = t;
    this.send('hand', { ...at, grip: true }, t);
  }

  close(key, hand, t) {
    this.gripped.add(key);
    if (this.hand === null) this.hand = key;
    else if (hand) this.stop.hold(key, t);
  }

  open(key, at, t) {
    this.gripped.delete(key);
    if (this.hand !== key) {
      this.stop.unhold(key, t);
      return;
    }
    this.hand = null;
    this.send('hand', { ...at, grip: false }, t);
  }

  /** Tracking of a hand is lost. Its stop stays, its steering ends. */
  lose(key) {
    this.gripped.delete(key);
    this.mustOpen.add(key);
    if (this.hand !== key) {
      this.stop.keep();
      return;
    }
    this.hand = null;
    this.send('release', { why: 'tracking' }, performance.now());
  }

  /** The session is hidden, blurred or over. Says whether a hand steered. */
  cut(why) {
    const steered = this.hand !== null;
    for (const key of this.gripped) this.mustOpen.add(key);
    this.gripped.clear();
    this.hand = null;
    if (steered) this.send('release', { why }, performance.now());
    return steered;
  }

  edge(name, is, down, up) {
    if (Boolean(is) === Boolean(this.buttons[name])) return;
    this.buttons[name] = Boolean(is);
    (is ? down : up)();
  }
}
