// SPDX-License-Identifier: BSD-3-Clause
// The socket /control: what this page commands, and what became of it. Commands have a socket of their own, so that they
// never wait behind pictures, and nothing is queued while the socket is down: an old command is not sent at all.
import { bounded, EventTimes } from './outgoing.js';
import { anotherName, pageName, Socket } from './socket.js';

const PERIOD = 500; // [ms] between two pings: while one waits for its answer the server sends no other
const WATCH = 250; // [ms]
const NAMESAKE = 4001; // close code: another page has said hello by the same name

export class ControlLink {
  /**
   * name: how others see this visitor. handlers: welcome(m), control(m), claim(m), steering(m), stop(m), told(m),
   * delay({rtt, delay}), silent(ms: for how long a ping has been due), connection(open), namesake(): another tab had the same
   * name, and this one has a new one; unsent(type): a message was not sent, since one of its numbers is none.
   */
  constructor(name, handlers) {
    this.handlers = handlers;
    this.pings = 0;
    this.pinged = 0; // [ms], when the last one came
    this.times = new EventTimes();
    setInterval(() => this.watch(), WATCH);
    this.socket = new Socket('/control', {
      open: () => {
        this.socket.send({ type: 'hello', page: pageName(), name });
        handlers.connection(true);
      },
      message: (data) => this.take(JSON.parse(data)),
      closed: (event) => {
        this.pings = 0;
        if (event.code === NAMESAKE) {
          anotherName();
          handlers.namesake();
        }
        handlers.connection(false, event);
      },
    });
  }

  /** A link that stands still brings no ping that could say so. */
  watch() {
    if (this.pings < 2) return; // it has no rhythm yet
    const due = performance.now() - this.pinged - PERIOD;
    if (due > WATCH) this.handlers.silent(due);
  }

  take(message) {
    if (message.type === 'ping') {
      this.pings += 1;
      this.pinged = performance.now();
      this.socket.send({ type: 'pong', id: message.id, t: performance.now() });
      this.handlers.delay(message);
    } else if (this.handlers[message.type]) {
      this.handlers[message.type](message);
    }
  }

  /** Sends a command that carries the time of what caused it: an event's timeStamp, or now. Says whether it could. */
  command(type, fields = {}, t = performance.now()) {
    const sane = bounded(type, fields);
    if (!sane) this.handlers.unsent(type);
    return sane !== null && this.socket.send({ type, t: this.times.of(t), ...sane });
  }
}
