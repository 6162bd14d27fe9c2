# SPDX-License-Identifier: BSD-3-Clause
"""scripts/attack, once everything needed is installed: builds hidwa_attack and runs the hostile campaign."""
import argparse
import os
import subprocess
import sys

from .places import SPACE
from .plain_build import CORES, BuildError, build

FOLDER = os.path.join(SPACE, 'build', 'attack')
PROGRAM = os.path.join(FOLDER, 'test', 'attack', 'hidwa_attack')


def program_arguments(options):
    """What hidwa_attack is called with."""
    arguments = ['--seconds', str(options.seconds)]
    if options.condition:
        arguments += ['--condition', options.condition]
    if options.seed is not None:
        arguments += ['--seed', str(options.seed)]
        return arguments + (['--trace', options.trace] if options.trace else [])
    return arguments + ['--drives', str(options.drives), '--first-seed', str(options.first_seed), '--jobs', str(options.jobs),
                        '--out', options.out]


def parse(arguments):
    """The command line."""
    parser = argparse.ArgumentParser(
        prog='scripts/attack', formatter_class=argparse.RawDescriptionHelpFormatter,
        description='Installs what is missing, builds hidwa_attack without ROS, and drives the planner with people who want a\n'
        'collision, faulty odometry, late cycles and bases of all kinds: every condition, 300 drives of 20 s each.\n'
        'Prints a line a condition and writes summary.json and drives.csv (docs/evidence/attack.md says what they hold).',
        epilog='exit status: 0 the planner held under every promised condition; 1 it did not; 2 something did not run\n'
        'environment: HIDWA_SPACE and HIDWA_INSTALL: scripts/build --help')
    parser.add_argument('--condition', metavar='NAME[,NAME...]', help='only these; --list names them')
    parser.add_argument('--drives', type=int, default=300, metavar='N', help='of each condition (300)')
    parser.add_argument('--seconds', type=int, default=20, metavar='N', help='of each drive [s] (20)')
    parser.add_argument('--first-seed', type=int, default=1, metavar='N', help='other drives (1)')
    parser.add_argument('--seed', type=int, metavar='N', help='one drive of one condition alone')
    parser.add_argument('--trace', metavar='FILE.csv', help='with --seed: what happened, every 10 ms')
    parser.add_argument('--jobs', default=CORES, metavar='N', help='drives at the same time (one a core)')
    parser.add_argument('--out', default=FOLDER, metavar='DIR', help='where the figures go (build/attack)')
    parser.add_argument('--list', action='store_true', help='the conditions')
    parser.add_argument('--no-build', action='store_true', help='run what is built')
    options = parser.parse_args(arguments)
    if options.seed is not None and not options.condition:
        parser.error('--seed needs a --condition')
    if options.trace and options.seed is None:
        parser.error('--trace needs a --seed')
    options.out = os.path.abspath(options.out)
    return options


def main(arguments=None):
    """scripts/attack"""
    options = parse(arguments)
    try:
        if not options.no_build:
            print('==> building', flush=True)
            build('hidwa_attack', FOLDER, ['-DHIDWA_TOOLS=OFF', '-DHIDWA_TESTS=ON', '-DHIDWA_TEST_SUITES=attack'])
        os.makedirs(options.out, exist_ok=True)
        command = ['--list'] if options.list else program_arguments(options)
        return subprocess.run([PROGRAM] + command, check=False).returncode
    except (BuildError, OSError) as fault:
        print(f'scripts/attack: {fault}', file=sys.stderr)
        return 2


if __name__ == '__main__':
    sys.exit(main())
