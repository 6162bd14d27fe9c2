# SPDX-License-Identifier: BSD-3-Clause
"""README and docs: links lead somewhere, tables are what the declarations say, the README stays short."""
import glob
import os
import re
import subprocess
import sys
import unittest

ROOT = os.path.abspath(os.path.join(os.path.dirname(os.path.abspath(__file__)), '..', '..'))
LONGEST_README = 250  # lines


def read(path):
    with open(os.path.join(ROOT, path), encoding='utf-8') as text:
        return text.read()


class Documents(unittest.TestCase):
    """As they are in the source tree."""

    def pages(self):
        return ['README.md'] + [os.path.relpath(path, ROOT) for path in sorted(glob.glob(os.path.join(ROOT, 'docs', '*.md')))]

    def test_links_lead_to_files(self):
        broken = []
        for page in self.pages():
            for target in re.findall(r'\]\(([^)#]+)', read(page)):
                if not target.startswith('http') and not os.path.exists(os.path.join(ROOT, os.path.dirname(page), target)):
                    broken.append(f'{page}: {target}')
        self.assertEqual(broken, [])

    def test_the_readme_names_every_page(self):
        readme = read('README.md')
        self.assertEqual([page for page in self.pages()[1:] if page not in readme], [])

    def test_the_readme_is_short(self):
        self.assertLessEqual(len(read('README.md').splitlines()), LONGEST_README)

    def test_the_table_of_parameters_is_what_is_declared(self):
        subprocess.run([sys.executable, os.path.join(ROOT, 'scripts', 'parameter_table'), '--check'], check=True)


if __name__ == '__main__':
    unittest.main()
