# SPDX-License-Identifier: BSD-3-Clause
"""scripts/study live: one drive of one participant in one condition, recorded under its own name."""
import argparse
import contextlib
import json
import os
import shlex
import shutil
import sys
import tempfile
import time
import xml.etree.ElementTree as xml

import yaml

from . import demo, options as demo_options
from .conditions import MODES, course, driven, next_of, parameters_of, run_name
from .errors import BagError, DemoError
from .exchange import read, write
from .processes import Child, end_on_signals
from .questionnaires import AnswersError, add_answers, refuse_second_answers
from .waiting import PATIENCE

NEEDED_ARGUMENTS = ('mode', 'extra_params', 'record')
LAST_WORDS = 2.0        # [s] in which the page shows its last text


def parser():
    """The argument parser."""
    p = argparse.ArgumentParser(
        prog='scripts/study live', formatter_class=argparse.RawDescriptionHelpFormatter,
        description='One drive of one person in one condition of the study: SJ (stick), SG (hand) or SW (button and stick).\n'
        'Starts the simulated robot, or yours with --robot, asks before anything drives, and records OUT/pNN_oK_CONDITION.bag:\n'
        'participant, place in their order, condition. scripts/study analyse OUT makes tables and tests of them.',
        epilog='further arguments: of scripts/demo (--map, --goal, --rate, --operator avoid to try it without a person), or with\n'
        '--robot the launch file\'s, NAME:=VALUE\nexit status: 0 driven and recorded; 1 not wanted; 2 refused or impossible; '
        '130 interrupted (the bag stays in its folder and does not count)')
    p.add_argument('--participant', type=int, required=True, metavar='N', help='from 1; odd ones begin with SJ, even ones with SW')
    p.add_argument('--condition', choices=sorted(MODES), required=True)
    p.add_argument('--out', required=True, metavar='DIR', help='where the study gathers')
    p.add_argument('--robot', nargs='?', const='', metavar='FILE.launch',
                   help='a real robot whose driver and localisation run already: by robot.launch, or a file of yours that takes '
                   'mode, extra_params and record as that does')
    p.add_argument('--goal', type=demo_options.pose, metavar='X,Y,YAW',
                   help='where to, in the map; with --robot and without it, give the goal in rviz')
    p.add_argument('--device', default='', metavar='NAME', help="the person's device: a file of launch/params/devices")
    p.add_argument('--params', metavar='FILE.yaml', type=demo_options.existing, help='more parameters, {HIDWAPlannerROS: {...}}')
    p.add_argument('--guard', choices=('none', 'nearest'), default='none',
                   help="in SW: the person's own velocity, even into an obstacle (the paper's), or the nearest legal one")
    p.add_argument('--console', action='store_true',
                   help="the participant sits at the console's page: consent, drive and questionnaire there; its answers go to "
                   'OUT/questionnaires.csv. With the simulated robot only; docs/use/console.md')
    p.add_argument('--console-options', default='', metavar='"..."', help="further options of the console's node")
    p.add_argument('--port', type=int, metavar='N', help="the simulation's ROS master, for a device's own node (default: any free one)")
    p.add_argument('--yes', action='store_true', help='do not ask; a condition out of its order is refused all the same')
    return p


def parse(arguments):
    """(options, further arguments)"""
    p = parser()
    o, further = p.parse_known_args(demo_options.join_poses(arguments))
    if o.robot and ':=' in o.robot:  # "--robot map:=floor.yaml": robot.launch, with an argument of its
        o.robot, further = '', [o.robot, *further]
    if o.console and o.robot is not None:
        p.error('--console is for the simulated robot')
    if o.participant < 1:
        p.error('--participant counts from 1')
    for word in further:
        if word.split('=')[0] in ('--mode', '--report', '--no-build'):
            p.error(f'{word.split("=")[0]} is what the condition and --out say')
        if o.robot is not None and ':=' not in word:
            p.error(f"'{word}' is no argument of a launch file (NAME:=VALUE)")
        if o.robot is not None and word.split(':=')[0] in NEEDED_ARGUMENTS:
            p.error(f'{word.split(":=")[0]} is what the condition, --params and --out say')
    o.out = os.path.abspath(o.out)
    return o, further


def ask(question):
    """Whether the answer is yes; no answer is no."""
    try:
        return input(f'{question} [y/N] ').strip().lower() in ('y', 'yes')
    except EOFError:
        print()
        return False


def admit(o):
    """The drive's place in the participant's order, or None where the asked one says no. DemoError where it is refused."""
    there = [path for who, _, condition, path in driven(o.out) if (who, condition) == (o.participant, o.condition)]
    if there:
        raise DemoError(f'participant {o.participant} has driven {o.condition} already, {there[0]}: it is never overwritten; move '
                        'it away to repeat the drive')
    if o.console:
        try:
            refuse_second_answers(o.out, o.participant, o.condition)
        except AnswersError as fault:
            raise DemoError(str(fault)) from fault
    place, due = next_of(o.out, o.participant)
    if o.condition != due:
        story = (f'participant {o.participant} is to drive {", ".join(course(o.participant))} in this order, and {due} is next, '
                 f'not {o.condition}')
        if o.yes:
            raise DemoError(f'{story}; without --yes you are asked')
        if not ask(f'{story}. Drive {o.condition} all the same, as drive {place}?'):
            return None
    robot = 'the simulated robot' if o.robot is None else f'your robot ({o.robot or "robot.launch"})'
    print(f'participant {o.participant}, drive {place} of 3: {o.condition}, mode {MODES[o.condition]}, {robot}', flush=True)
    if o.condition == 'SW' and o.guard == 'none':
        print('SW with guard none, as in the paper: nothing keeps the person from driving into things while in control '
              '(--guard nearest would).', flush=True)
    return place if o.yes or ask('Start?') else None


def merged_parameters(o, package):
    """{HIDWAPlannerROS: {...}, ...}: the device's, then --params, then the condition's."""
    result = {}
    files = [os.path.join(package, 'launch', 'params', 'devices', o.device + '.yaml')] if o.device else []
    for path in files + ([o.params] if o.params else []):
        if not os.path.isfile(path):
            names = sorted(name[:-5] for name in os.listdir(os.path.dirname(path)))
            raise DemoError(f"there is no device '{o.device}'; there are {', '.join(names)}")
        with open(path, encoding='utf-8') as text:
            for name, value in (yaml.safe_load(text) or {}).items():
                result[name] = {**result.get(name, {}), **value} if isinstance(value, dict) else value
    result['HIDWAPlannerROS'] = {**result.get('HIDWAPlannerROS', {}), **parameters_of(o.condition, o.guard)}
    return result


def attempt_folder(o, name):
    """A new folder for logs, report and the unfinished bag of one attempt."""
    os.makedirs(o.out, exist_ok=True)
    number = 1
    while True:
        path = os.path.join(o.out, f'{name}_attempt{number}')
        try:
            os.mkdir(path)
            return path
        except FileExistsError:
            number += 1


def keep(bag, path):
    """Gives a finished bag its name; never over another."""
    try:
        os.link(bag, path)
        os.remove(bag)
    except FileExistsError as fault:
        raise DemoError(f'{path} exists and is not overwritten; the new one stays {bag}') from fault
    except OSError:  # a file system without hard links
        if os.path.exists(path):
            raise DemoError(f'{path} exists and is not overwritten; the new one stays {bag}') from None
        shutil.move(bag, path)


def simulate(o, further, folder, params):
    """Drives the demo's robot into folder/drive.bag; what the host said."""
    arguments = [*further, '--mode', MODES[o.condition], '--report', folder, '--params', params]
    if o.console:
        write(os.path.join(folder, 'session.json'), session_of(o))
        study = f'--study {shlex.quote(folder)} {o.console_options}'
        arguments += ['--console', f'--console-options={study}']
    elif not any(word.split('=')[0] == '--operator' for word in further):
        arguments += ['--operator', 'joystick']
    if o.goal:
        arguments += ['--goal', ','.join(map(str, o.goal))]
    options = demo_options.parse(arguments)
    demo.complete(options)
    lock = demo.prepare_folder(folder)
    try:
        with tempfile.TemporaryDirectory(prefix='hidwa_study_') as logs:
            environment = demo.environment(logs, o.port)
            print(f'ROS_MASTER_URI={environment["ROS_MASTER_URI"]}', flush=True)
            if o.console:
                return demo.drive(options, environment, lambda launched: _wait_for_start(folder, launched),
                                  lambda launched: _wait_for_answers(folder, launched))[1]
            return demo.drive(options, environment)[1]
    finally:
        os.close(lock)


class NotWanted(Exception):
    """The participant does not agree: nothing is stored."""


def session_of(o):
    """What the page knows of the participant."""
    return {'participant': o.participant, 'condition': o.condition, 'place': next_of(o.out, o.participant)[0]}


def _wait_for_start(folder, launched):
    """Until the participant agreed and began. NotWanted where they do not agree."""
    demo.tell_address(os.path.join(folder, 'demo.log'), launched)
    print('==> waiting for the participant, in the page', flush=True)
    answers = os.path.join(folder, 'answers.json')
    _wait(lambda: read(answers).get('start') or read(answers).get('consent') is False, launched, None, 'the participant')
    if read(answers).get('consent') is False:
        time.sleep(LAST_WORDS)
        raise NotWanted


def _wait_for_answers(folder, launched):
    """The drive is over: the page asks, until every question is answered."""
    path = os.path.join(folder, 'session.json')
    write(path, {**read(path), 'driven': True})
    print('==> the drive is over; waiting for the answers, in the page', flush=True)
    _wait(lambda: 'ratings' in read(os.path.join(folder, 'answers.json')), launched, None, 'the answers')
    time.sleep(LAST_WORDS)


def robot_command(o, further, folder, params):
    """roslaunch's command line. DemoError where the file does not take what is needed."""
    file = o.robot or os.path.join(demo.package_path(demo.PACKAGE), 'launch', 'robot.launch')
    try:
        takes = {argument.get('name') for argument in xml.parse(file).getroot().iter('arg')}
    except (OSError, xml.ParseError) as fault:
        raise DemoError(f'{file} cannot be read: {fault}') from fault
    missing = [name for name in NEEDED_ARGUMENTS if name not in takes]
    if missing:
        raise DemoError(f'{file} takes no argument {", ".join(missing)}: pass them on to move_base.launch, as robot.launch does')
    return ['roslaunch', os.path.abspath(file), f'mode:={MODES[o.condition]}', f'extra_params:={params}',
            f'record:={os.path.join(folder, "drive.bag")}', *further]


def drive_robot(o, further, folder, params):
    """Drives the user's robot until its goal's result, into folder/drive.bag; what the host said."""
    import rosgraph
    import rospy
    from actionlib_msgs.msg import GoalID, GoalStatus
    from move_base_msgs.msg import MoveBaseActionGoal, MoveBaseActionResult
    from .drive import Latest, goal_message, unconnected
    command = robot_command(o, further, folder, params)
    if not rosgraph.is_master_online():
        raise DemoError(f'no ROS master at {os.environ.get("ROS_MASTER_URI", "")}: start the robot\'s driver and localisation first')
    rospy.init_node('study_live', disable_signals=True, anonymous=True)
    goals, results = rospy.resolve_name('move_base/goal'), Latest('move_base/result', MoveBaseActionResult)
    cancel = rospy.Publisher('move_base/cancel', GoalID, queue_size=1)
    launched = Child(command, os.path.join(folder, 'demo.log'), dict(os.environ))
    try:
        publisher = rospy.Publisher(goals, MoveBaseActionGoal, queue_size=1)
        master = rosgraph.Master('/study_live')

        def ready():
            listeners = dict(master.getSystemState()[1]).get(goals, [])
            recorders = [name for name in listeners if name.endswith('record_drive_bag')]
            return len(listeners) > 1 and recorders and not unconnected(recorders[0], [goals])
        _wait(ready, launched, PATIENCE, 'move_base and the recorder')
        mode = rospy.get_param(rospy.resolve_name('move_base/HIDWAPlannerROS/mode'), None)
        if mode != MODES[o.condition]:
            raise DemoError(f'the planner is in mode {mode}, not {MODES[o.condition]}: does the launch file pass on mode and '
                            'extra_params?')
        if o.goal:
            publisher.publish(goal_message(o.goal, 'study'))
        else:
            print('==> waiting for a goal, from rviz for one', flush=True)
        _wait(lambda: results.message, launched, None, 'the end of the drive')
        time.sleep(1.0)  # the last messages' way into the bag
        status = results.message.status
        return status.text or ('reached' if status.status == GoalStatus.SUCCEEDED else f'status {status.status}')
    finally:
        if not results.message:  # interrupted: the robot comes to rest before its host goes
            cancel.publish(GoalID())
            time.sleep(1.0)
        launched.stop(60.0)


def _wait(condition, launched, patience, what):
    deadline = time.monotonic() + (patience or float('inf'))
    while not condition():
        if not launched.running:
            raise DemoError('the launch ended; its log says why')
        if time.monotonic() > deadline:
            raise DemoError(f'after {patience:.0f} s still waiting for {what}')
        time.sleep(0.1)


def run(o, further):
    """The exit status."""
    place = admit(o)
    if place is None:
        print('not driven')
        return 1
    name = run_name(o.participant, place, o.condition)
    parameters = merged_parameters(o, demo.package_path(demo.PACKAGE))
    folder = attempt_folder(o, name)
    params = os.path.join(folder, 'parameters.yaml')
    with open(params, 'w', encoding='utf-8') as out:
        yaml.safe_dump(parameters, out)
    try:
        said = (simulate if o.robot is None else drive_robot)(o, further, folder, params)
    except DemoError:
        demo.show_log(folder)
        raise
    except NotWanted:
        shutil.rmtree(folder)
        print('not driven: the participant does not agree; nothing was stored')
        return 1
    except KeyboardInterrupt:
        print(f'\n==> interrupted: the drive does not count; what there is of it stays in {folder}', file=sys.stderr)
        return 130
    path = os.path.join(o.out, name + '.bag')
    keep(os.path.join(folder, 'drive.bag'), path)
    if o.console:
        try:
            add_answers(o.out, o.participant, o.condition, read(os.path.join(folder, 'answers.json'))['ratings'])
        except AnswersError as fault:
            raise DemoError(f'the answers stay in {folder}/answers.json: {fault}') from fault
    print(f'==> {said or "driven"}; {path}', flush=True)
    with contextlib.suppress(BagError):
        from .report import write_report
        figures = write_report(path, folder)
        print(json.dumps({key: figures.get(key) for key in ('arrived', 'outcome', 'duration_s', 'path_length_m', 'contacts',
                                                            'regions_crossed', 'operator_active_s')}))
    return 0


def main(arguments=None):
    """scripts/study live"""
    o, further = parse(sys.argv[1:] if arguments is None else arguments)
    end_on_signals()
    try:
        return run(o, further)
    except KeyboardInterrupt:
        print('\nscripts/study live: interrupted', file=sys.stderr)
        return 130
    except DemoError as fault:
        print(f'scripts/study live: {fault}', file=sys.stderr)
        return 2


if __name__ == '__main__':
    sys.exit(main())
