# SPDX-License-Identifier: BSD-3-Clause
"""What the robot is and can do, from the parameters that the planner runs with."""
import json

import numpy as np

from .description import LIMITS
from .errors import BagTestError


class Robot:
    """From the parameters of move_base and its planner, which are complete once that runs."""

    def __init__(self, parameters, overrides):
        costmap, planner = parameters.get('local_costmap', {}), parameters.get('HIDWAPlannerROS', {})
        missing = [name for name in (*LIMITS, 'control_latency') if name not in planner]
        if missing:
            raise BagTestError(f'the planner has not put {", ".join(missing)} on the parameter server: does it run as '
                               'HIDWAPlannerROS in move_base? Include bag_test.launch')
        self.limits = {name: float(overrides.get(name, planner[name])) for name in LIMITS}
        self.latency = float(planner['control_latency'])
        self.decel = tuple(abs(self.limits['decel_lim_' + a]) or self.limits['acc_lim_' + a] for a in ('x', 'theta'))
        self.period = 1.0 / (planner.get('controller_frequency') or parameters.get('controller_frequency', 20.0))
        self.footprint = footprint_of(costmap)


def footprint_of(costmap):
    """The outline (n, 2) [m] that a costmap's parameters give, without padding."""
    outline = costmap.get('footprint')
    if isinstance(outline, str):
        outline = json.loads(outline)
    if outline:
        return np.array(outline, float)
    radius = costmap.get('robot_radius')
    if not radius:
        raise BagTestError('the local costmap has neither footprint nor robot_radius: give bag_test.launch a footprint file')
    angles = np.radians(np.arange(0, 360, 22.5))
    return radius * np.column_stack([np.cos(angles), np.sin(angles)])


def radius_of(footprint):
    """Of the circle around the outline (n, 2) [m]."""
    return float(np.hypot(*footprint.T).max())
