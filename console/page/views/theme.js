// SPDX-License-Identifier: BSD-3-Clause
// The colours of the drawings. They come from style.css, so that light and dark are said in one place.

const NAMES = [
  'free', 'unknown', 'wall', 'costmap', 'inflation', 'scan', 'plan', 'predicted', 'wanted', 'command', 'robot', 'robot-edge', 'mover', 'region',
  'goal', 'solid', 'sky', 'floor', 'floor-line', 'text', 'panel', 'line', 'best', 'worst', 'rejected',
];

/** The colours in force, as CSS writes them. */
export function readTheme() {
  const style = getComputedStyle(document.documentElement);
  const theme = {};
  for (const name of NAMES) theme[name] = style.getPropertyValue(`--draw-${name}`).trim();
  return theme;
}

/** Calls back now, and whenever the browser changes between light and dark. */
export function onTheme(callback) {
  callback(readTheme());
  matchMedia('(prefers-color-scheme: dark)').addEventListener('change', () => callback(readTheme()));
}

/** A colour #rrggbb as [r, g, b] in 0..255. */
export function rgb(colour) {
  const value = parseInt(colour.slice(1), 16);
  return [(value >> 16) & 255, (value >> 8) & 255, value & 255];
}

/** Between two colours #rrggbb, as a CSS colour. */
export function mix(from, to, part) {
  const a = rgb(from);
  const b = rgb(to);
  return `rgb(${a.map((value, i) => Math.round(value + (b[i] - value) * part)).join(',')})`;
}
