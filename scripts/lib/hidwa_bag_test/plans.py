# SPDX-License-Identifier: BSD-3-Clause
"""Where the planner is to go: recorded plans, the driven way, or a way through what the scan leaves free."""
import math

import numpy as np
from geometry_msgs.msg import PoseStamped
from nav_msgs.msg import Path

SPACING = 0.05     # [m] between two poses
REPLAN = 1.0       # [s]; as move_base does
MARGIN = 0.15      # [m] beside the footprint of a free way
SHORTEST = 0.3     # [m]


def path_message(frame, poses):
    """nav_msgs/Path of poses (n, 3) without a stamp: valid at any time."""
    path = Path()
    path.header.frame_id = frame
    for x, y, yaw in poses:
        pose = PoseStamped()
        pose.header.frame_id = frame
        pose.pose.position.x, pose.pose.position.y = float(x), float(y)
        pose.pose.orientation.z, pose.pose.orientation.w = math.sin(yaw / 2), math.cos(yaw / 2)
        path.poses.append(pose)
    return path


def free_length(points, heading, half_width, longest):
    """How far a strip from the origin along `heading` [rad] is free of points (n, 2) [m]."""
    c, s = math.cos(heading), math.sin(heading)
    along, across = points @ np.array([c, s]), points @ np.array([-s, c])
    ahead = along[(np.abs(across) < half_width) & (along > 0.0)]
    return min(longest, float(ahead.min()) - half_width) if len(ahead) else longest


def free_way(pose, points, radius, longest):
    """Poses (n, 3) straight from `pose` into the free space of the scan, up to `longest` [m]: the longest of the ways
    within a right angle of its heading, the straightest of equals; None where none is worth it."""
    x, y, yaw = pose
    half_width = radius + MARGIN
    relative = points - np.array([x, y])
    headings = yaw + np.radians([0, *(sign * a for a in range(5, 95, 5) for sign in (1, -1))])
    lengths = [free_length(relative, heading, half_width, longest) for heading in headings]
    best = int(np.argmax(lengths))  # the first of equals
    if lengths[best] < SHORTEST:
        return None
    steps = np.arange(0.0, lengths[best] + 1e-9, SPACING)
    return np.column_stack([x + steps * math.cos(headings[best]), y + steps * math.sin(headings[best]),
                            np.full(len(steps), headings[best])])


def driven_way(poses):
    """Of poses (n, 3) those that lie SPACING apart, and the last."""
    kept = [poses[0]]
    for pose in poses[1:]:
        if math.hypot(pose[0] - kept[-1][0], pose[1] - kept[-1][1]) >= SPACING:
            kept.append(pose)
    if tuple(kept[-1]) != tuple(poses[-1]):
        kept.append(poses[-1])
    return np.array(kept)


def plans_of(recording, description, radius):
    """[(time, nav_msgs/Path)] in order."""
    kind, content = next(iter(description.plan.items()))
    if kind == 'topic':
        return [(time, path) for time, path in recording.of(content) if path.poses]
    follower = recording.follow()
    if kind == 'driven':
        poses = []
        for time in np.arange(recording.start, recording.end, 0.1):
            follower.advance(time)
            poses += [follower.pose()] if follower.pose() else []
        return [(recording.start, path_message(description.frame, driven_way(poses)))] if poses else []
    plans = []
    for time in np.arange(recording.start, recording.end, REPLAN):
        follower.advance(time)
        pose = follower.pose()
        way = free_way(pose, follower.points, radius, content) if pose and follower.scan_time else None
        plans += [(time, path_message(description.frame, way))] if way is not None else []
    return plans
