# SPDX-License-Identifier: BSD-3-Clause
"""Poses (x, y, yaw) [m, m, rad] in the plane."""
import math

import numpy as np


def composed(outer, inner):
    """The pose `inner`, given in the frame whose pose is `outer`, in that pose's frame."""
    x, y, yaw = outer
    c, s = math.cos(yaw), math.sin(yaw)
    return (x + c * inner[0] - s * inner[1], y + s * inner[0] + c * inner[1], yaw + inner[2])


def moved(outer, points):
    """The same for an array of rows x, y."""
    x, y, yaw = outer
    c, s = math.cos(yaw), math.sin(yaw)
    return np.asarray(points) @ np.array([[c, s], [-s, c]]) + (x, y)


def inverse(pose):
    """The pose of the outer frame in this one."""
    x, y, yaw = pose
    c, s = math.cos(yaw), math.sin(yaw)
    return (-c * x - s * y, s * x - c * y, -yaw)


def rounded(values, digits=3):
    """As a list that is short as JSON."""
    return [round(float(v), digits) for v in values]
