# SPDX-License-Identifier: BSD-3-Clause
"""What can go wrong in a way that the user is told, with a remedy."""


class DemoError(Exception):
    """The demo cannot begin or go on."""


class BagError(Exception):
    """The bag does not hold what a report needs."""
