# SPDX-License-Identifier: BSD-3-Clause
"""The figures of a drive, from what its bag holds and nothing else."""
import numpy as np

from . import geometry
from .drawing import STATE_NAMES, STEERED
from .gentleness import gentleness
from .people import measure_people

CONTACT_STEP = 0.01     # [s]; between recorded poses the drive is followed in steps no longer than this
AFTER_RELEASE = 4.0     # [s]; how long after a release the path still counts as bent by it
FAR = 1.0               # [m]; up to here distances to obstacles are measured, as in lab/drive/result.hpp
CLEARANCE_STEP = 0.1    # [s]
LONGEST_GAP = 0.35      # [s], simulated; between two commands, where a machine keeps up
LONGEST_SILENCE = 0.25  # [s]; a state lasts until the next message, but no longer than this


def _fine(truth):
    """Poses (m, 3) along the ground truth (n, 6), no more than CONTACT_STEP apart."""
    time, yaw = truth[:, 0], np.unwrap(truth[:, 3])
    steps = np.maximum(1, np.ceil(np.diff(time) / CONTACT_STEP - 1e-6).astype(int))
    fine = np.concatenate([np.linspace(a, b, n, endpoint=False) for a, b, n in zip(time, time[1:], steps)] + [time[-1:]])
    return np.column_stack([np.interp(fine, time, values) for values in (truth[:, 1], truth[:, 2], yaw)])


def overlaps(grid, footprint, poses):
    """Whether the footprint overlaps or touches an occupied cell, at each of the poses (n, 3)."""
    size = grid.resolution
    reach = np.hypot(footprint[:, 0], footprint[:, 1]).max()
    cells = int(np.ceil(reach / size)) + 1

    def overlap(x, y, yaw):
        column, row = np.floor((np.array([x, y]) - grid.origin) / size).astype(int)
        low = np.maximum([row - cells, column - cells], 0)
        near = np.argwhere(grid.occupied[low[0]:max(row + cells + 1, 0), low[1]:max(column + cells + 1, 0)]) + low
        centres = grid.origin + (near[:, ::-1] + 0.5) * size
        # From a cell's centre to its corner it is half a diagonal.
        centres = centres[np.hypot(centres[:, 0] - x, centres[:, 1] - y) <= reach + size]
        if not len(centres):
            return False
        return bool(geometry.meets_squares(geometry.placed(footprint, x, y, yaw), centres, size).any())

    answers, last, answer = [], None, False
    for pose in poses:
        if last is None or not np.array_equal(pose, last):
            answer, last = overlap(*pose), pose
        answers.append(answer)
    return np.array(answers, bool)


def clearance(grid, footprint, poses, at_most):
    """The smallest distance [m] from the footprint to an occupied cell over the poses (n, 3), at most `at_most`."""
    reach, size = np.hypot(footprint[:, 0], footprint[:, 1]).max(), grid.resolution
    centres = grid.origin + (np.argwhere(grid.occupied)[:, ::-1] + 0.5) * size
    for x, y, yaw in poses:
        near = centres[(np.abs(centres - [x, y]) <= reach + at_most + size).all(axis=1)]
        at_most = min(at_most, geometry.gap_to_squares(geometry.placed(footprint, x, y, yaw), near, size))
    return at_most


def mean_clearance(grid, footprint, truth):
    """The mean distance [m] from the footprint to the nearest occupied cell along the ground truth (n, 6), every
    CLEARANCE_STEP, each at most FAR."""
    times = np.minimum(np.arange(truth[0, 0], truth[-1, 0], CLEARANCE_STEP), truth[-1, 0])  # rounding passes the end
    poses = truth[np.searchsorted(truth[:, 0], times), 1:4]
    return float(np.mean([clearance(grid, footprint, poses[i:i + 1], FAR) for i in range(len(poses))]))


def count_contacts(grid, footprint, truth):
    """Uninterrupted overlaps of the footprint with an occupied cell along the ground truth."""
    touching = overlaps(grid, footprint, _fine(truth))
    return int(touching[0]) + int(np.count_nonzero(touching[1:] & ~touching[:-1]))


def count_regions(regions, footprint, truth):
    """Regions that the footprint touched."""
    poses = _fine(truth)
    reach = np.hypot(footprint[:, 0], footprint[:, 1]).max()
    crossed = 0
    for region in regions:
        near = ((poses[:, :2] > region.min(axis=0) - reach) & (poses[:, :2] < region.max(axis=0) + reach)).all(axis=1)
        crossed += any(geometry.polygons_touch(geometry.placed(footprint, *pose), region) for pose in poses[near])
    return crossed


def deflections(sticks, axis, sign, dead_zone):
    """(start, release, side) of each time the stick was held to one side; side is +1 for left."""
    result, start, side = [], None, 0
    for time, axes in sticks:
        value = axes[axis] * sign if axis < len(axes) else 0.0
        now = int(np.sign(value)) if abs(value) > dead_zone else 0
        if now != side:
            if side:
                result.append((start, time, side))
            start, side = time, now
    if side:
        result.append((start, sticks[-1][0], side))
    return result


def operator_shift(drive, side):
    """How far the driven path departs to one side (+1: left) from the first planned path between a deflection to
    that side and 4 s after its release, relative to where it was at the deflection; the largest [m]."""
    stick = drive.info.get('stick', {})
    held = deflections(drive.sticks, stick.get('axis', 0), stick.get('sign', 1), stick.get('dead_zone', 0.1))
    held = [h for h in held if drive.goal_time <= h[0] <= drive.result_time]
    plan, truth = first_plan(drive), drive.driven()
    if plan is None or not held or len(truth) == 0:
        return 0.0
    offset = side * geometry.PathOffset(plan).of(truth[:, 1:3])
    largest = 0.0
    for start, release, to in held:
        if to != side:
            continue
        back = [other[0] for other in held if other[0] >= release and other[2] != side]
        window = offset[(truth[:, 0] >= start) & (truth[:, 0] <= min([release + AFTER_RELEASE, *back]))]
        if len(window):
            largest = max(largest, float(window.max() - window[0]))
    return largest


def first_plan(drive):
    """The path (n, 2) that was planned first for the goal, or None."""
    plans = [points for time, points in drive.plans if time >= drive.goal_time]
    return plans[0] if plans else None


def _seconds(states, which):
    """Time [s] spent in those of the states (rows, time first) that the mask `which` names."""
    lasted = np.minimum(np.diff(states[:, 0], append=states[-1:, 0]), LONGEST_SILENCE)
    return round(float(lasted[which].sum()), 3)


def state_seconds(drive):
    """Time [s] spent in each of the operator's states between goal and result."""
    states = drive.during(drive.states)
    return {name: _seconds(states, states[:, 1] == i) for i, name in enumerate(STATE_NAMES)}


def driven_without_goal(drive):
    """Time [s] in which the person drove without a goal, in the whole bag: it is between goals. None where nothing tells the
    states."""
    states = drive.states
    return _seconds(states, (states[:, 1] == STATE_NAMES.index('MANUAL')) & (states[:, 4] != 0.0)) if len(states) else None


def cycle_times(drive):
    """Percentiles of the control cycle's duration [microseconds]; None where no cycle was recorded."""
    if len(drive.cycles) == 0:
        return {'p50': None, 'p99': None, 'max': None}
    p50, p99, longest = np.percentile(drive.cycles[:, 1] * 1e6, [50, 99, 100])
    return {'p50': round(p50, 1), 'p99': round(p99, 1), 'max': round(longest, 1)}


def longest_gap(drive):
    """The longest simulated time [s] between two control cycles; None where there are not two. Far above the control
    period, the machine did not keep up with the simulated clock."""
    times = drive.during(drive.cycles)[:, 0]
    return round(float(np.diff(times).max()), 3) if len(times) > 1 else None


def mean_change(values):
    """Mean absolute change from one to the next; None where there are not two."""
    return round(float(np.abs(np.diff(values)).mean()), 5) if len(values) > 1 else None


def measure(drive):
    """report.json, as a dict."""
    truth, info, plan = drive.driven(), drive.info, first_plan(drive)
    if len(truth) < 2:
        raise ValueError(f'the bag holds no {drive.pose_from} between goal and result')
    commands = drive.during(drive.commands)
    seconds = state_seconds(drive)
    known = drive.demo or len(drive.states) > 0  # what the person did
    shifts = (drive.demo or (known and len(drive.sticks) > 0)) and (drive.demo or plan is not None)
    report = {
        'arrived': drive.arrived,
        'outcome': drive.result_text,
        'duration_s': round(drive.result_time - drive.goal_time, 3),
        'path_length_m': round(geometry.path_length(truth[:, 1:3]), 3),
        'planned_length_m': round(geometry.path_length(plan), 3) if plan is not None else None,
        'contacts': count_contacts(drive.grid, drive.footprint, truth) if drive.contacts_known else None,
        **people_figures(drive, truth),
        'regions_crossed': count_regions(drive.regions, drive.footprint, truth) if _regions_known(drive) else None,
        'regions': len(drive.regions) if _regions_known(drive) else None,
        'operator_active_s': round(sum(seconds[name] for name in STEERED), 3) if known else None,
        'operator_shift_left_m': round(operator_shift(drive, 1), 3) if shifts else None,
        'operator_shift_right_m': round(operator_shift(drive, -1), 3) if shifts else None,
        'state_s': seconds if known else None,
        'cycles': len(drive.cycles),
        'cycle_us': cycle_times(drive),
        'longest_gap_s': longest_gap(drive),
        'mean_omega_change': mean_change(commands[:, 2]),
        'turns': gentleness(commands, drive.states, info.get('acc_lim_theta')),
        'mean_clearance_m': round(mean_clearance(drive.grid, drive.footprint, truth), 3) if drive.contacts_known else None,
        'simulator': drive.simulator,
        **{key: info.get(key) for key in ('map', 'mode', 'host', 'planner', 'operator', 'start', 'goal', 'rate')},
    }
    return report if drive.demo else {**report, **_of_real_drive(drive)}


def people_figures(drive, truth):
    """The figures of people.measure_people; None each where the bag does not say who was around, or how the robot is made."""
    known = drive.footprint is not None and (drive.demo or drive.people)
    figures = measure_people(drive.people if known else [], drive.footprint, truth)
    return figures if known else dict.fromkeys(figures)


def _regions_known(drive):
    return drive.demo or (bool(drive.regions) and drive.footprint is not None)


def _of_real_drive(drive):
    """What a report says besides, where the bag is not the demo's: what rests on what, and what is missing."""
    truth, lacking = drive.driven(), list(drive.lacking)
    contacts = 'by the ground truth and the map' if drive.contacts_known else \
        'not known: that takes the ground truth, a map and the footprint'
    estimate = None
    if drive.footprint is not None:
        distance, scans, inside = drive.seen.clearance(drive.footprint, drive.goal_time, drive.result_time)
        if scans:
            estimate = {'smallest_m': None if distance is None else round(distance, 3), 'scans': scans,
                        'hits_inside_the_outline': inside,
                        'note': 'estimated: from the outline to the nearest laser hit outside it, in the plane of the laser; '
                                'says nothing about what the laser does not see'}
    lacking += [f'no tf from the robot to {frame}: the laser is taken to lie at its centre' for frame in drive.seen.mounting_unknown()]
    return {'mean_speed_m_s': round(float(np.abs(truth[:, 4]).mean()), 3), 'contacts_note': contacts,
            'clearance_estimate': estimate, 'pose_from': drive.pose_from, 'topics': drive.used, 'lacking': lacking,
            'notes': drive.notes}
