// SPDX-License-Identifier: BSD-3-Clause
// What leaves the page: numbers and times that the server takes, by the name of one tab.
import assert from 'node:assert/strict';
import { beforeEach, test } from 'node:test';

import { clock, happens, listeners, load, pass, reset, stall } from './page.mjs';

const { ControlLink } = await load('link/control_link.js');

let link, sockets, told;

class FakeSocket {
  constructor() {
    this.readyState = FakeSocket.OPEN;
    this.sent = [];
    sockets.push(this);
  }

  send(text) {
    this.sent.push(JSON.parse(text));
  }

  close() {}
}
FakeSocket.OPEN = 1;

/** A tab's sessionStorage. */
function storage(content = {}) {
  const values = new Map(Object.entries(content));
  return {
    values,
    getItem: (key) => (values.has(key) ? values.get(key) : null),
    setItem: (key, value) => values.set(key, value),
    removeItem: (key) => values.delete(key),
  };
}

function store(value) {
  Object.defineProperty(globalThis, 'sessionStorage', typeof value === 'function' ? { get: value, configurable: true } : { value, configurable: true });
}

let tabs = 0;
/** The module of a page that begins in a tab with this storage. */
function page(of) {
  listeners.clear();
  store(of);
  tabs += 1;
  return load(`link/socket.js?${tabs}`);
}

const sent = () => sockets[sockets.length - 1].sent;

beforeEach(() => {
  reset();
  sockets = [];
  told = [];
  globalThis.WebSocket = FakeSocket;
  globalThis.location = { protocol: 'http:', host: 'localhost' };
  store(storage());
  link = new ControlLink('', {
    connection: (open) => told.push(open), namesake: () => told.push('namesake'), unsent: (type) => told.push(`unsent ${type}`),
  });
  pass(2000);
});

test('numbers are brought into their bounds', () => {
  link.command('stick', { left: 1.00002, forward: -1.7, held: true });
  link.command('hand', { left: 1e9, forward: 0.1, up: -101, grip: true });
  link.command('goal', { x: 2e5, y: 3, yaw: null, append: false });
  assert.deepEqual(sent().map(({ t, ...fields }) => fields), [
    { type: 'stick', left: 1, forward: -1, held: true },
    { type: 'hand', left: 100, forward: 0.1, up: -100, grip: true },
    { type: 'goal', x: 1e5, y: 3, yaw: null, append: false },
  ]);
});

test('what is no number does not leave, and that is said', () => {
  assert.equal(link.command('stick', { left: NaN, forward: 0, held: true }), false);
  assert.equal(link.command('hand', { left: 0, forward: Infinity, up: 0, grip: true }), false);
  assert.equal(link.command('tune', { values: { s_v: NaN } }), false);
  assert.equal(link.command('study', { answer: { ratings: { mental: Infinity } } }), false);
  assert.deepEqual(sent(), []);
  assert.deepEqual(told, ['unsent stick', 'unsent hand', 'unsent tune', 'unsent study']);
});

test('times that cannot be are replaced by the present, also for letting go', () => {
  const wrong = { nought: 0, negative: -5, epoch: 1.7e12, 'of the machine': 8.64e7, seconds: 12, early: clock.now - 1000, future: clock.now + 1,
    none: undefined, 'no number': NaN, nothing: null };
  for (const [what, t] of Object.entries(wrong)) {
    link.command('stick', { left: 1, forward: 0, held: true }, t);
    link.command('stick', { left: 0, forward: 0, held: false }, t);
    link.command('stop', { on: false }, t);
    assert.deepEqual(sent().splice(0).map((one) => one.t), [clock.now, clock.now, clock.now], what);
  }
});

test('an event keeps its time as far as it can have waited', () => {
  link.command('stop', { on: false }, clock.now - 100);
  assert.equal(sent().pop().t, clock.now - 100);
  const pressed = clock.now + 300;
  stall(3000); // the page draws, say; the event waits from `pressed` on
  link.command('stick', { left: 1, forward: 0, held: true }, pressed);
  assert.equal(sent().pop().t, pressed, 'an old command does not become a new one');
  pass(60); // the timer came first
  link.command('stick', { left: 1, forward: 0, held: true }, pressed);
  assert.equal(sent().pop().t, pressed);
  pass(2000);
  link.command('stick', { left: 1, forward: 0, held: true }, pressed);
  assert.equal(sent().pop().t, clock.now, 'since then the page was free');
});

test('a tab keeps its name over a reload, and a copy of the tab has another one', async () => {
  const tab = storage();
  const first = await page(tab);
  const name = first.pageName();
  assert.match(name, /^[0-9a-f]{32}$/);
  assert.equal(first.pageName(), name);
  const copy = storage(Object.fromEntries(tab.values));
  assert.notEqual((await page(copy)).pageName(), name);
  const again = await page(tab);
  again.pageName();
  happens('pagehide');
  assert.equal((await page(tab)).pageName(), again.pageName());
});

test('a page that comes back from the cache of pages leaves no name to copy', async () => {
  const tab = storage();
  const first = await page(tab);
  first.pageName();
  happens('pagehide', { persisted: true });
  happens('pageshow', { persisted: true });
  assert.equal(tab.values.size, 0);
});

test('a storage that is refused, or holds something else', async () => {
  const refused = await page(() => {
    throw new Error('SecurityError');
  });
  assert.match(refused.pageName(), /^[0-9a-f]{32}$/);
  assert.equal(refused.pageName(), refused.pageName());
  assert.match((await page(storage({ page: 'of another program' }))).pageName(), /^[0-9a-f]{32}$/);
});

test('a page whose name another one has takes a new one, once', () => {
  sockets[0].onopen();
  const [{ page: name }] = sent();
  told.length = 0;
  sockets[0].onclose({ code: 4001 });
  pass(1000);
  sockets[1].onopen();
  const [{ page: other }] = sent();
  assert.notEqual(other, name);
  assert.deepEqual(told, ['namesake', false, true]);
  sockets[1].onclose({ code: 1006 });
  pass(1000);
  sockets[2].onopen();
  assert.equal(sent()[0].page, other, 'a cut keeps the name');
});
