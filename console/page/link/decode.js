// SPDX-License-Identifier: BSD-3-Clause
// The binary messages of /view (docs/understand/console_protocol.md) as plain values. Little-endian; frame map; [m, rad].
import { place } from '../model/geometry.js';

const NO_INDEX = 0xffffffff;
const NOTHING = 255; // a cell outside the version before: unknown

/** Runs of (value, LEB128 length) to bytes; throws where they do not fill `cells` exactly. */
function readRuns(bytes, from, cells) {
  let at = 0;
  let i = from;
  while (i < bytes.length) {
    const value = bytes[i++];
    let count = 0;
    let shift = 0;
    let more = true;
    while (more) {
      if (i >= bytes.length || shift > 28) throw new Error('a grid ends within a run');
      count += (bytes[i] & 127) * 2 ** shift;
      shift += 7;
      more = bytes[i++] > 127;
    }
    if (at + count > cells.length) throw new Error('a grid has too many cells');
    cells.fill(value, at, at + count);
    at += count;
  }
  if (at !== cells.length) throw new Error(`a grid has ${at} of ${cells.length} cells`);
  return cells;
}

function readOrigin(view, at) {
  return { x: view.getFloat64(at, true), y: view.getFloat64(at + 8, true), yaw: view.getFloat64(at + 16, true) };
}

function wholeGrid(view, bytes) {
  const width = view.getUint32(12, true);
  const height = view.getUint32(16, true);
  const cells = readRuns(bytes, 48, new Uint8Array(width * height));
  return {
    version: view.getUint32(8, true),
    width,
    height,
    resolution: view.getFloat32(20, true),
    origin: readOrigin(view, 24),
    cells: new Int8Array(cells.buffer),
  };
}

/** The changed grid of the version before; null where that is not the one it builds on. */
function changedGrid(view, bytes, before) {
  if (!before || before.version !== view.getUint32(12, true)) return null;
  const { width, height, resolution } = before;
  const [dx, dy] = [view.getInt32(16, true), view.getInt32(20, true)];
  const cells = readRuns(bytes, 48, new Uint8Array(width * height));
  const old = new Uint8Array(before.cells.buffer);
  for (let y = 0; y < height; ++y) {
    const row = y + dy;
    for (let x = 0; x < width; ++x) {
      const column = x + dx;
      const inside = row >= 0 && row < height && column >= 0 && column < width;
      cells[y * width + x] += inside ? old[row * width + column] : NOTHING; // modulo 256
    }
  }
  return { version: view.getUint32(8, true), width, height, resolution, origin: readOrigin(view, 24), cells: new Int8Array(cells.buffer) };
}

/** A scan as points x, y, x, y, ... in the map. */
function scan(view) {
  const pose = readOrigin(view, 4);
  const first = view.getFloat32(28, true);
  const step = view.getFloat32(32, true);
  const count = view.getUint32(36, true);
  const points = new Float32Array(2 * count);
  let used = 0;
  for (let i = 0; i < count; ++i) {
    const range = view.getUint16(40 + 2 * i, true) / 1000;
    if (range === 0) continue;
    const angle = pose.yaw + first + i * step;
    points[used++] = pose.x + range * Math.cos(angle);
    points[used++] = pose.y + range * Math.sin(angle);
  }
  return points.subarray(0, used);
}

/** A path: which one, and [{x, y, t}]. */
function path(view) {
  const count = view.getUint32(8, true);
  const points = [];
  for (let i = 0; i < count; ++i) {
    const at = 12 + 12 * i;
    points.push({ x: view.getFloat32(at, true), y: view.getFloat32(at + 4, true), t: view.getFloat32(at + 8, true) });
  }
  return { which: view.getUint8(4), points };
}

/** Candidates; the cost is 0 for the cheapest legal one and 1 for the dearest. */
function candidates(view) {
  const pose = readOrigin(view, 4);
  const count = view.getUint32(28, true);
  const points = view.getUint32(32, true);
  const best = view.getUint32(36, true);
  const size = 12 + 4 * points;
  const result = [];
  for (let i = 0; i < count; ++i) {
    const at = 40 + i * size;
    const way = [];
    for (let k = 0; k < points; ++k) {
      const forward = view.getInt16(at + 12 + 4 * k, true) / 1000;
      way.push(place(pose, forward, view.getInt16(at + 14 + 4 * k, true) / 1000));
    }
    const total = view.getFloat32(at, true);
    result.push({
      total, legal: total >= 0, chosen: best !== NO_INDEX && i === best, points: way,
      v: view.getFloat32(at + 4, true), omega: view.getFloat32(at + 8, true),
    });
  }
  return withCosts(result);
}

function withCosts(all) {
  const totals = all.filter((one) => one.legal).map((one) => one.total);
  const low = Math.min(...totals);
  const span = Math.max(...totals) - low || 1;
  for (const one of all) one.cost = one.legal ? (one.total - low) / span : 1;
  return all.sort((a, b) => a.legal - b.legal || b.cost - a.cost); // the best are drawn last
}

/**
 * Any binary message: {kind, ...}. grids: the grids of before by `which`, which changed grids build on.
 * Throws on a message that cannot be right.
 */
export function decode(buffer, grids) {
  const view = new DataView(buffer);
  const bytes = new Uint8Array(buffer);
  switch (view.getUint8(0)) {
    case 1: return { kind: 'grid', which: view.getUint8(4), grid: wholeGrid(view, bytes) };
    case 2: return { kind: 'grid', which: view.getUint8(4), grid: changedGrid(view, bytes, grids[view.getUint8(4)]) };
    case 3: return { kind: 'scan', points: scan(view) };
    case 4: return { kind: 'path', ...path(view) };
    case 5: return { kind: 'candidates', candidates: candidates(view) };
    default: return { kind: 'unknown' };
  }
}
