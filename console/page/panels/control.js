// SPDX-License-Identifier: BSD-3-Clause
// Who holds the controls: take them, hand them over, be asked for them.

const byId = (id) => document.getElementById(id);

const CLAIMS = {
  asked: 'The holder is asked.',
  refused: 'The holder keeps the controls.',
  gone: 'The holder has left: ask again.',
};

function visitorName({ name, visitor }) {
  return name || `visitor ${visitor}`;
}

export class ControlPanel {
  /** send(type, fields): to the server; say(text): to the person. */
  constructor(send, say) {
    this.send = send;
    this.say = say;
    this.control = null;
    byId('claim').addEventListener('click', () => send('claim'));
    byId('give').addEventListener('click', () => send('give'));
    byId('request-yes').addEventListener('click', () => this.answer('give'));
    byId('request-no').addEventListener('click', () => this.answer('refuse'));
  }

  get mine() {
    return Boolean(this.control && this.control.held);
  }

  answer(type) {
    if (this.asking) this.send(type, { to: this.asking.visitor });
  }

  claimed({ result }) {
    if (CLAIMS[result]) this.say(CLAIMS[result]); // what was granted, the head of the page says
  }

  /** The server's message `control`. */
  show(control) {
    this.control = control;
    const holder = control.visitors.find((one) => one.holder);
    const others = control.visitors.length - 1;
    const watchers = others > 0 ? ` ${others} other${others > 1 ? 's' : ''} here.` : '';
    byId('who-text').textContent = control.held
      ? `You have the controls.${watchers}`
      : holder ? `${visitorName(holder)} has the controls. You watch.` : 'Nobody has the controls.';
    byId('claim').hidden = control.held;
    byId('claim').textContent = holder ? 'Ask for the controls' : 'Take the controls';
    byId('give').hidden = !control.held;
    byId('stick').classList.toggle('off', !control.held);
    this.asking = control.held && control.claims.length ? control.claims[0] : null;
    byId('request').hidden = !this.asking;
    if (this.asking) byId('request-text').textContent = `${visitorName(this.asking)} asks for the controls.`;
    for (const id of ['go', 'add', 'home', 'cancel', 'skip', 'record', 'take']) byId(id).disabled = !control.held;
  }

  gone() {
    this.control = null;
    byId('who-text').textContent = '';
    byId('claim').hidden = byId('give').hidden = byId('request').hidden = true;
  }
}
