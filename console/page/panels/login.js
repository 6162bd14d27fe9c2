// SPDX-License-Identifier: BSD-3-Clause
// Being let in: the token comes in the address's fragment, which no log holds, and leaves the address bar at once.

const byId = (id) => document.getElementById(id);

async function offer(token) {
  const answer = await fetch('/login', { method: 'POST', headers: { 'Content-Type': 'application/json' }, body: JSON.stringify({ token }) });
  return answer.status;
}

function ask() {
  return new Promise((resolve) => {
    const dialog = byId('login');
    dialog.oncancel = (event) => event.preventDefault();
    dialog.querySelector('form').onsubmit = async (event) => {
      event.preventDefault();
      const status = await offer(byId('token').value);
      if (status === 204) {
        dialog.close();
        resolve();
      } else {
        byId('login-error').textContent = status === 429 ? 'Too many attempts: wait a minute.' : 'This is not the token.';
      }
    };
    dialog.showModal();
  });
}

/** Returns when this browser is admitted. Throws where the server does not answer. */
export async function admitted() {
  const token = new URLSearchParams(location.hash.slice(1)).get('token');
  if (token) {
    history.replaceState(null, '', location.pathname);
    if ((await offer(token)) === 204) return;
  }
  const answer = await fetch('/login', { cache: 'no-store', headers: { 'X-Page-Origin': location.origin } });
  if (answer.status === 421) throw new Refused(await answer.text());
  if (answer.status !== 204) await ask();
}

/** The server would take no socket of this page; the message says why. */
export class Refused extends Error {}

let asking = false;

/** Asks for the token again where the server has begun anew with another one. Says why it refuses this page, else nothing. */
export async function admittedStill() {
  if (asking) return '';
  asking = true;
  const fault = await admitted().then(() => null, (error) => error); // else the link is down; it is tried again
  asking = false;
  return fault instanceof Refused ? fault.message : '';
}
