// SPDX-License-Identifier: BSD-3-Clause
// Gamepads by the Gamepad API: the left stick steers (there left and up are -1), the right face button (B, circle) stops as
// long as it is held, the lower one (A, cross) takes and gives back control in mode switching. All that are there are read:
// the first may be a dead one, or something else that a browser takes for a gamepad.

const POLL = 16; // [ms]; by a timer, so that a slow drawing delays nothing
const TOGGLE = 0;
const STOP = 1;

export class Gamepads {
  /** stop: input/stop.js; toggle(): takes or gives back control. */
  constructor(steering, stop, toggle) {
    this.steering = steering;
    this.stop = stop;
    this.toggle = toggle;
    this.pressed = new Map(); // of each pad that is there, by its input's name: which buttons are down
    setInterval(() => this.poll(), POLL);
    addEventListener('gamepaddisconnected', () => this.loseGone(this.pads()));
  }

  /** The pads that are there, by the names of their inputs. */
  pads() {
    const pads = [...navigator.getGamepads()].filter((pad) => pad && pad.connected);
    return new Map(pads.map((pad) => [`gamepad ${pad.index} ${pad.id}`, pad]));
  }

  poll() {
    const pads = this.pads();
    this.loseGone(pads); // not every browser tells of it
    if (document.hidden || !document.hasFocus()) return;
    for (const [input, pad] of pads) this.read(input, pad, performance.now());
  }

  read(input, { axes, buttons, mapping }, now) {
    this.steering.set(input, 0 - axes[0], 0 - axes[1], now); // no -0
    if (!this.pressed.has(input)) this.pressed.set(input, {});
    const edge = (button, down, up) => this.edge(this.pressed.get(input), button, buttons[button], down, up);
    edge(STOP, () => this.stop.hold(input, now), () => this.stop.unhold(input, now));
    if (mapping === 'standard') edge(TOGGLE, this.toggle, () => {}); // else nobody knows what its buttons are; a stop counts all the same
  }

  edge(pressed, button, state, down, up) {
    const is = Boolean(state && state.pressed);
    if (is === Boolean(pressed[button])) return;
    pressed[button] = is;
    (is ? down : up)();
  }

  loseGone(pads) {
    for (const [input, pressed] of this.pressed) {
      if (pads.has(input)) continue;
      this.pressed.delete(input);
      if (pressed[STOP]) this.stop.keep();
      this.steering.gone(input);
    }
  }

  /** The pad that steers rumbles for a moment; strength in [0, 1]. */
  rumble(strength) {
    const pad = this.pads().get(this.steering.active);
    if (!pad || !pad.vibrationActuator) return;
    pad.vibrationActuator
      .playEffect('dual-rumble', { duration: 120, strongMagnitude: strength, weakMagnitude: strength })
      .catch(() => {}); // a pad that cannot rumble steers all the same
  }
}
