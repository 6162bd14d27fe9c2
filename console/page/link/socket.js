// SPDX-License-Identifier: BSD-3-Clause
// A WebSocket that connects again by itself. It queues nothing: what cannot be sent now is not sent.

const FIRST_WAIT = 300; // [ms] before it connects again
const LONGEST_WAIT = 3000; // [ms]

export class Socket {
  /** path: on this page's host; handlers: open(), message(data), closed(event). */
  constructor(path, handlers) {
    this.path = path;
    this.handlers = handlers;
    this.wait = FIRST_WAIT;
    this.ended = false;
    this.connect();
  }

  connect() {
    const scheme = location.protocol === 'https:' ? 'wss' : 'ws';
    const socket = new WebSocket(`${scheme}://${location.host}${this.path}`);
    socket.binaryType = 'arraybuffer';
    socket.onopen = () => {
      this.wait = FIRST_WAIT;
      this.handlers.open();
    };
    socket.onmessage = (event) => this.handlers.message(event.data);
    socket.onclose = (event) => {
      this.handlers.closed(event);
      if (this.ended) return;
      this.timer = setTimeout(() => this.connect(), this.wait);
      this.wait = Math.min(LONGEST_WAIT, this.wait * 1.6);
    };
    this.socket = socket;
  }

  get open() {
    return this.socket.readyState === WebSocket.OPEN;
  }

  /** Sends an object as JSON; says whether it could. */
  send(message) {
    if (!this.open) return false;
    this.socket.send(JSON.stringify(message));
    return true;
  }

  /** Closes this connection and makes another. */
  again() {
    this.socket.close(1000);
  }

  /** Ends it for good. */
  end() {
    this.ended = true;
    clearTimeout(this.timer);
    this.socket.close(1000);
  }
}

/** The random name of this tab, which keeps the controls for it over a cut. */
export function pageName() {
  let name = sessionStorage.getItem('page');
  if (!name) {
    name = [...crypto.getRandomValues(new Uint8Array(16))].map((byte) => byte.toString(16).padStart(2, '0')).join('');
    sessionStorage.setItem('page', name);
  }
  return name;
}
