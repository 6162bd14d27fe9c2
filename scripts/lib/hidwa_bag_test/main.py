# SPDX-License-Identifier: BSD-3-Clause
"""bag_test: reads the description, plays, judges, and tells rostest of each expectation as a test of its own."""
import argparse
import os
import sys
import unittest

import rospy
import rostest

from .description import read_description
from .errors import BagTestError
from .plans import plans_of
from .player import Player
from .recording import Absent, Recording
from .robot import Robot, footprint_of, radius_of
from .verdicts import Verdicts

SHOWN = 3  # faults of one expectation


def options_of(arguments):
    parser = argparse.ArgumentParser(prog='bag_test', description='Plays a bag to the planner and judges what it commands; '
                                     'for a <test> of rostest beside bag_test.launch.')
    parser.add_argument('--test', required=True, metavar='FILE', help='the YAML file with bag and expectations')
    parser.add_argument('--bag', metavar='FILE', help='this bag instead of the one that the YAML file names')
    return parser.parse_known_args(arguments)[0]


def judge(description):
    """{expectation: faults}; BagTestError where it cannot be said."""
    recording = Recording(description)
    overrides = description.expect.limits if isinstance(description.expect.limits, dict) else {}
    launched = rospy.get_param('/move_base', {})
    plans = plans_of(recording, description, radius_of(footprint_of(launched.get('local_costmap', {}))))
    if not plans:
        raise BagTestError(f'{description.path}: plan {description.plan} gives no plan in this stretch of the bag')
    answers = Player(recording, description, plans, 1.0 / launched.get('controller_frequency', 20.0)).run()
    return Verdicts(description, recording, answers, Robot(rospy.get_param('/move_base'), overrides)).all()


def test_case(verdicts):
    """A unittest.TestCase with one test an expectation."""
    def met(faults):
        def test(self):
            more = f'; and {len(faults) - SHOWN} more' if len(faults) > SHOWN else ''
            if faults:
                self.fail('; '.join(faults[:SHOWN]) + more)
        return test
    return type('BagTest', (unittest.TestCase,), {f'test_{name}': met(faults) for name, faults in verdicts.items()})


def skipped(reason):
    return type('BagTest', (unittest.TestCase,), {'test_bag': lambda self: self.skipTest(reason)})


def main(arguments=None):
    """The node."""
    arguments = sys.argv if arguments is None else arguments
    options = options_of(rospy.myargv(arguments)[1:])
    rospy.init_node('bag_test')
    name = os.path.splitext(os.path.basename(options.test))[0]
    try:
        description = read_description(options.test, options.bag)
        try:
            case = test_case(judge(description))
        except Absent as fault:
            if description.if_absent == 'fail':
                raise
            print(f'bag_test: skipped, {fault}')
            case = skipped(str(fault))
    except BagTestError as fault:
        print(f'bag_test: {fault}', file=sys.stderr)
        case = test_case({'can_be_run': [str(fault)]})
    rostest.rosrun('hidwa_local_planner', name, case, arguments)
