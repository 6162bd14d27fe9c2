# SPDX-License-Identifier: BSD-3-Clause
"""The command line of scripts/demo. Standard library only: it is read before anything is installed."""
import argparse
import os

POSES = ('--start', '--goal')
OPERATORS = ('avoid', 'none', 'joystick')
MODES = ('joystick', 'gesture', 'switching')


def pose(text):
    """X,Y,YAW [m, m, rad] as a list."""
    try:
        values = [float(part) for part in text.split(',')]
    except ValueError:
        values = []
    if len(values) != 3:
        raise argparse.ArgumentTypeError(f"'{text}' is no X,Y,YAW, three numbers in m, m and rad without spaces")
    return values


def existing(text):
    """An absolute path of a file that is there."""
    if not os.path.isfile(text):
        raise argparse.ArgumentTypeError(f"there is no file '{text}'")
    return os.path.abspath(text)


def operator(text):
    """avoid, none, joystick, or the absolute path of a script."""
    if text in OPERATORS:
        return text
    if not os.path.isfile(text):
        raise argparse.ArgumentTypeError(f"'{text}' is neither {', '.join(OPERATORS)} nor a file")
    return os.path.abspath(text)


def positive(text):
    """A number above 0."""
    try:
        value = float(text)
    except ValueError:
        value = 0.0
    if not 0.0 < value < float('inf'):
        raise argparse.ArgumentTypeError(f"'{text}' is no positive number")
    return value


def count(text):
    """A whole number from 0."""
    if not text.isdecimal() or len(text) > 6:
        raise argparse.ArgumentTypeError(f"'{text}' is no whole number from 0")
    return int(text)


def parser():
    """The argument parser."""
    p = argparse.ArgumentParser(
        prog='scripts/demo', formatter_class=argparse.RawDescriptionHelpFormatter,
        description='Installs what is missing, builds, and drives a simulated robot to its goal in move_base with HI-DWA\n'
        'while a person bends its path. Writes report.json, report.png and drive.bag.',
        epilog='exit status: 0 arrived without contact; 1 drove, but not so; 2 could not drive; 130 interrupted\n'
        'environment: HIDWA_UNDERLAY=DIR an install space with the real navigation stack; see scripts/build --help')
    p.add_argument('--map', type=existing, metavar='FILE.yaml', help="the floor, as map_server reads it (default: our office)")
    p.add_argument('--start', type=pose, metavar='X,Y,YAW', help='where the robot stands at first, in the map [m, m, rad]')
    p.add_argument('--goal', type=pose, metavar='X,Y,YAW', help='where it is to go')
    p.add_argument('--regions', type=existing, metavar='FILE.yaml',
                   help="regions to avoid that no sensor sees (default: our office's; none on another map)")
    p.add_argument('--operator', type=operator, default='avoid', metavar='avoid|none|joystick|FILE',
                   help='who steers: a simulated person who steers round the regions (default), nobody, you with a '
                   'joystick at /dev/input/js0, or a script of {after_m: 12.0, for_s: 3.0, stick: [1.0, 0.0]}')
    p.add_argument('--mode', choices=MODES, default='joystick',
                   help='how the person steers: by stick or by hand in shared control, or by taking control and giving '
                   'it back (default: %(default)s)')
    p.add_argument('--people', type=count, default=4, metavar='N',
                   help='how many people walk around; 0: nobody (default: %(default)s)')
    p.add_argument('--people-seed', type=count, default=1, metavar='N', help='what their ways depend on (default: %(default)s)')
    p.add_argument('--report', default='report', metavar='DIR', help='where the results go (default: %(default)s)')
    p.add_argument('--console', action='store_true',
                   help='you steer from a page: serves it, prints its address, and drives to and fro until Ctrl-C; docs/use/console.md')
    p.add_argument('--console-options', default='', metavar='"..."',
                   help="further options of the console's node, for one --console-options=\"--port 8080\"")
    p.add_argument('--gui', action='store_true', help='watch in rviz')
    p.add_argument('--rate', type=positive, default=1.0, metavar='N', help='speed of the simulated time (default: 1)')
    p.add_argument('--timeout', type=positive, default=900.0, metavar='S',
                   help='give up after so many simulated seconds (default: %(default).0f)')
    p.add_argument('--params', type=existing, metavar='FILE.yaml',
                   help="parameters over the demo's own, in move_base's namespace ({HIDWAPlannerROS: {...}})")
    p.add_argument('--planner', default='hidwa_local_planner/HIDWAPlannerROS', metavar='NAME',
                   help='another local planner, for comparison: PACKAGE/CLASS or PACKAGE::CLASS, as its package declares it '
                   '(default: %(default)s)')
    p.add_argument('--global-planner', default='navfn/NavfnROS', metavar='NAME', help='(default: %(default)s)')
    p.add_argument('--no-build', action='store_true', help='drive what is built already')
    return p


def join_poses(arguments):
    """The same words, each option that takes a pose joined with it by =: argparse would take the minus of
    "--start -7,2,0" for an option's."""
    joined, rest = [], list(arguments)
    while rest:
        word = rest.pop(0)
        joined.append(f'{word}={rest.pop(0)}' if word in POSES and rest else word)
    return joined


def parse(arguments):
    """The options; exits with a message where they make no sense."""
    p = parser()
    options = p.parse_args(join_poses(arguments))
    options.report = os.path.abspath(options.report)
    if options.map and not (options.regions or (options.start and options.goal)):
        p.error('--map needs --start and --goal too')
    if options.console:
        options.operator = 'page'
    if options.operator == 'avoid' and options.map and not options.regions:
        options.operator = 'none'  # nothing there to steer round
    if options.gui and not os.environ.get('DISPLAY'):
        p.error('--gui needs a display, but DISPLAY is not set; leave --gui out or start it from a desktop')
    return options
