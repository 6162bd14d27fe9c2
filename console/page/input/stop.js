// SPDX-License-Identifier: BSD-3-Clause
// Stopping the robot. The button on the screen and the space bar stop until somebody lets go on purpose; a gamepad's or a
// controller's button stops as long as it is held. Where the page can no longer know whether a button is held (hidden tab, lost
// device), the stop stays until somebody lets go on purpose.

export class Stop {
  /** send(type, fields, t): to the server. */
  constructor(send) {
    this.send = send;
    this.holding = new Set(); // buttons that hold a stop now
    this.stays = false; // nobody's button ends it: it was pressed, or was there before the button
    this.on = false; // the server holds a stop
  }

  /** The server says whether it holds a stop. */
  told(on) {
    this.on = on;
    if (!on) this.stays = false;
  }

  /** Stops, and stays so. */
  press(t) {
    this.stays = true;
    this.send('stop', { on: true }, t);
  }

  /** A button is held down. */
  hold(button, t) {
    if (this.on && this.holding.size === 0) this.stays = true;
    this.holding.add(button);
    this.send('stop', { on: true }, t);
  }

  /** That button came up: the stop ends if it held this stop and nothing else does. */
  unhold(button, t) {
    if (this.holding.delete(button) && this.holding.size === 0 && !this.stays) this.send('stop', { on: false }, t);
  }

  /** What is held now stays, also when the button comes up. */
  keep() {
    if (this.holding.size > 0) this.stays = true;
    this.holding.clear();
  }

  /** Somebody lets go on purpose. */
  letGo(t) {
    this.stays = false;
    this.holding.clear();
    this.send('stop', { on: false }, t);
  }
}
