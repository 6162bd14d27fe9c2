# SPDX-License-Identifier: BSD-3-Clause
"""The page, the console and the simulated robot together: what a person does in the browser, and what the robot does then.

One robot and one browser for all tests (stage.py).
"""
import time
import unittest

import numpy
import stage
from stage import DriveTest, address, cycles, wait


def setUpModule():
    global robot, proxy, page
    robot, proxy, page = stage.begin()


class Drive(DriveTest):
    def test_a_both_views_show_the_robot_where_it_is(self):
        x, y, _ = robot.pose
        shown = page.app('[app.scene.robot.x, app.scene.robot.y]')
        self.assertAlmostEqual(shown[0], x, delta=0.15)
        self.assertAlmostEqual(shown[1], y, delta=0.15)
        page.wait(lambda: page.app('Boolean(app.board && app.board.base && app.board.shown)'))
        for view, hide in (('board-canvas', '(app.board.body.visible = %s, app.board.dirty = true)'),
                           ('above-canvas', '(app.above.%s, app.above.dirty = true)')):
            off, on = 'false', 'true'
            if view == 'above-canvas':
                off, on = 'robot = () => {}', 'robot = Object.getPrototypeOf(app.above).robot'
            with_robot = numpy.asarray(page.crop(view), dtype=int)
            page.app(hide % off)
            changed = page.wait(lambda: self.difference(view, with_robot, 50), 'pixels of the robot in ' + view)
            page.app(hide % on)
            if view == 'above-canvas':
                rows, columns = changed
                # The median: what else changes meanwhile lies elsewhere.
                self.assertAlmostEqual(numpy.median(columns), with_robot.shape[1] / 2, delta=8)
                self.assertAlmostEqual(numpy.median(rows), with_robot.shape[0] / 2, delta=8)

    @staticmethod
    def difference(view, before, least):
        changed = numpy.nonzero(numpy.abs(numpy.asarray(page.crop(view), dtype=int) - before).max(axis=2) > 20)
        return changed if changed[0].size >= least else None

    def test_b_a_goal_by_a_click_is_reached(self):
        began = time.monotonic()
        x0, y0, _ = robot.pose
        page.click('go')
        x, y, _, _ = page.middle('above-canvas')
        scale = page.app('app.above.camera.scale')
        ahead = 90
        page.mouse('mousePressed', x + ahead, y)
        page.mouse('mouseReleased', x + ahead, y)
        wait(lambda: robot.state != '', 'the planner runs')
        wait(lambda: robot.state == '' and robot.since(robot.states, began), 'the goal is reached')
        self.assertAlmostEqual(robot.pose[0], x0 + ahead / scale, delta=0.4)
        self.assertAlmostEqual(robot.pose[1], y0, delta=0.4)

    def test_c_the_stick_dragged_left_makes_the_robot_deviate_left(self):
        sense = self.drive_off()
        y0 = robot.pose[1]
        began = time.monotonic()
        at = self.take_over(-0.9, 0)
        wait(lambda: any(joy.axes[0] > 0.8 for joy in robot.since(robot.joys, began)), 'Joy to the left (+1)')
        wait(lambda: 'SHARED' in robot.since(robot.states, began), 'SHARED')
        self.turns_left(began)
        wait(lambda: sense * (robot.pose[1] - y0) > 0.25, 'a deviation to the left of 0.25 m')
        self.release_stick(at)
        wait(lambda: robot.state in ('HOLD', 'AUTONOMY'), 'autonomy again')

    def test_d_stop_and_let_go(self):
        self.drive_off()
        page.click('stop')
        wait(lambda: robot.state == 'STOPPED' and robot.speed[0] < 0.01, 'STOPPED and at rest')
        page.wait(lambda: page.text('state-title') == 'Stopped')
        page.click('letgo')
        wait(lambda: robot.state == 'AUTONOMY' and robot.speed[0] > 0.2, 'on its way again')

    def test_e_a_link_cut_while_steering_is_lost_and_the_page_says_so(self):
        self.drive_off()
        began = time.monotonic()
        at = self.steer(-0.8, 0)
        cut = time.monotonic()
        proxy.cut()
        wait(lambda: 'LOST' in robot.since(robot.states, cut), 'LOST')
        last = robot.since(robot.joys, began)[-1]
        self.assertGreater(abs(last.axes[0]), 0.5, 'no release was sent for it')
        page.wait(lambda: 'The link is cut' in page.text('notice'))
        proxy.mend()
        page.wait(lambda: page.app('Boolean(app.holder.mine)'), 'the controls again')
        mended = time.monotonic()
        page.mouse('mouseMoved', at[0] + 3, at[1])
        cycles(10)
        self.assertEqual(robot.steered(mended), [], 'what is still held does not steer')
        self.release_stick(at)
        wait(lambda: robot.state == 'AUTONOMY', 'autonomy again')

    def test_f_two_seconds_of_frames_at_once_steer_nothing_and_a_stop_in_them_counts(self):
        self.drive_off()
        at = self.steer(-0.8, 0)
        proxy.hold()
        cycles(20)
        page.click('stop')
        cycles(20)
        self.assertNotEqual(robot.state, 'STOPPED')
        flushed = time.monotonic()
        proxy.flush()
        self.release_stick(at)
        wait(lambda: robot.state == 'STOPPED', 'the stop counts')
        cycles(10)
        self.assertEqual(robot.steered(flushed), [])
        page.click('letgo')

    def test_g_a_stop_stays_when_the_tab_is_hidden_cut_and_closed(self):
        self.drive_off()
        page.click('stop')
        wait(lambda: robot.state == 'STOPPED' and robot.speed[0] < 0.01, 'STOPPED')
        first = page.driver.current_window_handle
        page.driver.switch_to.new_window('tab')
        cycles(14)
        self.assertEqual(robot.state, 'STOPPED', 'hidden')
        page.driver.switch_to.window(first)
        proxy.cut()
        cycles(14)
        self.assertEqual(robot.state, 'STOPPED', 'cut')
        proxy.mend()
        page.wait(lambda: page.app('Boolean(app.holder.mine)'))
        page.driver.close()
        page.driver.switch_to.window(page.driver.window_handles[0])
        page.prepare()
        cycles(14)
        self.assertEqual(robot.state, 'STOPPED', 'closed')
        began = time.monotonic()
        page.open(address())
        page.wait(lambda: page.app('Boolean(app.holder.mine)'), 'the controls')
        page.until("return !document.getElementById('letgo').hidden")
        self.assertEqual(set(robot.since(robot.states, began)), {'STOPPED'})
        page.click('letgo')
        wait(lambda: robot.state == 'AUTONOMY', 'on its way again')

    def test_h_a_hidden_tab_releases_at_once(self):
        self.drive_off()
        self.steer(-0.8, 0)
        first = page.driver.current_window_handle
        page.driver.switch_to.new_window('tab')
        wait(lambda: robot.state in ('HOLD', 'AUTONOMY'), 'released')
        cycles(4)  # what was on its way has come
        quiet = time.monotonic()
        cycles(12)  # more than the planner's timeout
        self.assertEqual(robot.since(robot.joys, quiet), [], 'silence')
        self.assertNotIn('LOST', robot.since(robot.states, quiet))
        page.driver.close()
        page.driver.switch_to.window(first)

    def test_i_a_second_visitor_watches_stops_and_takes_over(self):
        self.drive_off()
        first = page.driver.current_window_handle
        page.driver.switch_to.new_window('tab')
        second = page.driver.current_window_handle
        try:
            page.open(address())
            page.until("return document.getElementById('claim').textContent === 'Ask for the controls'")
            began = time.monotonic()
            at = self.press_stick(-0.9, 0)
            page.wait(lambda: 'watching' in page.text('notice'))
            self.release_stick(at)
            self.assertEqual(robot.steered(began), [])
            page.driver.switch_to.window(first)
            self.drive_off()  # on a slow machine the first goal is reached by now
            page.driver.switch_to.window(second)
            page.click('stop')
            wait(lambda: robot.state == 'STOPPED', 'a watcher stops')
            page.app("app.send('stop', {on: false})")
            cycles(10)
            self.assertEqual(robot.state, 'STOPPED', 'a watcher cannot let go')
            page.click('claim')
            page.driver.switch_to.window(first)
            page.until("return !document.getElementById('request').hidden")
            page.click('request-yes')
            page.driver.switch_to.window(second)
            page.wait(lambda: page.app('Boolean(app.holder.mine)'), 'the handover')
            page.click('letgo')
            wait(lambda: robot.state == 'AUTONOMY', 'the new holder lets go')
        finally:
            page.driver.switch_to.window(second)
            page.app("app.send('give')")
            page.driver.close()
            page.driver.switch_to.window(first)
            page.app("app.send('claim')")
            page.wait(lambda: page.app('Boolean(app.holder.mine)'))

    def test_j_take_control_drive_and_give_it_back(self):
        self.mode('switching')
        self.drive_off()
        page.click('take')
        wait(lambda: robot.state == 'MANUAL', 'MANUAL')
        wait(lambda: abs(robot.speed[0]) < 0.02, 'no input means stop')
        at = self.steer(0, -0.9, lambda: robot.speed[0] > 0.2)
        self.release_stick(at)
        wait(lambda: abs(robot.speed[0]) < 0.02, 'rest')
        self.assertEqual(robot.state, 'MANUAL', 'a centred stick in MANUAL is not lost')
        page.until("return document.getElementById('take').textContent === 'Give control back'")
        page.click('take')
        wait(lambda: robot.state == 'AUTONOMY', 'autonomy again')


if __name__ == '__main__':
    unittest.main()
