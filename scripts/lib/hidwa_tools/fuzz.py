# SPDX-License-Identifier: BSD-3-Clause
"""scripts/fuzz, once everything needed is installed: builds the targets of test/fuzz with libFuzzer and runs them."""
import argparse
import glob
import os
import re
import subprocess
import sys

from . import compilers
from .places import ROOT, SPACE
from .plain_build import CORES
from .processes import sourced

FOLDER = os.path.join(SPACE, 'build', 'fuzz')
KEPT = os.path.join(ROOT, 'test', 'fuzz', 'corpus')
CONSOLE = 'console'       # the one target in Python
WITH_ROS = os.path.join(FOLDER, 'ros')  # the space of those that take ROS to read
NEED_ROS = ('messages', 'bag')
MEMORY = 2048             # [MB], of a target; one allocation may take half of it
PATIENCE = 25             # [s], of one input
OPTIONS = {
    'ASAN_OPTIONS': 'detect_stack_use_after_return=1:strict_string_checks=1:abort_on_error=1:symbolize=1',
    'UBSAN_OPTIONS': 'print_stacktrace=1',
    'LSAN_OPTIONS': f'suppressions={ROOT}/test/sanitize/leaks.txt:print_suppressions=0'}


class FuzzError(Exception):
    """It cannot go on; the text says why."""


def configure_options():
    """What CMake is told besides."""
    compiler = compilers.clang()
    if not compilers.fuzzes(compiler):
        raise FuzzError(f'no Clang with libFuzzer here: {compilers.REMEDY}')
    return [f'-DCMAKE_CXX_COMPILER={compiler}', '-DHIDWA_FUZZ=ON', '-DHIDWA_SANITIZE=address,undefined',
            '-DCMAKE_BUILD_TYPE=Debug', '-DCMAKE_CXX_FLAGS_DEBUG=-O1']


def run_logged(commands, log, **more):
    """One after the other."""
    os.makedirs(os.path.dirname(log), exist_ok=True)
    with open(log, 'w', encoding='utf-8') as out:
        for command in commands:
            if subprocess.run(command, stdout=out, stderr=subprocess.STDOUT, check=False, **more).returncode:
                raise FuzzError(f'the build failed; its whole output is in {log}')


def build(folder, suites='fuzz'):
    """Builds the targets that need no ROS into a folder."""
    run_logged((['cmake', '-S', ROOT, '-B', folder, '-DHIDWA_ROS=OFF', '-DHIDWA_TESTS=ON', f'-DHIDWA_TEST_SUITES={suites}',
                 *configure_options()],
                ['cmake', '--build', folder, '-j', CORES]), os.path.join(folder, 'fuzz.log'))


def build_with_ros():
    """Builds the others, and what they link to, as scripts/build does."""
    run_logged([[os.path.join(ROOT, 'scripts', 'build'), '--tests', '-DHIDWA_TEST_SUITES=fuzz/ros', *configure_options()]],
               os.path.join(WITH_ROS, 'fuzz.log'), env={**os.environ, 'HIDWA_SPACE': WITH_ROS})


def programs(folder):
    """{target: its program} of a build folder, or of a space that has been built with ROS."""
    places = (os.path.join('test', 'fuzz'), os.path.join('build', 'hidwa_local_planner', 'devel', 'lib', 'hidwa_local_planner'))
    found = sorted(path for place in places for path in glob.glob(os.path.join(folder, place, 'hidwa_fuzz_*')))
    return {os.path.basename(path)[len('hidwa_fuzz_'):]: path for path in found if os.path.isfile(path) and os.access(path, os.X_OK)}


def command_of(name, program, seconds, seed, work):
    """How a target is called: what it finds out goes into `work`, the kept corpus is only read."""
    if name == CONSOLE:
        return ['/usr/bin/python3', program, '--seconds', str(seconds), '--seed', str(seed)]
    grown = os.path.join(work, 'corpus', name)
    os.makedirs(grown, exist_ok=True)
    command = [program, f'-max_total_time={seconds}', f'-seed={seed}', f'-rss_limit_mb={MEMORY}', f'-malloc_limit_mb={MEMORY // 2}',
               f'-timeout={PATIENCE}', '-max_len=16384', '-print_final_stats=1', f'-artifact_prefix={work}/{name}-', grown,
               os.path.join(KEPT, name)]
    return sourced(os.path.join(ROOT, 'scripts', 'env'), *command) if name in NEED_ROS else command


def environment_of(name):
    """What a target finds in its environment."""
    return {**os.environ, **OPTIONS, **({'HIDWA_SPACE': WITH_ROS} if name in NEED_ROS else {})}


def run_target(name, program, seconds, seed, work):
    """(whether nothing was found, what to say about it)."""
    log = os.path.join(work, name + '.log')
    with open(log, 'wb') as out:
        status = subprocess.run(command_of(name, program, seconds, seed, work), stdout=out, stderr=out, check=False,
                                env=environment_of(name)).returncode
    with open(log, encoding='utf-8', errors='replace') as text:
        said = text.read()
    inputs = re.findall(r'number_of_executed_units: (\d+)|^(\d+) inputs', said, re.MULTILINE)
    number = ''.join(inputs[-1]) if inputs else 'no'
    if status == 0 and inputs:
        return True, f'{number} inputs, nothing found'
    kept = re.findall(r'Test unit written to (\S+)', said)
    return False, f'FOUND something, exit status {status}: {log}' + (f'; repeat: {program} {kept[-1]}' if kept else '')


def run(folders, seconds, seed, only=()):
    """(targets without a finding, targets with one) of build folders; what is found goes into the first one."""
    targets = {CONSOLE: os.path.join(ROOT, 'test', 'fuzz', 'console_frames.py')}
    for folder in folders:
        targets.update(programs(folder))
    for name in only:
        if name not in targets:
            raise FuzzError(f"there is no target '{name}'; there are {', '.join(targets)}")
    work = os.path.join(folders[0], 'found')
    os.makedirs(work, exist_ok=True)
    well, found = [], []
    for name, program in targets.items():
        if only and name not in only:
            continue
        clean, words = run_target(name, program, seconds, seed, work)
        print(f'    {name:12} {words}', flush=True)
        (well if clean else found).append(name)
    return well, found


def build_and_run(only=(), seconds=60, seed=1, with_ros=True, build_first=True):
    """As run(), of the targets in `only` or of all; builds what they need before."""
    with_ros = with_ros and (not only or bool(set(only) & set(NEED_ROS)))
    if build_first:
        print('==> building', flush=True)
        if not only or set(only) - set(NEED_ROS):
            build(FOLDER)
        if with_ros:
            build_with_ros()
    print(f'==> {seconds} s of each target; logs and findings in {FOLDER}/found', flush=True)
    return run([FOLDER, WITH_ROS] if with_ros else [FOLDER], seconds, seed, only)


def main(arguments=None):
    """scripts/fuzz"""
    parser = argparse.ArgumentParser(
        prog='scripts/fuzz', formatter_class=argparse.RawDescriptionHelpFormatter,
        description='Installs what is missing, builds the targets of test/fuzz with libFuzzer, address and undefined-behaviour\n'
        'sanitizer, and gives each bytes that the fuzzer thinks of. The console has a fuzzer of its own. docs/evidence/trust.md says what\n'
        'each target takes.',
        epilog='exit status: 0 nothing was found; 1 something was; 2 something did not run\n'
        'environment: HIDWA_SPACE and HIDWA_INSTALL: scripts/build --help')
    parser.add_argument('targets', nargs='*', metavar='TARGET', help='only these (default: all)')
    parser.add_argument('--seconds', type=int, default=60, metavar='N', help='of each target [s] (60)')
    parser.add_argument('--seed', type=int, default=1, metavar='N', help='other inputs (1)')
    parser.add_argument('--no-build', action='store_true', help='run what is built')
    parser.add_argument('--built', metavar='DIR', help='run those of a build folder, which needs no ROS')
    parser.add_argument('--no-ros', action='store_true', help=f'leave out those that need ROS ({", ".join(NEED_ROS)})')
    options = parser.parse_args(arguments)
    try:
        if options.built:
            return 1 if run([options.built], options.seconds, options.seed, options.targets)[1] else 0
        return 1 if build_and_run(options.targets, options.seconds, options.seed, not options.no_ros, not options.no_build)[1] else 0
    except (FuzzError, OSError) as fault:
        print(f'scripts/fuzz: {fault}', file=sys.stderr)
        return 2


if __name__ == '__main__':
    sys.exit(main())
