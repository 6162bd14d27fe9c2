# SPDX-License-Identifier: BSD-3-Clause
"""What leaves the console for the robot: the messages of an ordinary device, as the planner's parameters ask for them."""
import rospy
from geometry_msgs.msg import PoseStamped
from sensor_msgs.msg import Joy
from std_msgs.msg import Bool, String

from .steering import NEUTRAL, Hand, is_neutral

AXES, BUTTONS = 8, 11   # those of a common gamepad; more where a parameter names a higher index
AXIS_INDEX = {'x': 0, 'y': 1, 'z': 2}
FRAME = 'console'


def joy_of(command, p):
    """(axes, buttons) of a sensor_msgs/Joy that the planner with the parameters `p` reads as this command."""
    hand = isinstance(command, Hand)
    axes, buttons = {}, {}
    if not hand:
        axes[p.get('axis_linear', 1)] = p.get('axis_linear_sign', 1) * command.forward
        axes[p.get('axis_angular', 0)] = p.get('axis_angular_sign', 1) * command.left
        buttons[p.get('enable_button', -1)] = int(command.held)
    clutch = hand and command.grip
    if p.get('mode') == 'gesture':
        if p.get('clutch_axis', -1) >= 0:
            released = -1.0 if p.get('clutch_threshold', 0.5) < 0.0 else 0.0
            axes[p['clutch_axis']] = p.get('clutch_axis_sign', 1) * (1.0 if clutch else released)
        else:
            buttons[p.get('clutch_button', 0)] = int(clutch)
    return _filled(axes, AXES, 0.0), _filled(buttons, BUTTONS, 0)


def _filled(values, least, empty):
    values.pop(-1, None)
    row = [empty] * max([least, *(index + 1 for index in values)])
    for index, value in values.items():
        row[index] = value
    return row


def position_of(hand, p):
    """x, y, z [m] of the hand on the axes that the planner reads."""
    place = [hand.up] * 3
    forward, left = AXIS_INDEX[p.get('gesture_linear_axis', 'x')], AXIS_INDEX[p.get('gesture_axis', 'y')]
    place[forward] = p.get('gesture_linear_sign', 1) * hand.forward
    place[left] = p.get('gesture_axis_sign', 1) * hand.left
    return place


class NeutralFirst(rospy.SubscribeListener):
    """A planner that starts asks for a neutral stick before anything else: it gets one as soon as it listens, unless somebody steers.
    `neutral()` gives that message, or None."""

    def __init__(self, neutral):
        super().__init__()
        self._neutral = neutral

    def peer_subscribe(self, topic_name, topic_publish, peer_publish):
        message = self._neutral()
        if message:
            peer_publish(message)


class Device:
    """The console as a device. `parameters()`: the planner's in force; `names`: robot.Names."""

    def __init__(self, names, parameters):
        self._parameters, self._publishers = parameters, {}
        self._joy, self._hand, self._last = None, None, NEUTRAL
        self._stop = self._publisher(names.of_planner('stop'), Bool)
        self._take_control = self._publisher(names.of_planner('take_control'), Bool)
        self._set_mode = self._publisher(names.of_planner('set_mode'), String)
        self.prepare()

    def prepare(self):
        """Publishers are known to the planner before their first message: it would be lost."""
        p = self._parameters()
        self._joy = self._publisher(p.get('joy_topic') or 'joy', Joy)
        self._hand = self._publisher(p.get('gesture_topic') or 'hand_pose', PoseStamped)

    def _publisher(self, topic, kind):
        topic = rospy.resolve_name(topic)
        if topic not in self._publishers:
            first = NeutralFirst(self._neutral) if kind is Joy else None
            self._publishers[topic] = rospy.Publisher(topic, kind, first, queue_size=10, tcp_nodelay=True)
        return self._publishers[topic]

    def steer(self, command):
        """A stick or a hand."""
        p = self._parameters()
        now = rospy.Time.now()
        if isinstance(command, Hand) and command.grip:
            pose = PoseStamped()
            pose.header.stamp, pose.header.frame_id, pose.pose.orientation.w = now, FRAME, 1.0
            pose.pose.position.x, pose.pose.position.y, pose.pose.position.z = position_of(command, p)
            self._hand.publish(pose)
        self._last = command
        self._joy.publish(self._message(command, p, now))

    def _neutral(self):
        return self._message(NEUTRAL, self._parameters(), rospy.Time.now()) if is_neutral(self._last) else None

    @staticmethod
    def _message(command, p, now):
        joy = Joy()
        joy.header.stamp, joy.header.frame_id = now, FRAME
        joy.axes, joy.buttons = joy_of(command, p)
        return joy

    def stop(self, on):
        """The topic stop."""
        self._stop.publish(Bool(on))

    def take_control(self, on):
        """The topic take_control."""
        self._take_control.publish(Bool(on))

    def set_mode(self, mode):
        """The topic set_mode."""
        self._set_mode.publish(String(mode))
