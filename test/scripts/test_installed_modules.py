# SPDX-License-Identifier: BSD-3-Clause
"""What is installed of the scripts' library is all that the installed programs import of it."""
import ast
import glob
import os
import re
import unittest

ROOT = os.path.abspath(os.path.join(os.path.dirname(os.path.abspath(__file__)), '..', '..'))
LIBRARY = os.path.join(ROOT, 'scripts', 'lib', 'hidwa_tools')
# record_drive and the console import of it; the console also runs the report as a program.
PROGRAMS = [os.path.join(ROOT, 'scripts', 'record_drive'), os.path.join(ROOT, 'console', 'console'),
            *sorted(glob.glob(os.path.join(ROOT, 'console', 'hidwa_console', '*.py')))]
RUN_AS_PROGRAMS = {'report'}


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
    def test_what_the_programs_import_is_installed(self):
        self.assertEqual(needed() - installed(), set())

    def test_the_search_finds_what_it_should(self):
        self.assertTrue({'bag', 'figure', 'pose_goal', 'processes', 'exchange'} <= needed())  # bag and figure by way of report


if __name__ == '__main__':
    unittest.main()
