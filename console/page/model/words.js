// SPDX-License-Identifier: BSD-3-Clause
// What the page says about the robot, in plain sentences.

const STATES = {
  AUTONOMY: ['The robot drives itself', 'Steer at any time: it bends its way to your side.'],
  SHARED: ['You steer', 'It bends its way to your side and avoids obstacles.'],
  HOLD: ['You let go', 'Straight on for a moment, then on to the goal.'],
  MANUAL: ['You drive', 'It goes where the stick says, and stops if you let go.'],
  STOPPED: ['Stopped', 'It stands until the stop ends. The goal is kept.'],
  LOST: ['Lost your steering', 'Nothing came from your stick. Centre it once to steer again.'],
  BLOCKED: ['Blocked', 'The robot waits: what you ask for is not safe.'],
};

// Those that say something else where the robot has no goal.
const STATES_WITHOUT_GOAL = {
  AUTONOMY: ['You let go', 'The robot brakes and stands.'],
  MANUAL: ['You drive. No goal.', 'It goes where the stick says, avoids obstacles, and stops if you let go.'],
  STOPPED: ['Stopped', 'It stands until the stop ends.'],
};

const REFUSALS = {
  Braking: 'it could not brake in time',
  Collision: 'it would hit something',
  BaseObstacle: 'it would hit something',
  ObstacleFootprint: 'it would hit something',
  'Moving obstacle': 'somebody is in the way',
  'Unknown cells': 'nothing has been seen there yet',
  Blind: 'no sensor sees there, so it creeps',
  Occlusion: 'somebody may step out there, so it creeps',
  RotateToGoal: 'the robot turns at its goal',
  Oscillation: 'the robot would go back and forth',
};

const NEXT = { straight: 'straight on', left: 'turn left', right: 'turn right', stop: 'stop', recover: 'look for a way out' };

export const MODES = {
  joystick: ['Stick', 'You bend the way of the robot with a stick.'],
  gesture: ['Hand', 'You bend its way with your hand, in a headset.'],
  switching: ['Take turns', 'You take control, drive, and give it back.'],
  off: ['Off', 'Nobody steers.'],
};

/** {key, title, line} for a scene's state (null: the planner runs no cycle), goals and limits. */
export function describe({ state, goals, limits }) {
  if (!state) {
    if (goals.length) return { key: 'NONE', title: 'Waiting', line: 'The robot has a goal and plans its way.' };
    const line = limits.driveWithoutGoal ? 'Steer to drive, or set a goal in the map.' : 'Set a goal in the map: steering works on the way to a goal.';
    return { key: 'NONE', title: 'No goal', line };
  }
  const [title, line] = (state.withoutGoal && STATES_WITHOUT_GOAL[state.name]) || STATES[state.name] || [state.name, ''];
  return { key: state.name, title, line };
}

/** Why the operator's wish is refused; empty where it is not. */
export function refusal(state) {
  if (!state || !state.active || !state.refusedBy) return '';
  const why = REFUSALS[state.refusedBy];
  return why ? `Refused: ${why} (${state.refusedBy})` : `Refused by ${state.refusedBy}`;
}

/** Whether the operator has taken control on the way to a goal, so that it can be given back. */
export function inControl(state) {
  return Boolean(state && state.name === 'MANUAL' && !state.withoutGoal);
}

/** What autonomy is about to do. */
export function announce(state) {
  if (!state || !state.next || state.withoutGoal) return '';
  const what = NEXT[state.next] || state.next;
  return state.nextReason ? `Next: ${what}. ${state.nextReason}` : `Next: ${what}`;
}

/** A duration as people read it. */
export function duration(seconds) {
  if (!Number.isFinite(seconds)) return '';
  const whole = Math.max(0, Math.round(seconds));
  return whole < 60 ? `${whole} s` : `${Math.floor(whole / 60)} min ${String(whole % 60).padStart(2, '0')} s`;
}
