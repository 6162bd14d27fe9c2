#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Tests of scripts/joy_reader, fed from pipes: no device and no ROS needed."""
import importlib.machinery
import importlib.util
import os
import struct
import sys
import tempfile
import threading
import time
import unittest

HERE = os.path.dirname(os.path.abspath(__file__))
SCRIPT = os.path.join(HERE, os.pardir, os.pardir, "scripts", "joy_reader")

sys.dont_write_bytecode = True
_loader = importlib.machinery.SourceFileLoader("joy_reader", SCRIPT)
joy_reader = importlib.util.module_from_spec(importlib.util.spec_from_loader("joy_reader", _loader))
_loader.exec_module(joy_reader)


def event(value, kind, number):
    return struct.pack("=IhBB", 0, value, kind, number)


AXIS, BUTTON, INIT = joy_reader.AXIS, joy_reader.BUTTON, joy_reader.INIT


class TestScaling(unittest.TestCase):
    def test_left_and_up_are_positive(self):
        # The kernel reports left and up as -32767.
        state = joy_reader.JoyState(deadzone=0.0)
        self.assertEqual(state.scaled(-32767), 1.0)
        self.assertEqual(state.scaled(32767), -1.0)
        self.assertEqual(state.scaled(-32768), 1.0)  # clipped
        self.assertEqual(state.scaled(0), 0.0)

    def test_dead_zone_is_taken_away_smoothly(self):
        state = joy_reader.JoyState(deadzone=0.1)
        self.assertEqual(state.scaled(3276), 0.0)
        self.assertEqual(state.scaled(-3276), 0.0)
        # Half way: (0.5 - 0.1) / (1 - 0.1) = 0.4444.
        self.assertAlmostEqual(state.scaled(-16384), (16384 / 32767 - 0.1) / 0.9, places=9)
        self.assertEqual(state.scaled(32767), -1.0)

    def test_bad_dead_zone_is_refused(self):
        with self.assertRaisesRegex(ValueError, "deadzone"):
            joy_reader.JoyState(deadzone=1.0)


class TestEvents(unittest.TestCase):
    def test_initial_axes_count_only_with_default_trig_val(self):
        for default_trig_val, expected in ((False, 0.0), (True, 1.0)):
            state = joy_reader.JoyState(default_trig_val=default_trig_val)
            state.resize(6, 0)
            state.apply(-32767, AXIS | INIT, 5)
            self.assertEqual(state.axes[5], expected)

    def test_buttons(self):
        state = joy_reader.JoyState()
        self.assertEqual(state.apply(1, BUTTON, 2), "button")
        self.assertEqual(state.buttons, [0, 0, 1])
        self.assertIsNone(state.apply(1, BUTTON, 2))
        self.assertEqual(state.apply(0, BUTTON, 2), "button")
        self.assertEqual(state.buttons, [0, 0, 0])

    def test_sticky_buttons_toggle_on_press(self):
        state = joy_reader.JoyState(sticky_buttons=True)
        seen = []
        for value in (1, 0, 1, 0):
            state.apply(value, BUTTON, 0)
            seen.append(state.buttons[0])
        self.assertEqual(seen, [1, 1, 0, 0])

    def test_unknown_kinds_are_ignored(self):
        state = joy_reader.JoyState()
        self.assertIsNone(state.apply(1, 0x40, 0))
        self.assertEqual((state.axes, state.buttons), ([], []))

    def test_events_cut_anywhere(self):
        read_end, write_end = os.pipe()
        data = event(-32767, AXIS, 0) + event(1, BUTTON, 3)
        reader = joy_reader.EventReader(read_end)
        seen = []
        for part in (data[:3], data[3:11], data[11:]):
            os.write(write_end, part)
            seen += reader.read()
        self.assertEqual(seen, [(-32767, AXIS, 0), (1, BUTTON, 3)])
        os.close(write_end)
        with self.assertRaises(EOFError):
            reader.read()
        os.close(read_end)


class TestSchedule(unittest.TestCase):
    def test_button_at_once_axis_after_interval(self):
        schedule = joy_reader.Schedule(0.0, 0.01)
        schedule.changed("axis", 5.0)
        self.assertEqual(schedule.due, 5.01)
        schedule.changed("axis", 5.008)
        self.assertEqual(schedule.due, 5.01)
        schedule.changed("button", 5.009)
        self.assertEqual(schedule.due, 5.009)
        schedule.sent(5.009)
        self.assertIsNone(schedule.due)

    def test_repeats(self):
        schedule = joy_reader.Schedule(20.0, 0.001)
        schedule.sent(1.0)
        self.assertEqual(schedule.due, 1.05)

    def test_contradiction_is_refused(self):
        with self.assertRaisesRegex(ValueError, "coalesce_interval"):
            joy_reader.Schedule(20.0, 0.1)


class TestReader(unittest.TestCase):
    """The whole loop on a named pipe that stands for the device."""

    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.path = os.path.join(self.folder.name, "js")
        os.mkfifo(self.path)
        self.messages, self.said, self.stop = [], [], False
        self.pause, joy_reader.RETRY = joy_reader.RETRY, 0.01

    def tearDown(self):
        self.stop = True
        self.thread.join()
        joy_reader.RETRY = self.pause
        self.folder.cleanup()

    def start(self):
        reader = joy_reader.Reader(self.path, joy_reader.JoyState(deadzone=0.0),
                                   joy_reader.Schedule(50.0, 0.0), lambda axes, buttons:
                                   self.messages.append((list(axes), list(buttons))),
                                   lambda: not self.stop, lambda level, text: self.said.append(text))
        self.thread = threading.Thread(target=reader.run)
        self.thread.start()

    def wait_for(self, condition):
        end = time.monotonic() + 10.0
        while not condition() and time.monotonic() < end:
            time.sleep(0.002)
        self.assertTrue(condition(), "messages %s, said %s" % (self.messages[-3:], self.said[-3:]))

    def test_repeats_then_device_goes_and_returns(self):
        writer = os.open(self.path, os.O_RDWR)
        self.start()
        os.write(writer, event(-32767, AXIS, 0))
        # Without further events: repeated.
        self.wait_for(lambda: [m[0] for m in self.messages].count([1.0]) >= 3)
        os.unlink(self.path)  # as udev does it
        os.close(writer)
        # Silent: no message says that the stick was centred.
        self.wait_for(lambda: any("cannot open" in text for text in self.said))
        self.assertTrue(any("went away" in text for text in self.said))
        self.assertEqual(self.messages[-1][0], [1.0])
        # It is back, with a button held: no message says that the button was released.
        before, back = len(self.messages), self.path + "_back"
        os.mkfifo(back)
        writer = os.open(back, os.O_RDWR)
        os.write(writer, event(1, BUTTON | INIT, 1))
        os.rename(back, self.path)
        self.wait_for(lambda: len(self.messages) > before)
        self.assertEqual(self.messages[before][1], [0, 1])
        os.close(writer)

    def test_missing_device_is_told_once_and_awaited(self):
        os.unlink(self.path)
        self.start()
        self.wait_for(lambda: any("cannot open" in text and self.path in text for text in self.said))
        os.mkfifo(self.path)
        writer = os.open(self.path, os.O_RDWR)
        os.write(writer, event(32767, AXIS, 1))
        self.wait_for(lambda: self.messages and self.messages[-1][0] == [0.0, -1.0])
        self.assertEqual(sum("cannot open" in text for text in self.said), 1)
        os.close(writer)


if __name__ == "__main__":
    unittest.main()
