# SPDX-License-Identifier: BSD-3-Clause
"""scripts/test, once everything needed is installed: builds, runs every suite, counts."""
import argparse
import collections
import contextlib
import csv
import glob
import io
import json
import math
import os
import re
import resource
import shutil
import signal
import subprocess
import sys
import time

from . import compilers, coverage as coverage_of, fuzz, sanitize
from .counting import Counts, count_ctest, count_unittest
from .lint import lint as run_tools
from .measure import LONGEST_GAP
from .places import ROOT, SPACE
from .processes import Child, end_on_signals, sourced
from .side_by_side import side_by_side

DATA = os.path.abspath(os.environ.get('HIDWA_DATA', os.path.join(ROOT, '..', 'shared', 'data')))
WORK = os.path.join(SPACE, 'build', 'tests')  # what the tests build and write
JOBS = str(os.cpu_count() or 1)
LIMIT = 1200.0        # [s], of one command
LONG_LIMIT = 6 * 3600.0  # [s], of one command of a long form, which says so to the suites that it starts:
LIMIT_NAME = 'HIDWA_COMMAND_LIMIT'
FUZZ_SECONDS = 5      # [s], of each target in the short form
FASTEST = 3.0         # simulated seconds a second, of the drives
CONTROL_RATE = 20.0   # [Hz], of the drives
RECORD_RATE = 100e3   # [byte/s], of cycle records
PEOPLE_RATE = 200e3   # [byte/s], where people walk: with them, what their points are, and the cells that change
COMPAT = ('nav_core', 'costmap_2d', 'map_server', 'move_base')
GDC = ('--start', '-7.05,-12.35,3.14', '--goal', '-16.65,32.85,1.57')


class Failed(Exception):
    """A suite could not run; the text says why and ends with the log's tail."""


class Absent(Exception):
    """A suite is skipped; the text names what is absent."""


def run(command, log, cwd=ROOT, check=True):
    """Runs a command into WORK/log.log and returns (exit status, output). What it started ends with it."""
    limit = float(os.environ.get(LIMIT_NAME, LIMIT))
    os.makedirs(WORK, exist_ok=True)
    path = os.path.join(WORK, log + '.log')
    with open(path, 'w', encoding='utf-8') as out:
        process = subprocess.Popen(command, cwd=cwd, stdin=subprocess.DEVNULL, stdout=out, stderr=subprocess.STDOUT,
                                   start_new_session=True)
        try:
            status = process.wait(limit)
        except subprocess.TimeoutExpired:
            status = f'none after {limit:.0f} s'
        finally:
            if process.poll() is None:
                os.killpg(process.pid, signal.SIGTERM)
                process.wait(60.0)
    with open(path, encoding='utf-8', errors='replace') as text:
        output = text.read()
    if check and status != 0:
        raise Failed(f'{" ".join(command[:3])} ...: exit status {status}\n{tail(output)}')
    return status, output


def tail(output, lines=40):
    return '\n'.join('    | ' + line for line in output.splitlines()[-lines:])


def in_install(*command):
    return sourced(os.path.join(ROOT, 'scripts', 'env'), *command)


def ctest(folder, log, wrap=lambda *command: list(command), jobs=JOBS, which=()):
    """Runs ctest in a build folder and counts; `which`: options that choose the tests."""
    _, listing = run(wrap('ctest', '--show-only=json-v1', *which), log + '_list', cwd=folder)
    since = time.time() - 1.0
    _, output = run(wrap('ctest', '-j', jobs, '--output-on-failure', *which), log, cwd=folder, check=False)
    counts = count_ctest(output, listing[listing.index('{'):], since)
    if counts.failed:
        print(tail(output, 80))
    return counts


def werror():
    """Whether warnings are errors, ON or OFF, as scripts/build has it."""
    script = '. "$0"/scripts/lib/common.sh && hidwa_werror'
    return subprocess.run(['bash', '-c', script, ROOT], check=True, stdout=subprocess.PIPE, text=True).stdout.strip()


def host_packages():
    """Those of the host's packages that come from compat/ in this build."""
    return [name for name in COMPAT if os.path.isdir(os.path.join(SPACE, 'build', name))]


def plain():
    """Core, critics, operator and simulation by plain CMake, without ROS."""
    folder = os.path.join(WORK, 'plain')
    # The list of test folders anew: a build folder of an older version remembers that version's.
    run(['cmake', '-S', ROOT, '-B', folder, '-UHIDWA_TEST_SUITES', '-DHIDWA_ROS=OFF', '-DHIDWA_TESTS=ON',
         '-DHIDWA_BENCHMARKS=ON', f'-DHIDWA_WERROR={werror()}', '-DHIDWA_UNITY=ON', '-DCMAKE_BUILD_TYPE=Release'], 'plain_configure')
    run(['cmake', '--build', folder, '-j', JOBS], 'plain_build')
    return ctest(folder, 'plain')


def ctest_sanitized(name, options, which):
    """The tests that need no ROS, from a build folder of that name made with these options of CMake."""
    folder = os.path.join(WORK, name)
    run(['cmake', '-S', ROOT, '-B', folder, '-UHIDWA_TEST_SUITES', '-DHIDWA_ROS=OFF', '-DHIDWA_TESTS=ON', '-DHIDWA_UNITY=ON',
         *options], f'{name}_configure')
    run(['cmake', '--build', folder, '-j', JOBS], f'{name}_build')
    os.environ.update(sanitize.environment(ROOT))
    return ctest(folder, name, which=which)


@contextlib.contextmanager
def without_long_cases():
    """Programs of GoogleTest leave out the cases that do one thing for long."""
    os.environ['GTEST_FILTER'] = '-' + ':'.join(LONG_CASES)
    try:
        yield
    finally:
        del os.environ['GTEST_FILTER']


def sanitized():
    """The unit tests under address and undefined-behaviour sanitizer; seconds of each fuzz target."""
    if not compilers.fuzzes(compilers.clang()):
        print(f'    no Clang with libFuzzer: by GCC, and the fuzz targets only repeat their corpus ({compilers.REMEDY})')
        options = sanitize.cmake_options('g++', sanitize.ADDRESS)
        return ctest_sanitized('sanitized', [*options, *sanitize.SHORT_BUILD], sanitize.ctest_options())
    with without_long_cases():
        counts = ctest_sanitized('sanitized', [*fuzz.configure_options(), *sanitize.SHORT_BUILD], sanitize.ctest_options())
    well, found = fuzz.run([os.path.join(WORK, 'sanitized')], FUZZ_SECONDS, 1)
    return counts + Counts(passed=len(well), failed=len(found))


def build():
    """The colcon build of everything; tests that need no ROS are not built twice."""
    run([os.path.join(ROOT, 'scripts', 'build'), '--tests', '-DHIDWA_TEST_SUITES=unit/ros;fuzz/ros'], 'build')
    return Counts(passed=1)


def package():
    """The tests of the plugin's parts, which need ROS to build."""
    return ctest(os.path.join(SPACE, 'build', 'hidwa_local_planner'), 'package', in_install)


def compat():
    """The tests of compat/."""
    names = host_packages()
    if not names:
        raise Absent('compat/ is not in use: the real navigation stack was found')
    counts = Counts()
    for name in names:
        if os.path.isdir(os.path.join(ROOT, 'compat', name, 'test')):
            counts += ctest(os.path.join(SPACE, 'build', name), f'compat_{name}', in_install, jobs='1')
    return counts


def ros():
    """rostests of what was installed, and the packages they need."""
    folder = os.path.join(WORK, 'ros')
    os.makedirs(folder, exist_ok=True)
    paths = [os.path.dirname(path) for path in sorted(glob.glob(os.path.join(ROOT, 'test', 'ros', '*', 'package.xml')))]
    # C++14, the default of GCC 9: a package with critics is lifted from it by this one.
    run(in_install('colcon', 'build', '--merge-install', '--executor', 'sequential', '--base-paths', *paths, '--cmake-args',
                   '-DCMAKE_CXX_FLAGS=-std=gnu++14', f'-DHIDWA_WERROR={werror()}', '-DCMAKE_BUILD_TYPE=Release',
                   '-DPYTHON_EXECUTABLE=/usr/bin/python3', '-DPython3_EXECUTABLE=/usr/bin/python3', '--no-warn-unused-cli'),
        'ros_build', cwd=folder)
    counts = Counts()
    setup = os.path.join(folder, 'install', 'setup.bash')
    for path in sorted(glob.glob(os.path.join(folder, 'build', '*', 'CTestTestfile.cmake'))):
        place = os.path.dirname(path)
        name = os.path.basename(place)
        run(sourced(setup, 'cmake', '--build', place, '--target', 'tests', '-j', JOBS), f'ros_{name}_build')
        _, listing = run(['ctest', '--show-only=json-v1'], f'ros_{name}_list', cwd=place)
        if json.loads(listing)['tests']:
            counts += ctest(place, f'ros_{name}', lambda *command: sourced(setup, *command))
    return counts if counts.total else Counts(failed=1)


def contract():
    """How the host calls a local planner, against what the real move_base was seen to do."""
    setup = os.path.join(WORK, 'ros', 'install', 'setup.bash')
    run(sourced(setup, '/usr/bin/python3', os.path.join(ROOT, 'test', 'ros', 'probe', 'run_probe'), '--log',
                os.path.join(WORK, 'contract.txt')), 'contract')
    return Counts(passed=1)


def python():
    """The scripts' own tests."""
    return unittests('scripts', 'python')


def console():
    """The operator's console beside the planner: its parts, and a page without a browser."""
    return unittests('console', 'console')


def browser():
    """The operator's page in a headless Chromium, against the running robot; what cannot run here counts as failed."""
    missing = [name for name in ('chromium', 'chromedriver') if not (shutil.which(name) or shutil.which(name + '-browser'))]
    if missing:
        raise Failed(f'{" and ".join(missing)} missing: apt-get install chromium chromium-driver python3-selenium (scripts/test does)')
    return unittests(os.path.join('console', 'browser'), 'browser')


def unittests(folder, log):
    """Python's unit tests in a folder of test/, counted."""
    _, output = run(in_install('/usr/bin/python3', '-W', 'ignore::ResourceWarning', '-m', 'unittest', 'discover', '-s',
                               os.path.join(ROOT, 'test', folder)), log, check=False)
    counts = count_unittest(output)
    if counts.failed:
        print(tail(output, 80))
    return counts


def robot():
    """Plugin and tracker alone, as a robot builds them: they link neither the simulation nor rosbag nor yaml-cpp."""
    folder = os.path.join(WORK, 'robot')
    os.makedirs(folder, exist_ok=True)
    run(in_install('colcon', 'build', '--merge-install', '--executor', 'sequential', '--base-paths', ROOT, '--packages-select',
                   'hidwa_local_planner', '--cmake-args', '-DHIDWA_TOOLS=OFF', '-DHIDWA_TESTS=OFF', '-DHIDWA_UNITY=ON',
                   f'-DHIDWA_WERROR={werror()}', '-DCMAKE_BUILD_TYPE=Release', '-DPYTHON_EXECUTABLE=/usr/bin/python3',
                   '-DPython3_EXECUTABLE=/usr/bin/python3'), 'robot_build', cwd=folder)
    place = os.path.join(folder, 'install', 'lib')
    library = os.path.join(place, 'libhidwa_local_planner.so')
    _, linked = run(sourced(os.path.join(folder, 'install', 'setup.bash'), 'ldd', library), 'robot_links')
    # The host's own libraries may link what they like.
    _, needed = run(['readelf', '-d', *sorted(glob.glob(os.path.join(place, 'libhidwa_*.so'))),
                     os.path.join(place, 'hidwa_local_planner', 'hidwa_tracker')], 'robot_needs')
    unwanted = [line.strip() for line in linked.splitlines() if 'not found' in line] + [
        line.strip() for line in needed.splitlines()
        if 'NEEDED' in line and any(name in line for name in ('hidwa_sim', 'rosbag', 'yaml-cpp'))]
    if unwanted:
        raise Failed('the plugin links\n' + '\n'.join(unwanted))
    _, own = run(['nm', '-DC', library], 'robot_symbols')
    if 'hidwa_local_planner::sim::' in own:
        raise Failed('libhidwa_local_planner.so holds parts of the simulation')
    programs = os.path.join(folder, 'install', 'lib', 'hidwa_local_planner')
    tracker = os.path.join(programs, 'hidwa_tracker')  # it runs on the robot
    if not os.access(tracker, os.X_OK):
        raise Failed('HIDWA_TOOLS=OFF installs no hidwa_tracker')
    tools = [path for path in glob.glob(os.path.join(programs, 'hidwa_*')) if path != tracker]
    if tools:
        raise Failed(f'HIDWA_TOOLS=OFF installs {", ".join(tools)}')
    return Counts(passed=3)


def lint():
    """The tools that hold the style, as scripts/lint."""
    with contextlib.redirect_stdout(io.StringIO()) as said:
        well, found, absent = run_tools()
    os.makedirs(WORK, exist_ok=True)
    with open(os.path.join(WORK, 'lint.log'), 'w', encoding='utf-8') as log:
        log.write(said.getvalue())
    if found:
        print(tail(said.getvalue(), 80))
    return Counts(passed=len(well), failed=len(found), skipped=len(absent))


def demo(name, rate, *arguments):
    """Runs scripts/demo: (exit status, report, output)."""
    folder = os.path.join(WORK, name)
    status, output = run([os.path.join(ROOT, 'scripts', 'demo'), '--no-build', '--rate', f'{rate:g}', '--report', folder,
                          *arguments], name, check=False)
    try:
        with open(os.path.join(folder, 'report.json'), encoding='utf-8') as text:
            return status, json.load(text), output
    except OSError as fault:
        raise Failed(f'scripts/demo wrote no report (exit status {status})\n{tail(output)}') from fault


def hidwa_replay(*arguments, log):
    """(exit status, output) of hidwa_replay."""
    program = os.path.join(SPACE, 'install', 'lib', 'hidwa_local_planner', 'hidwa_replay')
    script = '. "$0"/scripts/env && exec "$@"'
    return run(['bash', '-c', script, ROOT, program, *arguments], log, check=False)


Replayed = collections.namedtuple('Replayed', 'status cycles differences bytes output')


def replayed(bag, *arguments, log='replay'):
    """What became of the cycles of a bag."""
    status, output = hidwa_replay(bag, *arguments, log=log)
    last = re.search(r'^(\d+) cycles, (\d+) differences$', output, re.MULTILINE)
    size = re.search(r'^(\d+) bytes of records', output, re.MULTILINE)
    return Replayed(status, int(last[1]) if last else 0, int(last[2]) if last else -1, int(size[1]) if size else math.inf,
                    output)


def drive(name, *arguments, expect, record_rate=RECORD_RATE):
    """One demo; each of the expectations on its report is a test, and so are arrival and the simulator's own counts.

    Nobody walks around unless the arguments say so. A machine that does not keep up with the simulated clock
    shows nothing of the planner: then slower, down to real time.
    """
    rate, arguments = FASTEST, ('--people', '0', *arguments)
    status, report, output = demo(name, rate, *arguments)
    while rate > 1.0 and (report['longest_gap_s'] or 0.0) > LONGEST_GAP:
        print(f"    rate {rate:g}: {report['longest_gap_s']:.2f} s of simulated time between two commands; again, slower")
        rate = max(1.0, 0.5 * rate)
        status, report, output = demo(name, rate, *arguments)
    replay = replayed(os.path.join(WORK, name, 'drive.bag'), log=f'{name}_replay')
    expectations = {
        'arrives without contact (exit status 0)': status == 0,
        'every recorded cycle is repeated to the bit': replay.status == 0 and replay.differences == 0,
        'as many cycles as were driven are repeated': replay.cycles > 0.9 * CONTROL_RATE * report['duration_s'],
        f'cycle records take {record_rate / 1000:g} kB/s at most': replay.bytes < record_rate * report['duration_s'],
        'the bag shows what the simulator counted': report['simulator'] == {
            key: report[key] for key in ('contacts', 'contacts_moving', 'contacts_at_rest', 'regions_crossed')},
        'host is what was built': report['host'] == ('compat' if 'move_base' in host_packages() else 'real'),
        **{text: check(report) for text, check in expect.items()}}
    missed = [text for text, met in expectations.items() if not met]
    for text in missed:
        print(f'    not so: {text}')
    if missed:
        print(f'    {json.dumps(report)}\n{tail(output)}')
    return Counts(passed=len(expectations) - len(missed), failed=len(missed))


def study():
    """A small study by scripts/study, from an environment that knows nothing of ROS."""
    folder = os.path.join(WORK, 'study')
    shutil.rmtree(folder, ignore_errors=True)
    run(['env', '-i', f'HOME={os.environ.get("HOME", "/")}', f'PATH={os.environ["PATH"]}', f'HIDWA_SPACE={SPACE}',
         os.path.join(ROOT, 'scripts', 'study'), 'run', '--out', folder, '--participants', '2'], 'study')
    with open(os.path.join(folder, 'runs.csv'), encoding='utf-8', newline='') as text:
        runs = list(csv.DictReader(text))
    expectations = {
        'two people in three conditions': sorted(r['condition'] for r in runs) == ['SG', 'SG', 'SJ', 'SJ', 'SW', 'SW'],
        'SG comes last': all(r['order'] == '3' for r in runs if r['condition'] == 'SG'),
        'SJ and SW are counterbalanced': sorted(r['order'] for r in runs if r['condition'] == 'SJ') == ['1', '2'],
        'no contact in SJ and SG': all(r['contacts'] == '0' for r in runs if r['condition'] != 'SW'),
        'the page is there': os.path.getsize(os.path.join(folder, 'report.html')) > 10000}
    for text, met in expectations.items():
        if not met:
            print(f'    not so: {text}')
    return Counts(passed=sum(expectations.values()), failed=len(expectations) - sum(expectations.values()))


def soak():
    """scripts/soak, for a minute: the running host with goals, people, a stick, changes and faults at random."""
    folder = os.path.join(WORK, 'soak')
    status, output = run([os.path.join(ROOT, 'scripts', 'soak'), '--no-build', '--hours', '0.0125', '--out', folder], 'soak', check=False)
    if status:
        print(tail(output))
    return Counts(passed=int(status == 0), failed=int(status != 0))


def drive_avoid():
    """Through the office with a person who steers round the regions to avoid."""
    return drive('drive_avoid', '--operator', 'avoid', expect={
        'no region is crossed': lambda r: r['regions_crossed'] == 0,
        'the person steers': lambda r: r['operator_active_s'] > 1.0})


def drive_in_mode(mode, **more):
    """The office in another mode; the demo's person steers with what it has."""
    return drive(f'drive_{mode}', '--mode', mode, '--operator', 'avoid', expect={
        'no region is crossed': lambda r: r['regions_crossed'] == 0,
        f'the mode is {mode}': lambda r: r['mode'] == mode,
        'the person steers': lambda r: r['operator_active_s'] > 1.0, **more})


def drive_gesture():
    """Through the office with a person whose hand steers, with a clutch."""
    return drive_in_mode('gesture')


def drive_switching():
    """Through the office with a person who takes control and hands it back."""
    return drive_in_mode('switching', **{'the person is in control for a while': lambda r: r['state_s']['MANUAL'] > 1.0})


def drive_people():
    """Through the office among people who keep away from the robot, as scripts/demo drives by itself."""
    return drive('drive_people', '--people', '6', '--operator', 'avoid', record_rate=PEOPLE_RATE, expect={
        'six people are there': lambda r: r['people'] == 6,
        'the robot meets somebody': lambda r: r['closest_person_m'] < 2.0,
        'nobody is touched by the moving robot': lambda r: r['contacts_moving'] == 0})


def drive_none():
    """Through the office with nobody: autonomy cannot see the regions."""
    return drive('drive_none', '--operator', 'none', expect={
        'a region is crossed': lambda r: r['regions_crossed'] >= 1,
        'nobody steers': lambda r: r['operator_active_s'] == 0.0})


def gdc_map():
    path = os.path.join(DATA, 'maps', 'gdc_3', 'map.yaml')
    if not os.path.exists(path):
        raise Absent(f'{path} (HIDWA_DATA names the folder of the real data)')
    return path


def drive_real_map():
    """A real floor, 74 m, autonomy alone."""
    return drive('drive_real_map', '--map', gdc_map(), *GDC, '--operator', 'none', expect={
        'about as long as planned': lambda r: r['path_length_m'] < 1.05 * r['planned_length_m']})


def steer(side):
    script = os.path.join(ROOT, 'test', 'scripts', f'steer_{side}.yaml')
    return drive(f'drive_steer_{side}', '--map', gdc_map(), *GDC, '--operator', script, expect={
        f'the path goes 0.3 m or more to the {side}': lambda r: r[f'operator_shift_{side}_m'] >= 0.3,
        'the person steers for 3 s': lambda r: 2.8 <= r['operator_active_s'] <= 3.2})


def drive_steer_left():
    """The stick held left for 3 s in a corridor of the real floor."""
    return steer('left')


def drive_steer_right():
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
    cut, none = os.path.join(folder, 'cut.bag'), os.path.join(folder, 'none.bag')
    with open(bag, 'rb') as file, open(cut, 'wb') as half:
        half.write(file.read(os.path.getsize(bag) * 2 // 3))
    with open(none, 'wb') as file:
        file.write(b'no bag at all')
    intact, foreign, absent = replayed(cut), replayed(none), replayed(os.path.join(folder, 'absent.bag'))
    expectations = {
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
        'no bag: status 2 and the reason': foreign.status == 2 and 'is no bag' in foreign.output,
        'no file: status 2 and the reason': absent.status == 2 and 'no such file' in absent.output}
    missed = [text for text, met in expectations.items() if not met]
    for text in missed:
        print(f'    not so: {text}')
    return Counts(passed=len(expectations) - len(missed), failed=len(missed))


# In this order; those after `build` need what it built.
SUITES = (plain, sanitized, build, package, compat, ros, python, console, browser, robot, lint, study, soak, contract, drive_avoid,
          drive_gesture, drive_switching, drive_none, drive_people, drive_real_map, drive_steer_left, drive_steer_right,
          replay)
ALONE = (plain, sanitized, build, lint)
# They wait for simulated time rather than work: two at once.
PACED = (contract, drive_avoid, drive_gesture, drive_switching, drive_none, drive_people, drive_real_map,
         drive_steer_left, drive_steer_right)
AT_ONCE = 2
# They only compile and read: with what the processor has left beside suites that wait, and done before the paced ones.
BESIDE = (robot, lint)
# Cases that do one thing for long, of which the sanitizers see all in the first moments: left to the long forms.
LONG_CASES = ('Recovery.PastCornersThatThePlanHugs', 'Evasions.StepAsideInGoodTime', 'Evasions.GoOnForLessThanTheyBegin',
              'WaySearch.LooksCloselyWhereItHasFoundNothing', 'WaySearch.WaysAreFree',
              'Surroundings.CentresAreBlockedWhereTheirCellsSay')


def cpu_seconds():
    """CPU time [s] of all commands that have ended."""
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def run_suite(suite, built):
    """Counts of one suite; what did not run counts as failed."""
    begin, cpu = time.monotonic(), cpu_seconds()
    print(f'==> {suite.__name__}: {suite.__doc__.splitlines()[0]}', flush=True)
    try:
        if not built and suite not in ALONE:
            raise Failed('did not run: the build failed')
        counts = suite()
    except Absent as absent:
        print(f'    skipped, absent: {absent}')
        counts = Counts(skipped=1)
    except Exception as fault:  # whatever it is, the suite did not run to its end
        print(f'    {type(fault).__name__}: {fault}')
        counts = Counts(failed=1)
    print(f'    {suite.__name__}: {counts.passed} ok, {counts.failed} not ok, {counts.skipped} left out, '
          f'{time.monotonic() - begin:.0f} s, {cpu_seconds() - cpu:.0f} s of CPU', flush=True)
    return counts


def start_beside(suites):
    """Suites that begin now, in a process of lowest priority; None without suites."""
    if not suites:
        return None
    os.makedirs(WORK, exist_ok=True)
    path = os.path.join(WORK, 'beside.out')
    open(path, 'wb').close()
    names = [suite.__name__ for suite in suites]
    return Child(['nice', '-n', '19', sys.executable, '-m', __spec__.name, *names], path, dict(os.environ)), path


def end_beside(started):
    """Counts of what start_beside began, once it has ended."""
    if started is None:
        return Counts()
    child, path = started
    while child.running:
        time.sleep(0.2)
    child.stop()
    with open(path, encoding='utf-8', errors='replace') as text:
        output = text.read()
    counts = Counts.read(output)
    if counts is None:
        print(f'==> beside\n{tail(output)}\n    beside: did not run to its end')
        return Counts(failed=1)
    print('\n'.join(output.splitlines()[:-2]), flush=True)  # without its own sums
    return counts


def run_paced(suites):
    """Counts of suites that run side by side, each in a process of its own."""
    total = Counts()
    jobs = [(suite.__name__, [sys.executable, '-m', __spec__.name, suite.__name__]) for suite in suites]
    for name, output in side_by_side(jobs, AT_ONCE, WORK):
        counts = Counts.read(output)
        if counts is None:
            print(f'==> {name}\n{tail(output)}\n    {name}: did not run to its end')
            counts = Counts(failed=1)
        else:
            print('\n'.join(output.splitlines()[:-2]))  # without its own sums
        total += counts
        sys.stdout.flush()
    return total


def use_ccache():
    """Most files are compiled for plain CMake, for colcon and for a robot: once is enough. (CMake before 3.17 ignores this.)"""
    if shutil.which('ccache'):
        os.environ.setdefault('CMAKE_CXX_COMPILER_LAUNCHER', 'ccache')


def coverage():
    """Which lines and branches of the parts that decide run; fails below the bar."""
    folder = os.path.join(WORK, 'coverage')
    if not shutil.which('gcovr'):
        raise Failed('gcovr is missing: apt-get install gcovr (scripts/test --coverage does)')
    run(['cmake', '-S', ROOT, '-B', folder, f'-DHIDWA_TEST_SUITES={";".join(coverage_of.SUITES)}', '-DHIDWA_ROS=OFF', '-DHIDWA_TESTS=ON',
         '-DHIDWA_COVERAGE=ON', '-DCMAKE_CXX_COMPILER=g++', '-DCMAKE_BUILD_TYPE=Debug', '-DCMAKE_CXX_FLAGS_DEBUG=-O0 -DNDEBUG'],
        'coverage_configure')
    run(['cmake', '--build', folder, '-j', JOBS], 'coverage_build')
    for old in glob.glob(os.path.join(folder, '**', '*.gcda'), recursive=True):
        os.remove(old)
    with without_long_cases():
        counts = ctest(folder, 'coverage', which=sanitize.ctest_options(coverage_of.LONG))
    rows = coverage_of.rows_of(ROOT, folder)
    lines, below = coverage_of.table(coverage_of.shares(rows))
    print('\n'.join(lines + coverage_of.worst_files(rows)))
    print(f'    line by line: {folder}/html/index.html')
    for part in below:
        print(f'    {part} is below {coverage_of.LINES:g} % of the lines or {coverage_of.BRANCHES:g} % of the branches')
    return counts + Counts(passed=len(coverage_of.PARTS) - len(below), failed=len(below))


def sanitize_all(names):
    """Counts of the long forms: every test that needs no ROS, or the host with the plugin, by each compiler and sanitizer; fuzzing."""
    total = Counts()
    for name in names:
        compiler, sanitizers, with_ros = sanitize.FORMS[name]
        print(f'==> {name}: {compiler}, {sanitizers}', flush=True)
        if compiler == 'clang++' and not compilers.fuzzes(compilers.clang()):
            print(f'    skipped, absent: Clang with its run-time libraries ({compilers.REMEDY})')
            total += Counts(skipped=1)
            continue
        try:
            if name == sanitize.FUZZ:
                well, found = fuzz.build_and_run()
                counts = Counts(passed=len(well), failed=len(found))
            elif with_ros:
                counts = sanitize_host(name, compiler, sanitizers)
            else:
                counts = ctest_sanitized(name, sanitize.cmake_options(compiler, sanitizers), sanitize.ctest_options())
        except (Failed, fuzz.FuzzError) as fault:
            print(f'    {fault}')
            counts = Counts(failed=1)
        print(f'    {name}: {counts}', flush=True)
        total += counts
    return total


def sanitize_host(name, compiler, sanitizers):
    """Host, plugin, tools and rostests, all built with the sanitizer, in a space of their own."""
    space = os.path.join(WORK, name)
    os.makedirs(space, exist_ok=True)
    folder = os.path.join(space, 'findings')
    shutil.rmtree(folder, ignore_errors=True)
    os.makedirs(folder)
    options = sanitize.flags(sanitizers)
    environment = {**os.environ, **sanitize.with_ros(sanitize.environment(ROOT), folder), 'HIDWA_SPACE': space, 'CXX': compiler,
                   'CXXFLAGS': options, 'LDFLAGS': options, 'HIDWA_INSTALL': 'skip'}
    done = subprocess.run([sys.executable, '-m', __spec__.name, 'build', 'package', 'ros'], env=environment, stdout=subprocess.PIPE,
                          text=True, check=False)
    found = sanitize.findings(folder)
    print('\n'.join(done.stdout.splitlines()[:-2] + [f'    found: {line}' for line in found]), flush=True)
    return (Counts.read(done.stdout) or Counts(failed=1)) + Counts(passed=not found, failed=len(found))


def run_all(wanted):
    """Counts of suites, in their order; those that wait share the machine."""
    total, built, started = Counts(), True, None
    paced = [suite for suite in wanted if suite in PACED]
    beside = [suite for suite in wanted if suite in BESIDE]
    if len(paced) < 2:
        paced = []
    if len(wanted) == len(beside):
        beside = []
    try:
        for suite in wanted:
            if built and suite not in ALONE and beside:
                started, beside = start_beside(beside), []
            if built and suite in BESIDE and started:
                continue
            if built and suite in paced:
                if suite is paced[0]:
                    total += end_beside(started)
                    started = None
                    total += run_paced(paced)
                continue
            counts = run_suite(suite, built)
            built = built and not (suite is build and counts.failed)
            total += counts
        return total + end_beside(started)
    finally:
        if started:
            started[0].stop()


def main(arguments=None):
    """scripts/test"""
    names = [suite.__name__ for suite in SUITES]
    parser = argparse.ArgumentParser(
        prog='scripts/test', formatter_class=argparse.RawDescriptionHelpFormatter,
        description='Installs what is missing, builds and runs every test. Ends with the line\n'
        '"N passed, N failed, N skipped"; exit status 0 only if nothing failed.',
        epilog='suites:\n' + '\n'.join(f'  {suite.__name__:18}{suite.__doc__.splitlines()[0]}' for suite in SUITES)
        + '\n\nenvironment: HIDWA_DATA=DIR real maps (default: ../shared/data); HIDWA_UNDERLAY and more: scripts/build --help')
    parser.add_argument('--sanitize', nargs='*', choices=list(sanitize.FORMS), metavar='FORM',
                        help=f'instead: every test under sanitizers, or only these forms: {", ".join(sanitize.FORMS)}; takes hours')
    parser.add_argument('--coverage', action='store_true',
                        help='instead: the share of lines and branches that run; '
                        f'fails below {coverage_of.LINES:g} and {coverage_of.BRANCHES:g} %%')
    parser.add_argument('suites', nargs='*', metavar='SUITE', help='only these (default: all; what is built is used as it is)')
    options = parser.parse_args(arguments)
    for name in options.suites:
        if name not in names:
            parser.error(f"there is no suite '{name}'; there are {', '.join(names)}")
    end_on_signals()
    use_ccache()
    if options.coverage or options.sanitize is not None:
        os.environ[LIMIT_NAME] = str(LONG_LIMIT)
        os.environ.setdefault('CMAKE_BUILD_PARALLEL_LEVEL', JOBS)
        total = run_suite(coverage, True) if options.coverage else sanitize_all(options.sanitize or list(sanitize.FORMS))
        print(total, flush=True)
        return 1 if total.failed or not total.passed else 0
    begin = time.monotonic()
    total = run_all([suite for suite in SUITES if not options.suites or suite.__name__ in options.suites])
    print(f'==> {time.monotonic() - begin:.0f} s in all; logs in {WORK}')
    print(total, flush=True)
    return 1 if total.failed or not total.passed else 0


if __name__ == '__main__':
    sys.exit(main())
