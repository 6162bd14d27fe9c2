# SPDX-License-Identifier: BSD-3-Clause
"""Where the console's parts are, for its tests; import it first."""
import os
import sys

ROOT = os.path.abspath(os.path.join(os.path.dirname(__file__), '..', '..'))
sys.path[0:0] = [os.path.join(ROOT, 'console'), os.path.join(ROOT, 'scripts', 'lib'), os.path.join(ROOT, 'test', 'support')]
