// SPDX-License-Identifier: BSD-3-Clause
// The socket /view: takes ticks into the scene and acknowledges each, so that a slow page gets fewer ones, not late ones.
import { put } from '../model/scene.js';
import { decode } from './decode.js';
import { pageName, Socket } from './socket.js';

const GRID_PARTS = ['map', 'costmap'];

export class ViewLink {
  /** told(tick): each tick's JSON message, after the scene has it; connection(open): the link came or went. */
  constructor(scene, { told, connection }) {
    this.scene = scene;
    this.told = told;
    this.wanted = false;
    this.socket = new Socket('/view', {
      open: () => this.open(connection),
      message: (data) => this.take(data),
      closed: () => {
        put(scene, 'state', null);
        connection(false);
      },
    });
  }

  open(connection) {
    this.grids = {};
    this.pending = [];
    this.predictedTimed = false;
    this.socket.send({ type: 'hello', page: pageName() });
    this.want(this.wanted);
    connection(true);
  }

  /** Asks for the candidates, or no longer. */
  want(candidates) {
    this.wanted = candidates;
    this.socket.send({ type: 'want', candidates });
    if (!candidates) put(this.scene, 'candidates', []);
  }

  take(data) {
    if (typeof data !== 'string') return this.takeBinary(data);
    const message = JSON.parse(data);
    if (message.type !== 'tick') return undefined;
    this.takeTick(message);
    this.told(message);
    return this.socket.send({ type: 'ack', n: message.n });
  }

  takeBinary(data) {
    const { scene } = this;
    let message;
    try {
      message = decode(data, this.grids);
    } catch (error) {
      console.error('a message of /view cannot be read; connecting again', error);
      this.socket.again();
      return;
    }
    if (message.kind === 'grid' && message.grid) {
      this.grids[message.which] = message.grid;
      put(scene, GRID_PARTS[message.which], message.grid);
    } else if (message.kind === 'scan') {
      put(scene, 'scan', message.points);
    } else if (message.kind === 'path') {
      this.takePath(message);
    } else if (message.kind === 'candidates' && this.wanted) {
      put(scene, 'candidates', message.candidates);
    }
  }

  takePath({ which, points }) {
    if (which === 0) put(this.scene, 'plan', points.map(({ x, y }) => [x, y]));
    // The predicted path has times; where it does not come, the chosen rollout says as much.
    if (which === 3) this.predictedTimed = points.length > 0;
    if (which === 3 || (which === 2 && !this.predictedTimed)) put(this.scene, 'predicted', points);
  }

  takeTick(tick) {
    const { scene } = this;
    if (tick.pose) {
      const [x, y, yaw] = tick.pose;
      const [v, omega] = tick.velocity || [0, 0];
      put(scene, 'robot', { x, y, yaw, v, omega });
    }
    put(scene, 'state', tick.state && readState(tick.state));
    if (tick.limits) put(scene, 'limits', { maxV: tick.limits.max_vel_x, minV: tick.limits.min_vel_x, maxOmega: tick.limits.max_vel_theta, input_timeout: tick.limits.input_timeout, driveWithoutGoal: Boolean(tick.limits.drive_without_goal) });
    if (tick.footprint) put(scene, 'outline', tick.footprint);
    if (tick.regions) put(scene, 'regions', tick.regions);
    if (tick.obstacles) put(scene, 'movers', tick.obstacles.map(({ id, x, y, vx, vy, r }) => ({ id, x, y, vx, vy, radius: r })));
    if (tick.goals) {
      const goals = [...(tick.goals.active ? [tick.goals.active] : []), ...tick.goals.waiting];
      put(scene, 'goals', goals.map(([gx, gy, yaw]) => ({ x: gx, y: gy, yaw })));
    }
    if (tick.camera) put(scene, 'camera', tick.camera.info);
  }
}

function readState(state) {
  return {
    name: state.name, mode: state.mode, withoutGoal: state.without_goal, active: state.active,
    wanted: { v: state.wanted[0], omega: state.wanted[1] },
    command: { v: state.command[0], omega: state.command[1] },
    agreement: state.agreement, refusedBy: state.refused_by, next: state.next, nextReason: state.next_reason, age: state.age,
  };
}
