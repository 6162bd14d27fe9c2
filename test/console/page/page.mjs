// SPDX-License-Identifier: BSD-3-Clause
// A browser's clock, timers and events for the page's modules, as far as they need them; a test moves the time on.
export const clock = { now: 1e4 }; // [ms]
const timers = [];

export const listeners = new Map();
const listen = (type, listener) => listeners.set(type, [...(listeners.get(type) || []), listener]);

Object.defineProperty(globalThis, 'performance', { value: { now: () => clock.now }, configurable: true });
globalThis.setInterval = (call, period) => timers.push({ call, period, due: clock.now + period });
globalThis.setTimeout = (call, wait) => timers.push({ call, due: clock.now + Math.max(0, wait) });
globalThis.clearTimeout = (number) => number && (timers[number - 1].due = Infinity);
globalThis.addEventListener = listen;
globalThis.document = { addEventListener: listen, hidden: false, hasFocus: () => true };
globalThis.Element = globalThis.HTMLButtonElement = class {};

/** A new page: no timers, no listeners. */
export function reset() {
  timers.length = 0;
  listeners.clear();
}

/** An event happens. */
export function happens(type, event = {}) {
  for (const listener of listeners.get(type) || []) listener({ preventDefault() {}, ...event });
}

/** Time goes on [ms]; timers come when they are due. */
export function pass(milliseconds) {
  const end = clock.now + milliseconds;
  for (;;) {
    const next = timers.reduce((first, one) => (!first || one.due < first.due ? one : first), null);
    if (!next || next.due > end) break;
    clock.now = Math.max(clock.now, next.due);
    next.due = next.period ? clock.now + next.period : Infinity;
    next.call();
  }
  clock.now = end;
}

/** The page stands still for so long [ms]: no timer comes. */
export function stall(milliseconds) {
  clock.now += milliseconds;
}

/** A module of the page. */
export const load = (path) => import(`${process.env.HIDWA_PAGE}/${path}`);
