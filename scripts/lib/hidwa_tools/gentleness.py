# SPDX-License-Identifier: BSD-3-Clause
"""How gently autonomy turned, from its commands: as lab/drive/gentleness.hpp has it."""
import numpy as np

from .drawing import STATE_NAMES

BEND = 0.02      # [rad/s]; from here on omega is a bend
AT_LIMIT = 0.95  # of the limit
FIGURES = ('acc_rms', 'acc_p99', 'bend_acc_rms', 'jerk_rms', 'jerk_p99', 'at_limit', 'bend_at_limit')


def gentleness(commands, states, limit):
    """Root mean square and 99th percentile of the commanded angular acceleration [rad/s^2] and jerk [rad/s^3] over the
    commands (n, 3: time, v, omega) that were sent in AUTONOMY, of those in bends too, and their shares at `limit` [rad/s^2].
    states: (m, 2: time, state). The period is the median one. None where nothing can be said: no commands, no limit."""
    figures = dict.fromkeys(FIGURES)
    if len(commands) < 3:
        return figures
    period = float(np.median(np.diff(commands[:, 0])))
    acc = np.diff(commands[:, 2], prepend=commands[0, 2]) / period
    jerk = np.diff(acc, prepend=0.0) / period
    alone = _in_autonomy(commands[:, 0], states)
    alone[:1] = False  # nobody knows what was before
    bends = alone & (np.abs(commands[:, 2]) >= BEND)
    for name, values, chosen in (('acc', acc, alone), ('jerk', jerk, alone), ('bend_acc', acc, bends)):
        size = np.abs(values[chosen])
        if len(size) == 0:
            continue
        figures[name + '_rms'] = round(float(np.sqrt(np.mean(size ** 2))), 4)
        if name + '_p99' in figures:
            figures[name + '_p99'] = round(float(np.sort(size)[int(np.ceil(0.99 * len(size))) - 1]), 4)
        if limit and name != 'jerk':
            figures[name.replace('acc', '') + 'at_limit'] = round(float(np.mean(size >= AT_LIMIT * limit)), 5)
    return figures


def _in_autonomy(times, states):
    """Whether each time lies in AUTONOMY; where no states are known, all do."""
    if len(states) == 0:
        return np.ones(len(times), bool)
    last = np.searchsorted(states[:, 0], times, side='right') - 1
    return (last < 0) | (states[np.maximum(last, 0), 1] == STATE_NAMES.index('AUTONOMY'))
