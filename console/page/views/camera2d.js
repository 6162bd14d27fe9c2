// SPDX-License-Identifier: BSD-3-Clause
// What part of the map the view from above shows: centre [m, map], scale [CSS pixels a metre], following the robot or not.

const MIN_SCALE = 4;
const MAX_SCALE = 240;

export class Camera2D {
  constructor() {
    this.x = 0;
    this.y = 0;
    this.scale = 44;
    this.following = true;
    this.width = 1; // of the view [CSS pixels]
    this.height = 1;
  }

  /** The place in the map that is seen at a point of the view. */
  toMap(px, py) {
    return [this.x + (px - this.width / 2) / this.scale, this.y - (py - this.height / 2) / this.scale];
  }

  /** The point of the view at which a place in the map is seen. */
  toView(x, y) {
    return [this.width / 2 + (x - this.x) * this.scale, this.height / 2 - (y - this.y) * this.scale];
  }

  pan(dx, dy) {
    this.following = false;
    this.x -= dx / this.scale;
    this.y += dy / this.scale;
  }

  /** Zooms so that what is seen at (px, py) stays there; while following the robot stays in the middle. */
  zoom(factor, px, py) {
    const [x, y] = this.toMap(px, py);
    this.scale = Math.min(MAX_SCALE, Math.max(MIN_SCALE, this.scale * factor));
    if (this.following) return;
    const [nx, ny] = this.toMap(px, py);
    this.x += x - nx;
    this.y += y - ny;
  }

  follow(pose) {
    if (!this.following || !pose) return;
    this.x = pose.x;
    this.y = pose.y;
  }
}
