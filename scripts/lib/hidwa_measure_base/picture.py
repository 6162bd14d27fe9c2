# SPDX-License-Identifier: BSD-3-Clause
"""The step responses as a picture."""
import matplotlib
import numpy as np

from hidwa_tools.drawing import DRIVEN, INK, STEERED_COLOUR

from .track import AXES

matplotlib.use('Agg')
from matplotlib import pyplot  # noqa: E402

UNITS = ('m', 'rad')


def draw(found, path):
    """Each step's measured way and the ramp that explains it, without what was driven evenly before; latencies as lines."""
    if not found.answers:
        return 'There is no picture: the commands have no steps.'
    figure, axes = pyplot.subplots(1, len(found.answers), figsize=(4.5 * len(found.answers), 4.0), squeeze=False)
    for place, (axis, answers) in zip(axes[0], found.answers):
        slows = answers.each[0].step.slows
        for answer in answers.each:
            sign = np.sign(answer.step.before + answer.step.after) or 1.0
            even = np.polyfit(answer.time[answer.time <= 0.0], answer.fitted[answer.time <= 0.0], 1)
            base = np.polyval(even, answer.time)
            place.plot(answer.time, sign * (answer.way - base), '.', color=DRIVEN, markersize=3, alpha=0.6)
            place.plot(answer.time, sign * (answer.fitted - base), '-', color=INK, linewidth=0.6, alpha=0.6)
            place.axvline(answer.latency, color=STEERED_COLOUR, linewidth=0.6, alpha=0.5)
        place.set_title(f'{AXES[axis]}: {"slows down" if slows else "speeds up"}, {answers.rate:.2g} {UNITS[axis]}/s$^2$', fontsize=10)
        place.set_xlabel('time from the command [s]')
        place.set_ylabel(f'way beyond an even drive [{UNITS[axis]}]')
        place.set_xlim(-0.1, 1.0)
    figure.suptitle('measured: dots; explained: lines; latency: red')
    figure.tight_layout()
    figure.savefig(path, dpi=110)
    pyplot.close(figure)
    return f'The picture is {path}.'
