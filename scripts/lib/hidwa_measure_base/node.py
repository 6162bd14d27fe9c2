# SPDX-License-Identifier: BSD-3-Clause
"""The guided measurement as a node: asks, drives, and stops the robot whatever happens."""
import signal
import sys
import threading
import time

import rosgraph
import rospy
import tf2_ros
from geometry_msgs.msg import Twist
from nav_msgs.msg import Odometry
from sensor_msgs.msg import LaserScan

from hidwa_tools.geometry import scan_hits, yaw_of

from .course import Course, Doubt, Watch, phases
from .track import Track

RATE = 20.0          # [Hz] of the commands
START = 5.0          # [s], wall time; by then whatever sends has sent
STALL = 3.0          # [s], wall time without odometry or clock, also where time is simulated
LOOK = 0.5           # [s], wall time from one look for other publishers to the next
ZEROS = 10           # commands of 0 at the end
ANSWER = 'yes'
STOPPED = '; the robot was told to stop'
SIGNALS = (signal.SIGINT, signal.SIGTERM, signal.SIGHUP)


def publishers(topic):
    """(names of the other nodes that publish a topic, names of those that listen to it)"""
    sends, hears, _ = rosgraph.Master(rospy.get_name()).getSystemState()

    def nodes(table):
        return sorted({node for name, names in table if name == topic for node in names} - {rospy.get_name()})
    return nodes(sends), nodes(hears)


class Robot:
    """What is sent and heard."""

    def __init__(self, options):
        self._options, self.track, self._lock = options, Track(), threading.Lock()
        self._arrived, self._stranger, self._nearest, self._child = None, '', None, ''
        self._scan_fault, self._scanned, self._looked = '', None, 0.0
        self.velocity = rospy.Publisher(options.cmd_vel_topic, Twist, queue_size=1, tcp_nodelay=True)
        self.topic = rospy.resolve_name(options.cmd_vel_topic)
        rospy.Subscriber(options.odom_topic, Odometry, self._take_odometry, queue_size=50, tcp_nodelay=True)
        rospy.Subscriber(self.topic, Twist, self._take_command, queue_size=10)
        self._buffer = tf2_ros.Buffer()
        self._listener = tf2_ros.TransformListener(self._buffer)
        self._scans = rospy.Subscriber(options.scan_topic, LaserScan, self._take_scan, queue_size=1) if options.scans else None

    def _take_odometry(self, message):
        pose, twist, now = message.pose.pose, message.twist.twist, rospy.get_time()
        with self._lock:
            self._child, self._arrived = message.child_frame_id, time.monotonic()
            self.track.receive(now, pose.position.x, pose.position.y, float(yaw_of(pose.orientation)), twist.linear.x, twist.angular.z,
                               message.header.stamp.to_sec())

    def _take_command(self, message):
        sender = message._connection_header.get('callerid', '?')  # pylint: disable=protected-access  # rospy's way to tell
        if sender != rospy.get_name():
            self._stranger = sender

    def _take_scan(self, scan):
        self._scanned = time.monotonic()
        if not self._child:
            self._scan_fault = 'scans cannot be placed on the robot, since odometry has no child_frame_id; give --no-scan'
            return
        try:
            found = self._buffer.lookup_transform(self._child.lstrip('/'), scan.header.frame_id.lstrip('/'), rospy.Time(0)).transform
        except tf2_ros.TransformException as fault:
            self._scan_fault = f'scans cannot be placed on the robot ({fault}); start what publishes this transform, or give --no-scan'
            return
        points = scan_hits(scan, found.translation, found.rotation)
        self._nearest = float((points ** 2).sum(axis=1).min() ** 0.5) if len(points) else None
        self._scan_fault = ''

    def wait(self):
        """Until odometry and a listener are there; Doubt where they do not come."""
        self._looked, end = 0.0, time.monotonic() + START
        listeners = []
        # A listener that the master knows is not yet connected; this node listens, too.
        while time.monotonic() < end and not (self._arrived and listeners and self.velocity.get_num_connections() > 1):
            time.sleep(0.1)
            _, listeners = publishers(self.topic)
        if not self._arrived:
            raise Doubt(f'no odometry comes on {rospy.resolve_name(self._options.odom_topic)}: check --odom-topic')
        if not listeners:
            raise Doubt(f'nobody listens to {self.topic}: start the driver of the base, or check --cmd-vel-topic')
        time.sleep(0.5)  # for a first scan
        self.check()

    def check(self):
        """Doubt where somebody else drives, something is near, or nothing is heard any more."""
        if self._stranger:
            raise Doubt(f'{self._stranger} sends commands on {self.topic}, too: end it')
        if time.monotonic() - self._looked > LOOK:
            self._looked = time.monotonic()
            others, _ = publishers(self.topic)
            if others:
                raise Doubt(f'{", ".join(others)} may send commands on {self.topic}, too: end it, or give --cmd-vel-topic a topic of '
                            'its own')
        if time.monotonic() - self._arrived > STALL:
            raise Doubt('odometry or the clock stands still')
        if self._options.lifted or not self._scans:
            return
        if self._scan_fault:
            raise Doubt(self._scan_fault)
        if self._scanned and time.monotonic() - self._scanned > STALL:
            raise Doubt('the scan was there, and is silent now')
        if self._nearest is not None and self._nearest < self._options.clearance:
            raise Doubt(f'the scan sees something {self._nearest:.2f} m from the robot\'s centre, nearer than --clearance '
                        f'{self._options.clearance:g} m')

    def begin(self):
        """What odometry said while somebody read the question does not count."""
        with self._lock:
            del self.track.odometry[:-1]
        self._looked = 0.0

    def send(self, v, omega):
        twist = Twist()
        twist.linear.x, twist.angular.z = v, omega
        with self._lock:
            self.track.command(rospy.get_time(), v, omega)
        self.velocity.publish(twist)

    def stop(self):
        """Zero, again and again: one message may be lost."""
        for _ in range(ZEROS):
            try:
                self.velocity.publish(Twist())
            except rospy.ROSException:
                return  # the node is shut down
            time.sleep(1.0 / RATE)


def drive(robot, options, say):
    """The whole course; Doubt where it has to end, KeyboardInterrupt after a signal. What a signal's handler raises can be lost:
    rospy catches everything while it publishes. So the handler takes notes alone."""
    signals = []
    for number in SIGNALS:
        signal.signal(number, lambda number, _: signals.append(number))
    course, watch = Course(robot.track, phases(options.speed, options.turn)), Watch(robot.track, options.lifted)
    phase, all_ = None, course.left
    while True:
        now = rospy.get_time()
        robot.check()
        watch.check(now)
        try:
            command = course.command(now)
        except StopIteration:
            return
        if command:
            robot.send(*command)
        if course.phase is not phase:
            phase = course.phase
            say(f'\r{all_ - course.left} of {all_}: {phase.kind} {phase.v:5.2f} m/s {phase.omega:5.2f} rad/s   ')
        time.sleep(1.0 / RATE)
        if signals:
            raise KeyboardInterrupt


def question(options):
    """What will happen, in words."""
    place = 'The wheels are lifted: nothing touches them.' if options.lifted else \
        'The robot needs 2 m free ahead and 1 m around it. Or lift its wheels off the ground, and give --lifted.'
    return (f'This drives the base for about two minutes: forwards and backwards at {options.speed:g} m/s, then left and right at '
            f'{options.turn:g} rad/s.\nIt never sends more. {place}\nStand by the stop. Ctrl-C ends it, and the robot stops.\n'
            f'Twice it stops sending while the robot drives, for up to 2 s, to see whether the base stops by itself.\nType {ANSWER} to '
            'begin: ')


def guided(options):
    """(Track or None, why there is none, exit status)."""
    rospy.init_node('measure_base', anonymous=True, disable_signals=True)
    robot, began = Robot(options), False
    try:
        robot.wait()
        print(question(options), end='', flush=True)
        if sys.stdin.readline().strip().lower() != ANSWER:
            return None, 'nothing was driven', 2
        robot.begin()
        began = True
        drive(robot, options, lambda text: print(text, end='', file=sys.stderr, flush=True))
        return robot.track, '', 0
    except Doubt as doubt:
        return None, f'{doubt}{STOPPED if began else ""}', 1 if began else 2
    except KeyboardInterrupt:
        return None, f'ended by hand{STOPPED if began else ""}', 1 if began else 2
    finally:
        for number in SIGNALS:
            signal.signal(number, signal.SIG_IGN)  # nothing keeps it from stopping the robot
        if began:
            robot.stop()
        print(file=sys.stderr)
