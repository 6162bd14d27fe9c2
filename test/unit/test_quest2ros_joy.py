#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Tests of scripts/quest2ros_joy: the bytes of a message, without ROS."""
import importlib.machinery
import importlib.util
import os
import struct
import sys
import unittest

HERE = os.path.dirname(os.path.abspath(__file__))
SCRIPT = os.path.join(HERE, os.pardir, os.pardir, 'scripts', 'quest2ros_joy')

sys.dont_write_bytecode = True
_loader = importlib.machinery.SourceFileLoader('quest2ros_joy', SCRIPT)
quest2ros_joy = importlib.util.module_from_spec(importlib.util.spec_from_loader('quest2ros_joy', _loader))
_loader.exec_module(quest2ros_joy)


class TestInputs(unittest.TestCase):
    def test_every_field_has_its_place(self):
        # As ROS 1 serializes it: two bytes for the bools, four little-endian floats.
        data = bytes([1, 0]) + struct.pack('<f', -0.5) + struct.pack('<f', 0.25) + struct.pack('<f', 1.0) + \
            struct.pack('<f', 0.75)
        axes, buttons = quest2ros_joy.read_inputs(data)
        self.assertEqual(axes, [-0.5, 0.25, 1.0, 0.75])
        self.assertEqual(buttons, [1, 0])
        self.assertEqual(quest2ros_joy.read_inputs(bytes([0, 1]) + bytes(16))[1], [0, 1])

    def test_another_message_is_refused(self):
        for size in (0, 17, 19):
            with self.assertRaisesRegex(ValueError, '%d bytes' % size):
                quest2ros_joy.read_inputs(bytes(size))


if __name__ == '__main__':
    unittest.main()
