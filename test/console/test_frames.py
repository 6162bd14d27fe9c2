# SPDX-License-Identifier: BSD-3-Clause
"""The console's fuzzer for as long as a test may take, always with the same frames; scripts/fuzz console goes on for longer."""
import os
import sys
import unittest

import paths

sys.path.insert(0, os.path.join(paths.ROOT, 'test', 'fuzz'))

import console_frames  # noqa: E402


class Frames(unittest.TestCase):
    def test_whatever_comes_is_taken_or_refused(self):
        given, finding = console_frames.run(seed=1, inputs=20000)
        self.assertIsNone(finding, finding)
        self.assertEqual(given, 20000)

    def test_a_finding_is_told_with_the_frame_that_repeats_it(self):
        class Careless:
            """A parser that lets everything through."""
            Malformed = console_frames.messages.Malformed
            FARTHEST = console_frames.messages.FARTHEST

            @staticmethod
            def read(_):
                raise KeyError('type')
        kept, console_frames.messages = console_frames.messages, Careless
        try:
            given, finding = console_frames.run(seed=1, inputs=1000)
        finally:
            console_frames.messages = kept
        self.assertLess(given, 1000)
        self.assertIn('KeyError', finding)
        self.assertIn(f'frame {given} of seed 1', finding)


if __name__ == '__main__':
    unittest.main()
