# SPDX-License-Identifier: BSD-3-Clause
"""How long anything is waited for that must come. One limit for all: it costs nothing where all is well."""
import time

PATIENCE = 180.0  # [s], wall time; many times what it takes, also on a slow machine that does much else


def wait_for(condition, patience=PATIENCE):
    """Until `condition` holds; False after `patience` [s] of wall time."""
    deadline = time.monotonic() + patience
    while not condition():
        if time.monotonic() > deadline:
            return False
        time.sleep(0.02)
    return True
