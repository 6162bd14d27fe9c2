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


def begin(scripts=(browser.FEW_FRAMES,), options='', start=START, arguments=()):
    """(robot, proxy, page) for all tests of a module, which calls this in setUpModule; they end with it. scripts: run in every page
    before its own; start, options, arguments: of the Robot."""
    global robot, proxy, page
    robot = Robot(start, '--stop-delay %g %s' % (STOP_DELAY, options), arguments)
    unittest.addModuleCleanup(robot.end)
    proxy = Proxy(robot.port)
    unittest.addModuleCleanup(proxy.end)
    # A quarter of the pixels, which are drawn in software: the robot needs the processors.
    page = browser.Browser(scripts=scripts, scale=0.5, rules='MAP localhost:%d 127.0.0.1:%d' % (robot.port, proxy.port))
    unittest.addModuleCleanup(page.end)
    return robot, proxy, page


def address():
    """The page's; the browser goes there by way of the proxy."""
    return 'http://localhost:%d/' % robot.port


wait = browser.Browser.wait  # until condition() is true; its value


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

    def turns_left(self, began):
        """Until the robot was sent to the left since a time; else what it was asked for."""
        try:
            wait(lambda: any(omega > 0.1 for _, omega in robot.since(robot.commands, began)), 'the robot turns left')
        except AssertionError as fault:
            hands = [(round(m.pose.position.x, 2), round(m.pose.position.y, 2)) for m in robot.since(robot.hands, began)]
            raise AssertionError('%s; %s; hands %s' % (fault, page.app('app.scene.state'), hands[::20])) from None

    @staticmethod
    def until_told(counts, at):
        """Until the operator's command counts; else what the page was told."""
        try:
            return wait(counts, "the operator's command counts")
        except AssertionError as fault:
            facts = at.app('[app.status.facts, app.mode, app.hands.hand, app.scene.state]')
            raise AssertionError('%s; the page: %s; hands %d, Joy %s' % (fault, facts, len(robot.hands), robot.joys[-1:])) from None

    @staticmethod
    def press_stick(dx, dy, at=None):
        """Where the stick of a page, or of this one, is held now: (x, y) [px]."""
        at = at or page
        x, y, width, _ = at.middle('stick')
        to = (x + 0.36 * width * dx, y + 0.36 * width * dy)
        at.mouse('mousePressed', x, y)
        at.mouse('mouseMoved', *to)
        return to

    def steer(self, dx, dy, counts=lambda: robot.state == 'SHARED', at=None):
        """Holds the stick until it counts; where the stick is then, as press_stick says."""
        at = at or page
        return self.hold(lambda: self.press_stick(dx, dy, at), lambda to: at.mouse('mouseReleased', *to), counts, at)

    def hold(self, press, release, counts, at):
        """Holds a device until it counts: what press() returned. Where it was lost meanwhile, since the page came late on a slow
        machine, or the planner takes none of it, it is released, and held again, as the page asks for."""
        lost = ("document.getElementById('state-title').textContent === 'Lost your steering' || "
                "app.status.facts.steering === 'neutral_needed' || app.status.facts.ignored")
        for _ in range(5):
            held = press()
            if self.until_told(lambda: counts() and 'counts' or at.app(lost) and 'lost', at) == 'counts':
                return held
            release(held)
            at.wait(lambda: not at.app(lost), 'steering is free again')
        raise AssertionError('five times the device was lost')

    def take_over(self, dx, dy):
        """Holds the stick until the page says that the person steers."""
        return self.steer(dx, dy, lambda: page.text('state-title') in ('You steer', 'Blocked'))

    def release_stick(self, at):
        page.mouse('mouseReleased', *at)
