# SPDX-License-Identifier: BSD-3-Clause
"""ROS messages into arrays and on to the page, each against its slow twin: the generated classes, and the reader of the protocol's
page."""
import glob
import math
import os
import random
import re
import struct
import types
import unittest
from io import BytesIO
from unittest import mock

import numpy as np
import paths
from geometry_msgs.msg import Pose2D, PoseStamped
from hidwa_local_planner.msg import CriticScore, Evaluation, TrajectoryScore
from map_msgs.msg import OccupancyGridUpdate
from nav_msgs.msg import OccupancyGrid, Path
from sensor_msgs.msg import CompressedImage, Image, LaserScan
from std_msgs.msg import String

import page_twin
from hidwa_console import layouts, wire
from hidwa_console.camera import JPEG, PNG, Camera, NoPicture, picture_of
from hidwa_console.outputs import joy_of, position_of
from hidwa_console.planar import composed, inverse, moved
from hidwa_console.scene import GridPart, Scene
from hidwa_console.steering import Hand, Stick


def bytes_of(message):
    out = BytesIO()
    message.serialize(out)
    return out.getvalue()


def some_path(frames):
    path = Path()
    path.header.frame_id = 'map'
    path.header.stamp.secs = 7
    for i, frame in enumerate(frames):
        pose = PoseStamped()
        pose.header.frame_id, pose.header.stamp.secs, pose.header.stamp.nsecs = frame, 7 + i, 500000000
        pose.pose.position.x, pose.pose.position.y = 0.5 * i, -i
        pose.pose.orientation.z, pose.pose.orientation.w = math.sin(0.1 * i), math.cos(0.1 * i)
        path.poses.append(pose)
    return path


class Wire(unittest.TestCase):
    def test_paths(self):
        for frames in ([], ['map'] * 5, ['map', 'odom', '', 'map']):
            header, rows = wire.path(bytes_of(some_path(frames)))
            self.assertEqual(header, (7.0, 'map'))
            # The pose i: x = i/2, y = -i, yaw = 2 * 0.1 i, stamp 7.5 + i.
            expected = [(0.5 * i, -i, 0.2 * i, 7.5 + i) for i in range(len(frames))]
            np.testing.assert_allclose(rows, np.array(expected).reshape(-1, 4), atol=1e-12)

    def test_grids(self):
        grid = OccupancyGrid()
        grid.header.frame_id, grid.info.width, grid.info.height, grid.info.resolution = 'map', 3, 2, 0.05
        grid.info.origin.position.x, grid.info.origin.orientation.w = -1.0, 1.0
        grid.data = [0, 100, -1, 50, 99, 0]
        read = wire.grid(bytes_of(grid))
        self.assertEqual((read.width, read.height, read.origin, list(read.cells)), (3, 2, (-1.0, 0.0, 0.0), [0, 100, 255, 50, 99, 0]))
        grid.data = [0] * 5
        with self.assertRaises(wire.Broken):
            wire.grid(bytes_of(grid))
        update = OccupancyGridUpdate(x=1, y=0, width=2, height=1, data=[-1, 7])
        self.assertEqual(list(wire.grid_update(bytes_of(update)).cells), [255, 7])

    def test_scans(self):
        scan = LaserScan(angle_min=-1.0, angle_increment=0.25, range_min=0.1, range_max=10.0, ranges=[1.0, float('inf'), 0.5])
        read = wire.scan(bytes_of(scan))
        message = layouts.scan((1.0, 2.0, 3.0), read.angle_min, read.angle_increment, read.ranges, read.range_min, read.range_max)
        self.assertEqual(struct.unpack('<B3x3dffI3H', message), (3, 1.0, 2.0, 3.0, -1.0, 0.25, 3, 1000, 0, 500))

    def test_a_laser_upside_down_is_mirrored(self):
        scan = LaserScan(angle_min=-1.0, angle_increment=0.25, range_min=0.1, range_max=10.0, ranges=[1.0, float('inf'), 0.5])
        scan.header.frame_id = 'laser'
        half = 0.5 * 0.3  # [rad]; yaw of 0.3
        for rotation, turn in (((0.0, 0.0, math.sin(half), math.cos(half)), 1.0),
                               ((math.cos(half), math.sin(half), 0.0, 0.0), -1.0)):  # about x by pi, then about z
            robot = types.SimpleNamespace(pose_of=lambda frame, full: (1.0, 2.0, 0.4, *rotation) if frame == 'laser' else None)
            scene = Scene(robot, None, {})
            scene._on_scan(types.SimpleNamespace(data=bytes_of(scan)))  # pylint: disable=protected-access
            *head, first, second, third = struct.unpack('<B3x3dffI3H', scene.binary['scan'].value)
            np.testing.assert_allclose(head, (3, 1.0, 2.0, 0.3, -turn, 0.25 * turn, 3), atol=1e-9)
            self.assertEqual((first, second, third), (1000, 0, 500))

    def test_candidates(self):
        evaluation = Evaluation(best_index=1)
        for i in range(3):
            score = TrajectoryScore(total=-1.0 if i == 2 else 10.0 * i, refused_by='Collision' if i == 2 else '')
            score.traj.velocity.linear.x, score.traj.velocity.angular.z = 0.5, 0.1 * i
            score.traj.poses = [Pose2D(0.1 * k, 0.01 * i * k, 0.0) for k in range(1, 11 + i)]
            score.traj.time_offsets = [0.1 * k for k in range(1, 11 + i)]
            score.scores = [CriticScore('PathDist', 1.0, 2.0)] * i
            evaluation.twists.append(score)
        _, found, best = wire.evaluation(bytes_of(evaluation))
        self.assertEqual((len(found), best), (3, 1))
        message = layouts.candidates((0.0, 0.0, 0.0), found, best)
        self.assertEqual(struct.unpack_from('<B3x3dIII', message), (5, 0.0, 0.0, 0.0, 3, 8, 1))
        entry = struct.unpack_from('<3f16h', message, struct.calcsize('<B3x3dIII') + 2 * struct.calcsize('<3f16h'))
        self.assertAlmostEqual(entry[0], -1.0)
        self.assertAlmostEqual(entry[2], 0.2, places=6)
        self.assertEqual(entry[3:5], (100, 20))     # the first pose: 0.1 m ahead, 0.01 * 2 * 1 m left
        self.assertEqual(entry[-2:], (1200, 240))   # the last of 12: 1.2 m, 0.01 * 2 * 12 m

    def test_cut_short_anywhere_it_is_broken_and_nothing_else(self):
        evaluation = Evaluation(twists=[TrajectoryScore(scores=[CriticScore('a', 1.0, 1.0)])])
        for message, read in ((some_path(['map', 'odom']), wire.path), (LaserScan(ranges=[1.0] * 4), wire.scan),
                              (evaluation, wire.evaluation), (CompressedImage(data=b'12345'), wire.compressed_image),
                              (OccupancyGridUpdate(width=2, height=1, data=[1, 2]), wire.grid_update)):
            data = bytes_of(message)
            for length in range(len(data) - 1):
                try:
                    read(data[:length])
                except wire.Broken:
                    continue
                self.assertIn(read, (wire.scan, wire.evaluation))  # the last array of a scan is not read, nor the last two numbers


class Grids(unittest.TestCase):
    def test_runs_of_any_length(self):
        for lengths in ([1], [127], [128], [1, 16384, 2, 128, 300000]):
            cells = np.concatenate([np.full(n, i % 256, np.uint8) for i, n in enumerate(lengths)])
            self.assertEqual(page_twin.read_runs(layouts.runs(cells), 0, len(cells)), cells.tolist())

    def test_a_rolling_grid_arrives_as_it_is(self):
        dice = np.random.RandomState(2)
        world = dice.choice([0, 50, 100, 255], (60, 60)).astype(np.uint8)
        part, shown, steps = GridPart(layouts.COSTMAP), None, 0
        x, y = 20, 20
        for _ in range(40):
            x, y = x + dice.randint(-2, 3), y + dice.randint(-2, 3)
            world[dice.randint(60), dice.randint(60)] ^= 7
            cells = world[y:y + 15, x:x + 12].copy()
            grid = wire.Grid(wire.Header(0.0, 'odom'), 0.05, 12, 15, (0.05 * x, 0.05 * y, 0.0), cells.ravel())
            part.put(grid, (0.05 * x, 0.05 * y, 0.0))
            message = part.since(shown['version'] if shown else 0)
            if message is None:
                continue
            steps += message[0] == layouts.CHANGE
            shown = page_twin.read_grid(message) if message[0] == layouts.GRID else page_twin.change_grid(shown, message)
            self.assertEqual(shown['cells'], cells.ravel().tolist())
            self.assertEqual(shown['pose'], (0.05 * x, 0.05 * y, 0.0))
        self.assertGreater(steps, 30)

    def test_who_missed_a_version_gets_it_whole(self):
        part = GridPart(layouts.COSTMAP)
        for i in range(3):
            cells = np.full(6, i, np.uint8)
            part.put(wire.Grid(wire.Header(0.0, 'odom'), 0.05, 3, 2, (0.0, 0.0, 0.0), cells), (0.0, 0.0, 0.0))
        self.assertEqual([part.since(seen)[0] for seen in (0, 1, 2)], [layouts.GRID, layouts.GRID, layouts.CHANGE])
        self.assertIsNone(part.since(3))


class Plane(unittest.TestCase):
    def test_there_and_back(self):
        dice = random.Random(1)
        for _ in range(50):
            a, b = [tuple(dice.uniform(-3, 3) for _ in range(3)) for _ in range(2)]
            np.testing.assert_allclose(composed(inverse(a), composed(a, b)), b, atol=1e-9)
            np.testing.assert_allclose(moved(a, [b[:2]])[0], composed(a, b)[:2], atol=1e-9)


class Device(unittest.TestCase):
    def test_a_stick_as_the_parameters_ask_for_it(self):
        axes, buttons = joy_of(Stick(0.5, -1.0, True), {})
        self.assertEqual((axes[:2], len(axes), sum(buttons), len(buttons)), ([0.5, -1.0], 8, 0, 11))
        unity = {'axis_angular': '3 reversed', 'axis_linear': '9', 'enable_button': 12, 'mode': 'joystick'}
        trigger = {'axis_linear_rest': 1.0, 'axis_linear': '1 reversed'}  # pressed to -1; it knows no way back
        self.assertEqual([joy_of(Stick(0.0, forward, True), trigger)[0][1] for forward in (0.0, 0.5, 1.0, -1.0)],
                         [1.0, 0.0, -1.0, 1.0])
        axes, buttons = joy_of(Stick(0.5, -1.0, True), unity)
        self.assertEqual((axes, buttons), ([0, 0, 0, -0.5, 0, 0, 0, 0, 0, -1.0], [0] * 12 + [1]))

    def test_a_hand(self):
        hand = Hand(0.2, 0.1, -0.3, True)
        p = {'mode': 'gesture', 'clutch_button': 2}
        self.assertEqual(joy_of(hand, p)[1][:4], [0, 0, 1, 0])
        self.assertEqual(joy_of(hand._replace(grip=False), p)[1][:4], [0, 0, 0, 0])
        self.assertEqual(joy_of(hand, {**p, 'clutch_axis': '3 reversed'})[0][3], -1.0)
        self.assertEqual(joy_of(hand._replace(grip=False), {**p, 'clutch_axis': '3'})[0][3], 0.0)
        self.assertEqual(position_of(hand, {}), [0.1, 0.2, -0.3])  # x ahead, y left, z up
        unity = {'gesture_axis': '-x', 'gesture_linear_axis': 'z'}
        self.assertEqual(position_of(hand, unity), [-0.2, -0.3, 0.1])


class Pictures(unittest.TestCase):
    def test_compressed_ones_pass(self):
        for head, form in ((b'\xff\xd8\xff\xe0', JPEG), (b'\x89PNG\r\n\x1a\n', PNG)):
            image = CompressedImage(format='whatever', data=head + b'rest')
            image.header.stamp.secs = 4
            self.assertEqual(picture_of(image._type, bytes_of(image)), struct.pack('<B7xd', form, 4.0) + head + b'rest')
        with self.assertRaises(NoPicture):
            picture_of('sensor_msgs/CompressedImage', bytes_of(CompressedImage(data=b'<svg onload=...>')))

    def test_raw_ones_become_jpeg(self):
        from PIL import Image as Pillow
        for encoding, pixel in (('rgb8', bytes([250, 0, 0])), ('bgr8', bytes([0, 0, 250]))):
            image = Image(width=16, height=8, encoding=encoding, step=16 * 3 + 5, data=(pixel * 16 + b'extra') * 8)
            message = picture_of(image._type, bytes_of(image))
            picture = Pillow.open(BytesIO(message[16:]))
            self.assertEqual((message[0], picture.size, picture.format), (JPEG, (16, 8), 'JPEG'))
            red, green, blue = picture.getpixel((8, 4))
            self.assertTrue(red > 200 and green < 40 and blue < 40)

    def test_what_is_none(self):
        for image in (Image(width=4, height=4, encoding='rgb8', step=12, data=b'short'),
                      Image(width=4, height=4, encoding='bayer', step=4)):
            with self.assertRaises(NoPicture):
                picture_of(image._type, bytes_of(image))
        with self.assertRaises(NoPicture):
            picture_of('std_msgs/String', b'')

    def test_says_which_kind_it_does_not_know(self):
        depth = Image(width=4, height=4, encoding='16UC1', step=8, data=bytes(32))
        theora = CompressedImage(format='theora', data=b'OggS')
        for message, kind in ((depth, '16UC1'), (theora, 'theora'), (String('x'), 'std_msgs/String')):
            robot = mock.Mock()
            with mock.patch('hidwa_console.camera.Newest') as newest, mock.patch('hidwa_console.camera.rospy'):
                camera = Camera('/eye/image', '', robot)
                camera.watch(1)
                topic = newest.return_value
                topic.topic, topic.version, topic.kind, topic.data = '/eye/image', 1, message._type, bytes_of(message)
                topic.age.return_value = 0.1
                self.assertIsNone(camera.picture(0))
                self.assertFalse(camera.report()['on'])
                self.assertIn(kind, camera.report()['fault'])
                self.assertIn('/eye/image', camera.report()['fault'])
                good = CompressedImage(format='jpeg', data=b'\xff\xd8\xff')
                topic.version, topic.kind, topic.data = 2, good._type, bytes_of(good)
                self.assertEqual(camera.picture(1)[0], 2)
                self.assertEqual((camera.report()['on'], camera.report()['fault']), (True, ''))

    def test_says_that_none_comes(self):
        with mock.patch('hidwa_console.camera.Newest') as newest, mock.patch('hidwa_console.camera.time.monotonic') as now:
            now.return_value = 50.0
            camera = Camera('/eye/image', '', mock.Mock())
            self.assertEqual((camera.report()['on'], camera.report()['fault']), (True, ''))
            camera.watch(1)
            newest.return_value.topic, newest.return_value.age.return_value = '/eye/image', float('inf')
            self.assertEqual(camera.report()['fault'], '')
            now.return_value += 2.1
            self.assertEqual(camera.report()['fault'], '/eye/image: no picture comes')


class Words(unittest.TestCase):
    def test_the_page_spells_as_the_planner_who_refuses(self):
        def text(*path):
            with open(os.path.join(paths.ROOT, *path), encoding='utf-8') as file:
                return file.read()
        refusals = re.search(r'REFUSALS = \{(.*?)\};', text('console', 'page', 'model', 'words.js'), re.S).group(1)
        keys = {quoted or plain for quoted, plain in re.findall(r"^ *(?:'([^']+)'|(\w+)):", refusals, re.M)}
        checks = re.search(r'kNames\[\] = \{(.*?)\};', text('src', 'core', 'evaluation', 'critic_set.cpp')).group(1)
        names = set(re.findall(r'"([^"]*)"', checks))
        names.update(re.findall(r'kUnknownCells = "([^"]*)"', text('src', 'core', 'planner', 'explanation.cpp')))
        for path in glob.glob(os.path.join(paths.ROOT, 'src', 'critics', '*.cpp')):
            names.update(re.findall(r'BuiltInEntry entry\("(\w+)"', text(path)))
        self.assertGreater(len(names), 10)
        self.assertEqual(keys - names, set(), 'words that the planner never says')
        self.assertEqual({'Collision', 'Unknown cells', 'Braking', 'Moving obstacle'} - keys, set(), 'checks of the planner without words')


if __name__ == '__main__':
    unittest.main()
