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
        for folder in ('src', 'include', 'compat'):
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

    def test_a_change_of_host_starts_from_nothing(self):
        script = ('set -eu; . "$SCRIPTS/lib/common.sh"; . "$SCRIPTS/lib/packages.sh"; . "$SCRIPTS/lib/build.sh"; '
                  'hidwa_keep_or_clean one; touch "$HIDWA_SPACE/build/made"; hidwa_keep_or_clean one; '
                  'ls "$HIDWA_SPACE/build"; hidwa_keep_or_clean two; ls "$HIDWA_SPACE/build" "$HIDWA_SPACE"')
        _, output = self.bash(script)
        before, after = output.split('==> the host changed: building from nothing\n')
        self.assertIn('made', before)
        self.assertNotIn('made', after)
        self.assertNotIn('install', after)


if __name__ == '__main__':
    unittest.main()
