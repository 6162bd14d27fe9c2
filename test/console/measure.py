# SPDX-License-Identifier: BSD-3-Clause
"""What the console costs, and how fast it is: python3 test/console/measure.py [MAP.yaml X Y YAW GX GY GYAW], in a shell with
scripts/env. Prints the time from a page's message to the Joy message [ms] and the node's share of a core [%]."""
import asyncio
import os
import sys
import time

import rospy
from sensor_msgs.msg import Joy

from page_twin import Page, View, until
from running import World

SECONDS = 20.0  # [s], of each part
TICKS = os.sysconf('SC_CLK_TCK')


def cpu_of(pid):
    """CPU time of a process [s]."""
    with open(f'/proc/{pid}/stat', encoding='ascii', errors='replace') as stat:
        fields = stat.read().rsplit(')', 1)[1].split()
    return (int(fields[11]) + int(fields[12])) / TICKS


async def share(world, pid, pages):
    """Share of a core over a while [%], with so many pages more; ticks a second and bytes a second of the last."""
    views = []
    for i in range(pages):
        page = await Page(world.port, f'{i + 1:032x}').open()
        views.append((page, await View(page).open()))
    await asyncio.sleep(2.0)
    begin, cpu, last = time.monotonic(), cpu_of(pid), views[-1][1] if views else None
    ticks, size = (last.ticks, last.bytes) if last else (0, 0)
    await asyncio.sleep(SECONDS)
    passed = time.monotonic() - begin
    result = 100.0 * (cpu_of(pid) - cpu) / passed
    rates = ((last.ticks - ticks) / passed, (last.bytes - size) / passed) if last else (0.0, 0.0)
    for page, view in views:
        view.close()
        page.control.close()
    return result, rates


async def latencies(world, heard):
    """Times [ms] from a stick message to its Joy, on changes at 20 Hz while a view runs."""
    page = await Page(world.port, 'a' * 32).open()
    view = await View(page).open()
    await page.claim()
    sent = {}
    for i in range(round(20 * SECONDS)):
        value = round(0.2 + 0.5 * (i % 1000) / 1000, 4)
        sent[value] = time.monotonic()
        page.stick(value)
        await asyncio.sleep(0.05)
    page.stick(0.0)
    await asyncio.sleep(0.3)
    page.say('give')
    view.close()
    page.control.close()
    return sorted(1e3 * (at - sent[value]) for value, at in heard if value in sent)


async def main(world, goal):
    heard = []
    rospy.init_node('measure', disable_signals=True)
    subscriber = rospy.Subscriber('/joy', Joy, lambda m: heard.append((round(m.axes[0], 4), time.monotonic())), queue_size=100,
                                  tcp_nodelay=True)
    driver = await Page(world.port, 'f' * 32).open()
    await until(subscriber.get_num_connections, 'joy')
    await driver.claim()
    driver.say('goal', x=goal[0], y=goal[1], yaw=goal[2])
    await asyncio.sleep(3.0)
    driver.say('give')
    pid = world.child.pid
    for pages in (0, 1, 6):
        result, (ticks, size) = await share(world, pid, pages)
        print(f'{pages} views: {result:.1f} % of a core; {ticks:.1f} ticks/s, {size / 1e3:.0f} kB/s each', flush=True)
    times = await latencies(world, heard)
    print(f'message to Joy: {len(times)} of {round(20 * SECONDS)}, p50 {times[len(times) // 2]:.2f} ms, '
          f'p99 {times[int(0.99 * len(times))]:.2f} ms, max {times[-1]:.2f} ms; load {os.getloadavg()[0]:.1f}')


if __name__ == '__main__':
    where = sys.argv[1:] or [None, 5.5, 2.5, 1.57, 55.0, 27.0, 1.57]
    launch = [f'map:={where[0]}', 'regions:=none'] if where[0] else []
    the_world = World(*launch, f'x:={where[1]}', f'y:={where[2]}', f'yaw:={where[3]}')
    try:
        the_world.child, the_world.port, _ = the_world.console()
        asyncio.run(main(the_world, [float(v) for v in where[4:7]]))
    finally:
        the_world.end()
