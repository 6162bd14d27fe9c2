# SPDX-License-Identifier: BSD-3-Clause
"""What CMake makes of the build files on a user's machine: alone, among other packages, with an older CMake, under catkin."""
import json
import os
import re
import subprocess
import tempfile
import unittest

ROOT = os.path.abspath(os.path.join(os.path.dirname(__file__), '..', '..'))
# CMake before 3.20 gives the libraries of GTest these names only.
OLDER_GTEST = '''
foreach(name GTest Main)
  add_library(GTest::${name} INTERFACE IMPORTED)
  set_target_properties(GTest::${name} PROPERTIES INTERFACE_LINK_LIBRARIES found_as_${name})
endforeach()
set(GTest_FOUND TRUE)
'''
# Another package of the same workspace.
PARENT = '''
cmake_minimum_required(VERSION 3.16)
project(workspace CXX)
add_subdirectory({root} planner)
add_library(other STATIC other.cpp)
'''


class Configured:
    """A build folder that CMake has made, and what is to be built in it."""

    def __init__(self, source, *arguments, environment=None):
        self._folder = tempfile.TemporaryDirectory()
        self.path = self._folder.name
        done = subprocess.run(['cmake', '-S', source, '-B', self.path, '-DCMAKE_EXPORT_COMPILE_COMMANDS=ON', *arguments],
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False,
                              env={**os.environ, **(environment or {})})
        self.status, self.output = done.returncode, done.stdout

    def close(self):
        self._folder.cleanup()

    def read(self, *names):
        with open(os.path.join(self.path, *names), encoding='utf-8') as text:
            return text.read()

    def command(self, file):
        """How a file is compiled."""
        return next(entry['command'] for entry in json.loads(self.read('compile_commands.json'))
                    if entry['file'].endswith(file))

    def targets(self):
        """Names of all targets of make, without those of single files."""
        lines = subprocess.run(['make', '-C', self.path, 'help'], stdout=subprocess.PIPE, text=True, check=True).stdout.splitlines()
        names = [match[1] for match in map(re.compile(r'\.\.\. (\S+)').match, lines) if match]
        return [name for name in names if not re.search(r'\.(o|i|s|cpp)$', name)]

    def tests(self):
        """Names of the tests that ctest knows."""
        listing = subprocess.run(['ctest', '--show-only=json-v1'], cwd=self.path, stdout=subprocess.PIPE, text=True, check=True).stdout
        return [test['name'] for test in json.loads(listing)['tests']]

    def built_by(self, target):
        """Targets that `make target` builds."""
        rules = {}
        for made, needs in re.findall(r'^(\S+): (\S+)$', self.read('CMakeFiles', 'Makefile2'), re.MULTILINE):
            rules.setdefault(made, []).append(needs)
        open_, known = [target, f'CMakeFiles/{target}.dir/all'], set()
        while open_:
            rule = open_.pop()
            known.add(rule)
            open_ += [other for other in rules.get(rule, []) if other not in known]
        return {match[1] for match in map(re.compile(r'(?:.*/)?CMakeFiles/(\w+)\.dir/all$').match, known) if match}

    def built_by_all(self):
        """Targets that a plain `make` builds."""
        return self.built_by('all')


class BuildFiles(unittest.TestCase):
    def configured(self, source, *arguments):
        build = Configured(source, *arguments)
        self.addCleanup(build.close)
        self.assertEqual(build.status, 0, build.output)
        return build

    def test_without_options_it_is_a_release_without_tests_and_warnings_are_none_of_the_users_errors(self):
        build = self.configured(ROOT, '-DHIDWA_ROS=OFF')
        self.assertEqual(build.tests(), [])
        command = build.command('src/core/planner/planner.cpp')
        self.assertNotIn('-Werror', command)
        self.assertIn('-DNDEBUG', command)
        self.assertFalse([name for name in build.targets() if 'test' in name and name != 'test'])

    def test_warnings_are_errors_where_that_is_asked_for(self):
        build = self.configured(ROOT, '-DHIDWA_ROS=OFF', '-DHIDWA_WERROR=ON')
        self.assertIn('-Werror', build.command('src/core/planner/planner.cpp'))

    def test_gtest_by_the_names_that_cmake_3_16_knows(self):
        with tempfile.TemporaryDirectory() as modules:
            with open(os.path.join(modules, 'FindGTest.cmake'), 'w', encoding='utf-8') as out:
                out.write(OLDER_GTEST)
            build = self.configured(ROOT, '-DHIDWA_ROS=OFF', '-DHIDWA_TESTS=ON', f'-DCMAKE_MODULE_PATH={modules}')
        self.assertIn('hidwa_unit_input', build.tests())
        link = build.read('test', 'unit', 'input', 'CMakeFiles', 'hidwa_unit_input.dir', 'link.txt')
        self.assertIn('found_as_GTest', link)
        self.assertIn('found_as_Main', link)

    def test_other_packages_of_a_workspace_keep_their_build_type_and_their_names(self):
        with tempfile.TemporaryDirectory() as source:
            for name, text in (('CMakeLists.txt', PARENT.format(root=ROOT)), ('other.cpp', 'int other() { return 0; }\n')):
                with open(os.path.join(source, name), 'w', encoding='utf-8') as out:
                    out.write(text)
            build = self.configured(source, '-DHIDWA_ROS=OFF', '-DHIDWA_TESTS=ON')
            self.assertNotRegex(build.command('other.cpp'), r' -O| -DNDEBUG')
            self.assertRegex(build.command('src/input/gesture_source.cpp'), r' -O3 -DNDEBUG')
            made = {name for name in build.targets() if re.search(r'hidwa|test|unit', name)} - {'test'}
            self.assertEqual({name for name in made if not name.startswith('hidwa_')}, set())
            self.assertIn('hidwa_core', made)


@unittest.skipUnless(os.environ.get('ROS_PACKAGE_PATH'), 'no ROS in this environment (. scripts/env)')
class UnderCatkin(unittest.TestCase):
    def configured(self, *arguments):
        build = Configured(ROOT, '-DPYTHON_EXECUTABLE=/usr/bin/python3', '-DHIDWA_TEST_SUITES=unit/input;unit/ros;property', *arguments)
        self.addCleanup(build.close)
        self.assertEqual(build.status, 0, build.output)
        return build

    def test_tests_belong_to_run_tests_and_a_build_leaves_them_out(self):
        build = self.configured()
        for name in ('hidwa_unit_input', 'hidwa_unit_ros', 'hidwa_vector_width_test'):
            self.assertIn(f'run_tests_hidwa_local_planner_gtest_{name}', build.targets())
            self.assertIn(f'_ctest_hidwa_local_planner_gtest_{name}', build.tests())
        built = build.built_by_all()
        self.assertIn('hidwa_local_planner', built)
        self.assertNotIn('hidwa_unit_input', built)

    def test_the_controller_for_move_base_flex_waits_for_generated_headers_and_is_installed_with_its_export(self):
        with tempfile.TemporaryDirectory() as folder:
            # Found, as from a workspace that makes the messages in the same build.
            target = 'add_custom_target(mbf_msgs_made)\nset(mbf_msgs_EXPORTED_TARGETS mbf_msgs_made)\n'
            for name, more in (('mbf_costmap_core', ''), ('mbf_msgs', target)):
                with open(os.path.join(folder, f'{name}Config.cmake'), 'w', encoding='utf-8') as out:
                    out.write(f'set({name}_INCLUDE_DIRS /usr/include)\n{more}')
            build = self.configured('-DHIDWA_TESTS=OFF', f'-Dmbf_costmap_core_DIR={folder}', f'-Dmbf_msgs_DIR={folder}')
        self.assertIn('hidwa_mbf_controller', build.built_by_all())
        rules = build.read('CMakeFiles', 'Makefile2')
        self.assertRegex(rules, r'hidwa_mbf_controller\.dir/all: CMakeFiles/mbf_msgs_made\.dir/all')
        self.assertIn('/mbf_plugins.xml', build.read('cmake_install.cmake'))

    def test_move_base_flex_that_is_demanded_and_absent_is_an_error(self):
        build = Configured(ROOT, '-DPYTHON_EXECUTABLE=/usr/bin/python3', '-DHIDWA_TESTS=OFF',
                           '-DCMAKE_DISABLE_FIND_PACKAGE_mbf_msgs=ON', environment={'HIDWA_WITH_MBF': '1'})
        self.addCleanup(build.close)
        self.assertNotEqual(build.status, 0)
        self.assertIn('HIDWA_WITH_MBF=1, but', build.output)

    def test_they_follow_catkins_own_switch(self):
        self.assertEqual(self.configured('-DCATKIN_ENABLE_TESTING=OFF').tests(), [])


if __name__ == '__main__':
    unittest.main()
