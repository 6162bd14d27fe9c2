# SPDX-License-Identifier: BSD-3-Clause
"""The command line of measure_base."""
import argparse
import sys

from hidwa_tools.bagfile import choose, read_messages
from hidwa_tools.errors import BagError
from hidwa_tools.geometry import yaw_of
from hidwa_tools.processes import end_on_signals

from .course import FASTEST, FASTEST_TURN
from .findings import find, text
from .track import Track

NO_PICTURE = 'There is no picture: matplotlib is not installed (apt-get install python3-matplotlib).'


def at_most(limit, least):
    """A number from `least` to `limit`, for argparse."""
    def number(word):
        try:
            value = float(word)
        except ValueError:
            value = 0.0
        if not least <= value <= limit:
            raise argparse.ArgumentTypeError(f"'{word}' is no number from {least:g} to {limit:g}")
        return value
    return number


def parser():
    p = argparse.ArgumentParser(
        prog='measure_base', description='Measures how the base answers commands: control_latency, accelerations, decelerations, the '
        'dead band of turns, and how long it goes on when commands cease. Prints the YAML that robot_params of move_base.launch takes. '
        'It drives the robot, and asks before it does; with --bag it reads a recorded drive.',
        epilog='exit status: 0 measured; 1 ended while it drove; 2 drove nothing')
    p.add_argument('--bag', metavar='FILE', help='read commands and odometry from this bag, and drive nothing')
    p.add_argument('--lifted', action='store_true', help='the wheels are off the ground: neither the scan nor the way counts')
    p.add_argument('--speed', type=at_most(FASTEST, 0.1), default=0.25, metavar='V',
                   help=f'[m/s], at most {FASTEST} (default: %(default)s)')
    p.add_argument('--turn', type=at_most(FASTEST_TURN, 0.2), default=0.5, metavar='W',
                   help=f'[rad/s], at most {FASTEST_TURN} (default: %(default)s)')
    p.add_argument('--clearance', type=at_most(5.0, 0.1), default=0.6, metavar='D',
                   help="the scan must see nothing nearer to the robot's centre [m] (default: %(default)s)")
    p.add_argument('--no-scan', dest='scans', action='store_false', help='do not look at the scan')
    p.add_argument('--cmd-vel-topic', metavar='TOPIC', help='(default: cmd_vel; in a bag also by its type)')
    p.add_argument('--odom-topic', metavar='TOPIC', help='(default: odom; in a bag also by its type)')
    p.add_argument('--scan-topic', default='scan', metavar='TOPIC', help='(default: %(default)s)')
    p.add_argument('--out', metavar='FILE', help='write the YAML to this file, too')
    p.add_argument('--picture', default='measure_base.png', metavar='FILE', help='(default: %(default)s)')
    return p


def from_bag(options):
    """The Track of a bag; BagError where it holds none."""
    kinds = {'geometry_msgs/Twist', 'nav_msgs/Odometry'}
    messages = read_messages(options.bag, lambda topic, kind: kind in kinds)
    names = []
    for kind, usual, given in (('geometry_msgs/Twist', '/cmd_vel', options.cmd_vel_topic),
                               ('nav_msgs/Odometry', '/odom', options.odom_topic)):
        topic, doubt = choose(messages, {kind}, usual, given)
        if not messages.get(topic):
            option = '--cmd-vel-topic' if kind.endswith('Twist') else '--odom-topic'
            raise BagError(f'{options.bag} holds no {kind} that is {usual}: name the topic with {option} ({doubt or "there is none"})')
        names.append(topic)
    track = Track()
    for time, command in messages.get(names[0]):
        track.command(time - messages.begin, command.linear.x, command.angular.z)
    for time, message in messages.get(names[1]):
        pose, twist, stamp = message.pose.pose, message.twist.twist, message.header.stamp.to_sec()
        track.receive(time - messages.begin, pose.position.x, pose.position.y, float(yaw_of(pose.orientation)), twist.linear.x,
                      twist.angular.z, stamp - messages.begin if stamp else 0.0)
    return track


def draw(found, path):
    """The picture, or why there is none."""
    try:
        from .picture import draw as draw_picture
    except ModuleNotFoundError as fault:
        if fault.name != 'matplotlib':
            raise
        return NO_PICTURE
    try:
        return draw_picture(found, path)
    except OSError as fault:
        return f'There is no picture: {fault}.'


def main(arguments=None):
    """measure_base"""
    words = sys.argv[1:] if arguments is None else arguments
    options = parser().parse_args([word for word in words if ':=' not in word])  # rospy takes the remaps
    if options.bag:
        try:
            track = from_bag(options)
        except BagError as fault:
            print(f'measure_base: {fault}', file=sys.stderr)
            return 2
    else:
        from .node import guided
        options.cmd_vel_topic, options.odom_topic = options.cmd_vel_topic or 'cmd_vel', options.odom_topic or 'odom'
        end_on_signals()
        track, fault, status = guided(options)
        if not track:
            print(f'measure_base: {fault}', file=sys.stderr)
            return status
    found = find(track)
    print(text(found), end='')
    if options.out:
        with open(options.out, 'w', encoding='utf-8') as out:
            out.write(text(found))
    print(draw(found, options.picture), file=sys.stderr)
    return 0
