# SPDX-License-Identifier: BSD-3-Clause
"""What is installed of the scripts' library is all that the installed programs import of it."""
import ast
import glob
import os
import re
import subprocess
import unittest

ROOT = os.path.abspath(os.path.join(os.path.dirname(os.path.abspath(__file__)), '..', '..'))
LIBRARY = os.path.join(ROOT, 'scripts', 'lib', 'hidwa_tools')
# A robot's programs import of it; the console also runs the report as a program.
PROGRAMS = [*(os.path.join(ROOT, 'scripts', name) for name in ('joy_reader', 'measure_base', 'quest2ros_joy', 'record_drive', 'bag_test')),
            os.path.join(ROOT, 'console', 'console'), *sorted(glob.glob(os.path.join(ROOT, 'console', 'hidwa_console', '*.py'))),
            *sorted(path for package in ('hidwa_bag_test', 'hidwa_measure_base')
                    for path in glob.glob(os.path.join(ROOT, 'scripts', 'lib', package, '*.py')))]
RUN_AS_PROGRAMS = {'report'}
WITHOUT = ('matplotlib', 'scipy')  # a robot need not have them


def installed():
    """Modules that CMakeLists.txt installs."""
    with open(os.path.join(ROOT, 'CMakeLists.txt'), encoding='utf-8') as text:
        listed = re.search(r'foreach\(module ([^)]*)\)', text.read()).group(1)
    return set(listed.split())


def imported(path, package):
    """Modules of the library that a file imports: by name, or where package is true as its neighbours."""
    with open(path, encoding='utf-8') as text:
        tree = ast.parse(text.read(), path)
    found = set()
    for node in ast.walk(tree):
        if isinstance(node, ast.Import):
            found |= {alias.name.split('.')[1] for alias in node.names if alias.name.startswith('hidwa_tools.')}
        elif isinstance(node, ast.ImportFrom):
            name = node.module or ''
            if node.level == 1 and package:
                found |= {name.split('.')[0]} if name else {alias.name for alias in node.names}
            elif name == 'hidwa_tools':
                found |= {alias.name for alias in node.names}
            elif name.startswith('hidwa_tools.'):
                found.add(name.split('.')[1])
    return found


def needed():
    """All that the programs import of the library, and what that imports in turn."""
    open_, known = set.union(set(RUN_AS_PROGRAMS), *(imported(path, False) for path in PROGRAMS)), set()
    while open_:
        module = open_.pop()
        known.add(module)
        open_ |= imported(os.path.join(LIBRARY, module + '.py'), True) - known
    return known


class Installed(unittest.TestCase):
    def test_what_the_programs_import_is_installed_and_nothing_else(self):
        self.assertEqual(installed() - {'__init__'}, needed())

    @unittest.skipUnless(os.environ.get('ROS_PACKAGE_PATH'), 'no ROS in this environment (. scripts/env)')
    def test_they_begin_without_matplotlib_and_scipy(self):
        lines = [f'import sys; sys.modules.update(dict.fromkeys({WITHOUT}))']  # None there: the import fails
        lines += [f'import hidwa_tools.{name}' for name in sorted(installed() - {'figure'})]
        for path in PROGRAMS:
            package, name = os.path.basename(os.path.dirname(path)), os.path.basename(path)
            if name.endswith('.py') and name != 'picture.py':
                lines.append(f'import {package}.{name[:-3]}')
        places = (os.path.join(ROOT, 'scripts', 'lib'), os.path.join(ROOT, 'console'), os.environ.get('PYTHONPATH', ''))
        done = subprocess.run(['/usr/bin/python3', '-c', '\n'.join(lines)], env={**os.environ, 'PYTHONPATH': ':'.join(places)},
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False)
        self.assertEqual(done.returncode, 0, done.stdout)

    def test_the_search_finds_what_it_should(self):
        self.assertTrue({'bag', 'figure', 'pose_goal', 'processes', 'exchange'} <= needed())  # bag and figure by way of report


if __name__ == '__main__':
    unittest.main()
