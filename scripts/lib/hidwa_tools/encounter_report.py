# SPDX-License-Identifier: BSD-3-Clause
"""The report of drives among what moves: what hidwa_study dynabarn or crowd left in a folder, as one self-contained page."""
import json
import os

import numpy as np
import matplotlib
matplotlib.use('Agg')
import matplotlib.pyplot as plt
from matplotlib.collections import PatchCollection
from matplotlib.patches import Circle

from .drawing import DRIVEN, INK, STEERED_COLOUR
from .study_page import ReportError, embedded, html_table, read_table, read_way, way_of, world_lines, write_page

NUMBERS = ('release', 'success', 'touched_moving', 'touched_at_rest', 'touched_wall', 'timeout', 'time', 'touched_after_leap',
           'moved_into', 'encounters', 'closest', 'personal_space', 'standing', 'operator_active')
WORDS = ('id', 'world', 'class', 'mode', 'setting')
RESAMPLES, SEED = 10000, 1
RADIUS = 0.5  # [m], of DynaBARN's cylinders


def read_runs(folder):
    """The rows of runs.csv, numbers as such."""
    return read_table(os.path.join(folder, 'runs.csv'), NUMBERS, WORDS)


def about(folder):
    """study.json as a dictionary."""
    with open(os.path.join(folder, 'study.json'), encoding='utf-8') as text:
        return json.load(text)


def groups(rows):
    """{(class, mode, setting): rows}, in the order of their first run, classes of DynaBARN by difficulty."""
    order = {'easy': 0, 'medium': 1, 'hard': 2}
    found = {}
    for row in rows:
        found.setdefault((row['class'], row['mode'], row['setting']), []).append(row)
    return dict(sorted(found.items(), key=lambda entry: order.get(entry[0][0], 3)))


def interval(runs, measure, by='world'):
    """(mean, low, high): the mean over worlds of their runs' means, and its 95 % interval by bootstrap over worlds (the runs
    of one world are not independent)."""
    worlds = {}
    for row in runs:
        worlds.setdefault(row[by], []).append(row[measure])
    means = np.array([np.mean(values) for values in worlds.values()])
    drawn = np.random.default_rng(SEED).integers(0, len(means), (RESAMPLES, len(means)))
    low, high = np.percentile(means[drawn].mean(axis=1), [2.5, 97.5])
    return float(means.mean()), float(low), float(high)


def figures(runs, crowd):
    """The figures of one group. On one floor all runs are of one world: there each counts for itself."""
    by = 'id' if crowd else 'world'
    mean, low, high = interval(runs, 'success', by)
    share = {name: float(np.mean([row[name] > 0 for row in runs]))
             for name in ('touched_moving', 'touched_at_rest', 'touched_wall', 'timeout', 'touched_after_leap')}
    times = [row['time'] for row in runs if row['success']]
    return {'success': mean, 'low': low, 'high': high, **share, 'time': float(np.mean(times)) if times else float('nan'),
            'all_time': float(np.mean([row['time'] for row in runs])), 'standing': float(np.mean([row['standing'] for row in runs])),
            'touches_moving': int(sum(row['touched_moving'] for row in runs)),
            'touches_at_rest': int(sum(row['touched_at_rest'] for row in runs)),
            'encounters': int(sum(row['encounters'] for row in runs)),
            'personal_space': float(np.mean([row['personal_space'] for row in runs]))}


def _name(key):
    klass, mode, setting = key
    return f'{klass}, {mode}' + ('' if setting == 'default' else f', {setting}')


def statements(rows, crowd):
    """A sentence for each group."""
    said = []
    for key, runs in groups(rows).items():
        f = figures(runs, crowd)
        said.append(f'{_name(key)}: {len(runs)} drives, success {f["success"]:.3f} ({f["low"]:.3f} to {f["high"]:.3f}), touched moving '
                    f'{f["touched_moving"]:.3f}, at rest {f["touched_at_rest"]:.3f}, out of time {f["timeout"]:.3f}, after a leap '
                    f'{f["touched_after_leap"]:.3f}, {f["time"]:.1f} s; {f["encounters"]} encounters, '
                    f'{f["touches_moving"]} touches moving, {f["touches_at_rest"]} at rest')
    return said


def table(rows, crowd):
    """All groups as HTML."""
    head = ('', 'drives', 'success', '95 % interval', 'touched moving', 'touched at rest', 'wall', 'out of time',
            'by one that just leapt', 'time of successes [s]', 'stood [s]', 'encounters', 'touches moving', 'touches at rest',
            'within 0.5 m, moving [s]')
    lines = []
    for key, runs in groups(rows).items():
        f = figures(runs, crowd)
        lines.append([_name(key), f'{len(runs)}', f'{f["success"]:.3f}', f'{f["low"]:.3f} to {f["high"]:.3f}',
                      f'{f["touched_moving"]:.3f}', f'{f["touched_at_rest"]:.3f}', f'{f["touched_wall"]:.3f}', f'{f["timeout"]:.3f}',
                      f'{f["touched_after_leap"]:.3f}', f'{f["time"]:.1f}', f'{f["standing"]:.1f}', f'{f["encounters"]}',
                      f'{f["touches_moving"]}', f'{f["touches_at_rest"]}', f'{f["personal_space"]:.1f}'])
    return html_table(head, lines)


def load_tracks(path):
    """{world: [key frames (n, 3): time, x, y]} of a file of DynaBARN worlds."""
    worlds = {}
    try:
        for line in world_lines(path):
            head, *obstacles = line.split('|')
            worlds[head.split()[0]] = [np.array([[float(n) for n in word.split(':')] for word in obstacle.split()[1:]])
                                       for obstacle in obstacles]
    except (OSError, ValueError, IndexError) as fault:
        raise ReportError(f'{path} cannot be read as DynaBARN worlds: {fault}') from fault
    return worlds


def place(frames, time, motion):
    """Where a cylinder is, straight between key frames or on Gazebo's spline over their index."""
    t = time % frames[-1, 0]
    k = min(int(np.searchsorted(frames[1:-1, 0], t, side='right')), len(frames) - 2)
    u = (t - frames[k, 0]) / (frames[k + 1, 0] - frames[k, 0])
    points = frames[:, 1:]
    if motion != 'spline':
        return points[k] + u * (points[k + 1] - points[k])

    def tangent(i):
        return 0.5 * (points[min(i + 1, len(points) - 1)] - points[max(i - 1, 0)])
    return ((2 * u**3 - 3 * u**2 + 1) * points[k] + (u**3 - 2 * u**2 + u) * tangent(k) + (3 * u**2 - 2 * u**3) * points[k + 1] +
            (u**3 - u**2) * tangent(k + 1))


def shown_runs(rows, most=8):
    """Runs worth looking at: those that failed first, at most so many."""
    return sorted(rows, key=lambda r: (r['success'], r['id']))[:most]


def draw_ends(folder, rows, tracks, motion, out):
    """How drives ended: the way, and the cylinders at the end with their last second. False where no ways were kept."""
    shown = [(row, way_of(folder, row)) for row in shown_runs([r for r in rows if r['world'] in tracks])]
    shown = [(row, way) for row, way in shown if way]
    if not shown:
        return False
    figure, axes = plt.subplots(-(-len(shown) // 4), 4, figsize=(15, 3.6 * -(-len(shown) // 4)), squeeze=False, constrained_layout=True)
    for ax in axes.flat:
        ax.axis('off')
    for ax, (row, way) in zip(axes.flat, shown):
        points, steered = read_way(way)
        end = row['release'] + row['time']
        for frames in tracks[row['world']]:
            ax.plot(*np.array([place(frames, t, motion) for t in np.linspace(end - 1.0, end, 8)]).T, color='#8a949e', lw=0.8)
        ax.add_collection(PatchCollection([Circle(place(frames, end, motion), RADIUS) for frames in tracks[row['world']]],
                                          facecolor='#8a949e', alpha=0.5, lw=0))
        ax.plot(points[:, 0], points[:, 1], color=DRIVEN, lw=1.2)
        ax.plot(*np.where(steered[:, None], points, np.nan).T, color=STEERED_COLOUR, lw=1.4)
        ax.plot(*points[-1], 'o', color=INK, ms=4)
        for wall in ((-10.0, -10.0, -10.0, 10.0), (-10.0, 10.0, 10.0, 10.0), (-10.0, -10.0, 10.0, -10.0)):
            ax.plot(wall[::2], wall[1::2], color=INK, lw=2)
        ax.add_patch(Circle((-9.0, 0.0), 1.0, fill=False, color='#2a9d3a', lw=1.0))
        ax.set(xlim=(-10.6, 15.0), ylim=(-10.6, 10.6), aspect='equal')
        result = 'arrived' if row['success'] else 'touched, moving' if row['touched_moving'] else \
            'touched at rest' if row['touched_at_rest'] else 'touched a wall' if row['touched_wall'] else 'out of time'
        ax.set_title(f'{row["id"]}, {row["class"]}\n{result} after {row["time"]:.1f} s', fontsize=8, loc='left')
    figure.savefig(out, dpi=90)
    plt.close(figure)
    return True


def write_report(folder, worlds_path=None):
    """Writes report.html and, where ways and worlds are known, ends.png into the folder. Returns the page's path."""
    rows, study = read_runs(folder), about(folder)
    crowd = study['experiment'] == 'crowd'
    told = {'none': 'nothing: they are cells of its costmap', 'truth': 'their true states', 'laser': 'what its tracker makes of the scans'}
    if crowd:
        parts = [f'<p>The robot of the demo drives its route among {study["people"]} people who walk from place to place, '
                 f'{100 * study["yielding"]:.0f} % of whom keep away from it. The planner is told of them: {told[study["tracking"]]}. '
                 'A success is an arrival without a touch while the robot moved.</p>']
    else:
        parts = ['<p>DynaBARN-2D: a Jackal drives 19 m straight through a court that cylinders cross, which mind neither it nor one '
                 f'another. Between key frames they move by {study["motion"]} interpolation; the robot drives at most '
                 f'{study["speed"]:g} m/s. The planner is told of them: {told[study["tracking"]]}. Any touch ends a drive and fails, '
                 'also at rest. This is not the simulator of the DynaBARN benchmark: '
                 'figures compare planners and settings within it.</p>']
    parts += ['<h2>By class and mode</h2>', table(rows, crowd),
              '<p>Means over worlds; the interval is a bootstrap over worlds.</p>' if not crowd else
              '<p>Means over drives; the interval is a bootstrap over drives. An encounter: somebody within 1 m of the moving robot.</p>']
    ends = os.path.join(folder, 'ends.png')
    if worlds_path and not crowd and draw_ends(folder, rows, load_tracks(worlds_path), study['motion'], ends):
        parts += ['<h2>How drives ended</h2><p>Those that failed first. Red where a person steered; grey the cylinders at the end, with '
                  'their last second.</p>', embedded(ends)]
    return write_page(os.path.join(folder, 'report.html'), 'A crowd' if crowd else 'DynaBARN-2D', parts)
