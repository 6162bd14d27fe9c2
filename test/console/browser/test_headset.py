# SPDX-License-Identifier: BSD-3-Clause
"""The page in an emulated headset, against a server that shows a scene: what is seen and felt there. test_drive.py steers with it."""
import math
import unittest

import browser
import office
import test_page

HEADSET = """
    window.device = new IWER.XRDevice(IWER.metaQuest3);
    window.device.installRuntime({forceInstall: true});
    Object.defineProperty(XRPose.prototype, 'emulatedPosition', {get() { return false; }});
"""
# Where one looks, as a direction in the map: the camera's axis -z in the world, whose y is up and whose -z is the map's y.
HEADING = """(() => {
    const m = app.board.renderer.xr.getCamera().matrixWorld.elements;
    return Math.atan2(m[10], -m[8]);
})()"""


class Headset(test_page.PageTest):
    @classmethod
    def setUpClass(cls):
        cls.scripts = (browser.source_of(browser.library() + '/iwer/build/iwer.min.js'), HEADSET)
        super().setUpClass()

    def setUp(self):
        super().setUp()
        self.browser.resize(480, 270)  # few pixels: the processor draws them
        self.browser.until("return !document.getElementById('enter').hidden")
        self.browser.click('enter')
        self.browser.wait(lambda: self.browser.app('app.headset.frames') > 5, 'frames in the headset')

    def tearDown(self):
        self.browser.app('app.headset.leave()')
        self.browser.wait(lambda: self.browser.app('app.headset.session === null'))

    def turn(self, yaw):
        """The robot turns, and the view has shown it."""
        x, y, _ = office.ROBOT
        self.server.show(pose=[x, y, yaw], velocity=[0.0, 0.0])
        self.browser.wait(lambda: abs(self.browser.app('app.board.shown.yaw') - yaw) < 0.01, 'a robot that has turned')
        frames = self.browser.app('app.headset.frames')
        self.browser.wait(lambda: self.browser.app('app.headset.frames') > frames + 2, 'it is drawn')

    def heading(self):
        return self.browser.app(HEADING)

    def test_the_view_turns_with_the_robot_unless_it_unwinds_and_controllers_rumble(self):
        self.turn(0.3)
        self.assertAlmostEqual(self.heading(), 0.3, delta=0.03)
        self.browser.js("const e = document.getElementById('unwind'); e.checked = true; e.dispatchEvent(new Event('change'))")
        self.turn(1.5)
        self.assertAlmostEqual(self.heading(), 0.3, delta=0.03, msg='unwound')
        half = 0.7 / 2
        self.browser.js('window.device.quaternion.set(0, %r, 0, %r)' % (math.sin(half), math.cos(half)))  # the head turns left by 0.7
        self.browser.wait(lambda: abs(self.heading() - 1.0) < 0.03, 'the head turns the view')

        self.check_rumble()

    def check_rumble(self):
        self.browser.js('window.pulsed = []')
        self.browser.wait(lambda: self.browser.app('app.headset.session.inputSources.length') > 0, 'controllers')
        self.browser.app('[...app.headset.session.inputSources].forEach(({gamepad}) => { gamepad.hapticActuators[0].pulse = '
                         '(strength) => { window.pulsed.push(strength); return Promise.resolve(true); }; })')
        self.addCleanup(self.server.show, rumble=0.0)
        self.server.show(rumble=0.6)
        self.browser.until('return window.pulsed.filter((one) => one === 0.6).length > 5')  # for as long as it is so


if __name__ == '__main__':
    unittest.main()
