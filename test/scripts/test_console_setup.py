# SPDX-License-Identifier: BSD-3-Clause
"""Setting up the operator's page: the lock file is one that npm 6 and its successors read, and without npm there is the plain form."""
import json
import os
import subprocess
import tempfile
import unittest

ROOT = os.path.abspath(os.path.join(os.path.dirname(os.path.abspath(__file__)), '..', '..'))
LOCK = os.path.join(ROOT, 'console', 'package-lock.json')
# Programs that the shell library needs; npm is none of them.
NEEDED = ('bash', 'dirname', 'pwd', 'sed', 'grep', 'mkdir', 'cp', 'rm', 'cat')


def read(*path):
    with open(os.path.join(*path), encoding='utf-8') as text:
        return json.load(text)


class Lock(unittest.TestCase):
    def test_npm_6_reads_it(self):
        # npm 6 reads `dependencies`, which version 3 leaves out; its successors read `packages`.
        lock, wanted = read(LOCK), read(ROOT, 'console', 'package.json')
        self.assertIn(lock['lockfileVersion'], (1, 2))
        for name, version in {**wanted['dependencies'], **wanted['devDependencies']}.items():
            self.assertEqual(lock['dependencies'][name]['version'], version)
            self.assertEqual(lock['packages']['node_modules/' + name]['version'], version)
            self.assertTrue(lock['dependencies'][name]['integrity'].startswith('sha512-'))
            self.assertEqual(lock['dependencies'][name].get('dev', False), name in wanted['devDependencies'])

    def test_it_names_no_host(self):
        with open(LOCK, encoding='utf-8') as text:
            self.assertNotIn('"resolved"', text.read())  # whoever has a registry of their own uses that


class Setup(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name
        self.bin = os.path.join(self.folder, 'bin')
        os.mkdir(self.bin)
        for name in NEEDED:
            found = next(os.path.join(place, name) for place in ('/bin', '/usr/bin') if os.path.exists(os.path.join(place, name)))
            os.symlink(found, os.path.join(self.bin, name))
        self.space = os.path.join(self.folder, 'space')

    def npm(self, script):
        """A npm that does as the script says, and notes how it was called."""
        path = os.path.join(self.bin, 'npm')
        with open(path, 'w', encoding='utf-8') as out:
            out.write(f'#!/bin/bash\necho "$NODE_ENV $*" >> {self.folder}/called\n{script}\n')
        os.chmod(path, 0o755)

    def libraries(self, *arguments, install='yes', function='hidwa_console_libraries'):
        script = f'. "$ROOT/scripts/lib/common.sh"; . "$HIDWA_LIB/packages.sh"; . "$HIDWA_LIB/console.sh"; {function} "$@"'
        done = subprocess.run(['/bin/bash', '-c', 'set -euo pipefail; ' + script, 'setup', *arguments], stdout=subprocess.PIPE,
                              stderr=subprocess.STDOUT, text=True,
                              env={'PATH': self.bin, 'ROOT': ROOT, 'HOME': self.folder, 'HIDWA_SPACE': self.space,
                                   'HIDWA_INSTALL': install})
        return done.returncode, done.stdout

    def called(self):
        path = os.path.join(self.folder, 'called')
        if not os.path.exists(path):
            return []
        with open(path, encoding='utf-8') as text:
            return text.read().splitlines()

    def test_without_npm_it_says_so_and_goes_on(self):
        status, said = self.libraries()
        self.assertEqual(status, 0, said)
        self.assertIn('without its view from on board', said)

    def test_npm_that_fails_is_no_end(self):
        self.npm('exit 1')
        status, said = self.libraries()
        self.assertEqual(status, 0, said)
        self.assertIn('npm could not install them', said)
        self.libraries()
        self.assertEqual(len(self.called()), 2, 'it is tried again')

    def test_once_is_enough_and_for_the_tests_there_is_more(self):
        self.npm('exit 0')
        for arguments, calls in (((), 1), ((), 1), (('dev',), 2), ((), 2), (('dev',), 2)):
            status, said = self.libraries(*arguments)
            self.assertEqual((status, len(self.called())), (0, calls), said)
        self.assertEqual([line.split()[0] for line in self.called()], ['production', 'development'])
        self.assertTrue(all('--ignore-scripts' in line for line in self.called()), 'nothing of a package is run')

    def test_nothing_is_installed_where_that_is_not_wanted(self):
        self.npm('exit 0')
        status, said = self.libraries(install='no')
        self.assertEqual((status, self.called()), (2, []), said)

    def test_a_build_is_needed_where_the_libraries_came_after_it(self):
        def installed():
            return self.libraries(function='hidwa_console_installed')[0] == 0
        self.assertTrue(installed(), 'npm brought nothing')
        os.makedirs(os.path.join(self.space, 'build', 'console', 'node_modules', 'three'))
        self.assertFalse(installed())
        os.makedirs(os.path.join(self.space, 'install', 'share', 'hidwa_local_planner', 'console', 'lib', 'three'))
        self.assertTrue(installed())


if __name__ == '__main__':
    unittest.main()
