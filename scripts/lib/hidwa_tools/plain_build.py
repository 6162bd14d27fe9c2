# SPDX-License-Identifier: BSD-3-Clause
"""Builds one program as a Release by plain CMake, without ROS."""
import os
import subprocess

from .places import ROOT

CORES = str(os.cpu_count() or 1)


class BuildError(Exception):
    """It could not be built."""


def build(target, folder, options):
    """Builds `target` into `folder`; `options`: more of CMake's. What the build says goes to a file in the folder."""
    os.makedirs(folder, exist_ok=True)
    log = os.path.join(folder, f'{os.path.basename(folder)}.log')
    commands = (['cmake', '-S', ROOT, '-B', folder, '-DHIDWA_ROS=OFF', '-DCMAKE_BUILD_TYPE=Release', *options],
                ['cmake', '--build', folder, '--target', target, '-j', CORES])
    with open(log, 'w', encoding='utf-8') as out:
        for command in commands:
            if subprocess.run(command, stdout=out, stderr=subprocess.STDOUT, check=False).returncode:
                raise BuildError(f'the build failed; its whole output is in {log}')
