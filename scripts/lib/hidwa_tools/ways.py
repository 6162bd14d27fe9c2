# SPDX-License-Identifier: BSD-3-Clause
"""scripts/ways, once everything needed is installed: builds hidwa_ways and lets autonomy look for ways."""
import argparse
import os
import subprocess
import sys

from .options import existing
from .places import ROOT, SPACE
from .plain_build import CORES, BuildError, build

FOLDER = os.path.join(SPACE, 'build', 'ways')
PROGRAM = os.path.join(FOLDER, 'test', 'ways', 'hidwa_ways')
OFFICE = os.path.join(ROOT, 'maps', 'office.yaml')


def program_arguments(options):
    """What hidwa_ways is called with."""
    arguments = ['--map', ','.join([OFFICE, *options.map])]
    if options.barn:
        arguments += ['--barn', options.barn]
    if options.list:
        return arguments + ['--list']
    if options.scene:
        arguments += ['--scene', options.scene, '--seed', str(options.seed)]
        for name in ('trace', 'picture'):
            if getattr(options, name):
                arguments += [f'--{name}', getattr(options, name)]
        return arguments
    if options.kinds:
        arguments += ['--kinds', options.kinds]
    return arguments + ['--scenes', str(options.scenes), '--first-seed', str(options.first_seed), '--jobs', str(options.jobs),
                        '--out', options.out]


def parse(arguments):
    """The command line."""
    parser = argparse.ArgumentParser(
        prog='scripts/ways', formatter_class=argparse.RawDescriptionHelpFormatter,
        description='Installs what is missing, builds hidwa_ways without ROS, and leaves a robot alone in 5,000 tight places:\n'
        'does autonomy find the way where an exhaustive search finds one, and does it say so where there is none?\n'
        'Prints a table and writes summary.json, scenes.csv and table.txt (docs/evidence/ways.md says what they hold).',
        epilog='exit status: 0 every bar was reached; 1 not; 2 something did not run\n'
        'environment: HIDWA_SPACE and HIDWA_INSTALL: scripts/build --help')
    parser.add_argument('--scenes', type=int, default=5000, metavar='N', help='of all kinds together (5000)')
    parser.add_argument('--first-seed', type=int, default=1, metavar='N', help='other scenes (1)')
    parser.add_argument('--kinds', metavar='NAME[,NAME...]', help='only these; --list names them')
    parser.add_argument('--barn', type=existing, metavar='FILE', help='BARN worlds: adds the kind barn')
    parser.add_argument('--map', type=existing, action='append', default=[], metavar='FILE.yaml',
                        help='a map whose gaps are scenes too, besides the office; may be given several times')
    parser.add_argument('--scene', metavar='KIND', help='with --seed: one scene alone')
    parser.add_argument('--seed', type=int, metavar='N', help='of that scene')
    parser.add_argument('--trace', metavar='FILE.csv', help='with --scene: what happened, each cycle')
    parser.add_argument('--picture', metavar='FILE.svg', help='with --scene: map, plan, way found and way driven')
    parser.add_argument('--jobs', default=CORES, metavar='N', help='scenes at the same time (one a core)')
    parser.add_argument('--out', default=FOLDER, metavar='DIR', help='where the figures go (build/ways)')
    parser.add_argument('--list', action='store_true', help='the kinds of scenes')
    parser.add_argument('--no-build', action='store_true', help='run what is built')
    options = parser.parse_args(arguments)
    if (options.scene is None) != (options.seed is None):
        parser.error('--scene and --seed belong together')
    if (options.trace or options.picture) and not options.scene:
        parser.error('--trace and --picture need a --scene')
    options.out = os.path.abspath(options.out)
    return options


def main(arguments=None):
    """scripts/ways"""
    options = parse(arguments)
    try:
        if not options.no_build:
            print('==> building', flush=True)
            build('hidwa_ways', FOLDER, ['-DHIDWA_TOOLS=OFF', '-DHIDWA_TESTS=ON', '-DHIDWA_TEST_SUITES=ways'])
        os.makedirs(options.out, exist_ok=True)
        return subprocess.run([PROGRAM] + program_arguments(options), check=False).returncode
    except (BuildError, OSError) as fault:
        print(f'scripts/ways: {fault}', file=sys.stderr)
        return 2


if __name__ == '__main__':
    sys.exit(main())
