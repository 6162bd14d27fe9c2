# SPDX-License-Identifier: BSD-3-Clause
"""What leaves the console for the robot: the messages of an ordinary device, as the planner's parameters ask for them."""
import time

import rospy
from geometry_msgs.msg import PoseStamped
from sensor_msgs.msg import Joy
from std_msgs.msg import Bool, String

from .steering import DEVICE_OF_MODE, NEUTRAL, Hand, is_neutral

AXES, BUTTONS = 8, 11   # those of a common gamepad; more where a parameter names a higher index
FRAME = 'console'
CONNECTING = 2.0   # [s] for which nodes that connect may take to hear each other


def joy_of(command, p):
    """(axes, buttons) of a sensor_msgs/Joy that the planner with the parameters `p` reads as this command."""
    hand = isinstance(command, Hand)
    axes, buttons = {}, {}
    if not hand:
        rest = p.get('axis_linear_rest', 0.0)
        linear, sign = _axis(p, 'axis_linear', 1)
        axes[linear] = max(-1.0, min(1.0, rest + (1.0 + abs(rest)) * sign * command.forward))
        angular, sign = _axis(p, 'axis_angular', 0)
        axes[angular] = sign * command.left
        buttons[p.get('enable_button', -1)] = int(command.held)
    clutch = hand and command.grip
    if p.get('mode') == 'gesture':
        clutch_axis, sign = _axis(p, 'clutch_axis', -1)
        if clutch_axis >= 0:
            axes[clutch_axis] = sign * float(clutch)
        else:
            buttons[p.get('clutch_button', 0)] = int(clutch)
    return _filled(axes, AXES, 0.0), _filled(buttons, BUTTONS, 0)


def _axis(p, name, default):
    """(index, sign) of an axis such as 3 or '3 reversed'."""
    index, *reversed_ = str(p.get(name, default)).split()
    return int(index), -1 if reversed_ else 1


def _filled(values, least, empty):
    values.pop(-1, None)
    row = [empty] * max([least, *(index + 1 for index in values)])
    for index, value in values.items():
        row[index] = value
    return row


def position_of(hand, p):
    """x, y, z [m] of the hand on the axes that the planner reads."""
    place = [hand.up] * 3
    for axis, way in ((p.get('gesture_linear_axis', 'x'), hand.forward), (p.get('gesture_axis', 'y'), hand.left)):
        place['xyz'.index(axis[-1])] = -way if axis.startswith('-') else way
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


class Outlet:
    """A topic to the robot, and whether somebody listens there. What records it does not count: `there()` says whether the node is there
    for which it is meant."""

    def __init__(self, topic, kind, there, first=None, queue_size=10):
        self.topic, self._there, self._heard_at = rospy.resolve_name(topic), there, time.monotonic()
        self._publisher = rospy.Publisher(self.topic, kind, first, queue_size=queue_size, tcp_nodelay=True)

    def publish(self, message):
        """Sends it. Says why nobody hears it, else nothing."""
        self._publisher.publish(message)
        return '' if self.heard() else f'nobody listens on {self.topic}'

    def heard(self):
        """Whether somebody listens, or did a moment ago."""
        now = time.monotonic()
        if self._publisher.get_num_connections() and self._there():
            self._heard_at = now
        return now - self._heard_at < CONNECTING


class Device:
    """The console as a device. `parameters()`: the planner's in force; `names`: robot.Names; `there()`: whether the planner is."""

    def __init__(self, names, parameters, there=lambda: True):
        self._parameters, self._there, self._outlets = parameters, there, {}
        self._joy, self._hand, self._last = None, None, NEUTRAL
        self._stop = self._outlet(names.of_planner('stop'), Bool)
        self._take_control = self._outlet(names.of_planner('take_control'), Bool)
        self._set_mode = self._outlet(names.of_planner('set_mode'), String)
        self.prepare()

    def prepare(self):
        """Publishers are known to the planner before their first message: it would be lost."""
        p = self._parameters()
        self._joy = self._outlet(p.get('joy_topic') or 'joy', Joy)
        self._hand = self._outlet(p.get('gesture_topic') or 'hand_pose', PoseStamped)

    def _outlet(self, topic, kind):
        topic = rospy.resolve_name(topic)
        if topic not in self._outlets:
            self._outlets[topic] = Outlet(topic, kind, self._there, NeutralFirst(self._neutral) if kind is Joy else None)
        return self._outlets[topic]

    def unheard(self, mode):
        """{what: topic} of what nobody hears; mode: the planner's, or None."""
        outlets = {'stop': self._stop, 'mode': self._set_mode, 'take control': self._take_control}
        if mode in DEVICE_OF_MODE:
            outlets['stick'] = self._joy  # in mode gesture it has the clutch
        if mode == 'gesture':
            outlets['hand'] = self._hand
        return {what: outlet.topic for what, outlet in outlets.items() if not outlet.heard()}

    def steer(self, command):
        """A stick or a hand. As all that is sent here: says why nobody hears it, else nothing."""
        p = self._parameters()
        now, unheard = rospy.Time.now(), ''
        if isinstance(command, Hand) and command.grip:
            pose = PoseStamped()
            pose.header.stamp, pose.header.frame_id, pose.pose.orientation.w = now, FRAME, 1.0
            pose.pose.position.x, pose.pose.position.y, pose.pose.position.z = position_of(command, p)
            unheard = self._hand.publish(pose)
        self._last = command
        return self._joy.publish(self._message(command, p, now)) or unheard

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
        return self._stop.publish(Bool(on))

    def take_control(self, on):
        """The topic take_control."""
        return self._take_control.publish(Bool(on))

    def set_mode(self, mode):
        """The topic set_mode."""
        return self._set_mode.publish(String(mode))
