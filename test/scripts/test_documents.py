# SPDX-License-Identifier: BSD-3-Clause
"""README and docs: links lead somewhere, tables are what the declarations say, the README stays short."""
import glob
import os
import re
import subprocess
import sys
import unittest

ROOT = os.path.abspath(os.path.join(os.path.dirname(os.path.abspath(__file__)), '..', '..'))
LONGEST_README = 200  # lines


def read(path):
    with open(os.path.join(ROOT, path), encoding='utf-8') as text:
        return text.read()


def headings(text):
    """As links name them: words in small letters, joined by hyphens."""
    return [re.sub(r'[^\w\- ]', '', heading.lower()).strip().replace(' ', '-') for heading in re.findall(r'^#+ (.*)$', text, re.M)]


class Documents(unittest.TestCase):
    """As they are in the source tree."""

    def pages(self):
        return ['README.md'] + [os.path.relpath(path, ROOT) for path in sorted(glob.glob(os.path.join(ROOT, 'docs', '*', '*.md')))]

    def test_links_lead_to_files(self):
        broken = []
        for page in self.pages():
            for target in re.findall(r'\]\(([^)#]+)', read(page)):
                if not target.startswith('http') and not os.path.exists(os.path.join(ROOT, os.path.dirname(page), target)):
                    broken.append(f'{page}: {target}')
        self.assertEqual(broken, [])

    def test_links_lead_to_headings(self):
        broken = []
        for page in self.pages():
            for target, heading in re.findall(r'\]\(([^)#]*)#([^)]+)\)', read(page)):
                path = os.path.normpath(os.path.join(os.path.dirname(page), target)) if target else page
                if not target.startswith('http') and heading not in headings(read(path)):
                    broken.append(f'{page}: {target}#{heading}')
        self.assertEqual(broken, [])

    def test_the_readme_names_every_page(self):
        readme = read('README.md')
        self.assertEqual([page for page in self.pages()[1:] if page not in readme], [])

    def test_the_readme_is_short(self):
        self.assertLessEqual(len(read('README.md').splitlines()), LONGEST_README)

    def test_the_table_of_parameters_is_what_is_declared(self):
        subprocess.run([sys.executable, os.path.join(ROOT, 'scripts', 'parameter_table'), '--check'], check=True)


class Updates(unittest.TestCase):
    """docs/use/updates.md: the newest row of each parameter says what it is now."""

    def assert_current(self, part, column, defaults):
        """Of the rows of a part, the cell in `column` is the default where it is a number."""
        newest = {}
        for row in re.findall(r'^\| \d.*$', part, re.M):
            cells = [cell.strip() for cell in row.strip('|').split('|')]
            newest.setdefault(cells[1].strip('`'), cells[column])
        self.assertGreater(len(newest), 4)
        for name, value in newest.items():
            self.assertIn(name, defaults)
            if re.fullmatch(r'[-\d.]+', value):
                self.assertEqual(float(value), float(defaults[name]), name)

    def test_defaults_are_those_of_today(self):
        planner, tracker = (read('docs/use/updates.md').split(f'## Defaults of the {whose}')[1].split('\n## ')[0]
                            for whose in ('planner', 'tracker'))
        listed = dict(re.findall(r'HIDWA_(?:(?:DOUBLE|INT|BOOL|STRING)\(|ENUM\(\w+, )(\w+),\s*("[^"]*"|[^,]+),',
                                 read('include/hidwa_local_planner/core/parameter_list.inc')))
        changed, new = planner.split('New parameters')
        self.assert_current(changed, 3, listed)
        self.assert_current(new, 2, listed)
        settings = read('src/tracking/tracker_settings.hpp')
        self.assert_current(tracker, 3, dict(re.findall(r'^  double (\w+) = ([^;]+);', settings, re.M)))


if __name__ == '__main__':
    unittest.main()
