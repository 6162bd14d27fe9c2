// SPDX-License-Identifier: BSD-3-Clause
// Upright faces where occupied cells of a grid meet cells that are not: what a person on the floor sees of a map.

export const TILE = 256; // [cells] faces are cut and collected by tiles, so that what is far away need not be drawn

/**
 * The faces of a grid as a map from tile to [[x0, y0, x1, y1], ...] in cells. Each face is a run along one axis, and who
 * looks from (x0, y0) to (x1, y1) has the occupied side on the left.
 * solid(i): the cell of index i is occupied; open(i): a face towards it is worth drawing.
 */
export function wallFaces(width, height, solid, open) {
  const tiles = new Map();
  const add = (x0, y0, x1, y1) => {
    const key = `${Math.floor(Math.min(x0, x1) / TILE)},${Math.floor(Math.min(y0, y1) / TILE)}`;
    if (!tiles.has(key)) tiles.set(key, []);
    tiles.get(key).push([x0, y0, x1, y1]);
  };
  // Between the rows y - 1 and y: 1 where the solid cell is above the line, -1 where it is below.
  runs(width, height, (x, y) => side(solid, open, y * width + x, (y - 1) * width + x), (from, to, line, sign) => {
    if (sign > 0) add(from, line, to, line);
    else add(to, line, from, line);
  });
  // Between the columns x - 1 and x, alike.
  runs(height, width, (y, x) => side(solid, open, y * width + x, y * width + x - 1), (from, to, line, sign) => {
    if (sign > 0) add(line, to, line, from);
    else add(line, from, line, to);
  });
  return tiles;
}

function side(solid, open, after, before) {
  const a = solid(after);
  if (a === solid(before)) return 0;
  return a ? (open(before) ? 1 : 0) : open(after) ? -1 : 0;
}

/** Runs of equal sign on each inner line of a grid; cut where a tile ends. */
function runs(along, lines, signOf, add) {
  for (let line = 1; line < lines; ++line) {
    let start = 0;
    let sign = 0;
    for (let i = 0; i <= along; ++i) {
      const now = i < along ? signOf(i, line) : 0;
      if (now === sign && i % TILE !== 0) continue;
      if (sign) add(start, i, line, sign);
      start = i;
      sign = now;
    }
  }
}

/** Occupied cells of a costmap that lie farther than `reach` cells from every occupied cell of the map: what the map does not show. */
export function unexplained(costmap, map, reach = 3) {
  const { width, height, resolution, origin, cells } = costmap;
  const solid = new Uint8Array(width * height);
  for (let row = 0; row < height; ++row) {
    for (let column = 0; column < width; ++column) {
      const i = row * width + column;
      if (cells[i] < 100) continue;
      const c = Math.cos(origin.yaw);
      const s = Math.sin(origin.yaw);
      const x = (column + 0.5) * resolution;
      const y = (row + 0.5) * resolution;
      solid[i] = map && occupiedNear(map, origin.x + c * x - s * y, origin.y + s * x + c * y, reach) ? 0 : 1;
    }
  }
  return solid;
}

function occupiedNear(map, x, y, reach) {
  const c = Math.cos(map.origin.yaw);
  const s = Math.sin(map.origin.yaw);
  const dx = x - map.origin.x;
  const dy = y - map.origin.y;
  const column = Math.floor((c * dx + s * dy) / map.resolution);
  const row = Math.floor((c * dy - s * dx) / map.resolution);
  for (let r = Math.max(0, row - reach); r <= Math.min(map.height - 1, row + reach); ++r) {
    for (let k = Math.max(0, column - reach); k <= Math.min(map.width - 1, column + reach); ++k) {
      if (map.cells[r * map.width + k] >= 65) return true;
    }
  }
  return false;
}

/** How far one can go back from a pose [m], up to `most`, before a wall of the map is nearer than `margin`. */
export function roomBehind(map, pose, most, margin) {
  if (!map) return most;
  const step = map.resolution;
  for (let back = 0; back <= most + margin; back += step) {
    if (occupiedNear(map, pose.x - back * Math.cos(pose.yaw), pose.y - back * Math.sin(pose.yaw), 1)) return Math.max(0, back - margin);
  }
  return most;
}
