# SPDX-License-Identifier: BSD-3-Clause
"""People around a simulated robot: their ways, who was near, and touches, out of the true states that a bag holds."""
from dataclasses import dataclass

import numpy as np

from . import geometry

MOVES = 0.01           # [m/s], of the robot's outermost point: faster, it moves
PERSONAL_SPACE = 0.5   # [m]


@dataclass
class Person:
    """One person's way."""
    track: np.ndarray  # (n, 3): time, x, y [s, m, m], map frame
    radius: float      # [m]

    def at(self, times):
        """Positions (n, 2) at the times, on the straight line between two messages."""
        return np.column_stack([np.interp(times, self.track[:, 0], self.track[:, k]) for k in (1, 2)])


def read_people(messages):
    """[Person, ...] of the messages [(time, MovingObstacles), ...], by id."""
    tracks, radii = {}, {}
    for _, message in messages:
        time = message.header.stamp.to_sec()
        for obstacle in message.obstacles:
            tracks.setdefault(obstacle.id, []).append((time, obstacle.position.x, obstacle.position.y))
            radii[obstacle.id] = obstacle.radius
    return [Person(np.array(tracks[key], float), radii[key]) for key in sorted(tracks)]


def gaps(footprint, truth, person):
    """Free space [m] between the outline and the person's disc at each row of the truth (n, 6); 0 where they touch."""
    centres = person.at(truth[:, 0]) - truth[:, 1:3]
    cos, sin = np.cos(truth[:, 3]), np.sin(truth[:, 3])
    centres = np.column_stack([cos * centres[:, 0] + sin * centres[:, 1], cos * centres[:, 1] - sin * centres[:, 0]])
    inside = geometry.contains(footprint, centres)
    return np.where(inside, 0.0, np.maximum(0.0, geometry.distances(footprint, centres) - person.radius))


def measure_people(people, footprint, truth):
    """The report's figures: `truth` (n, 6) is the robot's way."""
    said = {'people': len(people), 'contacts_moving': 0, 'contacts_at_rest': 0, 'closest_person_m': None,
            'personal_space_s': 0.0}
    if not people or len(truth) < 2:
        return said
    radius = np.hypot(*np.asarray(footprint).T).max()
    moves = np.abs(truth[:, 4]) + radius * np.abs(truth[:, 5]) > MOVES
    lasted = np.diff(truth[:, 0], append=truth[-1, 0])
    nearest = np.full(len(truth), np.inf)
    for person in people:
        gap = gaps(footprint, truth, person)
        nearest = np.minimum(nearest, gap)
        begins = (gap <= 0.0) & ~np.r_[False, gap[:-1] <= 0.0]
        said['contacts_moving'] += int(np.count_nonzero(begins & moves))
        said['contacts_at_rest'] += int(np.count_nonzero(begins & ~moves))
    said['closest_person_m'] = round(float(nearest.min()), 3)
    said['personal_space_s'] = round(float(lasted[moves & (nearest < PERSONAL_SPACE)].sum()), 3)
    return said
