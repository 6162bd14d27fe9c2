// SPDX-License-Identifier: BSD-3-Clause
// Gamepads by the Gamepad API: the left stick steers (there left and up are -1), the right face button (B, circle) stops as
// long as it is held, the lower one (A, cross) takes and gives back control in mode switching.

const POLL = 16; // [ms]; by a timer, so that a slow drawing delays nothing
const TOGGLE = 0;
const STOP = 1;

export class Gamepads {
  /** stop: input/stop.js; toggle(): takes or gives back control. */
  constructor(steering, stop, toggle) {
    this.steering = steering;
    this.stop = stop;
    this.toggle = toggle;
    this.pressed = {};
    this.known = null;
    setInterval(() => this.poll(), POLL);
    addEventListener('gamepaddisconnected', (event) => this.gone(event));
  }

  /** The pad that was used last, or the first one. */
  pad() {
    const pads = [...navigator.getGamepads()].filter((pad) => pad && pad.connected);
    return pads.find((pad) => pad.index === this.known) || pads[0];
  }

  poll() {
    if (document.hidden || !document.hasFocus()) return;
    const pad = this.pad();
    if (!pad) return;
    this.known = pad.index;
    const now = performance.now();
    this.steering.set('gamepad', -pad.axes[0] + 0, -pad.axes[1] + 0, now); // + 0: no -0
    this.edge(pad, STOP, () => this.stop.hold('gamepad', now), () => this.stop.unhold('gamepad', now));
    this.edge(pad, TOGGLE, this.toggle, () => {});
  }

  edge(pad, button, down, up) {
    const is = Boolean(pad.buttons[button] && pad.buttons[button].pressed);
    if (is === Boolean(this.pressed[button])) return;
    this.pressed[button] = is;
    (is ? down : up)();
  }

  gone(event) {
    if (event.gamepad.index !== this.known) return;
    this.known = null;
    this.pressed = {};
    this.stop.keep();
    if (this.steering.active !== 'gamepad') return;
    this.steering.cut('device');
    this.steering.blocked.delete('gamepad');
    this.steering.wake();
  }

  /** Rumbles for a moment; strength in [0, 1]. */
  rumble(strength) {
    const pad = this.pad();
    if (!pad || !pad.vibrationActuator || this.steering.active !== 'gamepad') return;
    pad.vibrationActuator
      .playEffect('dual-rumble', { duration: 120, strongMagnitude: strength, weakMagnitude: strength })
      .catch(() => {}); // a pad that cannot rumble steers all the same
  }
}
