# SPDX-License-Identifier: BSD-3-Clause
"""The page's modules without a browser: each file of page/*.test.mjs is run by Node's own test runner."""
import glob
import json
import os
import shutil
import subprocess
import tempfile
import unittest

import paths

HERE = os.path.dirname(os.path.abspath(__file__))
OLDEST = 18  # node's version that has the runner


def node():
    """Whether there is one that has the runner."""
    if not shutil.which('node'):
        return False
    version = subprocess.run(['node', '--version'], stdout=subprocess.PIPE, universal_newlines=True, check=True).stdout
    return int(version.lstrip('v').split('.')[0]) >= OLDEST


@unittest.skipUnless(node(), f'node {OLDEST} or later is not installed')
class Modules(unittest.TestCase):
    def test_modules(self):
        with tempfile.TemporaryDirectory(prefix='hidwa_page_') as folder:
            page = shutil.copytree(os.path.join(paths.ROOT, 'console', 'page'), os.path.join(folder, 'page'))
            with open(os.path.join(page, 'package.json'), 'w', encoding='utf-8') as out:
                json.dump({'type': 'module'}, out)  # as a browser takes the files
            for file in sorted(glob.glob(os.path.join(HERE, 'page', '*.test.mjs'))):
                with self.subTest(os.path.basename(file)):
                    done = subprocess.run(['node', '--test', file], env={**os.environ, 'HIDWA_PAGE': page}, stdout=subprocess.PIPE,
                                          stderr=subprocess.STDOUT, universal_newlines=True, check=False)
                    self.assertEqual(done.returncode, 0, done.stdout)


if __name__ == '__main__':
    unittest.main()
