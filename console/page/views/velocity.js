// SPDX-License-Identifier: BSD-3-Clause
// The velocity window: turn rate across (left is left), speed up. A ring is what the operator asks for (u_h), a dot what
// the robot does (u*); with candidates asked for, each is a point in the colour of its cost.
import { Watch } from '../model/scene.js';
import { mix, onTheme } from './theme.js';

const EDGE = 12; // [CSS pixels]

export class VelocityView {
  constructor(canvas, scene) {
    this.canvas = canvas;
    this.scene = scene;
    this.watch = new Watch(scene);
    onTheme((theme) => {
      this.theme = theme;
      this.watch = new Watch(scene);
    });
  }

  draw() {
    if (!this.watch.changed('state', 'candidates', 'limits')) return false;
    const { canvas, scene, theme } = this;
    const ratio = window.devicePixelRatio || 1;
    const [width, height] = [canvas.clientWidth, canvas.clientHeight];
    if (!width) return false;
    canvas.width = Math.round(width * ratio);
    canvas.height = Math.round(height * ratio);
    const context = canvas.getContext('2d');
    context.scale(ratio, ratio);
    const { maxV, minV, maxOmega } = scene.limits;
    const low = Math.min(0, minV);
    const at = (v, omega) => [
      width / 2 - (clamp(omega, maxOmega) / maxOmega) * (width / 2 - EDGE),
      height - EDGE - ((Math.min(maxV, Math.max(low, v)) - low) / (maxV - low || 1)) * (height - 2 * EDGE),
    ];
    this.axes(context, at, { maxV, low, maxOmega });
    for (const one of scene.candidates) {
      const [x, y] = at(one.v, one.omega);
      context.fillStyle = one.legal ? mix(theme.best, theme.worst, one.cost) : theme.rejected;
      context.fillRect(x - 1.5, y - 1.5, 3, 3);
    }
    if (scene.state) this.motions(context, at, scene.state);
    return true;
  }

  axes(context, at, { maxV, low, maxOmega }) {
    const [[left, top], [right, bottom], [middle, zero]] = [at(maxV, maxOmega), at(low, -maxOmega), at(0, 0)];
    context.strokeStyle = this.theme.line;
    context.lineWidth = 1;
    context.strokeRect(left, top, right - left, bottom - top);
    context.beginPath();
    context.moveTo(middle, top);
    context.lineTo(middle, bottom);
    context.moveTo(left, zero);
    context.lineTo(right, zero);
    context.stroke();
  }

  motions(context, at, { active, wanted, command }) {
    const [x, y] = at(command.v, command.omega);
    context.fillStyle = this.theme.command;
    context.beginPath();
    context.arc(x, y, 5, 0, 2 * Math.PI);
    context.fill();
    if (!active) return;
    const [hx, hy] = at(wanted.v, wanted.omega);
    context.strokeStyle = this.theme.wanted;
    context.lineWidth = 3;
    context.beginPath();
    context.arc(hx, hy, 8, 0, 2 * Math.PI);
    context.stroke();
  }
}

function clamp(value, most) {
  return Math.max(-most, Math.min(most, value));
}
