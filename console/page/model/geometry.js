// SPDX-License-Identifier: BSD-3-Clause
// Poses and curves on the floor. Frames follow REP-103: x forward, y left, angles counter-clockwise. [m, rad]

/** The angle in [-pi, pi). */
export function wrap(angle) {
  const turns = Math.floor((angle + Math.PI) / (2 * Math.PI));
  return angle - turns * 2 * Math.PI;
}

/** A point of the pose's own frame, in the frame in which the pose is given. */
export function place(pose, x, y) {
  const c = Math.cos(pose.yaw);
  const s = Math.sin(pose.yaw);
  return [pose.x + c * x - s * y, pose.y + s * x + c * y];
}

/** A point of the outer frame, in the pose's own frame. */
export function into(pose, x, y) {
  const c = Math.cos(pose.yaw);
  const s = Math.sin(pose.yaw);
  const dx = x - pose.x;
  const dy = y - pose.y;
  return [c * dx + s * dy, c * dy - s * dx];
}

/**
 * The arc that a constant velocity drives from a pose: points at equal times, in the frame of the pose.
 * The exact integral of the unicycle model, so the number of points changes no place.
 */
export function arc(pose, v, omega, seconds, pieces = 20) {
  const points = [];
  for (let i = 0; i <= pieces; ++i) {
    const t = (seconds * i) / pieces;
    const turn = omega * t;
    // sin(a)/a and (1 - cos(a))/a, by their series near zero
    const along = Math.abs(turn) < 1e-4 ? 1 - (turn * turn) / 6 : Math.sin(turn) / turn;
    const aside = Math.abs(turn) < 1e-4 ? turn / 2 : (1 - Math.cos(turn)) / turn;
    points.push(place(pose, v * t * along, v * t * aside));
  }
  return points;
}

/** Between two poses, by the shorter turn; part 0 is the first, 1 the second. */
export function between(a, b, part) {
  return {
    x: a.x + (b.x - a.x) * part,
    y: a.y + (b.y - a.y) * part,
    yaw: a.yaw + wrap(b.yaw - a.yaw) * part,
  };
}

/** The length of a line of points [[x, y], ...]. */
export function length(points) {
  let sum = 0;
  for (let i = 1; i < points.length; ++i) {
    sum += Math.hypot(points[i][0] - points[i - 1][0], points[i][1] - points[i - 1][1]);
  }
  return sum;
}
