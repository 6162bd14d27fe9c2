// SPDX-License-Identifier: BSD-3-Clause
// The socket /camera: the newest picture, and the next one only when this one is shown.
import { put } from '../model/scene.js';
import { pageName, Socket } from './socket.js';

const TYPES = { 1: 'image/jpeg', 2: 'image/png' };
const HEADER = 16; // [bytes]

export class CameraLink {
  constructor(scene) {
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
    } catch (error) {
      console.error('a picture of the camera cannot be shown', error);
    }
    requestAnimationFrame(() => this.socket.send({ type: 'next' }));
  }

  end() {
    this.socket.end();
  }
}
