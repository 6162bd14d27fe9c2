// SPDX-License-Identifier: BSD-3-Clause
// A WebXR session: enters and leaves it, draws each frame from on board, and hands the frame's controllers and hands to
// HandSteering. A session that is not fully visible (visible-blurred, hidden) steers nothing.
import { readSources } from './hand.js';

export class Headset {
  /** board: views/board.js; hands: HandSteering; cut(why): as for a hidden tab; panel: views/head_panel.js */
  constructor(board, hands, cut, panel) {
    this.board = board;
    this.hands = hands;
    this.cut = cut;
    this.panel = panel;
    this.session = null;
    this.frames = 0;
  }

  static async available() {
    return Boolean(navigator.xr) && isSecureContext && navigator.xr.isSessionSupported('immersive-vr').catch(() => false);
  }

  async enter() {
    const { renderer } = this.board;
    const session = await navigator.xr.requestSession('immersive-vr', {
      requiredFeatures: ['local-floor'],
      optionalFeatures: ['hand-tracking'],
    });
    this.session = session;
    this.hands.clear();
    session.addEventListener('end', () => this.ended());
    session.addEventListener('visibilitychange', () => {
      if (session.visibilityState !== 'visible') this.cut('blur');
    });
    renderer.xr.enabled = true;
    renderer.xr.setReferenceSpaceType('local-floor');
    await renderer.xr.setSession(session);
    this.panel.show(true);
    renderer.setAnimationLoop((now, frame) => this.frame(now, frame));
  }

  leave() {
    return this.session ? this.session.end() : undefined;
  }

  ended() {
    this.cut('blur');
    const { renderer } = this.board;
    renderer.setAnimationLoop(null);
    renderer.xr.enabled = false;
    this.session = null;
    this.panel.show(false);
    this.board.leaveHeadset();
  }

  frame(now, frame) {
    if (!frame || !this.session) return;
    this.frames += 1;
    const space = this.board.renderer.xr.getReferenceSpace();
    if (this.session.visibilityState === 'visible' && space) {
      const sources = readSources(this.session, frame, space, this.hands.gripped);
      this.hands.take(sources, performance.now());
    }
    this.panel.update();
    this.board.frame(now);
  }

  /** strength in [0, 1]: on every controller that can. */
  rumble(strength) {
    if (!this.session) return;
    for (const { gamepad } of this.session.inputSources) {
      const actuator = gamepad && gamepad.hapticActuators && gamepad.hapticActuators[0];
      if (actuator) actuator.pulse(strength, 120).catch(() => {}); // one that cannot rumble steers all the same
    }
  }
}
