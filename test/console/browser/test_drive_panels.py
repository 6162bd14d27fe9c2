# SPDX-License-Identifier: BSD-3-Clause
"""What an operator does in a drive besides steering by the stick: goals, panels, recording, the camera, a gamepad, a slow link."""
import glob
import math
import os
import re
import time
import unittest

import browser
import numpy
import stage
from stage import DriveTest, wait

# A gamepad that is there once window.padOn is set; what it is asked to rumble is kept.
PAD = """
    window.rumbled = [];
    window.pad = {index: 0, connected: true, id: 'pad', mapping: 'standard', axes: [0, 0, 0, 0], timestamp: 0,
                  buttons: Array.from({length: 16}, () => ({pressed: false, value: 0})),
                  vibrationActuator: {playEffect: (kind, how) => {
                    window.rumbled.push(how.strongMagnitude);
                    return Promise.resolve('complete');
                  }}};
    navigator.getGamepads = () => window.padOn ? [window.pad] : [];
"""
CAMERA = '/eye/image'
PLANNER = '/move_base/HIDWAPlannerROS/'


def setUpModule():
    stage.begin((browser.FEW_FRAMES, PAD), '--camera ' + CAMERA)


class Goals(DriveTest):
    def press_map(self, button, metres):
        """Presses a button, then the map so many metres to the east of the robot, and drags to the east."""
        page = stage.page
        page.click(button)
        x, y, _, _ = page.middle('above-canvas')
        x += metres * page.app('app.above.camera.scale')
        page.mouse('mousePressed', x, y)
        page.mouse('mouseMoved', x + 50, y)
        page.mouse('mouseReleased', x + 50, y)

    @staticmethod
    def goals():
        return stage.page.app('app.scene.goals.map(({x, y}) => [x, y])')

    def test_several_in_a_row_one_skipped_then_back_to_the_start_and_cancelled(self):
        page, robot = stage.page, stage.robot
        page.click('stop')  # a robot that stands passes no goal before it is listed
        page.until("return !document.getElementById('letgo').hidden")
        x0 = robot.pose[0]
        self.press_map('go', 4.5)
        page.wait(lambda: len(self.goals()) == 1, 'the first goal')
        self.press_map('add', 1.6)
        page.wait(lambda: len(self.goals()) == 2, 'the second goal')
        page.click('skip')
        page.wait(lambda: len(self.goals()) == 1, 'the first one was passed over')
        second = self.goals()[0]
        self.assertAlmostEqual(second[0], x0 + 1.6, delta=0.4)
        self.press_map('add', 2.1)
        page.wait(lambda: len(self.goals()) == 2, 'another one')
        third = self.goals()[1]
        page.click('letgo')
        page.wait(lambda: ' m, ' in page.text('left') and ' s' in page.text('left'), 'the way and the time that are left')
        page.wait(lambda: self.goals() == [third], 'the second one is reached')
        self.assertLess(math.dist(robot.pose[:2], second), 0.4)
        page.wait(lambda: self.goals() == [], 'the third one is reached')
        self.assertLess(math.dist(robot.pose[:2], third), 0.4)
        page.wait(lambda: page.text('notice') == 'The goal is reached.', 'that it is reached')
        page.click('home')
        page.wait(lambda: self.goals(), 'the way home')
        self.assertLess(math.dist(self.goals()[0], stage.START[:2]), 0.2)
        page.click('cancel')
        page.wait(lambda: self.goals() == [] and page.text('state-title') == 'No goal', 'no goal')
        wait(lambda: abs(robot.speed[0]) < 0.02, 'rest')


class Panels(DriveTest):
    def test_a_parameter_is_changed_and_undone_and_a_preset_too(self):
        import rospy
        page = stage.page
        names = ('s_v', 's_omega', 'delta')

        def values():
            return [rospy.get_param(PLANNER + name) for name in names]
        before = values()
        page.click('tab-tuning')
        page.until("return document.getElementById('parameter-s_v') !== null")
        page.js("const e = document.getElementById('parameter-s_v'); e.value = '123.5'; e.dispatchEvent(new Event('change'))")
        page.wait(lambda: values() == [123.5, *before[1:]], 'the new value in force')
        page.wait(lambda: page.text('undo') == 'Undo (1)' and page.js("return document.getElementById('parameter-s_v').value") == '123.5')
        page.click('undo')
        page.wait(lambda: values() == before, 'the old value')
        page.wait(lambda: page.text('undo') == 'Undo', 'nothing is left to take back')
        page.js("[...document.querySelectorAll('#panel-tuning button')].find((one) => one.textContent === 'pilot 3').click()")
        page.wait(lambda: values() == [200.0, 400.0, 1.0], "the preset's values, launch/params/presets/pilot_3.yaml")
        page.wait(lambda: page.text('undo') == 'Undo (1)')
        page.click('undo')
        page.wait(lambda: values() == before, 'the old values')

    def test_a_drive_is_recorded_and_its_report_opens(self):
        page, robot = stage.page, stage.robot
        page.click('tab-record')
        page.click('record')
        page.wait(lambda: re.match(r'Recording, ([2-9]|\d\d) s', page.text('record')), 'two seconds')
        self.drive_off()  # now, since on a busy machine the recorder hears nothing for its first seconds
        begin = robot.pose[0]
        page.wait(lambda: abs(robot.pose[0] - begin) > 2.0, 'two metres')
        page.click('record')
        page.until("return !document.getElementById('report').hidden")
        bags = glob.glob(os.path.join(robot.folder, 'drive_*.bag'))
        self.assertEqual(len(bags), 1)
        self.assertGreater(os.path.getsize(bags[0]), 10000)
        self.assertIn(bags[0], page.text('record-text'))
        page.click('report')
        page.wait(lambda: page.js("return document.getElementById('report-dialog').open"), 'the dialog')
        page.wait(lambda: page.js("return document.getElementById('report-picture').complete"), 'the picture, or that there is none')
        shown = "const p = document.getElementById('report-picture'); return [p.hidden, p.naturalWidth]"
        self.assertGreater(page.js(shown)[1], 200, (page.js(shown), page.text('record-text')))
        figures = page.js("return Object.fromEntries([...document.getElementById('report-figures').rows]"
                          '.map((row) => [...row.cells].map((cell) => cell.textContent)))')
        self.assertGreater(float(figures['path length m']), 0.2)


def picture(red_columns):
    """A picture of 64 x 48 pixels, that many columns red and the rest blue."""
    image = numpy.zeros((48, 64, 3), numpy.uint8)
    image[:, :red_columns, 0] = 255
    image[:, red_columns:, 2] = 255
    return image


class Camera(DriveTest):
    def publish_calibration(self):
        """A lens 1 m above the robot that looks ahead and down by 30 degrees: it sees 1 to 5 m of the floor."""
        import rospy
        from geometry_msgs.msg import TransformStamped
        from sensor_msgs.msg import CameraInfo
        from tf2_msgs.msg import TFMessage
        place = TransformStamped()
        place.header.frame_id, place.child_frame_id = 'base_link', 'eye'
        place.transform.translation.z = 1.0
        # Optical axes (x right, y down, z ahead) by the half angles of -120 degrees about x after -90 degrees about z.
        a, b = math.radians(-120.0) / 2, math.radians(-90.0) / 2
        q = place.transform.rotation
        q.x, q.y, q.z, q.w = math.sin(a) * math.cos(b), math.sin(a) * math.sin(b), math.cos(a) * math.sin(b), math.cos(a) * math.cos(b)
        tf = rospy.Publisher('/tf_static', TFMessage, queue_size=1, latch=True)
        tf.publish(TFMessage([place]))
        info = rospy.Publisher('/eye/camera_info', CameraInfo, queue_size=1, latch=True)
        message = CameraInfo(width=64, height=48, K=[40.0, 0.0, 32.0, 0.0, 40.0, 24.0, 0.0, 0.0, 1.0])
        message.header.frame_id = 'eye'
        info.publish(message)
        return tf, info

    @staticmethod
    def shown():
        """What the page draws over and of the picture, or None where it shows none."""
        return stage.page.js("const c = document.getElementById('picture-canvas'); if (c.hidden || c.width !== 64) return null;"
                             "return Array.from(c.getContext('2d').getImageData(0, 0, 64, 48).data)")

    def pixels(self):
        data = self.shown()
        return None if data is None else numpy.array(data).reshape(48, 64, 4)[:, :, :3].astype(int)

    def red_columns(self):
        """How much of the topmost row is red: nothing is drawn over the sky."""
        pixels = self.pixels()
        return -1 if pixels is None else int((pixels[0, :, 0] > 150).sum())

    def test_a_raw_picture_is_shown_with_the_plan_over_it(self):
        import rospy
        from sensor_msgs.msg import Image
        page = stage.page
        page.wait(lambda: page.js("return document.getElementById('picture-canvas').hidden"), 'no picture comes: no picture is shown')
        kept = self.publish_calibration()
        camera = rospy.Publisher(CAMERA, Image, queue_size=1)
        for columns in (20, 44):
            image = picture(columns)
            message = Image(height=48, width=64, encoding='rgb8', step=3 * 64, data=image.tobytes())
            page.wait(lambda: camera.publish(message) or abs(self.red_columns() - columns) <= 2, 'a picture with %d red columns' % columns)
        page.wait(lambda: page.app('Boolean(app.scene.camera && app.scene.camera.pose)'), 'the calibration')
        # The floor 2 m ahead, seen from 1 m: 26.6 degrees below the horizon, 3.4 above the axis: v = 24 - 40 tan(3.4 deg) = 21.6.
        seen = page.app("import('/views/onboard_picture.js').then(({project}) => project(app.scene.camera, 2, 0))")
        self.assertAlmostEqual(seen[0], 32.0, delta=0.1)
        self.assertAlmostEqual(seen[1], 21.6, delta=0.1)

        def green():
            camera.publish(message)
            pixels = self.pixels()
            return pixels is not None and int((pixels[21:, :, 1] > 90).sum())
        self.assertEqual(green(), 0)
        self.drive_off()
        page.wait(lambda: green() > 10, 'the plan over the picture')
        page.click('picture-toggle')
        self.assertTrue(page.js("return document.getElementById('picture-canvas').hidden"), 'the view of the map again')
        for publisher in (*kept, camera):
            publisher.unregister()
        page.wait(lambda: not page.app('app.cameraOn'), 'no picture comes any more')


class Gamepad(DriveTest):
    def test_it_steers_and_rumbles_as_long_as_the_planner_says(self):
        import rospy
        from sensor_msgs.msg import JoyFeedback, JoyFeedbackArray
        page, robot = stage.page, stage.robot
        feedback = rospy.Publisher('/joy/set_feedback', JoyFeedbackArray, queue_size=1)
        self.addCleanup(feedback.unregister)
        page.js('window.padOn = true')
        page.wait(lambda: page.app('[...app.steering.rests.values()].some((rest) => rest.at[0] === 0)'), 'a pad that was seen at rest')
        began = time.monotonic()
        page.js('window.pad.axes[0] = -1; window.pad.axes[1] = -0.5')  # the API: left and up are -1
        wait(lambda: any(tuple(joy.axes[:2]) == (1.0, 0.5) for joy in robot.since(robot.joys, began)), 'Joy to the left and forward')

        def rumbled():
            feedback.publish(JoyFeedbackArray([JoyFeedback(type=JoyFeedback.TYPE_RUMBLE, intensity=0.5)]))
            return page.js('return window.rumbled.filter((one) => one === 0.5).length')
        # The planner says it in each cycle; one rumble lasts 0.12 s, so it is one after the other.
        page.wait(lambda: rumbled() >= 5, 'that it goes on rumbling')
        page.wait(lambda: page.app('app.rumble') == 0, 'its end')
        count = page.js('return window.rumbled.length')
        page.js('window.pad.axes[0] = 0; window.pad.axes[1] = 0')
        wait(lambda: tuple(robot.since(robot.joys, began)[-1].axes[:2]) == (0.0, 0.0), 'the release')
        self.assertEqual(page.js('return window.rumbled.length'), count)


class SlowLink(DriveTest):
    def test_above_the_limit_the_robot_is_asked_to_stop(self):
        page, robot, proxy = stage.page, stage.robot, stage.proxy
        self.drive_off()
        page.wait(lambda: page.text('delay').endswith(' ms') and int(page.text('delay').split()[0]) < 300, 'a quick link')
        held = time.monotonic()
        proxy.hold()
        wait(lambda: robot.state == 'STOPPED' and robot.speed[0] < 0.01, 'STOPPED')
        began = next(when for when, state in robot.states if when >= held and state == 'STOPPED')
        self.assertGreater(began - held, stage.STOP_DELAY - 0.6, 'the last ping may have waited 0.5 s')
        page.wait(lambda: int(page.text('delay').split()[0]) > 1e3 * stage.STOP_DELAY and 'too slow' in page.text('notice'),
                  'that the link is too slow')
        self.assertTrue(page.js("return document.getElementById('delay').parentElement.classList.contains('bad')"))
        proxy.flush()
        page.wait(lambda: int(page.text('delay').split()[0]) < 300, 'a quick link again')
        self.assertEqual(robot.state, 'STOPPED', 'until somebody lets go')
        page.click('letgo')
        wait(lambda: robot.state == 'AUTONOMY', 'on its way again')


if __name__ == '__main__':
    unittest.main()
