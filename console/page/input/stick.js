// SPDX-License-Identifier: BSD-3-Clause
// The stick on the screen, by finger, pen or mouse. The pointer is captured, so a drag may leave the stick; a pointer that is
// taken away (a system gesture, a call) releases it.

const TRAVEL = 0.36; // of the base's width: full deflection

export class ScreenStick {
  /** base: the element to press; steering: input/steering.js. The knob is the base's first child. */
  constructor(base, steering) {
    this.base = base;
    this.knob = base.firstElementChild;
    this.steering = steering;
    this.pointer = null;
    base.addEventListener('pointerdown', (event) => this.down(event));
    // Raw updates come at once, moves only with the next frame; a browser without the former has the latter.
    for (const move of ['pointerrawupdate', 'pointermove']) base.addEventListener(move, (event) => this.move(event));
    base.addEventListener('pointerup', (event) => this.up(event));
    base.addEventListener('pointercancel', (event) => this.lost(event));
    base.addEventListener('lostpointercapture', (event) => this.lost(event));
    base.addEventListener('contextmenu', (event) => event.preventDefault());
    steering.onChange(({ left, forward }) => this.draw(left, forward));
  }

  down(event) {
    if (this.pointer !== null || event.button !== 0) return;
    event.preventDefault();
    this.pointer = event.pointerId;
    this.base.setPointerCapture(event.pointerId);
    this.steering.blocked.delete('screen'); // a new press begins in neutral
    const box = this.base.getBoundingClientRect();
    this.middle = [event.clientX, event.clientY]; // where the finger lies is the middle: no jump
    this.travel = box.width * TRAVEL;
    this.steering.set('screen', 0, 0, event.timeStamp, true);
  }

  move(event) {
    if (event.pointerId !== this.pointer) return;
    const dx = (event.clientX - this.middle[0]) / this.travel;
    const dy = (event.clientY - this.middle[1]) / this.travel;
    const far = Math.max(1, Math.hypot(dx, dy));
    this.steering.set('screen', -dx / far, -dy / far, event.timeStamp, true);
  }

  up(event) {
    if (event.pointerId !== this.pointer) return;
    this.pointer = null;
    this.steering.let('screen', event.timeStamp);
  }

  lost(event) {
    if (event.pointerId !== this.pointer) return;
    this.pointer = null;
    this.steering.cut('pointer');
    this.steering.wake();
  }

  draw(left, forward) {
    const shift = this.base.clientWidth * TRAVEL;
    this.knob.style.transform = `translate(${(-left * shift).toFixed(1)}px, ${(-forward * shift).toFixed(1)}px)`;
    this.base.classList.toggle('held', left !== 0 || forward !== 0);
  }
}
