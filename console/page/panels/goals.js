// SPDX-License-Identifier: BSD-3-Clause
// Going somewhere: a goal by a press on the map, several in a row, cancel, skip, back to the start.

const byId = (id) => document.getElementById(id);

export class GoalPanel {
  /** pointer: views/map_pointer.js; send(type, fields): to the server; say(text): to the person. */
  constructor(pointer, send, say) {
    this.pointer = pointer;
    this.send = send;
    this.say = say;
    this.outcome = null; // of the last goal; null: the server has not said it yet
    this.arming = null; // the button that waits for a place
    byId('go').addEventListener('click', () => this.arm('go'));
    byId('add').addEventListener('click', () => this.arm('add'));
    byId('cancel').addEventListener('click', () => send('cancel'));
    byId('skip').addEventListener('click', () => send('skip'));
    byId('home').addEventListener('click', () => send('home'));
    addEventListener('keydown', (event) => {
      if (event.key === 'Escape') this.arm(null);
    });
  }

  arm(which) {
    this.arming = which === this.arming ? null : which;
    for (const id of ['go', 'add']) byId(id).setAttribute('aria-pressed', String(id === this.arming));
    byId('placing').hidden = !this.arming;
    this.pointer.arm(Boolean(this.arming));
  }

  /** The map says where. */
  placed({ x, y, yaw }) {
    const append = this.arming === 'add';
    this.arm(null);
    this.send('goal', { x, y, yaw, append });
  }

  tick({ goals }) {
    if (!goals) return;
    byId('cancel').hidden = !goals.active && goals.waiting.length === 0;
    byId('skip').hidden = goals.waiting.length === 0;
    this.tell(goals);
  }

  /** How a goal ended; not what ended before this page was there. */
  tell({ outcome, text }) {
    const before = this.outcome;
    this.outcome = outcome;
    if (before === null || before === outcome) return;
    if (outcome === 'reached') this.say('The goal is reached.');
    if (outcome === 'failed') this.say(`The goal was not reached${text ? `: ${text}` : '.'}`);
  }
}
