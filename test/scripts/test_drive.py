# SPDX-License-Identifier: BSD-3-Clause
"""Waiting for a drive to be ready, without a ROS graph: subscriptions that get lost."""
import contextlib
import io
import types
import unittest
from unittest import mock

from hidwa_tools import drive
from hidwa_tools.errors import DemoError


class Graph:
    """rospy as far as a Drive uses it. A topic of `lost` brings its message only to so many subscriptions and later ones."""

    def __init__(self, lost):
        self._lost, self.asked = lost, {}

    def Subscriber(self, topic, _kind, receive, queue_size):
        self.asked[topic] = self.asked.get(topic, 0) + 1
        if self.asked[topic] >= self._lost.get(topic, 1):
            receive(types.SimpleNamespace(_buff=bytes(17)))
        return mock.Mock()

    @staticmethod
    def Publisher(*_, **__):
        return types.SimpleNamespace(get_num_connections=lambda: 1)

    @staticmethod
    def init_node(*_, **__):
        pass

    AnyMsg = object


class Ready(unittest.TestCase):
    def ready(self, lost):
        """The graph, once a drive in it is ready; its clock runs by 1 s a look."""
        graph, said = Graph(lost), io.StringIO()
        options = types.SimpleNamespace(global_planner='navfn/NavfnROS', gui=False, operator='avoid')
        clock = types.SimpleNamespace(now=0.0)

        def sleep(_):
            clock.now += 1.0
        time = types.SimpleNamespace(monotonic=lambda: clock.now, sleep=sleep)
        with mock.patch.object(drive, 'rospy', graph), mock.patch.object(drive, 'time', time), \
                contextlib.redirect_stdout(said):
            drive.Drive(options, lambda: True).wait_until_ready()
        return graph, said.getvalue()

    def test_what_comes_is_asked_for_once(self):
        graph, said = self.ready({})
        self.assertEqual(set(graph.asked.values()), {1})
        self.assertEqual(said, '')

    def test_what_got_lost_is_asked_for_anew_and_nothing_else(self):
        graph, said = self.ready({'/scan': 3})
        self.assertEqual(graph.asked.pop('/scan'), 3)
        self.assertEqual(set(graph.asked.values()), {1})
        # After more than 15 and 30 s, by a clock of whole seconds.
        self.assertEqual(said, 'the laser: nothing after 16 s, asked anew\nthe laser: nothing after 31 s, asked anew\n')

    def test_on_a_slow_machine_what_is_on_its_way_gets_ever_more_time(self):
        # Within 180 s after 15, 30, 60 and 120 s: four times after the first one.
        graph = self.ready({'/scan': 5})[0]
        self.assertEqual(graph.asked.pop('/scan'), 5)

    def test_a_map_that_is_slow_to_come_is_waited_for_by_move_base_alone(self):
        self.assertNotIn('/map', self.ready({})[0].asked)

    def test_what_never_comes_is_named(self):
        with self.assertRaisesRegex(DemoError, '^after 180 s still waiting for the laser, move_base, or the map that it needs$'):
            self.ready({'/move_base/status': 99, '/scan': 99})


if __name__ == '__main__':
    unittest.main()
