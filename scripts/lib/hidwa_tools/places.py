# SPDX-License-Identifier: BSD-3-Clause
"""Where the package is, and where it may be built."""
import os

ROOT = os.environ.get('HIDWA_ROOT', os.path.abspath(os.path.join(os.path.dirname(__file__), '..', '..', '..')))
SPACE = os.environ.get('HIDWA_SPACE', ROOT)  # in its build/
