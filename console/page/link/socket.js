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

// The name of this tab. A tab that is duplicated copies its storage, so the name lies there only from the end of a page to the
// beginning of the next one in the same tab: it outlives a reload, and is never in two tabs.
const FORM = /^[0-9a-f]{32}$/;
let name = null;

function randomName() {
  return [...crypto.getRandomValues(new Uint8Array(16))].map((byte) => byte.toString(16).padStart(2, '0')).join('');
}

/** Does something with the tab's storage, which a browser may refuse: then a reload makes a new name. */
function withStorage(use) {
  try {
    return use(sessionStorage);
  } catch (error) {
    console.warn('this browser gives no storage:', error.message);
    return null;
  }
}

/** The random name of this tab, which keeps the controls for it over a cut. */
export function pageName() {
  if (!name) {
    const kept = withStorage((storage) => storage.getItem('page'));
    name = FORM.test(kept || '') ? kept : randomName();
    forget();
    addEventListener('pagehide', () => withStorage((storage) => storage.setItem('page', name)));
    addEventListener('pageshow', forget);
  }
  return name;
}

function forget() {
  withStorage((storage) => storage.removeItem('page'));
}

/** Another tab has this one's name. */
export function anotherName() {
  name = randomName();
}
