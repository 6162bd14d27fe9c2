# SPDX-License-Identifier: BSD-3-Clause
"""package.xml against what the package includes, finds, imports and launches."""
import ast
import glob
import importlib.util
import os
import re
import subprocess
import sysconfig
import tempfile
import unittest
import xml.etree.ElementTree as xml

from test_installed_modules import LIBRARY, PROGRAMS as ROBOT_PROGRAMS, installed

ROOT = os.path.abspath(os.path.join(os.path.dirname(__file__), '..', '..'))
NAME = 'hidwa_local_planner'
# What a header, a CMake package or a Python module is called as a dependency, where that is something else.
# roscpp hands on what it is made of; Boost comes with it; costmap_2d's package tells of threads.
OTHER_NAMES = {
    'Eigen': 'eigen', 'Eigen3': 'eigen', 'nlohmann': 'nlohmann-json-dev', 'nlohmann_json': 'nlohmann-json-dev',
    'ZLIB': 'zlib', 'zlib.h': 'zlib', 'ros': 'roscpp', 'xmlrpcpp': 'roscpp', 'boost': 'roscpp',
    'rosbag.h': 'rosbag_storage', 'urdf_parser': 'liburdfdom-dev', 'urdfdom': 'liburdfdom-dev',
    'console_bridge': 'libconsole-bridge-dev', 'urdfdom_headers': 'liburdfdom-dev', 'console_bridge': 'libconsole-bridge-dev',
    'GTest': 'gtest', 'numpy': 'python3-numpy', 'yaml': 'python3-yaml', 'matplotlib': 'python3-matplotlib',
    'scipy': 'python3-scipy', 'tornado': 'python3-tornado', 'PIL': 'python3-pil', 'rospkg': 'python3-rospkg'}
PROGRAMS = ('scripts/*', 'scripts/lib/**/*.py', 'console/*', 'console/hidwa_console/*.py')
# What a robot does without: folders that HIDWA_TOOLS adds, and pictures.
TOOLS = ('lab/', 'launch/demo.launch', 'launch/two_robots.launch',
         'scripts/lib/hidwa_tools/figure.py', 'scripts/lib/hidwa_measure_base/picture.py')
WITH_TOOLS, WITH_MBF = '$HIDWA_WITH_TOOLS == 1', '$HIDWA_WITH_MBF == 1'
SYSTEM = {'sys', 'Threads'}       # of the compiler and of CMake
OWN = {NAME, 'hidwa_tools', 'hidwa_bag_test', 'hidwa_console', 'hidwa_measure_base', 'joy_reader', 'quest2ros_joy', 'command_watch',
       'message_gate', 'running_host', 'console_frames'}
OPTIONAL = {'rviz', 'robot_state_publisher', 'benchmark'}  # to look at, and to measure: a robot needs neither


def read(path):
    with open(os.path.join(ROOT, path), encoding='utf-8') as text:
        return text.read()


def files(*patterns):
    return sorted(path for pattern in patterns for path in glob.glob(os.path.join(ROOT, pattern), recursive=True)
                  if os.path.isfile(path))


def of_robot(paths):
    """Those of the paths that are not the tools'."""
    return [path for path in paths if not os.path.relpath(path, ROOT).startswith(TOOLS)]


# In what follows `which` takes the paths of files and returns those that count.


def headers(*folders, which=list):
    """Folders of what is included in angle brackets; of a header in no folder its own name, if it is no system header."""
    found = set()
    for path in which(files(*(f'{folder}/**/*.[ch]pp' for folder in folders))):
        for name in re.findall(r'^#include <([\w.-]+/|zlib\.h)', read(path), re.MULTILINE):
            found.add(name.rstrip('/'))
    if 'rosbag' in found:
        found = found - {'rosbag'} | {'rosbag.h'}  # the library; the tool has another name
    return found


def cmake_packages(which=list):
    """What CMake is asked to find, components of catkin included, but for what only tests need."""
    found = set()
    for path in which(files('CMakeLists.txt', 'cmake/*.cmake', 'src/*/CMakeLists.txt', 'lab/*/CMakeLists.txt')):
        if path.endswith('/gtest.cmake'):
            continue
        text = re.sub(r'#.*', '', read(path))
        found.update(re.findall(r'find_package\((\S+?)[\s)]', text))
        for names in re.findall(r'set\(HIDWA_CATKIN_DEPENDS([^)]*)\)', text) + re.findall(r'COMPONENTS ([^)]*)\)', text):
            found.update(re.findall(r'[a-z]\w+', re.sub(r'\$\{.*?\}', '', names)))
    return found


def is_standard(module):
    """Whether a module comes with Python itself."""
    spec = importlib.util.find_spec(module)
    origin = spec.origin if spec else ''
    if origin in ('built-in', 'frozen'):
        return True
    inside = bool(origin) and origin.startswith(sysconfig.get_paths()['stdlib'] + os.sep)
    return inside and not re.search(r'(dist|site)-packages', origin)


def modules(path):
    """What a Python file imports, wherever in it."""
    for node in ast.walk(ast.parse(read(path))):
        if isinstance(node, ast.Import):
            yield from (alias.name.split('.')[0] for alias in node.names)
        elif isinstance(node, ast.ImportFrom) and node.level == 0:
            yield node.module.split('.')[0]


def imports(*patterns, which=list):
    """Imported modules that neither come with Python nor lie beside the file."""
    found = set()
    for path in which(files(*patterns)):
        if not path.endswith('.py') and 'python3' not in read(path).split('\n', 1)[0]:
            continue
        beside = {os.path.basename(other)[:-3] for other in glob.glob(os.path.join(os.path.dirname(path), '*.py'))}
        found.update(name for name in modules(path) if name not in beside | OWN and not is_standard(name))
    return found


def launched(which=list):
    """Packages of nodes and files that the launch files name."""
    text = '\n'.join(read(path) for path in which(files('launch/**/*.launch')))
    return set(re.findall(r'pkg="(\w+)"', text)) | set(re.findall(r'\$\(find (\w+)\)', text))


def named(names):
    return {OTHER_NAMES.get(name, name) for name in names} - SYSTEM - OWN - OPTIONAL


class PackageXml(unittest.TestCase):
    def setUp(self):
        self.package = xml.parse(os.path.join(ROOT, 'package.xml')).getroot()

    def depends(self, *kinds):
        return {tag.text for kind in kinds for tag in self.package.findall(kind)}

    def test_what_is_compiled_is_a_build_dependency(self):
        needed = named(headers('src', 'lab', 'include') | cmake_packages())
        self.assertIn('rosgraph_msgs', needed)
        self.assertIn('mbf_msgs', needed)
        self.assertEqual(needed - self.depends('depend', 'build_depend', 'buildtool_depend'), set())

    def test_what_is_run_is_an_execution_dependency(self):
        needed = named(imports(*PROGRAMS) | launched())
        self.assertLessEqual({'python3-yaml', 'genpy', 'map_server'}, needed)
        self.assertEqual(needed - self.depends('depend', 'exec_depend'), set())

    def test_what_tests_need_is_a_dependency(self):
        needed = named(imports('test/scripts/*.py', 'test/console/*.py', 'test/unit/*.py', 'test/property/*.py', 'cfg/*.cfg') |
                       headers('test/unit', 'test/oracle'))
        self.assertIn('gtest', needed)
        self.assertEqual(needed - self.depends('depend', 'exec_depend', 'build_depend', 'test_depend'), set())

    def test_nothing_is_named_that_nothing_needs(self):
        # Used as programs, by CMake's macros, and by tests.
        by_name = {'catkin', 'message_generation', 'message_runtime', 'roslaunch', 'gtest'}
        needed = named(headers('src', 'lab', 'include', 'test/unit') | cmake_packages() | launched()
                       | imports(*PROGRAMS, 'test/scripts/*.py', 'test/console/*.py', 'cfg/*.cfg'))
        named_here = self.depends('depend', 'build_depend', 'buildtool_depend', 'exec_depend', 'test_depend')
        self.assertEqual(named_here - needed - by_name, set())

    def test_move_base_flex_and_what_only_tools_need_are_optional_and_nothing_else(self):
        self.assertEqual(self.package.get('format'), '3')
        robot = named(headers('src', 'lab', 'include', which=of_robot) | cmake_packages(of_robot) | launched(of_robot)
                      | imports(*ROBOT_PROGRAMS, *(os.path.join(LIBRARY, name + '.py') for name in installed()), which=of_robot))
        self.assertLessEqual({'costmap_2d', 'map_server', 'rosbag', 'tf2_py', 'python3-tornado'}, robot)
        tools = named(headers('src', 'lab') | cmake_packages() | launched() | imports(*PROGRAMS)) - robot
        self.assertLessEqual({'rosbag_storage', 'yaml-cpp', 'python3-scipy', 'python3-matplotlib'}, tools)
        flex = {name for name in robot if name.startswith('mbf_')}
        for tag in self.package:
            if tag.tag.endswith('depend') and tag.tag != 'test_depend':
                condition = WITH_TOOLS if tag.text in tools else WITH_MBF if tag.text in flex else None
                self.assertEqual(tag.get('condition'), condition, tag.text)

    def test_it_says_who_and_where(self):
        for tag in ('author', 'maintainer', 'url', 'license'):
            self.assertTrue(self.package.find(tag).text, tag)


class Installed(unittest.TestCase):
    """What was installed, where that is in the environment."""

    def setUp(self):
        self.share = next((path for path in os.environ.get('ROS_PACKAGE_PATH', '').split(':')
                           if os.path.exists(os.path.join(path, NAME, 'plugins.xml'))), None)
        if not self.share:
            self.skipTest('nothing is installed in this environment (. scripts/env)')

    def exported(self):
        """What pluginlib is told when it asks for controllers of Move Base Flex."""
        with tempfile.TemporaryDirectory() as folder:
            mbf = os.path.join(folder, 'mbf_costmap_core')
            os.mkdir(mbf)
            with open(os.path.join(mbf, 'package.xml'), 'w', encoding='utf-8') as out:
                out.write('<package format="2"><name>mbf_costmap_core</name><version>0.0.0</version><description>x</description>'
                          '<maintainer email="x@x.org">x</maintainer><license>x</license></package>')
            found = subprocess.run(['rospack', 'plugins', '--attrib=plugin', 'mbf_costmap_core'], check=True, text=True,
                                   stdout=subprocess.PIPE, env={**os.environ, 'ROS_PACKAGE_PATH': f'{folder}:{self.share}'}).stdout
        return [line.split(' ', 1)[1] for line in found.splitlines() if line.startswith(NAME + ' ')]

    def test_the_controller_is_exported_where_it_was_built(self):
        built = os.path.exists(os.path.join(self.share, os.pardir, 'lib', 'libhidwa_mbf_controller.so'))
        self.assertEqual([os.path.exists(path) for path in self.exported()], [True] if built else [])
        self.assertEqual(os.path.exists(os.path.join(self.share, NAME, 'mbf_plugins.xml')), built)


if __name__ == '__main__':
    unittest.main()
