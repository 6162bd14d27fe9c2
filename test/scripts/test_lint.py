# SPDX-License-Identifier: BSD-3-Clause
"""scripts/lint: what it finds, what it leaves out."""
import contextlib
import io
import os
import shutil
import subprocess
import sys
import tempfile
import unittest
from unittest import mock

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), '..', '..', 'scripts', 'lib'))
from hidwa_tools import lint


class Lint(unittest.TestCase):
    """On a repository with one file of each kind."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name
        shutil.copy(os.path.join(lint.ROOT, '.clang-format'), self.folder)
        os.makedirs(os.path.join(self.folder, 'scripts'))
        self.write('scripts/good', '#!/usr/bin/env bash\ntrue\n')
        self.write('good.cpp', 'int f() { return 1; }\n')
        patch = mock.patch.object(lint, 'ROOT', self.folder)
        patch.start()
        self.addCleanup(patch.stop)

    def write(self, name, content):
        with open(os.path.join(self.folder, name), 'w', encoding='utf-8') as out:
            out.write(content)

    def run_lint(self, tool):
        """((well, found, left out), what was printed) with the files as they are."""
        subprocess.run('git init -q && git add -A', shell=True, cwd=self.folder, check=True)
        with contextlib.redirect_stdout(io.StringIO()) as said:
            names = lint.lint([tool])
        return names, said.getvalue()

    def found_by(self, tool):
        if lint.left_out(tool):
            self.skipTest(f'{tool}: {lint.left_out(tool)}')
        names, said = self.run_lint(tool)
        self.assertEqual(names[2], [])
        return said if names[1] else ''

    def test_without_a_repository_all_files_count_but_what_was_made(self):
        os.makedirs(os.path.join(self.folder, 'build'))
        self.write('build/made.cpp', '')
        self.assertEqual(lint.files('*.cpp', 'scripts/*'), ['good.cpp', 'scripts/good'])
        self.assertEqual(lint.shell_scripts(), ['scripts/good'])

    def test_a_line_that_is_not_formatted(self):
        self.assertEqual(self.found_by('clang-format'), '')
        self.write('bad.cpp', 'int  g( ){return 2;}\n')
        self.assertIn('bad.cpp:1:', self.found_by('clang-format'))

    def test_a_script_with_a_slip(self):
        self.assertEqual(self.found_by('shellcheck'), '')
        self.write('scripts/bad', '#!/usr/bin/env bash\nrm $1\n')
        self.assertIn('SC2086', self.found_by('shellcheck'))

    def test_a_misspelt_word(self):
        self.assertEqual(self.found_by('codespell'), '')
        self.write('README.md', 'It is reci' 'eved.\n')
        self.assertIn('README.md:1:', self.found_by('codespell'))

    def test_a_comment_without_its_noun_and_a_name_that_says_nothing(self):
        os.makedirs(os.path.join(self.folder, 'src'))
        self.write('src/good.hpp', '// Many candidates are kept.\n')
        self.assertEqual(self.found_by('grep'), '')
        self.write('src/bad.hpp', '// So many are kept.\nstruct Kept {};\n')
        self.assertIn('src/bad.hpp:1:', self.found_by('grep'))
        self.assertIn('src/bad.hpp:2:', self.found_by('grep'))

    def test_a_tool_that_is_missing_is_named_and_no_failure(self):
        with mock.patch.object(lint.shutil, 'which', return_value=None):
            names, said = self.run_lint('flake8')
        self.assertEqual(names, ([], [], ['flake8']))
        self.assertEqual(said, 'flake8: left out: not installed\n')

    def test_another_version_of_the_formatter_is_left_out(self):
        with mock.patch.object(lint, 'version_of', return_value=10), \
                mock.patch.object(lint.shutil, 'which', return_value='/usr/bin/clang-format'):
            names, said = self.run_lint('clang-format')
        self.assertEqual(names, ([], [], ['clang-format']))
        self.assertIn('version 14 is needed', said)


if __name__ == '__main__':
    unittest.main()
