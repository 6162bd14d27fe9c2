# SPDX-License-Identifier: BSD-3-Clause
import unittest

from hidwa_tools import parameter_list
from hidwa_tools.parameter_list import BadList, parameters

TEXT = '''// HIDWA_DOUBLE(in a comment, 0)
HIDWA_DOUBLE(max_vel_x, 0.5, 0.0, 10.0, "m/s", "Robot", "Largest velocity, forward")
HIDWA_INT   (samples, 40, 2, 2000, "", "Sampling", "Both ends included")

HIDWA_BOOL(escape, true, "Safety", "Out of it")
HIDWA_STRING(topic, "", "Topics", "Empty: none")
HIDWA_ENUM(HoldLinear, hold, operator_, "operator|robot", "Operator", "Whose")
HIDWA_AXIS(clutch, -1, -1, 31, "Operator", "Pressed: positive")
'''


class ParameterList(unittest.TestCase):
    def test_every_kind(self):
        speed, samples, escape, topic, hold, clutch = parameters(TEXT)
        self.assertEqual(
            (speed.kind, speed.name, speed.default, speed.low, speed.high, speed.unit, speed.tab, speed.description),
            ('DOUBLE', 'max_vel_x', '0.5', '0.0', '10.0', 'm/s', 'Robot', 'Largest velocity, forward'))
        self.assertEqual((samples.kind, samples.low, samples.high, samples.unit), ('INT', '2', '2000', ''))
        self.assertEqual((escape.kind, escape.default, escape.unit, escape.choices), ('BOOL', 'true', '', []))
        self.assertEqual((topic.kind, topic.default, topic.description), ('STRING', '', 'Empty: none'))
        self.assertEqual((hold.kind, hold.default, hold.choices), ('ENUM', 'operator', ['operator', 'robot']))
        self.assertEqual((clutch.kind, clutch.default, clutch.low, clutch.high, clutch.tab), ('AXIS', '-1', '-1', '31', 'Operator'))

    def test_a_bad_line_is_named(self):
        for line, fault in (('HIDWA_BOOL(escape,', 'line 2: a declaration must stand on one line'),
                            ('HIDWA_FLOAT(a, 1, "T", "d")', 'line 2: unknown kind of parameter HIDWA_FLOAT'),
                            ('HIDWA_BOOL(a, true, "d")', 'line 2: HIDWA_BOOL takes 4 values, not 3')):
            with self.assertRaises(BadList) as found:
                parameters('\n' + line)
            self.assertEqual(str(found.exception), fault)

    def test_no_topic_is_among_what_the_page_may_set(self):
        self.assertEqual([p.name for p in parameter_list.read() if p.tab in ('Operator', 'Critics') and p.name.endswith('_topic')], [])

    def test_the_planners_own(self):
        own = {p.name: p for p in parameter_list.read()}
        self.assertEqual((own['mode'].kind, own['mode'].choices), ('ENUM', ['off', 'joystick', 'gesture', 'switching']))
        for p in own.values():
            if p.kind in ('DOUBLE', 'INT'):
                self.assertTrue(float(p.low) <= float(p.default) <= float(p.high), p.name)
            if p.kind == 'ENUM':
                self.assertIn(p.default, p.choices, p.name)


if __name__ == '__main__':
    unittest.main()
