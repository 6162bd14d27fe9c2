# SPDX-License-Identifier: BSD-3-Clause
"""Measures the page beside the running robot: from a pointer event in the browser to the Joy message at a subscriber, and frames
drawn a second at 720p with software rendering, while the robot drives on the large map. No test: it prints figures.

    . scripts/env && PYTHONPATH=scripts/lib:$PYTHONPATH /usr/bin/python3 -W ignore test/console/browser/measure.py
"""
import os
import time

import browser
from robot import Robot

MOVES = 1000
PERIOD = 0.04  # [s] between two moves; another one than the stick's own repetition


def share(values, part):
    """The value below which this part of them lies."""
    ordered = sorted(values)
    return ordered[min(len(ordered) - 1, int(part * len(ordered)))]


def drag(page):
    """Drags the stick to MOVES places. A mouse's places are whole pixels; each comes back after 97 moves only."""
    x, y, _, _ = page.middle('stick')
    page.mouse('mousePressed', x, y)
    for k in range(MOVES):
        page.mouse('mouseMoved', x + 41 * k % 97 - 48, y)
        time.sleep(PERIOD)
    page.mouse('mouseReleased', x, y)


def main():
    robot = Robot((16.5, 8.3, 0.0))
    page = None
    try:
        page = browser.Browser()
        page.open('http://localhost:%d/' % robot.port)
        page.wait(lambda: page.app('Boolean(app.scene.map && app.holder.mine && !app.status.facts.neutralNeeded)'))
        page.app("app.send('goal', {x: 36, y: 8.4, yaw: null, append: false})")
        page.wait(lambda: robot.state == 'AUTONOMY' and robot.speed[0] > 0.3)
        began, first = time.monotonic(), page.app('[app.frames, app.board.frames]')
        time.sleep(4.0)
        frames = [(b - a) / (time.monotonic() - began) for a, b in zip(first, page.app('[app.frames, app.board.frames]'))]
        page.app("(window.moves = [], document.getElementById('stick').addEventListener('pointerrawupdate', (event) => "
                 'window.moves.push([performance.timeOrigin + event.timeStamp, app.steering.position.left])), true)')
        drag(page)
        time.sleep(0.5)
        wall = time.time() - time.monotonic()
        # The server publishes what it was sent, rounded to the float32 of Joy.
        came = [(at + wall, joy.axes[0]) for at, joy in robot.joys]
        delays = []
        for at, left in page.js('return window.moves'):
            times = [1000 * when - at for when, axis in came if abs(axis - left) < 1e-4 and 0 <= 1000 * when - at < 1000]
            if times:
                delays.append(min(times))
        print('load of the machine %.1f on %d cores' % (os.getloadavg()[0], os.cpu_count()))
        ratio = page.app('app.board.renderer.getPixelRatio()')
        print('frames a second: %.1f, of the three-dimensional view %.1f at %.2f of its pixels' % (*frames, ratio))
        print('pointer event to Joy, %d of %d moves: p50 %.1f ms, p90 %.1f ms, p99 %.1f ms' % (
            len(delays), len(page.js('return window.moves')), share(delays, 0.5), share(delays, 0.9), share(delays, 0.99)))
    finally:
        if page:
            page.end()
        robot.end()


if __name__ == '__main__':
    main()
