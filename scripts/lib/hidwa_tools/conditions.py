# SPDX-License-Identifier: BSD-3-Clause
"""The course of the study of Kalliokoski et al. (2022), section IV: its conditions, who drives which of them when, and how
the bags of its drives are called. Standard library only."""
import os
import re

MODES = {'SJ': 'joystick', 'SG': 'gesture', 'SW': 'switching'}
BAG = re.compile(r'p(\d+)_o([1-9])_(SJ|SG|SW)\.bag')


def course(participant):
    """A participant's conditions in their order: SJ and SW alternate over people, SG is last. As in lab/study/plan.cpp."""
    return ('SJ', 'SW', 'SG') if participant % 2 == 1 else ('SW', 'SJ', 'SG')


def run_name(participant, order, condition):
    """What a drive is called, p07_o1_SJ."""
    return f'p{participant:02d}_o{order}_{condition}'


def driven(folder):
    """[(participant, order, condition, path)] of the bags in a folder, in the order of people and drives."""
    found = []
    for name in os.listdir(folder) if os.path.isdir(folder) else ():
        match = BAG.fullmatch(name)
        if match:
            found.append((int(match[1]), int(match[2]), match[3], os.path.join(folder, name)))
    return sorted(found)


def next_of(folder, participant):
    """(place of the participant's next drive, from 1; the condition it should be, or None after the last)."""
    done = [condition for who, _, condition, _ in driven(folder) if who == participant]
    left = [condition for condition in course(participant) if condition not in done]
    return len(done) + 1, left[0] if left else None


def parameters_of(condition, guard):
    """The planner's parameters of a condition, as hidwa_study sets them."""
    return {'mode': MODES[condition], 'guard': guard}
