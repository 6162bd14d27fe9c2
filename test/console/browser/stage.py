# SPDX-License-Identifier: BSD-3-Clause
"""The running robot, a link that can be held up, and the page: what the tests of a drive share.

What the robot does is read from ROS topics, not from the page. The page reaches the console through a proxy, which holds the
link up and cuts it.
"""
import unittest

import browser
from proxy import Proxy
from robot import Robot

START = (16.5, 8.3, 0.0)  # [m, m, rad] in a corridor 3.4 m wide that leads east
ROOM = (15.0, 36.0)       # [m] between which x the tests drive to and fro
STOP_DELAY = 8.0          # [s] of the console; longer than any test but one holds the link up, on a slow machine too

robot = proxy = page = None


def begin(scripts=(), options=''):
    """(robot, proxy, page) for all tests of a module, which calls this in setUpModule; they end with it. scripts: run in every page
    before its own; options: of the console."""
    global robot, proxy, page
    robot = Robot(START, '--stop-delay %g %s' % (STOP_DELAY, options))
    unittest.addModuleCleanup(robot.end)
    proxy = Proxy(robot.port)
    unittest.addModuleCleanup(proxy.end)
    page = browser.Browser(scripts=scripts, rules='MAP localhost:%d 127.0.0.1:%d' % (robot.port, proxy.port))
    unittest.addModuleCleanup(page.end)
    return robot, proxy, page


def address():
    """The page's; the browser goes there by way of the proxy."""
    return 'http://localhost:%d/' % robot.port


def wait(condition, what):
    """Until condition() is true; its value."""
    return browser.Browser.wait(condition, what)


def cycles(count):
    """The planner has worked so many cycles more. What was sent before the first of them has come to it."""
    begin = len(robot.states)
    wait(lambda: len(robot.states) > begin + count, '%d cycles' % count)


class DriveTest(unittest.TestCase):
    """Each test opens the page anew and has the controls; the robot rests before and after it."""

    def setUp(self):
        proxy.flush()
        proxy.mend()
        page.open(address())
        ready = 'Boolean(app.scene.map && app.scene.robot && app.holder.mine && !app.status.facts.neutralNeeded)'
        page.wait(lambda: page.app(ready), 'the controls')
        self.letgo_if_stopped()
        if page.app('app.mode') != 'joystick':
            self.mode('joystick')

    def tearDown(self):
        proxy.flush()
        page.app("(app.send('stop', {on: false}), app.send('cancel'))")
        wait(lambda: robot.state == '' and abs(robot.speed[0]) < 0.02, 'rest after the goal was cancelled')

    def letgo_if_stopped(self):
        if not page.js("return document.getElementById('letgo').hidden"):
            page.click('letgo')
            page.until("return document.getElementById('letgo').hidden")

    def mode(self, mode):
        page.js("document.querySelector('[data-mode=%s]').click()" % mode)
        page.wait(lambda: page.app('app.mode') == mode, 'mode ' + mode)

    def drive_off(self, distance=12.0):
        """A goal along the corridor, and the robot on its way there."""
        x = robot.pose[0]
        east = x + distance <= ROOM[1]
        goal = x + distance if east else max(ROOM[0], x - distance)
        page.app("app.send('goal', {x: %g, y: 8.4, yaw: null, append: false})" % goal)
        # Where it has to turn round first, it drives once it faces the goal.
        wait(lambda: robot.state == 'AUTONOMY' and robot.speed[0] > 0.25 and abs(robot.speed[1]) < 0.2, 'the robot on its way')
        return 1.0 if east else -1.0

    def steers(self):
        """Until the operator's command counts; else what the page was told."""
        try:
            wait(lambda: robot.state == 'SHARED', 'SHARED')
        except AssertionError as fault:
            facts = page.app('[app.status.facts, app.mode, app.hands.hand, app.scene.state]')
            raise AssertionError('%s; the page: %s; hands %d, Joy %s' % (fault, facts, len(robot.hands), robot.joys[-1:])) from None

    def turns_left(self, began):
        """Until the robot was sent to the left since a time; else what it was asked for."""
        try:
            wait(lambda: any(omega > 0.1 for _, omega in robot.since(robot.commands, began)), 'the robot turns left')
        except AssertionError as fault:
            hands = [(round(m.pose.position.x, 2), round(m.pose.position.y, 2)) for m in robot.since(robot.hands, began)]
            raise AssertionError('%s; %s; hands %s' % (fault, page.app('app.scene.state'), hands[::20])) from None

    def press_stick(self, dx, dy):
        x, y, width, _ = page.middle('stick')
        to = (x + 0.36 * width * dx, y + 0.36 * width * dy)
        page.mouse('mousePressed', x, y)
        page.mouse('mouseMoved', *to)
        return to

    def take_over(self, dx, dy):
        """Holds the stick until the page says that the person steers. Where the robot lost it meanwhile, since the page came
        late on a slow machine, the stick is centred and held again, as the page asks for."""
        lost = 'Lost your steering'

        def answer():
            title = page.text('state-title')
            return title if title in ('You steer', 'Blocked', lost) else None
        for _ in range(3):
            at = self.press_stick(dx, dy)
            try:
                title = page.wait(answer, 'the page says who steers')
            except AssertionError as fault:
                raise AssertionError('%s; it says %r, the robot %s' % (fault, page.text('state-title'), robot.state)) from None
            if title != lost:
                return at
            self.release_stick(at)
            page.wait(lambda: page.text('state-title') != lost, 'steering is free again')
        raise AssertionError('three times the robot lost the stick')

    def release_stick(self, at):
        page.mouse('mouseReleased', *at)
