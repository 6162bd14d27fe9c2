// SPDX-License-Identifier: BSD-3-Clause
// The view from above: map, local costmap, laser, plan, motions, people, regions, goals and the robot, on a 2-D canvas.
import { arc, place } from '../model/geometry.js';
import { Watch } from '../model/scene.js';
import { costColours, GridBitmap, mapColours } from './bitmaps.js';
import { Camera2D } from './camera2d.js';
import { MapPointer } from './map_pointer.js';
import { mix, onTheme, rgb } from './theme.js';

export const ARC_TIME = 2; // [s] how far the arcs of the wanted and the executed motion reach
const HATCH = 9; // [device pixels] between the lines of a region to avoid

export class AboveView {
  /** canvas: to draw on; scene: model/scene.js; placed(goal): as in MapPointer. */
  constructor(canvas, scene, placed) {
    this.canvas = canvas;
    this.scene = scene;
    this.camera = new Camera2D();
    this.pointer = new MapPointer(canvas, this.camera, () => (this.dirty = true), placed);
    this.map = new GridBitmap();
    this.costmap = new GridBitmap();
    this.maps = new Watch(scene);
    this.parts = new Watch(scene);
    this.dirty = true;
    onTheme((theme) => this.useTheme(theme));
    new ResizeObserver(() => this.resize()).observe(canvas);
    this.resize();
  }

  useTheme(theme) {
    this.theme = theme;
    this.mapColours = mapColours(theme);
    this.costColours = costColours(theme);
    this.maps = new Watch(this.scene); // both bitmaps are to be drawn again
    this.hatch = this.makeHatch();
    this.dirty = true;
  }

  makeHatch() {
    const tile = document.createElement('canvas');
    tile.width = tile.height = HATCH;
    const context = tile.getContext('2d');
    context.strokeStyle = this.theme.region;
    context.lineWidth = 1.6;
    for (const shift of [-HATCH, 0, HATCH]) {
      context.beginPath();
      context.moveTo(shift, HATCH);
      context.lineTo(shift + HATCH, 0);
      context.stroke();
    }
    return tile;
  }

  resize() {
    const box = this.canvas.getBoundingClientRect();
    this.ratio = Math.min(2, window.devicePixelRatio || 1);
    this.camera.width = Math.max(1, box.width);
    this.camera.height = Math.max(1, box.height);
    this.canvas.width = Math.round(this.camera.width * this.ratio);
    this.canvas.height = Math.round(this.camera.height * this.ratio);
    this.dirty = true;
  }

  /** Draws if something changed since the last call; says whether it drew. */
  draw() {
    const { scene } = this;
    if (this.maps.changed('map') && scene.map) this.map.draw(scene.map, this.mapColours);
    if (this.maps.changed('costmap') && scene.costmap) this.costmap.draw(scene.costmap, this.costColours);
    const changed = this.parts.changed(...Object.keys(scene.version));
    if (!changed && !this.dirty) return false;
    this.dirty = false;
    this.camera.follow(scene.robot);
    this.paint(this.canvas.getContext('2d', { alpha: false }));
    return true;
  }

  paint(context) {
    const { camera, ratio, theme, scene } = this;
    context.setTransform(1, 0, 0, 1, 0, 0);
    context.fillStyle = theme.unknown;
    context.fillRect(0, 0, this.canvas.width, this.canvas.height);
    const scale = camera.scale * ratio;
    context.setTransform(scale, 0, 0, -scale, this.canvas.width / 2 - camera.x * scale, this.canvas.height / 2 + camera.y * scale);
    this.pixel = 1 / camera.scale; // [m] a CSS pixel
    context.lineJoin = context.lineCap = 'round';
    this.grid(context, scene.map, this.map);
    this.regions(context);
    this.grid(context, scene.costmap, this.costmap);
    this.laser(context);
    this.line(context, scene.plan, theme.plan, 5);
    this.candidates(context);
    this.goals(context);
    this.movers(context);
    if (scene.robot) this.robot(context);
    if (this.pointer.draft) this.goal(context, this.pointer.draft, '+');
  }

  grid(context, grid, bitmap) {
    if (!grid) return;
    context.save();
    context.translate(grid.origin.x, grid.origin.y);
    context.rotate(grid.origin.yaw);
    context.scale(grid.resolution, -grid.resolution);
    context.imageSmoothingEnabled = this.camera.scale * this.ratio * grid.resolution < 1;
    context.drawImage(bitmap.canvas, 0, -grid.height);
    context.restore();
  }

  laser(context) {
    const { scan } = this.scene;
    const size = Math.max(2.5 * this.pixel, 0.03);
    context.fillStyle = this.theme.scan;
    for (let i = 0; i + 1 < scan.length; i += 2) context.fillRect(scan[i] - size / 2, scan[i + 1] - size / 2, size, size);
  }

  trace(context, points, closed = false) {
    context.beginPath();
    points.forEach(([x, y], i) => (i ? context.lineTo(x, y) : context.moveTo(x, y)));
    if (closed) context.closePath();
  }

  /** A line of points, its width in CSS pixels. */
  line(context, points, colour, width) {
    if (points.length < 2) return;
    this.trace(context, points);
    context.strokeStyle = colour;
    context.lineWidth = width * this.pixel;
    context.stroke();
  }

  candidates(context) {
    const { best, worst, rejected } = this.theme;
    for (const one of this.scene.candidates) {
      this.line(context, one.points, one.legal ? mix(best, worst, one.cost) : rejected, one.chosen ? 4 : 1.2);
    }
  }

  /** Hatched, with an outline and a name: no sensor sees these. */
  regions(context) {
    const { region } = this.theme;
    const [r, g, b] = rgb(region);
    const pattern = context.createPattern(this.hatch, 'repeat');
    pattern.setTransform(new DOMMatrix([this.pixel / this.ratio, 0, 0, this.pixel / this.ratio, 0, 0]));
    for (const { polygon } of this.scene.regions) {
      this.trace(context, polygon, true);
      context.fillStyle = `rgba(${r},${g},${b},0.14)`;
      context.fill();
      context.fillStyle = pattern;
      context.fill();
      context.strokeStyle = region;
      context.lineWidth = 2 * this.pixel;
      context.stroke();
    }
  }

  movers(context) {
    for (const one of this.scene.movers) {
      context.beginPath();
      context.arc(one.x, one.y, one.radius, 0, 2 * Math.PI);
      context.fillStyle = this.theme.mover;
      context.globalAlpha = 0.5;
      context.fill();
      context.globalAlpha = 1;
      context.strokeStyle = this.theme.mover;
      context.lineWidth = 2 * this.pixel;
      context.stroke();
      this.line(context, [[one.x, one.y], [one.x + one.vx, one.y + one.vy]], this.theme.mover, 3);
    }
  }

  goals(context) {
    this.scene.goals.forEach((goal, i) => this.goal(context, goal, String(i + 1)));
  }

  goal(context, goal, label) {
    const radius = 11 * this.pixel;
    context.fillStyle = this.theme.goal;
    if (goal.yaw !== null) {
      const tip = place(goal, 24 * this.pixel, 0);
      this.trace(context, [tip, place(goal, 0, radius), place(goal, 0, -radius)], true);
      context.fill();
    }
    context.beginPath();
    context.arc(goal.x, goal.y, radius, 0, 2 * Math.PI);
    context.fill();
    this.label(context, label, goal.x, goal.y, '#fff', 13);
  }

  /** Upright text, its middle at a place of the map. */
  label(context, text, x, y, colour, size) {
    const [px, py] = this.camera.toView(x, y);
    context.save();
    context.setTransform(this.ratio, 0, 0, this.ratio, 0, 0);
    context.fillStyle = colour;
    context.font = `600 ${size}px system-ui, sans-serif`;
    context.textAlign = 'center';
    context.textBaseline = 'middle';
    context.fillText(text, px, py);
    context.restore();
  }

  robot(context) {
    const { robot, outline, state, predicted } = this.scene;
    this.line(context, predicted.map(({ x, y }) => [x, y]), this.theme.predicted, 3);
    for (const { x, y } of predicted.filter((_, i) => i % 5 === 4)) {
      context.fillStyle = this.theme.predicted;
      context.fillRect(x - 2.5 * this.pixel, y - 2.5 * this.pixel, 5 * this.pixel, 5 * this.pixel);
    }
    if (outline.length > 2) {
      this.trace(context, outline.map(([x, y]) => place(robot, x, y)), true);
      context.fillStyle = this.theme.robot;
      context.fill();
      context.strokeStyle = this.theme['robot-edge'];
      context.lineWidth = 2 * this.pixel;
      context.stroke();
      const tip = Math.max(...outline.map(([x]) => x));
      this.trace(context, [place(robot, tip * 0.8, 0), place(robot, -tip * 0.1, tip * 0.5), place(robot, -tip * 0.1, -tip * 0.5)], true);
      context.fillStyle = this.theme['robot-edge'];
      context.fill();
    }
    if (!state) return;
    this.line(context, arc(robot, state.command.v, state.command.omega, ARC_TIME), this.theme.command, 7);
    if (state.active) this.line(context, arc(robot, state.wanted.v, state.wanted.omega, ARC_TIME), this.theme.wanted, 3);
  }
}
