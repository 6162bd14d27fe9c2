# SPDX-License-Identifier: BSD-3-Clause
"""Commands that wait more than they work, a few at once."""
import os
import time

from .processes import Child


def side_by_side(jobs, at_once, folder):
    """Runs (name, command) jobs, `at_once` of them at a time, and yields (name, output) of each as it ends.

    Outputs are kept in `folder`. What still runs ends with the caller's loop."""
    os.makedirs(folder, exist_ok=True)
    waiting, running = list(jobs), {}
    try:
        while waiting or running:
            while waiting and len(running) < at_once:
                name, command = waiting.pop(0)
                path = os.path.join(folder, f'{name}.out')
                open(path, 'wb').close()
                running[name] = Child(command, path, dict(os.environ)), path
            ended = [name for name, (child, _) in running.items() if not child.running]
            for name in ended:
                child, path = running.pop(name)
                child.stop()
                with open(path, encoding='utf-8', errors='replace') as text:
                    yield name, text.read()
            if not ended:
                time.sleep(0.1)
    finally:
        for child, _ in running.values():
            child.stop()
