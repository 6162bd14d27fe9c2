# SPDX-License-Identifier: BSD-3-Clause
"""What keeps a bag test from running."""


class BagTestError(Exception):
    """One line that names the thing and the remedy."""
