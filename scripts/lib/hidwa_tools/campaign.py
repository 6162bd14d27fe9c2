# SPDX-License-Identifier: BSD-3-Clause
"""scripts/attack and scripts/ways, once everything needed is installed: builds hidwa_attack or hidwa_ways and runs it."""
import os
import subprocess
import sys

from .places import ROOT, SPACE
from .plain_build import CORES, BuildError, build

ALWAYS = {'attack': [], 'ways': ['--map', os.path.join(ROOT, 'maps', 'office.yaml')]}
NO_BUILD = '--no-build'
HELP = """scripts/{0} [--no-build] [OPTION...]: installs what is missing, builds hidwa_{0} without ROS and runs it.
--no-build: run what is built; all other options are the program's (docs/evidence/{0}.md has examples).
environment: HIDWA_SPACE and HIDWA_INSTALL: scripts/build --help"""


def main(name, arguments):
    """Exit status of the program; 2 where it could not run. The program says what is wrong with its arguments."""
    folder = os.path.join(SPACE, 'build', name)
    program = os.path.join(folder, 'test', name, f'hidwa_{name}')
    try:
        if '--help' in arguments or '-h' in arguments:
            print(HELP.format(name), flush=True)
            return subprocess.run([program, '--help'], check=False).returncode if os.path.exists(program) else 0
        if NO_BUILD not in arguments:
            print('==> building', file=sys.stderr, flush=True)
            build(f'hidwa_{name}', folder, ['-DHIDWA_TOOLS=demo', '-DHIDWA_TESTS=ON', f'-DHIDWA_TEST_SUITES={name}'])
        own = [argument for argument in arguments if argument != NO_BUILD]
        return subprocess.run([program, *ALWAYS[name], '--jobs', CORES, '--out', folder, *own], check=False).returncode
    except (BuildError, OSError) as fault:
        print(f'scripts/{name}: {fault}', file=sys.stderr)
        return 2


if __name__ == '__main__':
    sys.exit(main(sys.argv[1], sys.argv[2:]))
