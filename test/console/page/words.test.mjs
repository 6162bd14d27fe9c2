// SPDX-License-Identifier: BSD-3-Clause
// What the page says of the robot's state, with a goal and without one.
import assert from 'node:assert/strict';
import { test } from 'node:test';

import { load } from './page.mjs';

const { announce, describe, inControl } = await load('model/words.js');
const { emptyScene } = await load('model/scene.js');

const GOAL = { x: 1, y: 2, yaw: 0 };

/** A scene in which the planner runs a cycle, or none (name null). */
const scene = (name, { withoutGoal = false, driveWithoutGoal = false, goals = [] } = {}) => ({
  ...emptyScene(),
  state: name && { name, withoutGoal, next: 'straight', nextReason: '' },
  goals,
  limits: { driveWithoutGoal },
});

test('without a goal the title says who drives, and that there is none', () => {
  const { key, title, line } = describe(scene('MANUAL', { withoutGoal: true }));
  assert.deepEqual([key, title], ['MANUAL', 'You drive. No goal.']);
  assert.match(line, /stops if you let go/);
  assert.equal(describe(scene('AUTONOMY', { withoutGoal: true })).title, 'You let go');
});

test('a goal that is not there is not kept', () => {
  assert.match(describe(scene('STOPPED')).line, /goal is kept/);
  assert.doesNotMatch(describe(scene('STOPPED', { withoutGoal: true })).line, /goal/);
});

test('with a goal every state says what it said', () => {
  const titles = ['AUTONOMY', 'SHARED', 'HOLD', 'MANUAL', 'STOPPED', 'LOST', 'BLOCKED'].map((name) => describe(scene(name, { goals: [GOAL] })).title);
  assert.deepEqual(titles, ['The robot drives itself', 'You steer', 'You let go', 'You drive', 'Stopped', 'Lost your steering', 'Blocked']);
});

test('a robot that rests invites to steer where that drives it', () => {
  assert.equal(describe(scene(null)).line, 'Set a goal in the map: steering works on the way to a goal.');
  assert.equal(describe(scene(null, { driveWithoutGoal: true })).line, 'Steer to drive, or set a goal in the map.');
  assert.equal(describe(scene(null, { driveWithoutGoal: true, goals: [GOAL] })).title, 'Waiting');
  assert.equal(describe(scene(null, { driveWithoutGoal: true })).title, 'No goal');
});

test('control is given back, and autonomy is announced, with a goal only', () => {
  assert.deepEqual([inControl(null), inControl(scene('MANUAL').state), inControl(scene('MANUAL', { withoutGoal: true }).state)], [false, true, false]);
  assert.equal(announce(scene('MANUAL').state), 'Next: straight on');
  assert.equal(announce(scene('MANUAL', { withoutGoal: true }).state), '');
});
