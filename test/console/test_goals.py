# SPDX-License-Identifier: BSD-3-Clause
"""Goals in a row, the tour of scripts/demo --console, and what move_base says of them."""
import unittest

import paths  # noqa: F401
from hidwa_console.goals import MOST, NEAR, SEND_AGAIN, SUCCEEDED, TOUR_PAUSE, Goals

HERE, THERE, FAR = (0.0, 0.0, 0.0), (3.0, 0.0, 0.0), (3.0, 4.0, 0.0)
ABORTED = 4  # actionlib_msgs/GoalStatus


class Progress:
    def begin(self, now):
        pass

    def end(self):
        pass


class Row(unittest.TestCase):
    def setUp(self):
        self.sent, self.cancelled = [], []

    def goals(self, tour=()):
        return Goals(lambda number, pose: self.sent.append((number, pose)), lambda: self.cancelled.append(True), Progress(), tour)

    def poses(self):
        return [pose for _, pose in self.sent]

    def reach(self, goals, now, status=SUCCEEDED, text=''):
        goals.result(self.sent[-1][0], status, text, now)

    def test_one_after_the_other(self):
        goals = self.goals()
        goals.see(HERE, 0.0, False)
        goals.goal(*THERE, False, HERE, 0.0)
        goals.goal(3.0, 4.0, None, True, HERE, 0.0)
        self.assertEqual(self.poses(), [THERE])
        self.reach(goals, 1.0)
        # Without a heading: as one arrives, from (3, 0) to (3, 4): pi / 2.
        self.assertEqual(self.poses()[1][:2], (3.0, 4.0))
        self.assertAlmostEqual(self.poses()[1][2], 1.5707963, places=6)
        self.reach(goals, 2.0)
        self.assertEqual((goals.active, goals.outcome, len(self.sent)), (None, 'reached', 2))

    def test_what_fails_ends_the_row_and_says_why(self):
        goals = self.goals()
        goals.goal(*THERE, False, HERE, 0.0)
        goals.goal(*FAR, True, HERE, 0.0)
        self.reach(goals, 1.0, ABORTED, 'no plan')
        self.assertEqual((goals.outcome, goals.text, len(self.sent)), ('failed', 'no plan', 1))
        self.assertEqual(goals.skip(2.0), (True, ''))
        self.assertEqual(self.poses(), [THERE, FAR])

    def test_back_to_where_the_robot_was_first_seen(self):
        goals = self.goals()
        self.assertFalse(goals.home(False, None, 0.0)[0])
        goals.see(HERE, 0.0, False)
        goals.see(FAR, 1.0, False)
        goals.home(False, FAR, 1.0)
        self.assertEqual(self.poses(), [HERE])

    def test_cancel_forgets_those_that_wait(self):
        goals = self.goals()
        goals.goal(*THERE, False, HERE, 0.0)
        goals.goal(*FAR, True, HERE, 0.0)
        goals.cancel()
        self.assertEqual((goals.active, goals.waiting, goals.outcome, self.cancelled), (None, [], 'cancelled', [True]))
        self.assertFalse(goals.skip(1.0)[0])

    def test_no_more_than_so_many_wait(self):
        goals = self.goals()
        goals.goal(*THERE, False, HERE, 0.0)
        self.assertEqual([goals.goal(*FAR, True, HERE, 0.0)[0] for _ in range(MOST + 1)], [True] * MOST + [False])

    def test_a_goal_that_move_base_does_not_know_is_sent_again(self):
        goals = self.goals()
        goals.goal(*THERE, False, HERE, 0.0)
        goals.see(HERE, 0.5 * SEND_AGAIN, False)
        self.assertEqual(len(self.sent), 1)
        goals.see(HERE, 1.1 * SEND_AGAIN, False)
        self.assertEqual(self.sent[1], self.sent[0])
        goals.known([self.sent[0][0]])
        goals.see(HERE, 9.0 * SEND_AGAIN, False)
        self.assertEqual(len(self.sent), 2)

    def test_the_tour_goes_to_and_fro_with_a_pause_unless_somebody_wants_something_else(self):
        goals, now = self.goals((THERE, HERE)), 100.0
        goals.see(HERE, now, False)
        goals.see(HERE, now + 0.05, False)
        self.assertEqual(self.poses(), [THERE], 'the first one at once')
        for pose, expected in ((THERE, [THERE, HERE]), (HERE, [THERE, HERE, THERE])):
            now += 10.0
            goals.known([self.sent[-1][0]])
            goals.see(pose, now, False)
            self.reach(goals, now)
            goals.see(pose, now + 0.9 * TOUR_PAUSE, False)
            self.assertEqual(len(self.sent), len(expected) - 1, 'a pause')
            now += 2.0 * TOUR_PAUSE
            goals.see(pose, now, False)
            self.assertEqual(self.poses(), expected)
        goals.cancel()
        goals.see(HERE, now + 99.0, False)
        self.assertEqual(len(self.sent), 3, 'it rests')
        goals.goal(*FAR, False, HERE, now + 100.0)
        goals.known([self.sent[-1][0]])
        goals.see(FAR, now + 101.0, False)
        self.reach(goals, now + 101.0)
        goals.see(FAR, now + 102.0 + TOUR_PAUSE, True)
        self.assertEqual(self.poses()[3:], [FAR], 'not while somebody stops the robot')
        goals.see(FAR, now + 103.0 + 2 * TOUR_PAUSE, False)
        self.assertEqual(self.poses()[4:], [HERE], 'it goes on')

    def test_a_goal_of_the_tour_that_is_near_is_passed_over(self):
        near = (0.5 * NEAR, 0.0, 0.0)
        goals = self.goals((near, THERE))
        goals.see(HERE, 0.0, False)
        for tick in range(1, 4):
            goals.see(HERE, 0.05 * tick, False)
        self.assertEqual(self.poses(), [THERE])


if __name__ == '__main__':
    unittest.main()
