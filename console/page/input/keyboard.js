// SPDX-License-Identifier: BSD-3-Clause
// Steering by the arrow keys or WASD (with shift: full deflection), space stops, G lets go of a stop.

const WAYS = {
  ArrowLeft: [1, 0], KeyA: [1, 0], ArrowRight: [-1, 0], KeyD: [-1, 0],
  ArrowUp: [0, 1], KeyW: [0, 1], ArrowDown: [0, -1], KeyS: [0, -1],
};
const GENTLE = 0.7; // deflection without shift

/** Whether a key belongs to what has the focus: text, numbers, lists. */
function isTyping(target) {
  return target instanceof Element && target.closest('input, select, textarea, dialog, [role=slider]') !== null;
}

export class Keyboard {
  /** stop: input/stop.js */
  constructor(steering, stop) {
    this.steering = steering;
    this.down = new Map();
    addEventListener('keydown', (event) => this.press(event, stop));
    addEventListener('keyup', (event) => this.lift(event));
  }

  /** After a cut: a key that is down no longer counts. */
  clear() {
    this.down.clear();
  }

  press(event, stop) {
    if (event.key === 'Meta') this.drop(event); // macOS tells of no key that comes up while this one is down
    if (event.code === 'Space' && !(event.target instanceof HTMLButtonElement) && !isTyping(event.target)) {
      event.preventDefault();
      if (!event.repeat) stop.press(event.timeStamp);
      return;
    }
    if (isTyping(event.target) || event.ctrlKey || event.altKey || event.metaKey) return;
    if (event.code === 'KeyG' && !event.repeat) stop.letGo(event.timeStamp);
    if (!WAYS[event.code]) return;
    event.preventDefault();
    if (event.repeat && !this.down.has(event.code)) return; // held since before a cut
    if (this.down.size === 0) this.steering.blocked.delete('keyboard'); // no key was down: that is neutral
    this.down.set(event.code, true);
    this.tell(event);
  }

  lift(event) {
    if (this.down.delete(event.code)) this.tell(event);
  }

  drop(event) {
    if (this.down.size === 0) return;
    this.down.clear();
    this.tell(event);
  }

  tell(event) {
    let left = 0;
    let forward = 0;
    for (const code of this.down.keys()) {
      left += WAYS[code][0];
      forward += WAYS[code][1];
    }
    const size = (event.shiftKey ? 1 : GENTLE) / Math.max(1, Math.hypot(left, forward));
    this.steering.set('keyboard', left * size, forward * size, event.timeStamp, this.down.size > 0);
  }
}
