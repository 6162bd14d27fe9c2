# SPDX-License-Identifier: BSD-3-Clause
"""scripts/demo, once everything is built: launches, drives, records, reports."""
import fcntl
import os
import shlex
import signal
import subprocess
import sys
import tempfile
import time
import xml.etree.ElementTree as xml

import rosgraph
import yaml

from .drive import Drive
from .errors import BagError, DemoError
from .measure import LONGEST_GAP
from .options import parse
from .processes import Child, end_on_signals, free_port
from .recording import recorded_topics
from .report import write_report
from .waiting import PATIENCE

PACKAGE = 'hidwa_local_planner'
RECORDER = 'demo_recorder'
ADDRESS = 'console: '     # before each address in the log
FILES = ('drive.bag', 'drive.bag.active', 'report.json', 'report.png', 'demo.log', 'recorder.log')


def say(text):
    print(f'==> {text}', flush=True)


def package_path(name):
    """Where rospack finds a package."""
    found = subprocess.run(['rospack', 'find', name], capture_output=True, text=True)
    if found.returncode:
        raise DemoError(f'rospack does not find {name}: run scripts/build')
    return found.stdout.strip()


def host_kind():
    """`compat` or `real`, as the move_base in use says of itself."""
    manifest = xml.parse(os.path.join(package_path('move_base'), 'package.xml'))
    return 'compat' if manifest.find('export/compat') is not None else 'real'


def complete(options):
    """Fills in map, regions, start and goal from our office where they are not given."""
    share = package_path(PACKAGE)
    if not options.map:
        options.map = os.path.join(share, 'maps', 'office.yaml')
        options.regions = options.regions or os.path.join(share, 'maps', 'office_regions.yaml')
    places = {}
    if options.regions:
        with open(options.regions, encoding='utf-8') as text:
            places = yaml.safe_load(text) or {}
    options.start = options.start or places.get('start')
    options.goal = options.goal or places.get('goal')
    if not options.start or not options.goal:
        raise DemoError(f'{options.regions} names no start or no goal: give --start and --goal')
    options.map_name = _short(options.map)
    options.operator_name = os.path.basename(options.operator)


def _short(path):
    """maps/gdc_3/map.yaml is known by its folder, office.yaml by itself."""
    name = os.path.splitext(os.path.basename(path))[0]
    return os.path.basename(os.path.dirname(path)) if name == 'map' else name


def launch_arguments(o):
    """Arguments of demo.launch."""
    kind = o.operator if o.operator in ('avoid', 'none', 'joystick', 'page') else 'script'
    x, y, yaw = o.start
    # roslaunch takes an empty value for none given: what is not there is left out.
    arguments = {'map': o.map, 'regions': o.regions or 'none', 'x': x, 'y': y, 'yaw': yaw, 'operator': kind, 'mode': o.mode,
                 'rate': o.rate, 'gui': str(o.gui).lower(), 'record_cycles': 'true', 'base_local_planner': o.planner,
                 'base_global_planner': o.global_planner}
    arguments.update(people=o.people, people_seed=o.people_seed, goal_x=o.goal[0], goal_y=o.goal[1])
    if kind == 'script':
        arguments['script'] = o.operator
    if o.params:
        arguments['extra_params'] = o.params
    if o.console:
        tour = ' '.join(f'--tour={",".join(map(str, pose))}' for pose in (o.goal, o.start))
        recordings = shlex.quote(os.path.join(o.report, 'recordings'))
        arguments['console_options'] = f'{tour} --recordings {recordings} {o.console_options}'
    return [f'{name}:={value}' for name, value in arguments.items()]


def prepare_folder(folder):
    """Makes the folder and removes what an earlier run left there; the lock returned keeps a second run out."""
    os.makedirs(folder, exist_ok=True)
    lock = os.open(folder, os.O_RDONLY)
    try:
        fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except BlockingIOError as fault:
        raise DemoError(f'another demo writes into {folder}: give another --report') from fault
    for name in FILES:
        if os.path.exists(os.path.join(folder, name)):
            os.remove(os.path.join(folder, name))
    return lock


def environment(logs, port=None):
    """Its own master on the port given or one that nothing else uses, ROS's own logs in the folder given."""
    os.environ.update(ROS_MASTER_URI=f'http://localhost:{port or free_port()}', ROS_HOSTNAME='localhost', ROS_LOG_DIR=logs,
                      ROS_HOME=logs, PYTHONUNBUFFERED='1')
    for name in ('ROS_IP', 'ROS_NAMESPACE'):
        os.environ.pop(name, None)
    return dict(os.environ)


def drive(options, env, before=lambda launched: None, after=lambda launched: None):
    """Launches, drives and records; (arrived, text). `before` and `after` are called with the launched nodes running: before
    anything is recorded, and once the recording is finished."""
    folder = options.report
    log = os.path.join(folder, 'demo.log')
    port = env['ROS_MASTER_URI'].rsplit(':', 1)[1]
    say('starting robot, person and move_base')
    file = os.path.join(package_path(PACKAGE), 'launch', 'demo.launch')
    launched = Child(['roslaunch', '-p', port, file, *launch_arguments(options)], log, env)
    recorder = None
    try:
        wait_for_master(launched)
        this = Drive(options, lambda: launched.running and not _could_not_launch(log))
        this.wait_until_ready()
        before(launched)
        this.describe(host_kind())
        topics = recorded_topics(options.global_planner, options.planner)
        recorder = Child(['rosbag', 'record', '--lz4', '--chunksize=128', '-O', os.path.join(folder, 'drive.bag'), *topics,
                          f'__name:={RECORDER}'], os.path.join(folder, 'recorder.log'), env)
        this.wait_for_recorder('/' + RECORDER, topics, recorder)
        say(f'driving to ({options.goal[0]:.2f}, {options.goal[1]:.2f}), operator: {options.operator_name}, mode: {options.mode}')
        result = this.go()
        recorder.stop()
        recorder = None
        after(launched)
        return result
    finally:
        # A second Ctrl-C must not leave anything running.
        patient = signal.signal(signal.SIGINT, signal.SIG_IGN)
        for child in (recorder, launched):
            if child:
                child.stop()
        signal.signal(signal.SIGINT, patient)


def serve(options, env):
    """Launches robot, move_base and the console, says where the page is, and goes on until Ctrl-C."""
    log = os.path.join(options.report, 'demo.log')
    port = env['ROS_MASTER_URI'].rsplit(':', 1)[1]
    say('starting robot, move_base and console')
    file = os.path.join(package_path(PACKAGE), 'launch', 'demo.launch')
    launched = Child(['roslaunch', '-p', port, file, *launch_arguments(options)], log, env)
    try:
        wait_for_master(launched)
        tell_address(log, launched)
        say(f'the robot drives to and fro until Ctrl-C; ROS_MASTER_URI={env["ROS_MASTER_URI"]}')
        while launched.running:
            time.sleep(0.2)
        raise DemoError(f'a node ended: {launched.complaint()}')
    finally:
        patient = signal.signal(signal.SIGINT, signal.SIG_IGN)
        launched.stop()
        signal.signal(signal.SIGINT, patient)


def tell_address(log, launched):
    """Waits for the console, and says where its page is."""
    deadline = time.monotonic() + PATIENCE
    while not _lines(log, ADDRESS):
        if not launched.running or _could_not_launch(log) or _lines(log, 'FATAL'):
            raise DemoError(f'the console did not start: {launched.complaint()}')
        if time.monotonic() > deadline:
            raise DemoError(f'the console has not started after {PATIENCE:.0f} s: {launched.complaint()}')
        time.sleep(0.1)
    for line in _lines(log, ADDRESS):
        say(f'open {line[line.index(ADDRESS) + len(ADDRESS):].strip()}')


def _lines(log, text):
    """Lines of the log that hold a text."""
    if not os.path.exists(log):
        return []
    with open(log, encoding='utf-8', errors='replace') as lines:
        return [line for line in lines if text in line]


def _could_not_launch(log):
    """roslaunch goes on without a node that it cannot find."""
    with open(log, encoding='utf-8', errors='replace') as text:
        return 'cannot launch node' in text.read()


def wait_for_master(launched, patience=PATIENCE):
    """Until the launched master holds the launch file's parameters, at most `patience` [s]."""
    deadline = time.monotonic() + patience
    while not rosgraph.is_master_online() or not rosgraph.Master('/demo').hasParam('/use_sim_time'):
        if not launched.running:
            raise DemoError(f'roslaunch ended before anything ran: {launched.complaint()}')
        if time.monotonic() > deadline:
            raise DemoError(f'roslaunch has not started the nodes after {patience:.0f} s: {launched.complaint()}; if it says '
                            'nothing of a fault, the machine is too busy')
        time.sleep(0.1)


def show_log(folder):
    """The last lines of the nodes' log, errors first."""
    path = os.path.join(folder, 'demo.log')
    if not os.path.exists(path):
        return
    with open(path, encoding='utf-8', errors='replace') as text:
        lines = text.read().splitlines()
    errors = [line for line in lines if 'FATAL' in line or 'ERROR' in line or 'RLException' in line]
    print('\n'.join(['---- ' + path, *errors[:8], '...', *lines[-15:], '----']), file=sys.stderr)


def _summary(report, folder):
    r = report
    say(f"{'arrived' if r['arrived'] else 'did NOT arrive (' + r['outcome'] + ')'}: {r['path_length_m']:.1f} m in "
        f"{r['duration_s']:.1f} s, contacts {r['contacts']}, regions crossed {r['regions_crossed']} of {r['regions']}, "
        f"steered {r['operator_active_s']:.1f} s; host {r['host']}")
    if r['people']:
        say(f"{r['people']} people: {r['contacts_moving']} touched while the robot moved, {r['contacts_at_rest']} while it stood; "
            f"closest {r['closest_person_m']:.2f} m, {r['personal_space_s']:.1f} s within 0.5 m of somebody")
    if (r['longest_gap_s'] or 0.0) > LONGEST_GAP:
        say(f"this machine does not keep up with --rate {r['rate']:g}: {r['longest_gap_s']:.2f} s of simulated time passed "
            'between two commands; take a lower one')
    say(f"{folder}/report.json, report.png, drive.bag")


def run(options):
    """The exit status."""
    complete(options)
    lock = prepare_folder(options.report)
    try:
        with tempfile.TemporaryDirectory(prefix='hidwa_demo_') as logs:
            if options.console:
                serve(options, environment(logs))
            arrived, text = drive(options, environment(logs))
        if not arrived:
            say(f'the goal was not reached: {text}')
            show_log(options.report)
        say('writing the report')
        report = write_report(os.path.join(options.report, 'drive.bag'), options.report)
        _summary(report, options.report)
        counted = report['simulator'].get('contacts', 0)
        if counted != report['contacts']:
            say(f"the simulator counted {counted} contacts, the bag shows {report['contacts']}")
        return 0 if report['arrived'] and report['contacts'] == 0 and counted == 0 and not report['contacts_moving'] else 1
    finally:
        os.close(lock)


def main(arguments=None):
    """scripts/demo"""
    options = parse(sys.argv[1:] if arguments is None else arguments)
    end_on_signals()
    try:
        return run(options)
    except KeyboardInterrupt:
        if options.console:
            print()
            say('ended; recordings, if any, are in ' + os.path.join(options.report, 'recordings'))
            return 0
        print('\nscripts/demo: interrupted; all programs that it started have ended', file=sys.stderr)
        return 130
    except (DemoError, BagError) as fault:
        print(f'\nscripts/demo: {fault}', file=sys.stderr)
    show_log(options.report)
    return 2


if __name__ == '__main__':
    sys.exit(main())
