# SPDX-License-Identifier: BSD-3-Clause
"""The robot's camera: the newest picture alone, as it came where it is compressed, else as JPEG by Pillow."""
import io
import struct
import time

import rospy
from sensor_msgs.msg import CameraInfo, Image

from . import wire
from .robot import Newest

JPEG, PNG = 1, 2
QUALITY = 70
MODES = {'rgb8': ('RGB', 'RGB', 3), 'bgr8': ('RGB', 'BGR', 3), 'rgba8': ('RGBA', 'RGBA', 4), 'bgra8': ('RGBA', 'BGRA', 4),
         'mono8': ('L', 'L', 1)}
SHOWN = 2.0  # [s] after the last picture: then none come any more


class NoPicture(Exception):
    """A message of which no picture can be made; the text says why."""


def framed(form, stamp, data):
    """A picture as docs/understand/console_protocol.md lays it out."""
    return struct.pack('<B7xd', form, stamp) + data


def picture_of(kind, data):
    """A message (its type and bytes) as the page gets it."""
    if kind == 'sensor_msgs/CompressedImage':
        header, form, content = wire.compressed_image(data)
        if content[:3] == b'\xff\xd8\xff':
            return framed(JPEG, header.stamp, content)
        if content[:8] == b'\x89PNG\r\n\x1a\n':
            return framed(PNG, header.stamp, content)
        raise NoPicture(f'format {form or "without a name"} is neither JPEG nor PNG: publish it as one of them')
    if kind != 'sensor_msgs/Image':
        raise NoPicture(f'{kind} is neither sensor_msgs/CompressedImage nor sensor_msgs/Image')
    image = Image().deserialize(data)
    if image.encoding not in MODES:
        raise NoPicture(f'encoding {image.encoding or "without a name"} is not known here ({", ".join(MODES)} are): '
                        'publish it compressed (image_transport republish)')
    mode, raw, channels = MODES[image.encoding]
    if image.step < image.width * channels or len(image.data) < image.step * image.height:
        raise NoPicture('it has fewer bytes than its size says')
    try:
        from PIL import Image as Pillow
    except ImportError:
        raise NoPicture('Pillow is not installed (python3-pil): install it, or publish the picture compressed') from None
    out = io.BytesIO()
    picture = Pillow.frombuffer(mode, (image.width, image.height), bytes(image.data), 'raw', raw, image.step, 1)
    picture.convert('RGB').save(out, 'JPEG', quality=QUALITY)
    return framed(JPEG, image.header.stamp.to_sec(), out.getvalue())


class Camera:
    """Subscribes while somebody watches. topic '': there is no camera."""

    def __init__(self, topic, info_topic, robot):
        self._topic, self._robot, self._newest, self._fault = topic, robot, None, ''
        self._info = Newest(info_topic) if topic and info_topic else None
        self._watchers, self._since = 0, 0.0  # since when somebody watches
        self._made = (0, None)  # version, picture

    def watch(self, more):
        """One page more (1) or less (-1) asks for pictures."""
        self._watchers += more
        if self._watchers > 0 and self._topic and self._newest is None:
            self._newest, self._made, self._since, self._fault = Newest(self._topic), (0, None), time.monotonic(), ''
        elif self._watchers <= 0 and self._newest:
            self._newest.end()
            self._newest = None

    def picture(self, seen):
        """(version, picture) where there is one that is newer than `seen`, else None. Each is made once."""
        newest = self._newest
        if newest is None or newest.version in (0, seen):
            return None
        if self._made[0] != newest.version:
            version = newest.version
            try:
                self._made, self._fault = (version, picture_of(newest.kind, newest.data)), ''
            except (NoPicture, wire.Broken) as fault:
                rospy.logwarn_throttle(10.0, f'{newest.topic}: no picture can be shown: {fault}')
                self._made, self._fault = (version, None), f'{newest.topic}: {fault}'
        return self._made if self._made[1] is not None else None

    def report(self):
        """The page's `camera`."""
        on = bool(self._topic) and (self._newest is None or self._newest.age() < SHOWN)
        silent = self._newest and not on and time.monotonic() - self._since > SHOWN
        fault = f'{self._newest.topic}: no picture comes' if silent else self._fault
        return {'on': on and not fault, 'fault': fault, 'info': self._calibration()}

    def _calibration(self):
        message = self._info and self._info.message(CameraInfo)
        if not message or not message.width or not message.K[0]:
            return None
        pose = self._robot.pose_of(message.header.frame_id, full=True, target=self._robot.names.base_frame)
        return {'width': message.width, 'height': message.height, 'fx': message.K[0], 'fy': message.K[4], 'cx': message.K[2],
                'cy': message.K[5], 'pose': pose and [round(v, 5) for v in pose]}
