# SPDX-License-Identifier: BSD-3-Clause
"""Where the parts are that these tests share with others; import it first."""
import os
import sys

ROOT = os.path.abspath(os.path.join(os.path.dirname(os.path.realpath(__file__)), *4 * ('..',)))
sys.path[0:0] = [os.path.join(ROOT, 'test', 'support'), os.path.join(ROOT, 'scripts', 'lib')]
