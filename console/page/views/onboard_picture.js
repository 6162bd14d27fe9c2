// SPDX-License-Identifier: BSD-3-Clause
// The camera's picture, with the plan and the motions drawn over it where the camera's calibration and place are known.
import { arc, into } from '../model/geometry.js';
import { Watch } from '../model/scene.js';
import { onTheme } from './theme.js';

const ARC_TIME = 2; // [s] as in the view from above
const NEAR = 0.05; // [m] in front of the lens; what is nearer is not drawn
const STEP = 0.1; // [m] pieces of the plan, so that a line that passes behind the lens is cut well

/** Turns a vector by a quaternion [x, y, z, w]. */
export function turn([x, y, z, w], [vx, vy, vz]) {
  const [tx, ty, tz] = [2 * (y * vz - z * vy), 2 * (z * vx - x * vz), 2 * (x * vy - y * vx)];
  return [vx + w * tx + y * tz - z * ty, vy + w * ty + z * tx - x * tz, vz + w * tz + x * ty - y * tx];
}

/**
 * Where a point of the floor, given in the robot's frame [m], is seen in the picture [pixels of the calibration], or null
 * where it lies behind the lens. The pinhole model of sensor_msgs/CameraInfo; the optical frame has z ahead, x to the right.
 */
export function project(info, x, y) {
  const [cx, cy, cz, qx, qy, qz, qw] = info.pose;
  const [ox, oy, oz] = turn([-qx, -qy, -qz, qw], [x - cx, y - cy, -cz]);
  return oz < NEAR ? null : [info.cx + (info.fx * ox) / oz, info.cy + (info.fy * oy) / oz];
}

export class PictureView {
  constructor(canvas, scene) {
    this.canvas = canvas;
    this.scene = scene;
    this.watch = new Watch(scene);
    onTheme((theme) => (this.theme = theme));
  }

  /** Draws if something changed; says whether it drew. */
  draw() {
    const { scene, canvas } = this;
    const { picture } = scene;
    if (!this.watch.changed('picture', 'state', 'plan', 'robot') || !picture) return false;
    if (canvas.width !== picture.width) canvas.width = picture.width;
    if (canvas.height !== picture.height) canvas.height = picture.height;
    const context = canvas.getContext('2d', { alpha: false });
    context.drawImage(picture, 0, 0);
    if (scene.camera && scene.camera.pose && scene.robot) this.overlay(context);
    return true;
  }

  overlay(context) {
    const { scene, theme } = this;
    const { robot, state } = scene;
    context.save();
    context.scale(this.canvas.width / scene.camera.width, this.canvas.height / scene.camera.height);
    this.line(context, fine(scene.plan.map(([x, y]) => into(robot, x, y))), theme.plan, 6);
    if (state) {
      const here = { x: 0, y: 0, yaw: 0 };
      this.line(context, fine(arc(here, state.command.v, state.command.omega, ARC_TIME)), theme.command, 8);
      if (state.active) this.line(context, fine(arc(here, state.wanted.v, state.wanted.omega, ARC_TIME)), theme.wanted, 4);
    }
    context.restore();
  }

  /** points: [[x, y], ...] on the floor in the robot's frame */
  line(context, points, colour, width) {
    context.beginPath();
    let drawing = false;
    for (const [x, y] of points) {
      const at = project(this.scene.camera, x, y);
      if (at && drawing) context.lineTo(at[0], at[1]);
      else if (at) context.moveTo(at[0], at[1]);
      drawing = at !== null;
    }
    context.strokeStyle = colour;
    context.lineWidth = width;
    context.lineJoin = context.lineCap = 'round';
    context.stroke();
  }
}

/** The same line in pieces no longer than STEP, of its first 12 m. */
function fine(points) {
  const result = [];
  let passed = 0;
  for (let i = 1; i < points.length && passed < 12; ++i) {
    const [[ax, ay], [bx, by]] = [points[i - 1], points[i]];
    const long = Math.hypot(bx - ax, by - ay);
    const pieces = Math.max(1, Math.ceil(long / STEP));
    for (let k = i === 1 ? 0 : 1; k <= pieces; ++k) result.push([ax + ((bx - ax) * k) / pieces, ay + ((by - ay) * k) / pieces]);
    passed += long;
  }
  return result;
}
