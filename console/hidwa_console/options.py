# SPDX-License-Identifier: BSD-3-Clause
"""The command line of the console's node. Standard library only."""
import argparse
import os

from .access import is_loopback, place_of, split_host

PORT = 8790


def host_name(text):
    """A name or address, without port."""
    name, port = split_host(f'[{text}]' if text.count(':') > 1 and not text.startswith('[') else text)
    if not name or port is not None:
        raise argparse.ArgumentTypeError(f"'{text}' is no host name (give it without port)")
    return name


def origin(text):
    """https://HOST or http://HOST:PORT"""
    if not text.startswith(('http://', 'https://')) or not split_host(text.split('//', 1)[1].rstrip('/'))[0]:
        raise argparse.ArgumentTypeError(f"'{text}' is no origin: give https://HOST or http://HOST:PORT")
    return text


def seconds(text):
    """A time [s], 0 or more."""
    try:
        value = float(text)
    except ValueError:
        value = -1.0
    if not 0.0 <= value <= 60.0:
        raise argparse.ArgumentTypeError(f"'{text}' is no time from 0 to 60 s")
    return value


def file_name(text):
    """A file that is there."""
    if not os.path.isfile(text):
        raise argparse.ArgumentTypeError(f"there is no file '{text}'")
    return text


def pose(text):
    """X,Y,YAW"""
    try:
        values = tuple(float(part) for part in text.split(','))
    except ValueError:
        values = ()
    if len(values) != 3:
        raise argparse.ArgumentTypeError(f"'{text}' is no X,Y,YAW")
    return values


def parser():
    """The argument parser."""
    p = argparse.ArgumentParser(prog='console', description="The operator's console: serves a page from which a person sits in the robot.")
    p.add_argument('--planner', default='', metavar='NAME',
                   help='full name of the planner, as /move_base_flex/HIDWAPlannerROS (default: the one that runs, else of move_base)')
    p.add_argument('--address', default='127.0.0.1', help='where to listen; any but loopback asks for a token (default: %(default)s)')
    p.add_argument('--port', type=int, default=PORT, help='(default: %(default)s; 0: any that is free)')
    p.add_argument('--host-name', action='append', default=[], type=host_name, metavar='NAME',
                   help='a name or address by which browsers reach this machine; may be given several times')
    p.add_argument('--token', action='store_true', help='ask for a token on loopback too')
    p.add_argument('--certfile', type=file_name, help='TLS: the certificate, PEM')
    p.add_argument('--keyfile', type=file_name, help='TLS: its key, PEM')
    p.add_argument('--allow-origin', action='append', default=[], type=origin, metavar='ORIGIN',
                   help="a web page's origin that may use Foxglove's protocol; may be given several times")
    p.add_argument('--page-origin', action='append', default=[], type=origin, metavar='ORIGIN',
                   help="the page's address as browsers see it, where a proxy or a port forwarded under another number is between: "
                        'https://HOST or http://localhost:PORT; may be given several times')
    p.add_argument('--max-age', type=seconds, default=0.3, metavar='S', help='older commands do not steer (default: %(default)s)')
    p.add_argument('--stop-delay', type=seconds, default=2.0, metavar='S',
                   help='a link delay, both ways, above which the robot is asked to stop; 0: never (default: %(default)s)')
    p.add_argument('--camera', default='', metavar='TOPIC', help='sensor_msgs/CompressedImage or Image (default: no camera)')
    p.add_argument('--camera-info', default='', metavar='TOPIC', help='its sensor_msgs/CameraInfo (default: camera_info beside it)')
    p.add_argument('--regions', default='', metavar='FILE.yaml', help='regions to avoid, as maps/office_regions.yaml has them')
    p.add_argument('--recordings', default=os.path.join('~', 'hidwa_recordings'), metavar='DIR', help='(default: %(default)s)')
    p.add_argument('--tour', action='append', default=[], type=pose, metavar='X,Y,YAW',
                   help='drive to these poses in turn, for ever, while nobody wants anything else [m, m, rad]')
    p.add_argument('--study', default='', metavar='DIR', help='a session of scripts/study live --console')
    p.add_argument('--page', default='', metavar='DIR', help="the page's folder (default: where it was installed)")
    return p


def parse(arguments):
    """The options; exits with a message where they make no sense. Empty words are left out: a launch file may have some."""
    p = parser()
    o = p.parse_args([word for word in _joined(arguments) if word])
    if bool(o.certfile) != bool(o.keyfile):
        p.error('--certfile and --keyfile go together')
    if not 0 <= o.port < 65536:
        p.error('--port is 0 to 65535')
    if not is_loopback(o.address):
        o.token = True
        if not (o.host_name or o.page_origin) and o.address in ('0.0.0.0', '::', ''):
            p.error(f'--address {o.address} needs --host-name or --page-origin: how browsers reach this machine')
        if o.address not in ('0.0.0.0', '::', ''):
            o.host_name = [*o.host_name, host_name(o.address)]
    if any(not is_loopback(place_of(page)[1]) for page in o.page_origin):
        o.token = True  # others come by way of the proxy
    if o.camera and not o.camera_info:
        base = o.camera[:-len('/compressed')] if o.camera.endswith('/compressed') else o.camera
        o.camera_info = base.rsplit('/', 1)[0] + '/camera_info' if '/' in base else 'camera_info'
    return o


def _joined(arguments):
    """--tour -1,2,0 as one word: argparse would take the minus for an option's."""
    words, rest = [], list(arguments)
    while rest:
        word = rest.pop(0)
        words.append(f'{word}={rest.pop(0)}' if word == '--tour' and rest else word)
    return words
