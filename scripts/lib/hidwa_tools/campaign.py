# SPDX-License-Identifier: BSD-3-Clause
"""scripts/attack and scripts/ways, once everything needed is installed: builds hidwa_study or hidwa_ways and runs it."""
import collections
import os
import subprocess
import sys
import time

from .places import ROOT, SPACE
from .plain_build import CORES, BuildError, build

# Where a program stands in its build folder, CMake's options for it, and its arguments before the user's. anew: each run has a
# folder of its own, named by the time, for the program would go on with what it finds there.
Program = collections.namedtuple('Program', 'path options arguments anew')
PROGRAMS = {
    'attack': Program(os.path.join('lab', 'study', 'hidwa_study'), ['-DHIDWA_TOOLS=ON'], ['attack'], True),
    'ways': Program(os.path.join('test', 'ways', 'hidwa_ways'), ['-DHIDWA_TOOLS=demo', '-DHIDWA_TESTS=ON', '-DHIDWA_TEST_SUITES=ways'],
                    ['--map', os.path.join(ROOT, 'maps', 'office.yaml'), '--jobs', CORES], False)}
NO_BUILD = '--no-build'
HELP = """scripts/{0} [--no-build] [OPTION...]: installs what is missing, builds {1} without ROS and runs it.
--no-build: run what is built; all other options are the program's (docs/evidence/{0}.md has examples).
environment: HIDWA_SPACE and HIDWA_INSTALL: scripts/build --help"""


def main(name, arguments):
    """Exit status of the program; 2 where it could not run. The program says what is wrong with its arguments."""
    folder, known = os.path.join(SPACE, 'build', name), PROGRAMS[name]
    program, out = os.path.join(folder, known.path), folder
    if known.anew:
        out = os.path.join(folder, 'drives', time.strftime('%Y-%m-%d_%H%M%S'))
    target = os.path.basename(program)
    try:
        if '--help' in arguments or '-h' in arguments:
            print(HELP.format(name, target), flush=True)
            return subprocess.run([program, '--help'], check=False).returncode if os.path.exists(program) else 0
        if NO_BUILD not in arguments:
            print('==> building', file=sys.stderr, flush=True)
            build(target, folder, known.options)
        own = [argument for argument in arguments if argument != NO_BUILD]
        return subprocess.run([program, *known.arguments, '--out', out, *own], check=False).returncode
    except (BuildError, OSError) as fault:
        print(f'scripts/{name}: {fault}', file=sys.stderr)
        return 2


if __name__ == '__main__':
    sys.exit(main(sys.argv[1], sys.argv[2:]))
