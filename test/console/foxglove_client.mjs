// SPDX-License-Identifier: BSD-3-Clause
// The protocol's own client against the console: node foxglove_client.mjs URL. Subscribes to the map and the robot's state, gives a goal
// 3 m right of the robot's start, and prints what it got as one line of JSON. Its modules are found through NODE_PATH.
import { createRequire } from 'node:module';
import { join } from 'node:path';

const require = createRequire(join(process.env.NODE_PATH, 'here.js'));
const { FoxgloveClient } = require('@foxglove/ws-protocol');
const { WebSocket } = require('ws');

const wanted = { '/map': 'map', '/move_base/HIDWAPlannerROS/operator_state': 'state' };
const got = { subprotocol: null, server: null, topics: 0, schemas: {}, bytes: {}, statuses: [] };
const socket = new WebSocket(process.argv[2], FoxgloveClient.SUPPORTED_SUBPROTOCOL ? [FoxgloveClient.SUPPORTED_SUBPROTOCOL] : ['foxglove.websocket.v1']);
const client = new FoxgloveClient({ ws: socket });
const names = new Map();

function finish(code) {
  got.subprotocol = socket.protocol;
  console.log(JSON.stringify(got));
  process.exit(code);
}

function finishOnceAllIsThere() {
  if (got.bytes.map && got.bytes.state && got.statuses.length > 0) { finish(0); }
}

client.on('error', (error) => { got.statuses.push(String(error.message || error)); finish(1); });
client.on('serverInfo', (info) => { got.server = info; });
client.on('status', (status) => { got.statuses.push(status.message); finishOnceAllIsThere(); });
client.on('advertise', (channels) => {
  got.topics += channels.length;
  for (const channel of channels) {
    if (wanted[channel.topic]) {
      got.schemas[wanted[channel.topic]] = channel.schemaName;
      names.set(client.subscribe(channel.id), wanted[channel.topic]);
    }
  }
  const goal = client.advertise({ topic: '/move_base_simple/goal', encoding: 'json', schemaName: 'geometry_msgs/PoseStamped' });
  const pose = { position: { x: 8.5, y: 2.5, z: 0 }, orientation: { x: 0, y: 0, z: 0, w: 1 } };
  client.sendMessage(goal, new TextEncoder().encode(JSON.stringify({ header: { frame_id: 'map' }, pose })));
});
client.on('message', ({ subscriptionId, data }) => {
  got.bytes[names.get(subscriptionId)] = data.byteLength;
  finishOnceAllIsThere();
});
setTimeout(() => finish(2), 20000);
