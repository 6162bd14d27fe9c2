// SPDX-License-Identifier: BSD-3-Clause
// What is known about the robot and its surroundings: plain values that the link writes and the views read.
// All geometry is in the frame `map` [m, rad] unless a comment says otherwise. Each part has a version that grows when the
// part changes, so a view redraws no more than what changed.

/** A scene about which nothing is known yet. */
export function emptyScene() {
  return {
    version: {},
    map: null, // grid; cells: 0 free .. 100 occupied, -1 unknown (Int8Array)
    costmap: null, // grid of the local costmap, as above
    robot: null, // {x, y, yaw, v, omega}: pose, and odometry's velocity [m/s, rad/s]
    outline: [], // of the robot, [[x, y], ...] in base_link
    limits: { maxV: 0.5, minV: 0, maxOmega: 1, driveWithoutGoal: false }, // [m/s, rad/s]
    scan: new Float32Array(0), // x, y, x, y, ...
    plan: [], // [[x, y], ...]
    predicted: [], // [{x, y, yaw, t}], t from now [s]
    candidates: [], // [{points: [[x, y], ...], cost, legal, chosen}]; cost 0 (best) .. 1 (worst legal)
    state: null, // {name, mode, withoutGoal, active, wanted: {v, omega}, command: {v, omega}, agreement, refusedBy, next, nextReason}
    movers: [], // [{id, x, y, vx, vy, radius}]
    regions: [], // [{name, polygon: [[x, y], ...]}]
    goals: [], // [{x, y, yaw}], the first is the one that is driven to
    progress: null, // {distance [m], seconds}: what is left to the goal
    camera: null, // calibration: {width, height, fx, fy, cx, cy, pose: [x, y, z, qx, qy, qz, qw] of the optical frame in base_link}
    picture: null, // the camera's newest picture, an ImageBitmap
  };
}

/** Writes a part of the scene and says that it changed. */
export function put(scene, part, value) {
  scene[part] = value;
  scene.version[part] = (scene.version[part] || 0) + 1;
}

/** Says for parts of a scene whether they changed since this watch asked last. */
export class Watch {
  constructor(scene) {
    this.scene = scene;
    this.seen = {};
  }

  changed(...parts) {
    let any = false;
    for (const part of parts) {
      const version = this.scene.version[part] || 0;
      if (this.seen[part] !== version) any = true;
      this.seen[part] = version;
    }
    return any;
  }
}
