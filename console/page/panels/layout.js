// SPDX-License-Identifier: BSD-3-Clause
// Which view is large, and which panel is open.

const PANELS = ['window', 'tuning', 'record', 'help'];

const byId = (id) => document.getElementById(id);

function enlarge(view) {
  const main = document.querySelector('main');
  if (main.dataset.large === view) delete main.dataset.large;
  else main.dataset.large = view;
}

/** Shows a panel, or none. */
export function openPanel(name) {
  document.body.dataset.tab = name || 'none';
  for (const panel of PANELS) {
    byId(`panel-${panel}`).hidden = panel !== name;
    byId(`tab-${panel}`).setAttribute('aria-selected', String(panel === name));
  }
}

export function setUpLayout() {
  for (const view of ['board', 'above']) byId(`${view}-large`).addEventListener('click', () => enlarge(view));
  for (const panel of PANELS) {
    byId(`tab-${panel}`).addEventListener('click', () => openPanel(document.body.dataset.tab === panel ? null : panel));
  }
  const narrow = matchMedia('(max-width: 900px)');
  const fit = () => openPanel(narrow.matches ? null : 'window');
  narrow.addEventListener('change', fit);
  fit();
}
