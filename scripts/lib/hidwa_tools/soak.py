# SPDX-License-Identifier: BSD-3-Clause
"""scripts/soak, once everything is built: a simulated robot in its host for hours, with goals, people, a person who steers, changes
of parameters and faults at random. Is memory flat, is every cycle there, and does the time of a cycle stay what it is?"""
import argparse
import itertools
import math
import os
import random
import sys
import tempfile
import time
import xmlrpc.client

from .places import ROOT, SPACE

LAUNCH = os.path.join(ROOT, 'test', 'ros', 'faults', 'launch', 'robot.launch')
CLEARANCE = 0.7   # of a place where the robot is sent [m]
QUIET = (4.0, 12.0)  # between two disturbances [s]
GOAL_TIME = 90.0  # for one goal [s]; then the next


def parse(arguments):
    """The command line."""
    parser = argparse.ArgumentParser(
        prog='scripts/soak',
        description='Drives a simulated robot in move_base for hours of simulated time: random goals, people, a stick,\n'
        'changes of parameters, faults. Writes a line a minute to soak.csv, and summary.json.',
        formatter_class=argparse.RawDescriptionHelpFormatter,
        epilog='exit status: 0 memory and times stayed flat, no cycle was lost and every command was within its limits; 1 not so;\n'
        '2 something did not run')
    parser.add_argument('--hours', type=float, default=1.0, metavar='H', help='of simulated time (1)')
    parser.add_argument('--rate', type=float, default=1.0, metavar='R', help='simulated seconds a second (1)')
    parser.add_argument('--people', type=int, default=4, metavar='N', help='who walk around (4)')
    parser.add_argument('--seed', type=int, default=1, metavar='N', help='other goals and disturbances (1)')
    parser.add_argument('--out', default=os.path.join(SPACE, 'build', 'soak'), metavar='DIR', help='where the figures go (build/soak)')
    parser.add_argument('--no-build', action='store_true', help='run what is built')
    options = parser.parse_args(arguments)
    if not (options.hours > 0.0 and options.rate > 0.0):
        parser.error('--hours and --rate must be above 0')
    options.out = os.path.abspath(options.out)
    return options


class Places:
    """Free places of the map, drawn at random."""

    def __init__(self, grid, rng):
        self._grid, self._random = grid, rng

    def draw(self):
        info = self._grid.info
        reach = math.ceil(CLEARANCE / info.resolution)
        while True:
            i, j = self._random.randrange(reach, info.width - reach), self._random.randrange(reach, info.height - reach)
            rows = range(j - reach, j + reach + 1)
            starts = [row * info.width + i - reach for row in rows]
            if all(not any(self._grid.data[start:start + 2 * reach + 1]) for start in starts):
                return (info.origin.position.x + (i + 0.5) * info.resolution, info.origin.position.y + (j + 0.5) * info.resolution)


class Disturbances:
    """What happens to the robot, one at a time: each a name, and a function that begins it and returns what ends it."""

    def __init__(self, host, gate, stick, rng):
        import rospy
        from dynamic_reconfigure.msg import Config, DoubleParameter, IntParameter
        from dynamic_reconfigure.srv import Reconfigure
        from roscpp.srv import Empty
        from std_msgs.msg import Bool, String
        from command_watch import PLANNER
        from message_gate import transforms_with
        self._host, self._gate, self._stick, self._random = host, gate, stick, rng
        self._set = rospy.ServiceProxy(PLANNER + '/set_parameters', Reconfigure)
        self._clear = rospy.ServiceProxy('/move_base/clear_costmaps', Empty)
        self._mode = rospy.Publisher(PLANNER + '/set_mode', String, queue_size=1)
        self._stop = rospy.Publisher(PLANNER + '/stop', Bool, queue_size=1)
        self.count = 0

        def steer():
            stick.left, stick.ahead = rng.uniform(-1.0, 1.0), rng.uniform(-0.3, 1.0)
            return neutral

        def neutral():
            stick.left, stick.ahead, stick.sends = 0.0, 0.0, True

        def cut():
            stick.left = rng.choice((-0.8, 0.8))
            time.sleep(0.5)
            stick.sends = False
            return neutral

        def parameters():
            before = self._set(Config()).config  # with more or fewer samples for good, times could not be compared
            self._set(Config(doubles=[DoubleParameter('authority', rng.uniform(0.3, 1.0)),
                                      DoubleParameter('sim_time', rng.uniform(1.2, 2.0)),
                                      DoubleParameter('max_vel_x', rng.uniform(0.3, 0.5))],
                             ints=[IntParameter('vx_samples', rng.randrange(8, 21)), IntParameter('vth_samples', rng.randrange(8, 21))]))
            return lambda: self._set(before)

        def mode():
            self._mode.publish(rng.choice(('switching', 'off', 'gesture')))
            return lambda: self._mode.publish('joystick')

        def stop():
            self._stop.publish(True)
            return lambda: self._stop.publish(False)

        def jump(message):
            if self._random.random() < 0.3:
                message.twist.twist.linear.x = 3.0
            return message

        def nudge(transform):
            transform.transform.translation.x += 0.2
            return transform

        def ahead(transform):
            transform.header.stamp += rospy.Duration(1.0)
            return transform

        def drop(*names):
            def begin():
                gate.drop(*names)
                return gate.heal
            return begin

        def disturb(name, function):
            def begin():
                gate.disturb(name, function)
                return gate.heal
            return begin
        self._kinds = (steer, steer, steer, cut, parameters, parameters, mode, stop, self._host.cancel, lambda: self._clear() and None,
                       drop('odom'), drop('tf'), drop('scan'), disturb('odom', jump), disturb('tf', transforms_with('odom', nudge)),
                       disturb('tf', transforms_with('base_link', ahead)))

    def one(self, sleep):
        """Begins one, waits, ends it."""
        self.count += 1
        end = self._random.choice(self._kinds)()
        sleep(self._random.uniform(0.5, 3.0))
        if end:
            end()


def memory_of(pid):
    """Resident [MB]."""
    with open(f'/proc/{pid}/status', encoding='ascii', errors='replace') as status:
        return next(int(line.split()[1]) for line in status if line.startswith('VmRSS')) / 1024.0


def pid_of(node):
    import rosgraph
    return xmlrpc.client.ServerProxy(rosgraph.Master('/soak').lookupNode(node)).getPid('/soak')[2]


def run(options, launched):
    """The minutes; prints them as they pass."""
    import rospy
    from nav_msgs.msg import OccupancyGrid
    from command_watch import PAUSE, CommandWatch
    from message_gate import Gate
    from running_host import RunningHost, Stick
    from .soak_figures import Minute, lateness, lost, quantile, write
    from .waiting import PATIENCE
    rng = random.Random(options.seed)
    rospy.init_node('soak', disable_signals=True)
    gate, stick = Gate(), Stick()
    grid = rospy.wait_for_message('/map', OccupancyGrid, PATIENCE)
    places = Places(grid, rng)
    host = RunningHost(None)
    if not host.wait_until_ready():
        raise RuntimeError('move_base does not come up: ' + launched.complaint())
    watch, pid = CommandWatch(), pid_of('/move_base')
    disturbances = Disturbances(host, gate, stick, rng)
    minutes, goals = [], 0
    begun = rospy.get_time()
    for number in itertools.count(1):
        goals_before, disturbed_before = goals, disturbances.count
        watch.begin()
        next_disturbance = rospy.get_time() + rng.uniform(*QUIET)
        until, since_goal = begun + min(60.0 * number, 3600.0 * options.hours), -math.inf
        while rospy.get_time() < until:
            if not launched.running:
                raise RuntimeError('a node ended: ' + launched.complaint())
            spent = rospy.get_time() - since_goal
            if spent > GOAL_TIME or (not host.has_goal() and spent > 2.0):
                host.send_goal(*places.draw())
                goals, since_goal = goals + 1, rospy.get_time()
            if rospy.get_time() > next_disturbance:
                disturbances.one(rospy.sleep)
                next_disturbance = rospy.get_time() + rng.uniform(*QUIET)
            time.sleep(0.05)
        cycles = watch.cycles()
        stamps = [cycle.header.stamp.to_sec() for cycle in cycles]
        minutes.append(Minute(
            minute=number, memory=round(memory_of(pid), 1), cycles=len(cycles),
            p99=round(1e3 * quantile([cycle.duration for cycle in cycles], 0.99), 2), late=lateness(stamps, watch.period, PAUSE),
            lost=lost([cycle.header.seq for cycle in cycles]), goals=goals - goals_before,
            disturbances=disturbances.count - disturbed_before, abrupt=watch.abrupt_stops(), contacts=host.contacts,
            load=round(os.getloadavg()[0] / (os.cpu_count() or 1), 2), faults=watch.faults()))
        write(minutes, options.out)
        print(' '.join(f'{name}={value}' for name, value in minutes[-1]._asdict().items()), flush=True)
        if until >= begun + 3600.0 * options.hours:
            return minutes


def main(arguments=None):
    """scripts/soak"""
    options = parse(sys.argv[1:] if arguments is None else arguments)
    sys.path.insert(0, os.path.join(ROOT, 'test', 'support'))
    from . import demo
    from .processes import Child, end_on_signals
    from .soak_figures import summary
    end_on_signals()
    os.makedirs(options.out, exist_ok=True)
    with tempfile.TemporaryDirectory(prefix='hidwa_soak_') as logs:
        env = demo.environment(logs)
        port = env['ROS_MASTER_URI'].rsplit(':', 1)[1]
        launched = Child(['roslaunch', '-p', port, LAUNCH, f'people:={options.people}', f'rate:={options.rate}'],
                         os.path.join(options.out, 'soak.log'), env)
        try:
            demo.wait_for_master(launched)
            minutes = run(options, launched)
        except KeyboardInterrupt:
            print('scripts/soak: interrupted', file=sys.stderr)
            return 2
        except Exception as fault:  # whatever it is, the soak did not run to its end
            print(f'scripts/soak: {type(fault).__name__}: {fault}; the log is {options.out}/soak.log', file=sys.stderr)
            return 2
        finally:
            launched.stop()
    whole = summary(minutes)
    for name, value in whole.items():
        print(f'{name}: {value}')
    return 1 if whole['found'] else 0


if __name__ == '__main__':
    sys.exit(main())
