// SPDX-License-Identifier: BSD-3-Clause
// The socket /camera: the newest picture, and the next one only when this one is shown.
import { put } from '../model/scene.js';
import { pageName, Socket } from './socket.js';

const TYPES = { 1: 'image/jpeg', 2: 'image/png' };
const HEADER = 16; // [bytes]

export class CameraLink {
  /** failed(text): of a picture that the browser cannot show; empty: of one that it can. */
  constructor(scene, failed) {
    this.failed = failed;
    this.socket = new Socket('/camera', {
      open: () => {
        this.socket.send({ type: 'hello', page: pageName() });
        this.socket.send({ type: 'next' });
      },
      message: (data) => this.take(scene, data),
      closed: () => put(scene, 'picture', null),
    });
  }

  async take(scene, data) {
    const type = TYPES[new Uint8Array(data)[0]];
    try {
      const picture = await createImageBitmap(new Blob([data.slice(HEADER)], { type }));
      if (scene.picture) scene.picture.close();
      put(scene, 'picture', picture);
      this.failed('');
    } catch (error) {
      this.failed(`this browser cannot show it (${type || 'an unknown format'}): ${error.message}`);
    }
    requestAnimationFrame(() => this.socket.send({ type: 'next' }));
  }

  end() {
    this.socket.end();
  }
}
