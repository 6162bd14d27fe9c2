# SPDX-License-Identifier: BSD-3-Clause
"""What a plain build in a catkin workspace makes: what a robot needs, and nothing else; and what that links."""
import glob
import os
import re
import subprocess
import unittest

from test_build_files import Configured, ROOT

NAME = 'hidwa_local_planner'
LIBRARIES = {'hidwa_core', 'hidwa_tracking', NAME}
COMPILED = {'hidwa_tracker', 'hidwa_plan_follower'}
PROGRAMS = COMPILED | {'joy_reader', 'quest2ros_joy', 'record_drive', 'measure_base', 'bag_test', 'console'}
# What package.xml names for tools alone: a robot may lack it.
OF_TOOLS = ('nlohmann_json', 'rosbag_storage', 'yaml-cpp')


def run(*command):
    return subprocess.run(command, stdout=subprocess.PIPE, text=True, check=True).stdout


@unittest.skipUnless(os.environ.get('ROS_PACKAGE_PATH'), 'no ROS in this environment (. scripts/env)')
class RobotBuild(unittest.TestCase):
    def configured(self, *arguments):
        build = Configured(ROOT, '-DPYTHON_EXECUTABLE=/usr/bin/python3', '-DCMAKE_DISABLE_FIND_PACKAGE_mbf_msgs=ON', *arguments)
        self.addCleanup(build.close)
        self.assertEqual(build.status, 0, build.output)
        return build

    def assert_of_robot(self, build):
        own = {name for name in build.built_by_all() if re.match('hidwa_(?!local_planner_)', name)}  # not the messages
        self.assertEqual(own, LIBRARIES | COMPILED)
        rules = '\n'.join(build.read(os.path.relpath(path, build.path))
                          for path in glob.glob(os.path.join(build.path, '**', 'cmake_install.cmake'), recursive=True))
        installed = re.findall(rf'file\(INSTALL DESTINATION "\S*/lib/{NAME}" TYPE (?:EXECUTABLE|PROGRAM) FILES\s+([^)]*)\)', rules)
        self.assertEqual({os.path.basename(path) for paths in installed for path in re.findall('"([^"]*)"', paths)}, PROGRAMS)
        self.assertNotRegex(rules, r'/maps"|/urdf"|/(demo|two_robots)\.launch"')

    def test_it_needs_nothing_of_tools_and_its_tests_wait_for_run_tests(self):
        build = self.configured(*(f'-DCMAKE_DISABLE_FIND_PACKAGE_{name}=ON' for name in OF_TOOLS))
        self.assert_of_robot(build)
        waiting = {name for name in build.built_by('tests') if name.startswith('hidwa_')}
        self.assertLessEqual({'hidwa_unit_ros', 'hidwa_attack_test', 'hidwa_replay_messages'}, waiting)
        self.assertFalse({'hidwa_sim', 'hidwa_drive'} & waiting)


class Links(unittest.TestCase):
    """What was installed, with or without tools: a robot's part of it has nothing of theirs."""

    def setUp(self):
        share = next((path for path in os.environ.get('ROS_PACKAGE_PATH', '').split(':')
                      if os.path.exists(os.path.join(path, NAME, 'plugins.xml'))), None)
        if not share:
            self.skipTest('nothing is installed in this environment (. scripts/env)')
        self.place = os.path.join(os.path.dirname(share), 'lib')
        self.files = [os.path.join(self.place, f'lib{name}.so') for name in sorted(LIBRARIES)]
        self.files += [os.path.join(self.place, NAME, name) for name in sorted(COMPILED)]

    def test_no_library_of_tools(self):
        for path in self.files:
            needed = re.findall(r'\(NEEDED\).*\[(.*)\]', run('readelf', '-d', path))
            self.assertTrue(any(name.startswith('libc.') for name in needed), path)
            self.assertEqual([name for name in needed if re.search('hidwa_sim|rosbag|yaml-cpp', name)], [], path)

    def test_every_library_is_found(self):
        for path in self.files:
            self.assertNotIn('not found', run('ldd', path), path)

    def test_no_part_of_the_simulation(self):
        """It is linked statically."""
        for path in self.files:
            symbols = run('nm', '-C', *(['-D'] if path.endswith('.so') else []), path)
            self.assertIn(' T ', symbols, path)
            self.assertNotRegex(symbols, f'{NAME}::(sim|drive|study)::|hidwa_attack::', path)


if __name__ == '__main__':
    unittest.main()
