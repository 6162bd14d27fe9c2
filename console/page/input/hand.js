// SPDX-License-Identifier: BSD-3-Clause
// What a headset's controllers and tracked hands say in one frame, as plain values. WebXR's axes are x right, y up, z back;
// here a hand is {left, forward, up} [m] in the room (local-floor), which does not turn with the head.

const PINCH_ON = 0.02; // [m] between the tips of thumb and index finger
const PINCH_OFF = 0.035; // [m]
const SQUEEZE = 1; // buttons of the xr-standard mapping
const TOGGLE = 4; // A, X
const STOP = 5; // B, Y

const inRoom = ({ x, y, z }) => ({ left: -x, forward: -z, up: y });

function distance(a, b) {
  return Math.hypot(a.x - b.x, a.y - b.y, a.z - b.z);
}

/** A pose that is seen now: emulated ones keep the last place of a hand that is lost, so they are none. */
function seen(pose) {
  return pose && !pose.emulatedPosition ? pose.transform.position : null;
}

function readController(source, frame, space) {
  const { buttons, axes } = source.gamepad;
  const pressed = (index) => Boolean(buttons[index] && buttons[index].pressed);
  const at = source.gripSpace ? seen(frame.getPose(source.gripSpace, space)) : null;
  return {
    stick: { left: -(axes[2] || 0) + 0, forward: -(axes[3] || 0) + 0 },
    grip: pressed(SQUEEZE),
    at: at && inRoom(at),
    stop: pressed(STOP),
    toggle: pressed(TOGGLE),
  };
}

function readHand(source, frame, space, wasPinched) {
  const joint = (name) => seen(frame.getJointPose(source.hand.get(name), space));
  const thumb = joint('thumb-tip');
  const index = joint('index-finger-tip');
  if (!thumb || !index) return { grip: wasPinched, at: null };
  const grip = distance(thumb, index) < (wasPinched ? PINCH_OFF : PINCH_ON);
  const at = { x: (thumb.x + index.x) / 2, y: (thumb.y + index.y) / 2, z: (thumb.z + index.z) / 2 };
  return { grip, at: inRoom(at) };
}

/**
 * Each source of a session in this frame: {key, stick, grip, at, stop, toggle}. `at` is null while the hand is not tracked.
 * pinched: which keys gripped in the frame before.
 */
export function readSources(session, frame, space, pinched) {
  const result = [];
  for (const source of session.inputSources) {
    const key = source.handedness;
    if (source.hand) result.push({ key, hand: true, ...readHand(source, frame, space, pinched.has(key)) });
    else if (source.gamepad) result.push({ key, hand: false, ...readController(source, frame, space) });
  }
  return result;
}
