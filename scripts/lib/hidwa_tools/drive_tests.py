# SPDX-License-Identifier: BSD-3-Clause
"""Drives of the simulated robot in its host, as tests: `python3 -m hidwa_tools.drive_tests NAME` starts one and judges its report.

Exit status 0: all that is expected holds; 1: something does not; 77: left out, since real data are not there."""
import collections
import csv
import json
import math
import os
import re
import shutil
import signal
import subprocess
import sys

from .demo import LONGEST_GAP
from .places import DATA, ROOT, SPACE
from .processes import end_on_signals

WORK = os.path.join(SPACE, 'build', 'tests')
LEFT_OUT = 77
RATES = (3.0, 1.5, 0.75)  # [simulated seconds a second]; the next one where the machine did not keep up
CONTROL_RATE = 20.0  # [Hz]
RECORD_RATE = 200e3  # [byte/s], of cycle records: twice what the demo's take, since a machine that keeps up maps more often
PART = ('--start', '18.0,8.0,0.0', '--goal', '33.3,18.7,1.05')  # of the office, past two regions
GDC_GOAL = ('--goal', '-16.65,32.85,1.57')
GDC = ('--start', '-7.05,-12.35,3.14', *GDC_GOAL)


class Absent(Exception):
    """The test is left out; the text names what is absent."""


def run(command, log):
    """Runs a command into WORK/log.log: (exit status, output)."""
    os.makedirs(WORK, exist_ok=True)
    path = os.path.join(WORK, log + '.log')
    with open(path, 'w', encoding='utf-8') as out:
        process = subprocess.Popen(command, cwd=ROOT, stdin=subprocess.DEVNULL, stdout=out, stderr=subprocess.STDOUT,
                                   start_new_session=True)
        try:
            status = process.wait()
        finally:
            if process.poll() is None:  # this test was asked to end
                os.killpg(process.pid, signal.SIGTERM)
                process.wait()
    with open(path, encoding='utf-8', errors='replace') as text:
        return status, text.read()


def judge(expectations, *shown):
    """Whether all of {text: met} hold; says which do not, and then what is to be shown."""
    missed = [text for text, met in expectations.items() if not met]
    for text in missed:
        print(f'not so: {text}')
    if missed:
        print(*shown, sep='\n')
    return not missed


def host():
    """Of what was built: `compat` or `real`."""
    return 'compat' if os.path.isdir(os.path.join(SPACE, 'build', 'move_base')) else 'real'


def demo(name, rate, *arguments):
    """Runs scripts/demo: (exit status, report, output)."""
    folder = os.path.join(WORK, name)
    status, output = run([os.path.join(ROOT, 'scripts', 'demo'), '--no-build', '--rate', f'{rate:g}', '--report', folder,
                          *arguments], name)
    path = os.path.join(folder, 'report.json')
    if not os.path.exists(path):
        print(output)
        sys.exit(f'scripts/demo wrote no report (exit status {status})')
    with open(path, encoding='utf-8') as text:
        return status, json.load(text), output


def hidwa_replay(*arguments, log):
    """(exit status, output) of hidwa_replay."""
    program = os.path.join(SPACE, 'install', 'lib', 'hidwa_local_planner', 'hidwa_replay')
    script = '. "$0"/scripts/env && exec "$@"'
    return run(['bash', '-c', script, ROOT, program, *arguments], log)


Replayed = collections.namedtuple('Replayed', 'status cycles differences bytes output')


def replayed(bag, *arguments, log='replay'):
    """What became of the cycles of a bag."""
    status, output = hidwa_replay(bag, *arguments, log=log)
    last = re.search(r'^(\d+) cycles, (\d+) differences$', output, re.MULTILINE)
    size = re.search(r'^(\d+) bytes of records', output, re.MULTILINE)
    return Replayed(status, int(last[1]) if last else 0, int(last[2]) if last else -1, int(size[1]) if size else math.inf,
                    output)


def drive(name, *arguments, expect):
    """Whether one demo, and each of the expectations on its report, holds, if need be at a rate that the machine keeps up with.
    Nobody walks around unless the arguments say so."""
    for rate in RATES:
        status, report, output = demo(f'drive_{name}', rate, '--people', '0', *arguments)
        if judge_drive(f'drive_{name}', status, report, output, expect):
            return True
        if report['contacts'] or (report['longest_gap_s'] or 0.0) <= LONGEST_GAP:
            return False
    return False


def judge_drive(name, status, report, output, expect):
    """Whether one demo holds what each must, and each of the expectations on its report."""
    repeated = replayed(os.path.join(WORK, name, 'drive.bag'), log=f'{name}_replay')
    return judge({
        'arrives without contact (exit status 0)': status == 0,
        'every recorded cycle is repeated to the bit': repeated.status == 0 and repeated.differences == 0,
        'as many cycles as were driven are repeated': repeated.cycles > 0.9 * CONTROL_RATE * report['duration_s'],
        f'cycle records take {RECORD_RATE / 1000:g} kB/s at most': repeated.bytes < RECORD_RATE * report['duration_s'],
        'the bag shows what the simulator counted': report['simulator'] == {
            key: report[key] for key in ('contacts', 'contacts_moving', 'contacts_at_rest', 'regions_crossed')},
        'host is what was built': report['host'] == host(),
        **{text: check(report) for text, check in expect.items()}}, json.dumps(report), output)


def avoid():
    """Through a part of the office with a person who steers round the regions to avoid."""
    return drive('avoid', *PART, '--operator', 'avoid', expect={
        'no region is crossed': lambda r: r['regions_crossed'] == 0,
        'the person steers': lambda r: r['operator_active_s'] > 1.0})


def drive_in_mode(mode, **more):
    """A part of the office in another mode; the demo's person steers with what it has."""
    return drive(mode, *PART, '--mode', mode, '--operator', 'avoid', expect={
        'no region is crossed': lambda r: r['regions_crossed'] == 0,
        f'the mode is {mode}': lambda r: r['mode'] == mode,
        'the person steers': lambda r: r['operator_active_s'] > 1.0, **more})


def gesture():
    """Through the office with a person whose hand steers, with a clutch."""
    return drive_in_mode('gesture')


def switching():
    """Through the office with a person who takes control and hands it back."""
    return drive_in_mode('switching', **{'the person is in control for a while': lambda r: r['state_s']['MANUAL'] > 1.0})


def people():
    """A part of the office among people who keep away from the robot."""
    return drive('people', *PART, '--people', '6', '--operator', 'avoid', expect={
        'six people are there': lambda r: r['people'] == 6,
        'the robot meets somebody': lambda r: r['closest_person_m'] < 2.0,
        'nobody is touched by the moving robot': lambda r: r['contacts_moving'] == 0})


def none():
    """Through the office with nobody: autonomy cannot see the regions."""
    return drive('none', '--operator', 'none', expect={
        'a region is crossed': lambda r: r['regions_crossed'] >= 1,
        'nobody steers': lambda r: r['operator_active_s'] == 0.0})


def gdc_map():
    path = os.path.join(DATA, 'maps', 'gdc_3', 'map.yaml')
    if not os.path.exists(path):
        raise Absent(f'{path} (HIDWA_DATA names the folder of the real data)')
    return path


def real_map():
    """Half of a real floor, 37 m, autonomy alone."""
    return drive('real_map', '--map', gdc_map(), '--start', '6.45,15.31,1.57', *GDC_GOAL, '--operator', 'none', expect={
        'about as long as planned': lambda r: r['path_length_m'] < 1.05 * r['planned_length_m']})


def steer(side):
    script = os.path.join(ROOT, 'test', 'scripts', f'steer_{side}.yaml')
    return drive(f'steer_{side}', '--map', gdc_map(), *GDC, '--operator', script, expect={
        f'the path goes 0.3 m or more to the {side}': lambda r: r[f'operator_shift_{side}_m'] >= 0.3,
        'the person steers for 3 s': lambda r: 2.8 <= r['operator_active_s'] <= 3.2})


def steer_left():
    """The stick held left for 3 s in a corridor of the real floor."""
    return steer('left')


def steer_right():
    """The stick held right for 3 s there."""
    return steer('right')


def replay():
    """hidwa_replay on the bag of drive_avoid: what if, a cycle explained, a bag cut short, files that are none."""
    bag = os.path.join(WORK, 'drive_avoid', 'drive.bag')
    if not os.path.exists(bag):
        raise Absent(f'{bag}, which drive_avoid writes')
    folder = os.path.join(WORK, 'replay')
    shutil.rmtree(folder, ignore_errors=True)
    os.makedirs(folder)
    whole = replayed(bag)
    same = replayed(bag, '--set', 'odom_topic=elsewhere', '--out', folder)
    other = replayed(bag, '--set', 'PathDist_scale=200', '--out', folder)
    one = replayed(bag, '--at', '30', '--out', folder)
    clock = re.search(r'cycle at (\S+) s \(ROS time (\S+)\)', one.output)
    by_clock = replayed(bag, '--at', 'ros:' + clock.group(2), '--no-picture', '--out', folder) if clock else one
    shown = [line for line in one.output.splitlines() if re.match(r' *\d+ +-?\d+\.\d+ ', line)]
    cut, foreign = os.path.join(folder, 'cut.bag'), os.path.join(folder, 'none.bag')
    with open(bag, 'rb') as file, open(cut, 'wb') as half:
        half.write(file.read(os.path.getsize(bag) * 2 // 3))
    with open(foreign, 'wb') as file:
        file.write(b'no bag at all')
    intact, refused, absent = replayed(cut), replayed(foreign), replayed(os.path.join(folder, 'absent.bag'))
    return judge({
        'nothing changed, nothing differs': whole.status == 0 and whole.differences == 0,
        'a parameter that the core does not read changes nothing': same.status == 0 and same.differences == 0,
        'a weight changes cycles': other.status == 1 and 0 < other.differences < other.cycles,
        'and they are listed': os.path.getsize(os.path.join(folder, 'changes.csv')) > 1000 and 'recorded  ' in other.output,
        'the changes are drawn': os.path.getsize(os.path.join(folder, 'changes.png')) > 10000,
        'every candidate of a cycle is shown': len(shown) > 2400 and 'chosen: #' in one.output,
        'it is that cycle, to the bit': one.status == 0,
        'its ROS time means the same cycle': clock and by_clock.status == 0 and clock.group(0) in by_clock.output,
        'and drawn': os.path.getsize(os.path.join(folder, 'cycle.png')) > 10000,
        'a bag cut short: status 2': intact.status == 2 and 'was cut short' in intact.output,
        'its intact part is repeated': 0.5 * whole.cycles < intact.cycles < whole.cycles and intact.differences == 0,
        'no bag: status 2 and the reason': refused.status == 2 and 'is no bag' in refused.output,
        'no file: status 2 and the reason': absent.status == 2 and 'no such file' in absent.output})


def study():
    """A small study by scripts/study, from an environment that knows nothing of ROS."""
    folder = os.path.join(WORK, 'study')
    shutil.rmtree(folder, ignore_errors=True)
    environment = ['env', '-i', f'HOME={os.environ.get("HOME", "/")}', f'PATH={os.environ["PATH"]}', f'HIDWA_SPACE={SPACE}']
    status, output = run([*environment, os.path.join(ROOT, 'scripts', 'study'), 'run', '--out', folder, '--participants', '2'], 'study')
    if status:
        return judge({'exit status 0': False}, output)
    with open(os.path.join(folder, 'runs.csv'), encoding='utf-8', newline='') as text:
        runs = list(csv.DictReader(text))
    return judge({
        'two people in three conditions': sorted(r['condition'] for r in runs) == ['SG', 'SG', 'SJ', 'SJ', 'SW', 'SW'],
        'SG comes last': all(r['order'] == '3' for r in runs if r['condition'] == 'SG'),
        'SJ and SW are counterbalanced': sorted(r['order'] for r in runs if r['condition'] == 'SJ') == ['1', '2'],
        'no contact in SJ and SG': all(r['contacts'] == '0' for r in runs if r['condition'] != 'SW'),
        'the page is there': os.path.getsize(os.path.join(folder, 'report.html')) > 10000}, output)


def soak():
    """scripts/soak, for a minute: the running host with goals, people, a stick, changes and faults at random."""
    folder = os.path.join(WORK, 'soak')
    status, output = run([os.path.join(ROOT, 'scripts', 'soak'), '--no-build', '--hours', '0.0125', '--out', folder], 'soak')
    return judge({'exit status 0': status == 0}, output)


TESTS = {test.__name__: test for test in (avoid, gesture, switching, people, none, real_map, steer_left, steer_right, replay, study, soak)}


def main(name):
    """The exit status of a test."""
    end_on_signals()
    try:
        return 0 if TESTS[name]() else 1
    except Absent as absent:
        print(f'left out, absent: {absent}')
        return LEFT_OUT


if __name__ == '__main__':
    sys.exit(main(*sys.argv[1:]))
