# SPDX-License-Identifier: BSD-3-Clause
"""scripts/test, once everything needed is installed: builds, lets CTest run every test, and counts the cases."""
import argparse
import glob
import json
import os
import shutil
import subprocess
import sys
import time

from . import compilers, fuzz, long_forms, sanitize
from .counting import Counts, count_ctest, ctest_outcomes
from .places import DATA, ROOT, SPACE
from .processes import end_on_signals, sourced

WORK = os.path.join(SPACE, 'build', 'tests')  # what the tests build and write
CORES = os.cpu_count() or 1
# Tests that compute take two places (PROCESSORS); the others wait for simulated time, and two fit on a core. With three on a core
# the page in the browser falls behind.
AT_ONCE = 2 * CORES
COMPAT = ('nav_core', 'costmap_2d', 'map_server', 'move_base')


class BuildFailed(Exception):
    """Nothing can be tested; the text says what failed."""


def run(log, *command, show=False, **more):
    """Runs a command, and returns what it says; that is also in WORK/log.log, and shown where it should be."""
    os.makedirs(WORK, exist_ok=True)
    path, lines = os.path.join(WORK, log + '.log'), []
    with open(path, 'w', encoding='utf-8') as out, \
         subprocess.Popen(command, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, encoding='utf-8',
                          errors='replace', **more) as process:
        for line in process.stdout:
            out.write(line)
            lines.append(line)
            if show:
                sys.stdout.write(line)
                sys.stdout.flush()
    if process.returncode and not show:
        raise BuildFailed(f'{" ".join(command[:3])} ...: exit status {process.returncode}, {path}\n' + ''.join(lines[-40:]))
    return ''.join(lines)


def step(text):
    print(f'==> {text}', flush=True)


def installed(*command):
    """The command in the environment of what was built."""
    return sourced(os.path.join(ROOT, 'scripts', 'env'), *command)


def build_package():
    """Host, plugin, tools and their tests, by colcon: the build folders with tests."""
    run('build', os.path.join(ROOT, 'scripts', 'build'), '--tests')
    names = ['hidwa_local_planner', *(name for name in COMPAT if os.path.isdir(os.path.join(ROOT, 'compat', name, 'test')))]
    folders = (os.path.join(SPACE, 'build', name) for name in names)
    return [folder for folder in folders if os.path.exists(os.path.join(folder, 'CTestTestfile.cmake'))]


def build_rostests():
    """The packages of test/ros, upon what was installed: their build folders."""
    lines = 'set -euo pipefail; cd "$0"/scripts/lib; . ./common.sh; . ./packages.sh; . ./build.sh; hidwa_rostests'
    run('ros', 'bash', '-c', lines, ROOT)
    return sorted(glob.glob(os.path.join(WORK, 'ros', 'build', 'hidwa_*')))


def configure_sanitized():
    """What parses bytes and what starts threads, for the sanitizers: its build folder. A test builds it."""
    folder = os.path.join(WORK, 'sanitized')
    if compilers.fuzzes(compilers.clang()):
        options = fuzz.configure_options()
    else:
        step(f'no Clang with libFuzzer: by GCC, and the fuzz targets only repeat their corpus ({compilers.REMEDY})')
        options = sanitize.cmake_options('g++', sanitize.ADDRESS)
    run('sanitized', 'cmake', '-S', ROOT, '-B', folder, '-DHIDWA_ROS=OFF', '-DHIDWA_TESTS=ON', '-DHIDWA_UNITY=ON',
        *options, *sanitize.SHORT_BUILD)
    return folder


def configure_tree(folders, sanitized=''):
    """All tests as one tree: its folder."""
    tree = os.path.join(WORK, 'whole')
    builds = ';'.join([*folders, *([sanitized] if sanitized else [])])
    run('whole', 'cmake', '-S', os.path.join(ROOT, 'test', 'whole'), '-B', tree, f'-DHIDWA_BUILDS={builds}',
        f'-DHIDWA_SANITIZED={sanitized}')
    return tree


def use_ccache():
    """What is built for several forms is compiled once. (CMake before 3.17 ignores this.)"""
    if shutil.which('ccache'):
        os.environ.setdefault('CMAKE_CXX_COMPILER_LAUNCHER', 'ccache')
        os.environ.setdefault('CCACHE_SLOPPINESS', 'pch_defines,time_macros')  # for headers that are compiled once


def build():
    """Everything that the tests need; the environment of this process becomes theirs. The folder of their tree."""
    step('building host, plugin, tools and tests')
    folders = build_package()
    step('building the rostests')
    return configure_tree([*folders, *build_rostests()], configure_sanitized())


def ctest(tree, options, own=False):
    """Counts of the tests that the options of ctest choose, and the names of those that failed. `own`: they need nothing that was
    installed."""
    def call(*words):
        command = ['ctest', *words, *options]
        return command if own else installed(*sourced(os.path.join(WORK, 'ros', 'install', 'setup.bash'), *command))
    environment = {**os.environ, **sanitize.environment(ROOT), 'HIDWA_DATA': DATA}
    listing = run('list', *call('--show-only=json-v1'), cwd=tree, env=environment)
    since = time.time() - 1.0
    output = run('ctest', *call('-j', str(AT_ONCE), '--output-on-failure'), show=True, cwd=tree, env=environment)
    listing, outcomes = listing[listing.index('{'):], ctest_outcomes(output)
    failed = [test['name'] for test in json.loads(listing)['tests'] if outcomes.get(test['name'], 'failed') == 'failed']
    return count_ctest(output, listing, since), failed


def main(arguments=None):
    """scripts/test"""
    parser = argparse.ArgumentParser(
        prog='scripts/test', formatter_class=argparse.RawDescriptionHelpFormatter,
        description='Installs what is missing, builds and runs every test. Ends with the line\n'
        '"N passed, N failed, N skipped"; exit status 0 only if nothing failed.',
        epilog='labels: unit, oracle, property, closed_loop, attack, ways, sanitized, ros, package, compat, python, console, browser,\n'
        f'lint, drive; one test alone: cd {os.path.relpath(WORK)}/whole && ctest -R NAME --output-on-failure\n'
        'forms of --long: ' + ', '.join(long_forms.FORMS) + '\n'
        'environment: HIDWA_DATA=DIR real maps and bags (default: ../shared/data); HIDWA_UNDERLAY and more: scripts/build --help')
    parser.add_argument('--long', action='store_true', help='all counts, conditions and forms, or those that are named: hours. '
                        'A form that has passed with the same sources is not run again; ends with a table')
    parser.add_argument('--anew', action='store_true', help='with --long: run what has passed, too')
    parser.add_argument('--no-build', action='store_true', help='run what is built')
    parser.add_argument('names', nargs='*', metavar='LABEL', help='only tests with these labels; with --long: only these forms')
    options = parser.parse_args(arguments)
    end_on_signals()
    use_ccache()
    if options.long:
        return long_forms.main(parser, options)
    begin = time.monotonic()
    try:
        tree = os.path.join(WORK, 'whole') if options.no_build else build()
        chosen = ['-L', f'^({"|".join(options.names)})$'] if options.names else []
        counts, _ = ctest(tree, ['-LE', '^long$', *chosen])
    except BuildFailed as fault:
        print(fault)
        counts = Counts(failed=1)
    step(f'{time.monotonic() - begin:.0f} s in all; logs in {WORK}')
    print(counts, flush=True)
    return 1 if counts.failed or not counts.passed else 0


if __name__ == '__main__':
    sys.exit(main())
