# SPDX-License-Identifier: BSD-3-Clause
"""A headset in a drive: a controller's thumbstick, and hands that are carried, steer the simulated robot."""
import time
import unittest

import browser
import stage
from stage import DriveTest, cycles, wait

HEADSET = """
    window.device = new IWER.XRDevice(IWER.metaQuest3);
    window.device.installRuntime({forceInstall: true});
    window.lost = false;
    // iwer calls every place emulated; a real headset does so only where tracking is lost.
    Object.defineProperty(XRPose.prototype, 'emulatedPosition', {get() { return window.lost; }});
"""


def setUpModule():
    global robot, page
    iwer = browser.source_of(browser.library() + '/iwer/build/iwer.min.js')
    robot, _, page = stage.begin((iwer, HEADSET))


def carry(what, x):
    """A script that carries a controller or hand to a place at the side [m], as an arm does: at 0.5 m/s, not in a jump."""
    return ('const p = window.device.%s.position; window.carrying = setInterval(() => { p.x += Math.max(-0.01, Math.min(0.01, %g - p.x)); '
            'if (Math.abs(p.x - %g) < 1e-6) clearInterval(window.carrying); }, 20)' % (what, x, x))


class HeadsetDrive(DriveTest):
    def enter(self):
        # Few pixels: the processor draws them, and a hand is read once a frame.
        page.resize(480, 270)
        self.addCleanup(page.resize, *browser.DESKTOP)
        page.until("return !document.getElementById('enter').hidden")
        page.click('enter')
        page.wait(lambda: page.app('app.headset.frames') > 5, 'frames in the headset')

    def leave(self):
        page.app('app.headset.leave()')
        page.wait(lambda: page.app('app.headset.session === null'))

    def test_a_thumbstick_steers_and_blurred_releases(self):
        self.enter()
        self.addCleanup(self.leave)
        self.drive_off()
        began = time.monotonic()
        page.js("window.device.controllers.right.updateAxes('thumbstick', -1, 0)")
        wait(lambda: any(joy.axes[0] > 0.9 for joy in robot.since(robot.joys, began)), 'Joy to the left')
        self.until_told(lambda: robot.state == 'SHARED', page)
        page.js("window.device.updateVisibilityState('visible-blurred')")
        wait(lambda: robot.state in ('HOLD', 'AUTONOMY'), 'released')
        page.js("window.device.controllers.right.updateAxes('thumbstick', 0, 0); window.device.updateVisibilityState('visible')")

    def hand_test(self, close, move, open_):
        self.mode('gesture')
        self.enter()
        self.addCleanup(self.leave)
        self.drive_off()
        self.until_told(lambda: self.turns_by_hand(close, move, open_), page)
        page.js('window.lost = true')
        wait(lambda: robot.state in ('HOLD', 'AUTONOMY'), 'lost tracking releases')
        page.js('window.lost = false')
        cycles(10)
        self.assertIn(robot.state, ('HOLD', 'AUTONOMY'), 'the hand must open first')
        page.js(open_)
        page.wait(lambda: page.app('app.hands.mustOpen.size === 0'))
        page.js(close)
        page.wait(lambda: page.app("app.hands.hand === 'right'"))
        page.js(open_)
        page.wait(lambda: page.app('app.hands.hand === null'))

    @staticmethod
    def turns_by_hand(close, move, open_):
        """Whether a hand that grips and is carried asks for a turn to the left. Input from a page that draws slowly may be
        lost: then it must open first."""
        page.js('clearInterval(window.carrying)')
        page.js(open_)
        page.wait(lambda: page.app('app.hands.hand === null && app.hands.mustOpen.size === 0'), 'an open hand')
        page.js(close)
        page.wait(lambda: page.app("app.hands.hand === 'right'"), 'a hand that grips')
        page.js(move)
        asks = 'Boolean(app.scene.state && app.scene.state.wanted.omega > 0.3)'
        wait(lambda: page.app(asks) or robot.state == 'LOST', 'a turn to the left is asked for')
        return robot.state == 'SHARED' and page.app(asks)

    def test_b_a_controller_moved_sideways_while_gripped_steers(self):
        right = 'window.device.controllers.right'
        self.hand_test(right + '.position.set(0.25, 1.2, -0.3); ' + right + ".updateButtonValue('squeeze', 1)",
                       carry('controllers.right', 0.0), right + ".updateButtonValue('squeeze', 0)")

    def test_c_a_tracked_hand_steers_by_pinch(self):
        page.js("window.device.primaryInputMode = 'hand'")
        self.addCleanup(lambda: page.js("window.device.primaryInputMode = 'controller'"))
        self.hand_test('window.device.hands.right.position.set(0.25, 1.2, -0.3); window.device.hands.right.updatePinchValue(1)',
                       carry('hands.right', 0.0),
                       'window.device.hands.right.updatePinchValue(0)')


if __name__ == '__main__':
    unittest.main()
