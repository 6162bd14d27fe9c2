// SPDX-License-Identifier: BSD-3-Clause
// Everything that takes a page away from the person: then steering is released once, and a held stop stays.

/** cut(why): releases; wake(): the page is looked at again. */
export function watchCuts(cut, wake) {
  document.addEventListener('visibilitychange', () => (document.hidden ? cut('hidden') : wake()));
  addEventListener('blur', () => cut('blur'));
  addEventListener('pagehide', () => cut('pagehide'));
  document.addEventListener('freeze', () => cut('hidden'));
  addEventListener('focus', () => wake());
  addEventListener('pageshow', () => wake());
}
