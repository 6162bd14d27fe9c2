# SPDX-License-Identifier: BSD-3-Clause
"""Foxglove's WebSocket protocol, version 1, for Lichtblick and its like: they see the listed topics, and may set goals. Messages
pass as they came, undecoded."""
import collections
import json
import math
import struct
import time

import rospy
import tornado.web
from diagnostic_msgs.msg import DiagnosticArray
from geometry_msgs.msg import PolygonStamped, PoseStamped
from hidwa_local_planner.msg import Cycle, Evaluation, MovingObstacles, OperatorState
from map_msgs.msg import OccupancyGridUpdate
from nav_msgs.msg import OccupancyGrid, Odometry, Path
from sensor_msgs.msg import Joy, LaserScan
from tf2_msgs.msg import TFMessage
from visualization_msgs.msg import MarkerArray

from .messages import FARTHEST, Malformed
from .robot import Newest
from .server import POLICY, Socket
from .wire import yaw_of

SUBPROTOCOLS = ('foxglove.sdk.v1', 'foxglove.websocket.v1')
DATA = 1                   # op of a binary message, both ways
GOAL_TOPIC = 'move_base_simple/goal'
MOST = 256                 # subscriptions, and advertised channels, of one client
KEPT_TF = 100              # messages of tf that may wait; of all else the newest
INFO, WARNING = 0, 1       # levels of a status

Channel = collections.namedtuple('Channel', 'id topic kind kept')


def channels_of(names, obstacles='moving_obstacles'):
    """What may be seen, by full names."""
    costmap, p = names.host + '/local_costmap/', names.of_planner
    kinds = {'/tf': TFMessage, '/tf_static': TFMessage, 'map': OccupancyGrid, costmap + 'costmap': OccupancyGrid,
             costmap + 'costmap_updates': OccupancyGridUpdate, costmap + 'footprint': PolygonStamped, 'scan': LaserScan,
             'odom': Odometry, 'joy': Joy, names.global_plan: Path, p('global_plan'): Path, p('local_plan'): Path,
             p('predicted_path'): Path, p('operator_state'): OperatorState, p('operator_markers'): MarkerArray,
             p('trajectories'): MarkerArray, p('cycle'): Cycle, p('evaluation'): Evaluation, obstacles: MovingObstacles,
             'regions': MarkerArray, '/diagnostics': DiagnosticArray, names.host + '/current_goal': PoseStamped}
    return [Channel(i, rospy.resolve_name(topic), kind, KEPT_TF if kind is TFMessage else 1)
            for i, (topic, kind) in enumerate(kinds.items(), 1)]


class Feeds:
    """The topics for those that watch them. `find(topic)`: a robot.Newest that there is anyway, or None; `post(function)` runs it in the
    server's thread."""

    def __init__(self, channels, find, post):
        self.channels, self._find, self._post, self._own = {c.id: c for c in channels}, find, post, {}

    def add(self, number, client):
        """A client, a function of (stamp [ns], bytes); returns what ends it."""
        channel = self.channels[number]
        topic, ended = self._find(channel.topic) or self._watch(channel), []

        def pass_on(stamp, data):
            if not ended:
                client(stamp, data)

        def listen(data):
            stamp = rospy.get_rostime().to_nsec()
            self._post(lambda: pass_on(stamp, data))
        topic.listen(listen)

        def end():
            ended.append(True)
            topic.forget(listen)
            self._leave(channel)
        return end

    def _watch(self, channel):
        topic, count = self._own.get(channel.id) or (Newest(channel.topic, queue_size=channel.kept), 0)
        self._own[channel.id] = (topic, count + 1)
        return topic

    def _leave(self, channel):
        if channel.id not in self._own:
            return
        topic, count = self._own[channel.id]
        self._own[channel.id] = (topic, count - 1)
        if count == 1:
            topic.end()
            del self._own[channel.id]


class Subscription:
    """A client's subscription: at most one message on its way, behind it the newest (of tf some more)."""

    def __init__(self, number, kept, write):
        self._head, self._write, self._busy = struct.pack('<BI', DATA, number), write, False
        self._waiting = collections.deque(maxlen=kept)

    def __call__(self, stamp, data):
        self._waiting.append(struct.pack('<Q', stamp) + data)
        self._send()

    def _send(self, _=None):
        if self._busy or not self._waiting:
            return
        self._busy = True
        self._write(self._head + self._waiting.popleft(), self._sent)

    def _sent(self):
        self._busy = False
        self._send()


def goal_of(encoding, data):
    """(frame, x, y, yaw) of a geometry_msgs/PoseStamped in `ros1` or `json`. Malformed where it is none."""
    try:
        if encoding == 'ros1':
            message = PoseStamped().deserialize(data)
            p, q, frame = message.pose.position, message.pose.orientation, message.header.frame_id
            values = (p.x, p.y, q.x, q.y, q.z, q.w)
        else:
            message = json.loads(data.decode('utf-8'))
            p, q, frame = message['pose']['position'], message['pose']['orientation'], message.get('header', {}).get('frame_id', '')
            values = tuple(float(v) for v in (p['x'], p['y'], q['x'], q['y'], q['z'], q['w']))
    except Exception as fault:  # genpy raises what it likes
        raise Malformed(f'it is no geometry_msgs/PoseStamped: {fault}') from None
    if not all(math.isfinite(v) for v in values) or not isinstance(frame, str):
        raise Malformed('the goal is not finite')
    if max(abs(values[0]), abs(values[1])) > FARTHEST:
        raise Malformed(f'the goal is farther than {FARTHEST:g} m')
    if abs(math.sqrt(sum(v * v for v in values[2:])) - 1.0) > 0.1:
        raise Malformed("the goal's quaternion is none")
    return frame.lstrip('/'), values[0], values[1], float(yaw_of(*values[2:]))


class FoxgloveSocket(Socket):
    """/foxglove"""

    def prepare(self):
        super(Socket, self).prepare()
        token = self.path_args[0] if self.path_args else None
        if not self.console.access.foreign_allowed(self.request.headers.get('Origin'), token or ''):
            raise tornado.web.HTTPError(403, reason='this origin may not (--allow-origin adds it; off loopback the token is in the path)')

    def check_origin(self, origin):
        return True  # prepare() did

    def select_subprotocol(self, subprotocols):
        return next((name for name in SUBPROTOCOLS if name in subprotocols), None)

    def opened(self):
        self.subscriptions, self.advertised = {}, {}
        if self.selected_subprotocol is None:
            self.end(POLICY, 'ask for the subprotocol ' + ' or '.join(SUBPROTOCOLS))
            return
        self.say({'op': 'serverInfo', 'name': 'hidwa_local_planner', 'capabilities': ['clientPublish'],
                  'supportedEncodings': ['ros1', 'json'], 'metadata': {'ROS_DISTRO': 'noetic'}, 'sessionId': str(time.time())})
        self.say({'op': 'advertise', 'channels': [
            {'id': c.id, 'topic': c.topic, 'encoding': 'ros1', 'schemaName': c.kind._type, 'schema': c.kind._full_text,
             'schemaEncoding': 'ros1msg'} for c in self.console.feeds.channels.values()]})

    def greeted(self):
        return True

    def closed(self):
        for number in list(getattr(self, 'subscriptions', ())):
            self._unsubscribe(number)

    def take(self, data):
        if isinstance(data, bytes):
            self._publish(data)
            return
        try:
            message = json.loads(data)
            take = {'subscribe': self._on_subscribe, 'unsubscribe': self._on_unsubscribe, 'advertise': self._on_advertise,
                    'unadvertise': self._on_unadvertise}.get(message['op'])
            if take:
                take(message)
            else:
                self._status(WARNING, f'{str(message["op"])[:40]} is not offered here')
        except (ValueError, KeyError, TypeError, AttributeError, RecursionError):
            raise Malformed('it is no message of Foxglove\'s protocol') from None

    def _status(self, level, text):
        self.say({'op': 'status', 'level': level, 'message': text})

    def _on_subscribe(self, message):
        for entry in message['subscriptions']:
            number, channel = _id(entry['id']), self.console.feeds.channels.get(_id(entry['channelId']))
            if channel is None or number in self.subscriptions or len(self.subscriptions) >= MOST:
                self._status(WARNING, f'subscription {number} is not possible: no such channel, used already, or too many')
                continue
            client = Subscription(number, channel.kept, self._write)
            self.subscriptions[number] = self.console.feeds.add(channel.id, client)

    def _on_unsubscribe(self, message):
        for number in message['subscriptionIds']:
            if _id(number) in self.subscriptions:
                self._unsubscribe(number)

    def _unsubscribe(self, number):
        self.subscriptions.pop(number)()

    def _write(self, data, done):
        if not self.ws_connection:
            return
        try:
            future = self.write_message(data, True)
        except tornado.websocket.WebSocketClosedError:
            return
        self.console.when_done(future, done)

    def _on_advertise(self, message):
        for entry in message['channels']:
            number, topic = _id(entry['id']), rospy.resolve_name(str(entry['topic']))
            if topic != rospy.resolve_name(GOAL_TOPIC) or entry['encoding'] not in ('ros1', 'json') or len(self.advertised) >= MOST:
                self._status(WARNING, f'{topic[:80]} cannot be published here: {rospy.resolve_name(GOAL_TOPIC)} alone can')
                continue
            self.advertised[number] = entry['encoding']

    def _on_unadvertise(self, message):
        for number in message['channelIds']:
            self.advertised.pop(_id(number), None)

    def _publish(self, data):
        if len(data) < 5 or data[0] != DATA:
            raise Malformed('it is no message of Foxglove\'s protocol')
        encoding = self.advertised.get(struct.unpack_from('<I', data, 1)[0])
        if encoding is None:
            self._status(WARNING, 'a message of a channel that was not advertised, or may not be')
            return
        ok, text = self.console.foreign_goal(*goal_of(encoding, data[5:]))
        self._status(INFO if ok else WARNING, text)


def _id(value):
    if isinstance(value, bool) or not isinstance(value, int) or not 0 <= value < 2 ** 32:
        raise ValueError
    return value
