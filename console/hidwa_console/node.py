# SPDX-License-Identifier: BSD-3-Clause
"""The node: reads its options, starts the server, prints the address."""
import asyncio
import os
import signal
import ssl
import sys
import time

import rospkg
import rospy
import tornado.httpserver
import tornado.ioloop
import tornado.netutil
import yaml

from . import foxglove, server
from .access import Access, is_loopback, new_token
from .console import SLOW_TICK, TICK, Console
from .desk import Settings
from .options import parse
from .outputs import Device
from .planar import rounded
from .recorder import Recorder
from .robot import Names, Robot, planners
from .study import Session
from .tuning import Tuning, read_presets

PACKAGE = 'hidwa_local_planner'
LIBRARIES = ('three',)
SWITCH = 0.001  # [s], after which Python lets another thread run: a stick's message must not wait for a map
PLANNER_PATIENCE = 30.0  # [s] for move_base's parameters, where roslaunch is still at it


class CannotServe(Exception):
    """The server cannot begin; the text says why and what helps."""


def share():
    """The package's shared files: installed, or its source."""
    return rospkg.RosPack().get_path(PACKAGE)


def page_folder(option):
    """Where the page lies."""
    folder = os.path.abspath(option or os.path.join(share(), 'console', 'page'))
    if not os.path.isfile(os.path.join(folder, 'index.html')):
        raise CannotServe(f'there is no page in {folder}: run scripts/build, or give --page')
    return folder


def libraries():
    """{name: folder} of the browser's libraries that npm installed."""
    folders = {name: os.path.join(share(), 'console', 'lib', name) for name in LIBRARIES}
    found = {name: folder for name, folder in folders.items() if os.path.isdir(folder)}
    for name in set(LIBRARIES) - set(found):
        rospy.logwarn(f'{name} is not installed: the page works in its plain form, without the view from on board; '
                      'scripts/console_libraries installs it where npm is')
    return found


def read_regions(path):
    """[{name, polygon, crossed}] of a file of regions to avoid."""
    if not path:
        return []
    with open(path, encoding='utf-8') as text:
        regions = (yaml.safe_load(text) or {}).get('regions', [])
    return [{'name': r.get('name', ''), 'polygon': [rounded(p) for p in r['polygon']], 'crossed': False} for r in regions]


def record_command(path):
    """record_drive's command line for a bag, in move_base's namespace."""
    here = os.path.dirname(os.path.abspath(sys.argv[0]))
    program = next((p for p in (os.path.join(here, 'record_drive'), os.path.join(here, '..', 'scripts', 'record_drive'))
                    if os.path.isfile(p)), None)
    if program is None:
        raise CannotServe('record_drive is not installed beside the console: run scripts/build')
    host = Names().host
    remaps = [f'{name}:={rospy.resolve_name(name)}' for name in ('odom', 'scan', 'joy', 'cmd_vel')]
    planners = [f'_{name}:={rospy.get_param(f"{host}/{name}", default)}' for name, default in
                (('base_local_planner', 'hidwa_local_planner/HIDWAPlannerROS'), ('base_global_planner', 'navfn/NavfnROS'))]
    return [sys.executable, program, f'__ns:={rospy.get_namespace()}', '__name:=console_recorder', f'_bag:={path}', *planners, *remaps]


def tls(options):
    """An ssl context, or None."""
    if not options.certfile:
        return None
    context = ssl.create_default_context(ssl.Purpose.CLIENT_AUTH)
    try:
        context.load_cert_chain(options.certfile, options.keyfile)
    except (OSError, ssl.SSLError) as fault:
        raise CannotServe(f'--certfile {options.certfile} and --keyfile {options.keyfile} do not go together: {fault}') from fault
    return context


def listen(options):
    """(sockets, port)"""
    try:
        sockets = tornado.netutil.bind_sockets(options.port, '127.0.0.1' if options.address == 'localhost' else options.address)
    except OSError as fault:
        raise CannotServe(f'{options.address}:{options.port} cannot be listened on: {fault.strerror}; --port takes another') from fault
    return sockets, sockets[0].getsockname()[1]


def addresses(options, port, token, secure):
    """The addresses to print."""
    names = options.host_name or ['localhost' if is_loopback(options.address) else options.address]
    fragment = f'#token={token}' if token else ''
    own = [f'{"https" if secure else "http"}://{f"[{n}]" if ":" in n else n}:{port}' for n in names]
    return [f'{origin.rstrip("/")}/{fragment}' for origin in options.page_origin or own]


def say(line):
    """One write with the end of the line in it: print makes two, and a thread that logs may get between them."""
    sys.stdout.write(line + '\n')
    sys.stdout.flush()


def wait_for_planner():
    """Until a planner runs, or the parameter server has move_base's parameters. Its full name, where it runs; else '': then the names
    are those of move_base, by default where it has no parameters."""
    deadline = time.monotonic() + PLANNER_PATIENCE
    while not rospy.is_shutdown():
        found = planners()
        if found or rospy.has_param(rospy.resolve_name('move_base/base_local_planner')):
            break
        if time.monotonic() > deadline:
            rospy.logwarn('there is no move_base: the console takes its usual names')
            break
        time.sleep(0.2)
    if len(found) > 1:
        rospy.logwarn(f'{len(found)} planners run, {", ".join(found)}: the console takes the first; --planner takes another')
    return found[0] if found else ''


def make(loop, options, access, secure, study=None):
    """The Console."""
    names = Names(options.planner or wait_for_planner())
    tuning = Tuning(names.planner, read_presets(os.path.join(share(), 'launch', 'params', 'presets')))

    def cycles(on):
        loop.add_callback(lambda: loop.run_in_executor(None, tuning.set, {'record_cycles': on}))
    recorder = Recorder(record_command, os.path.abspath(os.path.expanduser(options.recordings)), cycles)
    robot = Robot(names)
    parts = (names, robot, tuning, Device(names, tuning.parameters, lambda: robot.mode.sources > 0), recorder)
    settings = Settings(options.max_age, options.stop_delay)
    return Console(loop, access, secure, settings, parts, options, read_regions(options.regions), study)


def serve(options):
    """Until the node ends."""
    context = tls(options)
    sockets, port = listen(options)
    token = new_token() if options.token else None
    access = Access(port, options.host_name, token, context is not None, options.allow_origin, options.page_origin)
    loop = tornado.ioloop.IOLoop.current()
    console = make(loop, options, access, context is not None, Session(options.study) if options.study else None)
    application = server.application(console, page_folder(options.page), libraries(), foxglove.FoxgloveSocket)
    http = tornado.httpserver.HTTPServer(application, ssl_options=context, max_body_size=4096, max_header_size=16384,
                                         idle_connection_timeout=60.0)
    http.add_sockets(sockets)
    ticks = [tornado.ioloop.PeriodicCallback(call, 1000.0 * period) for call, period in
             ((console.tick, TICK), (console.slow_tick, SLOW_TICK))]
    for tick in ticks:
        tick.start()
    if not is_loopback(options.address) and context is None:
        rospy.logwarn('without --certfile and --keyfile everybody on the way can read and change what is sent, the token too; '
                      'and a headset gives no WebXR')
    for address in addresses(options, port, token, context is not None):
        say(f'console: {address}')
    loop.start()
    console.close()
    http.stop()


def main():
    """The program."""
    sys.setswitchinterval(SWITCH)
    options = parse(rospy.myargv(sys.argv)[1:])
    asyncio.set_event_loop(asyncio.new_event_loop())
    rospy.init_node('console', disable_signals=True)
    loop = tornado.ioloop.IOLoop.current()
    for number in (signal.SIGINT, signal.SIGTERM):
        signal.signal(number, lambda *_: loop.add_callback_from_signal(loop.stop))
    try:
        serve(options)
    except CannotServe as fault:
        rospy.logfatal('%s', fault)
        return 2
    finally:
        rospy.signal_shutdown('the console ends')
    return 0
