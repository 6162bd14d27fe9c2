# SPDX-License-Identifier: BSD-3-Clause
"""What the robot says, kept as it came: the newest message of each topic on the list, undecoded, and tf. Nothing else of the
ROS graph is reached."""
import math
import threading
import time

import genpy
import rospy
import tf2_ros
from diagnostic_msgs.msg import DiagnosticArray, DiagnosticStatus
from hidwa_local_planner.msg import OperatorState
from tf2_msgs.msg import TFMessage

from hidwa_tools.recording import DEFAULT_PLANNER, HOST, plugin_name

from .wire import yaw_of

DEFAULT_GLOBAL_PLANNER = 'navfn/NavfnROS'
SAID = 3.0  # [s] for which a diagnostic counts; there is one a second


class Newest:
    """The newest message of a topic, as bytes. `version` counts them, `at` is when it came (monotonic [s]). A process subscribes to a
    topic only once: rospy gives a latched message to the first subscriber alone. So others listen here."""

    def __init__(self, topic, also=None, queue_size=1):
        self.topic, self.data, self.version, self.at, self.kind = rospy.resolve_name(topic), None, 0, None, ''
        self._also, self._listeners, self._latched, self._lock = also, [], {}, threading.Lock()
        self._subscriber = rospy.Subscriber(self.topic, rospy.AnyMsg, self._receive, queue_size=queue_size, buff_size=1 << 24,
                                            tcp_nodelay=True)

    def _receive(self, message):
        header, data = message._connection_header, message._buff
        self.data, self.at, self.kind = data, time.monotonic(), header.get('type', '')
        self.version += 1
        if self._also:
            self._also(data)
        with self._lock:
            if header.get('latching') == '1':
                self._latched[header.get('callerid', '')] = data
            listeners = list(self._listeners)
        for listener in listeners:
            listener(data)

    def listen(self, listener):
        """Calls listener(bytes), in rospy's thread: now with what is latched, then with each message."""
        with self._lock:
            self._listeners.append(listener)
            latched = list(self._latched.values())
        for data in latched:
            listener(data)

    def forget(self, listener):
        """The listener is not called any more."""
        with self._lock:
            self._listeners.remove(listener)

    def age(self):
        """Time since it came [s]; infinite where none did."""
        return float('inf') if self.at is None else time.monotonic() - self.at

    def message(self, kind):
        """It as a message of a class; None where it is none."""
        if self.data is None or self.kind != kind._type:
            return None
        try:
            return kind().deserialize(self.data)
        except Exception as fault:  # whatever a foreign sender wrote
            rospy.logwarn_throttle(10.0, f'{self.topic} carries what is no {kind._type}: {fault}')
            return None

    @property
    def sources(self):
        """How many nodes publish it."""
        return self._subscriber.get_num_connections()

    def end(self):
        """No more of them."""
        self._subscriber.unregister()


def planners():
    """Full names of the planners that run in this node's namespace."""
    end = '/operator_state'
    return sorted(topic[:-len(end)] for topic, kind in rospy.get_published_topics(rospy.get_namespace())
                  if kind == OperatorState._type and topic.endswith(end))


class Names:
    """Full names of the host's topics: of that of the planner with this name, else of move_base, as its parameters say."""

    def __init__(self, planner=''):
        self.host = rospy.resolve_name(planner or HOST.rstrip('/'))
        if planner:
            self.planner, self.host = self.host, self.host.rsplit('/', 1)[0]
        else:
            self.planner = f'{self.host}/{self._plugin("base_local_planner", DEFAULT_PLANNER)}'
        self.global_plan = f'{self.host}/{self._plugin("base_global_planner", DEFAULT_GLOBAL_PLANNER)}/plan'
        self.map_frame = rospy.get_param(f'{self.host}/global_costmap/global_frame', 'map').lstrip('/')
        self.base_frame = rospy.get_param(f'{self.host}/local_costmap/robot_base_frame', 'base_link').lstrip('/')

    def _plugin(self, parameter, default):
        return plugin_name(rospy.get_param(f'{self.host}/{parameter}', default))

    def of_planner(self, name):
        """A topic of the planner."""
        return f'{self.planner}/{name}'


class Robot:
    """The topics that the page may see."""

    def __init__(self, names, obstacles_topic='moving_obstacles'):
        self.names = names
        costmap = f'{names.host}/local_costmap/'
        self.updates, self._lock = [], threading.Lock()
        self.map = Newest('map')
        self.costmap = Newest(costmap + 'costmap', also=self._forget_updates)
        self._updates = Newest(costmap + 'costmap_updates', also=self._keep_update)
        self.footprint = Newest(costmap + 'footprint')
        self.scan, self.odom = Newest('scan'), Newest('odom')
        self.plan = Newest(names.global_plan)
        self.window, self.local_plan = Newest(names.of_planner('global_plan')), Newest(names.of_planner('local_plan'))
        self.predicted = Newest(names.of_planner('predicted_path'))
        self.state, self.mode = Newest(names.of_planner('operator_state')), Newest(names.of_planner('mode'))
        self.obstacles, self.regions = Newest(obstacles_topic), Newest('regions')
        self._buffer = tf2_ros.Buffer(rospy.Duration(10.0))
        self._tf = Newest('/tf', also=lambda data: self._take_transforms(data, self._buffer.set_transform), queue_size=100)
        self._tf_static = Newest('/tf_static', also=lambda data: self._take_transforms(data, self._buffer.set_transform_static),
                                 queue_size=100)
        self._said = ('', -math.inf)  # of the operator's device, and when it came (monotonic [s])
        self._diagnostics = Newest('/diagnostics', also=self._take_diagnostics, queue_size=10)
        self._topics = {value.topic: value for value in vars(self).values() if isinstance(value, Newest)}

    def _take_diagnostics(self, data):
        try:
            array = DiagnosticArray().deserialize(data)
        except genpy.DeserializationError:
            return
        end = f'{self.names.planner.rsplit("/", 1)[1]} operator'
        for status in array.status:
            if status.name.endswith(end):
                self._said = (status.message if status.level != DiagnosticStatus.OK else '', time.monotonic())

    def said(self):
        """What the planner complains of about the operator's device, in words; else empty."""
        text, at = self._said
        return text if time.monotonic() - at < SAID else ''

    def find(self, topic):
        """The Newest of a topic that is followed anyway, or None."""
        return self._topics.get(topic)

    @staticmethod
    def _take_transforms(data, put):
        for transform in TFMessage().deserialize(data).transforms:
            put(transform, 'console')

    def _keep_update(self, data):
        with self._lock:
            self.updates = [*self.updates[-99:], data]

    def _forget_updates(self, _):
        with self._lock:
            self.updates = []

    def take_updates(self):
        """The changes of the costmap since the last call."""
        with self._lock:
            taken, self.updates = self.updates, []
        return taken

    def pose_of(self, frame, full=False, target=None):
        """x, y, yaw of a frame in the map; with `full` x, y, z and the quaternion. None where tf does not know."""
        try:
            t = self._buffer.lookup_transform(target or self.names.map_frame, frame.lstrip('/'), rospy.Time(0)).transform
        except (tf2_ros.LookupException, tf2_ros.ConnectivityException, tf2_ros.ExtrapolationException,
                tf2_ros.InvalidArgumentException):
            return None
        p, q = t.translation, t.rotation
        return (p.x, p.y, p.z, q.x, q.y, q.z, q.w) if full else (p.x, p.y, float(yaw_of(q.x, q.y, q.z, q.w)))
