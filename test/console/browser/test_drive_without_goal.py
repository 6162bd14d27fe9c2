# SPDX-License-Identifier: BSD-3-Clause
"""Driving without a goal, in the browser: the page's stick takes the simulated robot through a doorway, and a goal takes over."""
import math
import time
import unittest

import stage
from stage import DriveTest, cycles, wait

# A doorway of maps/office.yaml that leads south out of a corridor: x from 25.5 to 26.45 m, the wall's y from 6.45 to 6.6 m.
# It is 0.95 m wide, the robot 0.60 m. The robot begins 1.5 m before it, 0.12 m beside its middle, and faces 4 degrees farther
# to that side: straight on it would miss the middle by 0.12 + 1.5 tan(4 deg) = 0.22 m, and 0.95 / 2 - 0.30 = 0.175 m fit.
DOOR, WALL, RADIUS = 25.975, 6.45, 0.30  # [m] each
CORRIDOR = 8.4  # [m] the y of its middle
START = (DOOR - 0.12, 8.1, -math.pi / 2 - math.radians(4.0))
FORWARD = (0, -1)  # of the stick: up
DRIVING = 'You drive. No goal.'
SWITCH = 'parameter-drive_without_goal'


def setUpModule():
    global robot, page
    robot, _, page = stage.begin(start=START, arguments=('people:=0', 'drive_without_goal:=false'))


class WithoutGoal(DriveTest):
    def switch(self, on):
        """The parameter, by the page's panel."""
        page.click('tab-tuning')
        page.until("return document.getElementById('%s') !== null" % SWITCH)
        if page.js("return document.getElementById('%s').checked" % SWITCH) != on:
            page.click(SWITCH)
        page.wait(lambda: page.app('app.scene.limits.driveWithoutGoal') is on, 'the parameter in force')

    @staticmethod
    def drives():
        return page.text('state-title') == DRIVING and robot.speed[0] > 0.15

    @staticmethod
    def rests():
        return page.text('state-title') == 'No goal' and abs(robot.speed[0]) < 0.01

    def test_a_while_it_is_off_the_stick_drives_nothing(self):
        self.switch(False)
        self.assertIn('steering works on the way to a goal', page.text('state-line'))
        began = time.monotonic()
        pose = robot.pose
        at = self.press_stick(*FORWARD)
        wait(lambda: len([joy for joy in robot.since(robot.joys, began) if joy.axes[1] > 0.9]) > 20, 'a second of the stick')
        self.assertEqual((robot.since(robot.states, began), robot.since(robot.commands, began)), ([], []))
        self.assertEqual(robot.pose, pose)
        self.release_stick(at)
        wait(lambda: robot.since(robot.joys, began)[-1].axes[1] == 0.0, 'the release')

    def test_b_through_a_doorway_and_rest(self):
        self.switch(True)
        page.wait(lambda: page.text('state-line').startswith('Steer to drive'), 'an invitation')
        began = time.monotonic()
        at = self.steer(*FORWARD, lambda: robot.pose[1] < WALL - 2 * RADIUS and self.drives())
        self.assertIn('MANUAL', robot.since(robot.states, began))
        self.assertLessEqual(set(robot.since(robot.states, began)), {'MANUAL', 'LOST', 'AUTONOMY'})  # lost on a slow machine
        released = time.monotonic()
        self.release_stick(at)
        page.wait(self.rests, 'rest')
        self.assertLessEqual(set(robot.since(robot.states, released)), {'MANUAL', 'LOST', 'AUTONOMY'})
        last = robot.since(robot.commands, released)
        self.assertEqual((last[-1], last.count((0.0, 0.0))), ((0.0, 0.0), 1), 'one zero, then silence')
        self.assertIn('Steer to drive', page.text('state-line'))
        self.assertEqual(robot.contacts, 0)

    @staticmethod
    def give_goal(metres):
        """In the corridor, so far east of the doorway."""
        page.app("app.send('goal', {x: %g, y: %g, yaw: null, append: false})" % (DOOR + metres, CORRIDOR))
        wait(lambda: robot.has_goal, 'the goal')

    def hold_key(self):
        """The arrow key drives ahead: the mouse is free."""
        self.addCleanup(page.key, 'keyUp', 'ArrowUp', 'ArrowUp')
        self.hold(lambda: page.key('keyDown', 'ArrowUp', 'ArrowUp'), lambda _: page.key('keyUp', 'ArrowUp', 'ArrowUp'), self.drives, page)

    @staticmethod
    def robot_drives():
        """Towards the goal, although the key is held; where a slow page has lost it meanwhile, the page does not say so."""
        try:
            wait(lambda: robot.state == 'AUTONOMY' and robot.speed[0] > 0.15, 'the robot on its way')
        except AssertionError as fault:
            states = [state for _, state in robot.states[-3:]]
            raise AssertionError('%s; goal %s, states %s, at %s' % (fault, robot.has_goal, states, robot.pose)) from None

    def test_c_a_goal_that_comes_while_the_robot_drives_takes_over(self):
        self.switch(True)
        self.hold_key()
        self.give_goal(8.0)  # it leads back through the doorway, and takes long enough for a slow page
        self.robot_drives()
        page.key('keyUp', 'ArrowUp', 'ArrowUp')
        page.wait(lambda: page.text('state-title') == 'The robot drives itself')
        page.wait(lambda: page.text('notice') == 'The goal is reached.', 'the goal')
        self.assertGreater(robot.pose[1], WALL + 2 * RADIUS)
        self.assertEqual(robot.contacts, 0)

    def held_while_a_goal_ends(self, cancel):
        """Whether the key was held all the time and two seconds longer; then it counted for nothing."""
        self.hold_key()
        self.give_goal(8.0 if robot.pose[0] < DOOR + 4.0 else 0.0)  # at least 4 m away, wherever it came to
        self.robot_drives()
        if cancel:
            page.app("app.send('cancel')")
        wait(lambda: robot.state == '', 'the goal is cancelled, or reached')
        ended = time.monotonic()
        page.wait(self.rests, 'rest')
        wait(lambda: len(robot.since(robot.joys, ended)) > 40, 'two seconds of Joy')
        held = all(joy.axes[1] > 0.6 for joy in robot.since(robot.joys, ended))
        self.assertNotIn('MANUAL', robot.since(robot.states, ended))
        if held:
            self.assertIn('the robot takes none of it', page.text('notice'))
        page.key('keyUp', 'ArrowUp', 'ArrowUp')
        return held

    def test_d_a_stick_that_is_held_when_a_goal_ends_must_be_centred_first(self):
        self.switch(True)
        for cancel in (True, False):
            held = any(self.held_while_a_goal_ends(cancel) for _ in range(5))  # a slow page may lose the key
            self.assertTrue(held, 'five times the key was lost')
            page.wait(lambda: page.text('notice') == '', 'nothing is wrong')
        self.hold_key()
        page.key('keyUp', 'ArrowUp', 'ArrowUp')
        page.wait(self.rests, 'rest')

    def test_e_a_mode_that_is_chosen_without_a_goal_counts_at_once(self):
        self.switch(True)
        self.give_goal(8.0 if robot.pose[0] < DOOR + 4.0 else 0.0)
        self.robot_drives()
        self.mode('off')
        cycles(5)
        page.app("app.send('cancel')")
        page.wait(self.rests, 'rest')
        self.mode('switching')
        at = self.steer(0.9, -0.4, lambda: page.text('state-title') == DRIVING)
        self.assertEqual(page.text('take'), 'Take control', 'there is nothing to give back')
        self.release_stick(at)
        page.wait(self.rests, 'rest')


if __name__ == '__main__':
    unittest.main()
