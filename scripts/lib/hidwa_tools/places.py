# SPDX-License-Identifier: BSD-3-Clause
"""Where the package is, where it may be built, and where real data are."""
import os

ROOT = os.environ.get('HIDWA_ROOT', os.path.abspath(os.path.join(os.path.dirname(__file__), '..', '..', '..')))
SPACE = os.environ.get('HIDWA_SPACE', ROOT)  # in its build/
DATA = os.path.abspath(os.environ.get('HIDWA_DATA', os.path.join(ROOT, '..', 'shared', 'data')))
