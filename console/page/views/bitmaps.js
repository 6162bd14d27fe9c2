// SPDX-License-Identifier: BSD-3-Clause
// Grids as off-screen pictures, a pixel a cell, so that drawing a large map is one call.
import { rgb } from './theme.js';

const OCCUPIED = 65; // [%] what map_server calls occupied
const INSCRIBED = 99; // [%] costmap_2d's inscribed cost as an occupancy

function lookup(colourOf) {
  const table = new Uint32Array(256);
  const bytes = new Uint8Array(table.buffer);
  for (let value = -128; value < 128; ++value) bytes.set(colourOf(value), (value & 255) * 4);
  return table;
}

/** Colours of a map: walls, free and unknown floor. */
export function mapColours(theme) {
  const [wall, free, unknown] = [rgb(theme.wall), rgb(theme.free), rgb(theme.unknown)];
  return lookup((value) => {
    const c = value < 0 ? unknown : value >= OCCUPIED ? wall : free;
    return [c[0], c[1], c[2], 255];
  });
}

/** Colours of a costmap: transparent where it is free, the more opaque the higher the cost. */
export function costColours(theme) {
  const [lethal, near] = [rgb(theme.costmap), rgb(theme.inflation)];
  return lookup((value) => {
    if (value <= 0) return [0, 0, 0, 0];
    if (value >= 100) return [lethal[0], lethal[1], lethal[2], 255];
    return [near[0], near[1], near[2], value >= INSCRIBED ? 120 : Math.round(value * 0.8)];
  });
}

/** A grid's picture. Row 0 of the picture is the grid's last row, since y points up in a map. */
export class GridBitmap {
  constructor() {
    this.canvas = document.createElement('canvas');
  }

  draw(grid, colours) {
    const { width, height, cells } = grid;
    if (this.canvas.width !== width || this.canvas.height !== height) {
      this.canvas.width = width;
      this.canvas.height = height;
      this.image = null;
    }
    const context = this.canvas.getContext('2d');
    if (!this.image) this.image = context.createImageData(width, height);
    const pixels = new Uint32Array(this.image.data.buffer);
    for (let row = 0; row < height; ++row) {
      const from = (height - 1 - row) * width;
      const to = row * width;
      for (let column = 0; column < width; ++column) pixels[to + column] = colours[cells[from + column] & 255];
    }
    context.putImageData(this.image, 0, 0);
  }
}
