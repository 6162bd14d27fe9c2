# SPDX-License-Identifier: BSD-3-Clause
"""scripts/test --long: forms that have passed are not run again, and the weekly workflow runs each."""
import os
import re
import tempfile
import types
import unittest
from unittest import mock

from hidwa_tools import long_forms, sanitize
from hidwa_tools.counting import Counts

ROOT = os.path.abspath(os.path.join(os.path.dirname(__file__), '..', '..'))


class Forms(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.ran, self.counts = [], {'one': Counts(passed=3), 'two': Counts(passed=1, failed=2)}
        self.sources = 'a'

        def form(name):
            def run():
                """What it does."""
                self.ran.append(name)
                return self.counts[name]
            return run
        forms = {name: form(name) for name in self.counts}
        for name, value in {'FOLDER': folder.name, 'FORMS': forms, 'sources': lambda: self.sources}.items():
            patch = mock.patch.object(long_forms, name, value)
            patch.start()
            self.addCleanup(patch.stop)

    def run_forms(self, *names, anew=False):
        """(exit status, forms that ran)."""
        self.ran = []
        status = long_forms.main(None, types.SimpleNamespace(names=list(names), anew=anew))
        return status, self.ran

    def test_what_has_passed_is_kept_and_what_has_failed_runs_again(self):
        self.assertEqual(self.run_forms(), (1, ['one', 'two']))
        self.counts['two'] = Counts(passed=3)
        self.assertEqual(self.run_forms(), (0, ['two']))
        self.assertEqual(self.run_forms(), (0, []))

    def test_other_sources_or_the_wish_make_it_run_again(self):
        self.assertEqual(self.run_forms('one'), (0, ['one']))
        self.assertEqual(self.run_forms('one', anew=True), (0, ['one']))
        self.sources = 'b'
        self.assertEqual(self.run_forms('one'), (0, ['one']))

    def test_the_table_has_a_row_a_form(self):
        self.run_forms()
        rows = [[cell.strip() for cell in line.strip('|').split('|')] for line in long_forms.table(['one', 'two'])[2:]]
        self.assertEqual([row[:4] + row[5:6] for row in rows], [['one', '3', '0', '0', 'a'], ['two', '1', '2', '0', 'a']])


class Builds(unittest.TestCase):
    def test_each_form_without_ros_configures_builds_and_tests(self):
        for name in ('plain', *sanitize.FORMS):
            commands = []
            with mock.patch.object(long_forms.tests, 'run', lambda log, *command, **more: commands.append(command)), \
                 mock.patch.object(long_forms.tests, 'ctest', lambda *arguments, **more: (Counts(passed=1), [])), \
                 mock.patch.object(sanitize.compilers, 'fuzzes', lambda compiler: True):
                self.assertEqual(long_forms.FORMS[name](), Counts(passed=1), name)
            self.assertEqual([command[:2] for command in commands], [('cmake', '-S'), ('cmake', '--build')], name)


class Weekly(unittest.TestCase):
    def test_every_form_is_in_the_workflow(self):
        with open(os.path.join(ROOT, '.github', 'workflows', 'weekly.yml'), encoding='utf-8') as text:
            listed = re.search(r'form: \[([^]]*)\]', text.read()).group(1)
        self.assertEqual(re.split(r',\s*', listed), list(long_forms.FORMS))


if __name__ == '__main__':
    unittest.main()
