# SPDX-License-Identifier: BSD-3-Clause
"""scripts/env and what the shell scripts share, with workspaces made up for the purpose."""
import os
import re
import subprocess
import tempfile
import unittest

SCRIPTS = os.path.abspath(os.path.join(os.path.dirname(__file__), '..', '..', 'scripts'))
# What colcon's and catkin's setup files do: read variables that are not set, run commands that fail.
SETUP = 'false\n: $THIS_IS_NOT_SET\nfalse\nexport {name}=yes\n'
# What catkin's do, too: without --extend they take what was sourced before out of the environment.
CATKIN_SETUP = 'case " $* " in *" --extend "*) ;; *) export ROS_PACKAGE_PATH=/opt/ros/noetic/share ;; esac\n'


class Shell(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name
        self.space = self.workspace('space', 'install', 'SPACE_SOURCED')
        self.underlay = self.workspace('underlay', '', 'UNDERLAY_SOURCED')

    def workspace(self, name, install, variable):
        path = os.path.join(self.folder, name)
        os.makedirs(os.path.join(path, install))
        with open(os.path.join(path, install, 'setup.bash'), 'w', encoding='utf-8') as out:
            out.write(SETUP.format(name=variable))
        return path

    def write(self, name, text):
        path = os.path.join(self.folder, name)
        os.makedirs(os.path.dirname(path), exist_ok=True)
        with open(path, 'w', encoding='utf-8') as out:
            out.write(text)

    def bash(self, script, **variables):
        """(exit status, output) of a script run far from the source tree."""
        environment = {'PATH': os.environ['PATH'], 'HOME': self.folder, 'HIDWA_NOETIC': os.path.join(self.folder, 'absent'),
                       'SCRIPTS': SCRIPTS, 'HIDWA_SPACE': self.space, **variables}
        done = subprocess.run(['bash', '-c', script], cwd=self.folder, env=environment, stdout=subprocess.PIPE,
                              stderr=subprocess.STDOUT, text=True)
        return done.returncode, done.stdout

    def test_what_was_built_before_is_no_part_of_the_host(self):
        install = os.path.join(self.space, 'install')
        script = 'set -eu; . "$SCRIPTS/lib/common.sh"; hidwa_clean_path; echo "$ROS_PACKAGE_PATH|$CMAKE_PREFIX_PATH|$PYTHONPATH"'
        status, output = self.bash(script, ROS_PACKAGE_PATH=f'{install}/share:/other/share:/usr/share',
                                   CMAKE_PREFIX_PATH=f'/other:{install}', PYTHONPATH=f'{install}/lib/python3/dist-packages')
        self.assertEqual((status, output), (0, '/other/share:/usr/share|/other|\n'))
        status, output = self.bash(script, ROS_PACKAGE_PATH=f'{install}er/share:/a b', CMAKE_PREFIX_PATH='', PYTHONPATH='x')
        self.assertEqual((status, output), (0, f'{install}er/share:/a b||x\n'))

    def test_env_under_strict_options(self):
        status, output = self.bash('set -eu; . "$SCRIPTS/env"; echo "$SPACE_SOURCED $-"; echo "${NOT_SET}"; echo on')
        self.assertIn('yes', output)
        self.assertNotIn('\non', output)  # nounset is in force again
        self.assertNotEqual(status, 0)
        status, output = self.bash('set -eu; . "$SCRIPTS/env"; false; echo on')
        self.assertNotIn('on', output.split())  # so is errexit
        self.assertNotEqual(status, 0)

    def test_env_leaves_lax_options_lax_and_nothing_but_its_own_names(self):
        status, output = self.bash('. "$SCRIPTS/env"; false; echo "${NOT_SET}on"; type say fail 2>/dev/null; true')
        self.assertEqual((status, output), (0, 'on\n'))

    def test_env_takes_an_underlay(self):
        _, output = self.bash('. "$SCRIPTS/env"; echo "$UNDERLAY_SOURCED"', HIDWA_UNDERLAY=self.underlay)
        self.assertEqual(output, 'yes\n')
        status, output = self.bash('set -e; . "$SCRIPTS/env"; echo on', HIDWA_UNDERLAY=self.folder)
        self.assertNotEqual(status, 0)
        self.assertIn(f'HIDWA_UNDERLAY={self.folder} holds no setup.bash', output)

    def test_env_says_when_nothing_is_built_or_it_is_run(self):
        status, output = self.bash('set -e; . "$SCRIPTS/env"; echo on', HIDWA_SPACE=self.folder)
        self.assertNotEqual(status, 0)
        self.assertIn('run scripts/build first', output)
        status, output = self.bash('bash "$SCRIPTS/env"')
        self.assertEqual(status, 2)
        self.assertIn('is to be sourced', output)

    def test_another_python_goes_out_of_path(self):
        mine, plain = os.path.join(self.folder, 'shims'), os.path.join(self.folder, 'tools')
        for path, name in ((mine, 'python3'), (plain, 'other')):
            os.mkdir(path)
            with open(os.path.join(path, name), 'w', encoding='utf-8') as out:
                out.write('#!/bin/sh\necho shim\n')
            os.chmod(os.path.join(path, name), 0o755)
        _, output = self.bash('. "$SCRIPTS/env"; . "$SCRIPTS/env"; command -v python3; command -v other; echo "$PATH"',
                              PATH=f'{mine}:{plain}:{os.environ["PATH"]}')
        python, other, path = output.splitlines()
        self.assertEqual((python, other), ('/usr/bin/python3', os.path.join(plain, 'other')))
        entries = path.split(':')
        self.assertNotIn(mine, entries)
        self.assertEqual(len(entries), len(set(entries)))

    def test_packages_that_are_missing_are_named_and_nothing_is_installed_when_told_not_to(self):
        script = ('set -euo pipefail; . "$SCRIPTS/lib/common.sh"; . "$SCRIPTS/lib/packages.sh"; '
                  'HIDWA_DEBIAN_RUN="bash no-such-package-here"; hidwa_install run')
        status, output = self.bash(script, HIDWA_INSTALL='no')
        self.assertEqual(status, 2)
        self.assertIn('no-such-package-here', output)
        self.assertNotIn(' bash ', output)

    def test_every_message_that_a_node_speaks_can_be_echoed_on_debian(self):
        spoken, root = set(), os.path.dirname(SCRIPTS)
        for folder in ('src', 'lab', 'include', 'compat'):
            for place, _, names in os.walk(os.path.join(root, folder)):
                for name in names:
                    with open(os.path.join(place, name), encoding='utf-8', errors='replace') as text:
                        spoken.update(re.findall(r'#include [<"](\w+_msgs|diagnostic_updater|dynamic_reconfigure)/', text.read()))
        self.assertGreater(len(spoken), 8)
        spoken -= {'mbf_msgs', 'tf2_geometry_msgs'}  # no Debian package; no messages
        spoken = {'diagnostic_msgs' if name == 'diagnostic_updater' else name for name in spoken}
        script = '. "$SCRIPTS/lib/common.sh"; . "$SCRIPTS/lib/packages.sh"; hidwa_packages run'
        installed = self.bash(script)[1].split()
        self.assertEqual([name for name in sorted(spoken) if 'python3-' + name.replace('_', '-') not in installed], [])

    def test_another_host_takes_what_depends_on_it_and_leaves_the_rest(self):
        cache = 'costmap_2d_DIR:PATH=/real/share\nHIDWA_TESTS:BOOL=ON\nhidwa_BINARY_DIR:STATIC=/b\n'
        self.write('space/build/hidwa_local_planner/CMakeCache.txt', cache)
        for name in ('hidwa_local_planner/core.o', 'hidwa_local_planner/cmake_args.last', 'costmap_2d/made.o', 'tests/ros/made.o',
                     'tests/plain/made.o', 'bench/made.o'):
            self.write(f'space/build/{name}', '')
        script = ('set -eu; . "$SCRIPTS/lib/common.sh"; . "$SCRIPTS/lib/packages.sh"; . "$SCRIPTS/lib/build.sh"; '
                  'hidwa_take_host one; hidwa_take_host one; cd "$HIDWA_SPACE"; find . -type f | sort; hidwa_take_host two; '
                  'find . -type f | sort; cat build/hidwa_local_planner/CMakeCache.txt')
        status, output = self.bash(script)
        self.assertEqual(status, 0, output)
        before, after = output.split('==> the host changed: building anew what depends on it\n')
        self.assertIn('./build/costmap_2d/made.o', before)
        self.assertEqual(after.splitlines(), [
            './build/bench/made.o', './build/hidwa_local_planner/CMakeCache.txt', './build/hidwa_local_planner/core.o',
            './build/host', './build/tests/plain/made.o', 'costmap_2d_DIR:PATH=costmap_2d_DIR-NOTFOUND', 'HIDWA_TESTS:BOOL=ON',
            'hidwa_BINARY_DIR:STATIC=/b'])

    def test_a_first_build_leaves_study_replay_and_tests_out_and_a_later_one_keeps_them(self):
        self.write('tools/colcon', '#!/bin/sh\necho "$@" > "$HIDWA_SPACE/arguments"\n')
        os.chmod(os.path.join(self.folder, 'tools', 'colcon'), 0o755)
        script = ('set -euo pipefail; . "$SCRIPTS/lib/common.sh"; . "$SCRIPTS/lib/packages.sh"; . "$SCRIPTS/lib/build.sh"; '
                  'hidwa_build; cat "$HIDWA_SPACE/arguments"')
        path = f'{self.folder}/tools:{os.environ["PATH"]}'
        _, first = self.bash(script, PATH=path)
        self.assertIn('-DHIDWA_TESTS=OFF -DCOMPAT_TESTS=OFF -DHIDWA_TOOLS=demo', first)
        self.write('space/build/hidwa_local_planner/CMakeCache.txt', 'HIDWA_TESTS:BOOL=ON\nHIDWA_TOOLS:STRING=demo\n')
        _, tested = self.bash(script, PATH=path)
        self.assertNotIn('HIDWA_TESTS', tested)
        self.assertIn('-DHIDWA_TOOLS=demo', tested)
        self.write('space/build/hidwa_local_planner/CMakeCache.txt', 'HIDWA_TESTS:BOOL=OFF\nHIDWA_TOOLS:BOOL=ON\n')
        self.assertNotIn('HIDWA_TOOLS', self.bash(script, PATH=path)[1])

    def test_without_colcon_catkin_builds_the_same_packages_with_the_same_arguments(self):
        self.write('packages/one/package.xml', '')
        self.write('packages/two/package.xml', '')
        self.write('space/build/source/gone/package.xml', '')  # of an earlier build
        script = ('set -euo pipefail; . "$SCRIPTS/lib/common.sh"; . "$SCRIPTS/lib/packages.sh"; . "$SCRIPTS/lib/build.sh"; '
                  'command() { [ "$2" != colcon ]; }; '  # as where it is not installed
                  'catkin_make_isolated() { ls build/source/*/package.xml; echo "$@" >&2; return "$STATUS"; }; '
                  'hidwa_workspace "$HIDWA_SPACE" "$PWD/packages/one" "$PWD/packages/two" -- -DA=1 "-DB=2 3" || echo "status $?"; '
                  'cat log/latest_build/stdout_stderr.log')
        status, output = self.bash(script, STATUS='0')
        said = ('build/source/one/package.xml\nbuild/source/two/package.xml\n'
                '--source build/source --build build --devel build/devel --merge --install --install-space install '
                '--catkin-make-args all tests --cmake-args -DA=1 -DB=2 3\n')
        self.assertEqual((status, output), (0, said + said))  # said, and kept in the log
        self.assertIn('status 5\n', self.bash(script, STATUS='5')[1])

    def test_the_host_is_known_by_where_its_packages_lie(self):
        self.write('tools/rospack', '#!/bin/sh\n[ "$2" = move_base ] && echo /mine/share/move_base\n')
        os.chmod(os.path.join(self.folder, 'tools', 'rospack'), 0o755)
        _, output = self.bash('. "$SCRIPTS/lib/common.sh"; hidwa_host', PATH=f'{self.folder}/tools:{os.environ["PATH"]}')
        self.assertEqual(output, 'nav_core compat\ncostmap_2d compat\nmap_server compat\nmove_base /mine/share/move_base\n')

    def test_warnings_are_errors_with_gcc_12_alone(self):
        script = '. "$SCRIPTS/lib/common.sh"; hidwa_werror'
        for version, expected in (('9', 'OFF'), ('12', 'ON'), ('14', 'OFF')):
            self.write('tools/compiler', f'#!/bin/sh\n[ "$1" = -dumpversion ] && echo {version}\n')
            compiler = os.path.join(self.folder, 'tools', 'compiler')
            os.chmod(compiler, 0o755)
            self.assertEqual(self.bash(script, CXX=compiler)[1], expected + '\n')
            self.assertEqual(self.bash(script, CXX=compiler, HIDWA_WERROR='ON')[1], 'ON\n')
            self.assertEqual(self.bash(script, CXX=compiler, HIDWA_WERROR='OFF')[1], 'OFF\n')

    def test_workspaces_that_were_sourced_before_stay(self):
        for setup in ('noetic/setup.bash', 'underlay/setup.bash', 'space/install/setup.bash'):
            self.write(setup, CATKIN_SETUP)
        script = 'set -eu; . "$SCRIPTS/{}"; echo "$ROS_PACKAGE_PATH $EDITOR"'
        overlay = {'ROS_PACKAGE_PATH': '/home/me/catkin_ws/src', 'EDITOR': 'mine'}
        for file, more in (('env', {}), ('env', {'HIDWA_UNDERLAY': self.underlay}),
                           ('lib/common.sh"; hidwa_clean_path; hidwa_underlay; : "', {'HIDWA_UNDERLAY': self.underlay})):
            _, output = self.bash(script.format(file), HIDWA_NOETIC=os.path.join(self.folder, 'noetic'), **overlay, **more)
            self.assertEqual(output, '/home/me/catkin_ws/src mine\n', file)


if __name__ == '__main__':
    unittest.main()
