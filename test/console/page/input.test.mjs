// SPDX-License-Identifier: BSD-3-Clause
// The person's devices in the page: which of them steers, and that each of them lets go.
import assert from 'node:assert/strict';
import { beforeEach, test } from 'node:test';

import { clock, happens, load, pass, reset } from './page.mjs';

const { Gamepads } = await load('input/gamepad.js');
const { HandSteering } = await load('input/hand_steering.js');
const { Keyboard } = await load('input/keyboard.js');
const { Rest } = await load('input/rest.js');
const { Steering } = await load('input/steering.js');
const { Stop } = await load('input/stop.js');

let pads, sent, steering, toggled;

/** A gamepad; axes as the Gamepad API has them: left and up are -1. */
function pad(index, axes = [0, 0, 0, 0], id = `pad ${index}`) {
  return { index, id, connected: true, mapping: 'standard', axes, buttons: Array.from({ length: 16 }, () => ({ pressed: false })) };
}

function begin(...all) {
  pads = all;
  pass(50);
  sent.length = 0;
}

/** The last stick message as [left, forward, held]. */
function last() {
  const sticks = sent.filter(({ type }) => type === 'stick');
  const { left, forward, held } = sticks[sticks.length - 1] || {};
  return [left, forward, held];
}

const drag = (left, forward) => steering.set('screen', left, forward, clock.now, true);

beforeEach(() => {
  reset();
  pads = [];
  sent = [];
  toggled = 0;
  Object.defineProperty(globalThis, 'navigator', { value: { getGamepads: () => pads }, configurable: true });
  const send = (type, fields, t) => sent.push({ type, t, ...fields });
  steering = new Steering(send);
  new Gamepads(steering, new Stop(send), () => (toggled += 1));
});

test('the pad that is moved steers, whatever the first one is', () => {
  const others = {
    dead: [0, 0],
    'without axes': [],
    'stuck at its end': [1, -1],
    'a hat in the place of the stick': [3.2857, 3.2857],
    'of no numbers': [NaN, undefined],
  };
  for (const [what, axes] of Object.entries(others)) {
    const other = pad(0, axes, what);
    const moved = pad(1);
    begin(null, other, moved);
    moved.axes = [-1, -0.25];
    pass(32);
    assert.deepEqual(last(), [1, 0.25, true], what);
    moved.axes = [0, 0];
    pass(200);
    assert.deepEqual(last(), [0, 0, false], what);
    assert.equal(sent.filter(({ held }) => held === false).length, 1, what);
  }
});

test('a pad that was there alone gives way to one that is plugged in', () => {
  const first = pad(0);
  begin(first);
  first.axes = [0.5, 0];
  pass(32);
  first.axes = [0, 0];
  pass(32);
  pads = [first, pad(1)];
  pass(32);
  pads[1].axes = [0, -1];
  pass(32);
  assert.deepEqual(last(), [0, 1, true]);
});

test('a worn pad takes nothing from a stick that a finger drags', () => {
  for (const rest of [0.09, 0.2, -0.29]) {
    const worn = pad(0, [rest, 0], `rest ${rest}`);
    begin(worn);
    drag(-0.8, 0.1);
    for (let i = 0; i < 200; ++i) {
      worn.axes[0] = rest + 0.01 * (i % 2); // it trembles
      pass(16);
      if (i % 10 === 0) drag(-0.8, 0.1 + 0.001 * i);
    }
    assert.ok(sent.every(({ left }) => left === -0.8), `rest ${rest}`);
    steering.let('screen', clock.now);
    pass(500);
    assert.deepEqual(last(), [0, 0, false], `rest ${rest}`);
  }
});

test('a worn pad reaches its ends, and comes to rest elsewhere after a push', () => {
  const worn = pad(0, [0.09, 0]);
  begin(worn);
  worn.axes = [1, 0];
  pass(32);
  assert.deepEqual(last(), [-1, 0, true]);
  worn.axes = [-1, 0];
  pass(32);
  assert.deepEqual(last(), [1, 0, true]);
  worn.axes = [-0.1, 0]; // 0.19 from where it rested before, 0.1 beyond the middle: held, until it has lain there for a second
  pass(1100);
  assert.deepEqual(last(), [0, 0, false]);
  const count = sent.length;
  pass(1000);
  assert.equal(sent.length, count, 'silence');
});

test('who holds the stick when it is seen first steers nowhere until it was seen near the middle', () => {
  const held = pad(0, [0, -1]);
  begin(held);
  pass(2000);
  assert.deepEqual(sent, []);
  held.axes = [0, -0.25]; // on its way back
  pass(16);
  held.axes = [0, 0];
  pass(3000);
  assert.deepEqual(sent, [], 'and it steers to no other side then');
  held.axes = [0, -1];
  pass(32);
  assert.deepEqual(last(), [0, 1, true]);
});

test('a stick that is held still goes on', () => {
  const one = pad(0);
  begin(one);
  one.axes = [0.2, -0.6];
  pass(5000);
  assert.deepEqual(last(), [-0.2, 0.6, true]);
});

test('of two that are held the one that was moved last steers; what lies or creeps takes nothing', () => {
  const lies = pad(0);
  begin(lies);
  lies.axes = [0.5, 0];
  pass(32);
  drag(1, 0);
  assert.deepEqual(last(), [1, 0, true]);
  for (let i = 0; i < 100; ++i) {
    lies.axes[0] = 0.5 + 0.004 * i; // 0.4 within 5 s: 0.08 a second
    pass(50);
  }
  assert.deepEqual(last(), [1, 0, true]);
  lies.axes[0] = 0.2;
  pass(32);
  assert.deepEqual(last(), [-0.2, 0, true]);
  drag(0.9, 0);
  assert.deepEqual(last(), [-0.2, 0, true], 'a finger that trembles');
  drag(0.5, 0);
  assert.deepEqual(last(), [0.5, 0, true]);
});

test('a reading beyond its end, or none', () => {
  const one = pad(0);
  begin(one);
  for (const [value, left] of [[1.00002, -1], [-1.5, 1], [Infinity, 0], [NaN, 0], [undefined, 0]]) {
    one.axes = [value, -0.5];
    pass(32);
    assert.deepEqual(last(), [left, 0.5, true], String(value));
  }
});

test('a pad that is gone releases, whether the browser tells of it or not', () => {
  const ways = {
    told: () => happens('gamepaddisconnected', { gamepad: pads.pop() }),
    'no longer listed': () => pads.pop(),
    'an empty place': () => pads.splice(0, 1, null),
    'no longer connected': () => (pads[0].connected = false),
    'another one in its place': () => pads.splice(0, 1, pad(0, [1, 0], 'another')),
  };
  for (const [what, goes] of Object.entries(ways)) {
    begin();
    begin(pad(0));
    pads[0].axes = [1, 0];
    pass(32);
    sent.length = 0;
    goes();
    pass(500);
    assert.deepEqual(sent.map(({ type, why }) => [type, why]), [['release', 'device']], what);
  }
});

test('buttons of every pad count, and a stop of one that is gone stays', () => {
  begin(pad(0), pad(1));
  pads[1].buttons[1].pressed = true;
  pads[1].buttons[0].pressed = true;
  pass(32);
  assert.deepEqual([sent.map(({ type, on }) => [type, on]), toggled], [[['stop', true]], 1]);
  pads.pop();
  pass(100);
  assert.equal(sent.length, 1);
});

test('a device that is no gamepad hands over no control', () => {
  begin({ ...pad(0), mapping: '' });
  for (let i = 0; i < 10; ++i) {
    pads[0].buttons[0].pressed = i % 2 === 0;
    pass(32);
  }
  assert.equal(toggled, 0);
});

test('keys that come up unheard, behind Command, steer no more', () => {
  const keyboard = new Keyboard(steering, {});
  happens('keydown', { code: 'ArrowLeft', key: 'ArrowLeft', timeStamp: clock.now });
  assert.deepEqual(last(), [0.7, 0, true]);
  happens('keydown', { code: 'MetaLeft', key: 'Meta', metaKey: true, timeStamp: clock.now });
  assert.deepEqual(last(), [0, 0, false]);
  assert.equal(keyboard.down.size, 0);
});

test('a hand in a quick headset sends no more than the server takes', () => {
  const hands = new HandSteering((type, fields, t) => sent.push({ type, t, ...fields }), steering, new Stop(() => {}), () => {});
  const source = (grip) => [{ key: 'right', hand: true, grip, at: { left: 0, forward: 0, up: 1 } }];
  for (let i = 0; i < 144; ++i) {
    hands.take(source(true), clock.now);
    pass(1000 / 144);
  }
  assert.ok(sent.length > 60 && sent.length <= 84, `${sent.length} within a second`); // 1000 / 12
  hands.take(source(false), clock.now);
  assert.equal(sent[sent.length - 1].grip, false, 'letting go is not held back');
});

test('a thumbstick of a headset that drifts takes nothing either', () => {
  const hands = new HandSteering(() => {}, steering, new Stop(() => {}), () => {});
  const stick = (left) => hands.take([{ key: 'left', hand: false, stick: { left, forward: 0 }, grip: false, at: null }], clock.now);
  stick(0.15);
  drag(-0.5, 0);
  for (let i = 0; i < 100; ++i) {
    stick(0.15 + 0.005 * (i % 3));
    pass(14);
  }
  assert.ok(sent.every(({ left }) => left === -0.5));
});

test('the deflection of a reading', () => {
  const rest = new Rest();
  rest.read(0.1, -0.2, 0);
  assert.deepEqual(rest.read(0.1, -0.2, 10), { left: 0, forward: 0, held: false });
  assert.deepEqual(rest.read(0, 0, 20), { left: 0, forward: 0, held: false }, 'nearer to the middle than its rest');
  const { left, forward } = rest.read(0.55, -0.6, 30);
  assert.ok(Math.abs(left - 0.5) < 1e-12); // (0.55 - 0.1) / (1 - 0.1)
  assert.ok(Math.abs(forward + 0.5) < 1e-12); // -(0.6 - 0.2) / (1 - 0.2)
});
