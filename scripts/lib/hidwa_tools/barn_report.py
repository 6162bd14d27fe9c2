# SPDX-License-Identifier: BSD-3-Clause
"""The report of BARN-2D: what hidwa_study barn left in a folder, as one self-contained page and its pictures."""
import os

import numpy as np
import matplotlib
matplotlib.use('Agg')
import matplotlib.pyplot as plt
from matplotlib.collections import PatchCollection
from matplotlib.patches import Circle

from .drawing import DRIVEN, INK, STEERED_COLOUR
from .study_page import ReportError, embedded, html_table, read_table, read_way, way_of, world_lines, write_page

MODES = ('AUTONOMY', 'HELPFUL', 'HOSTILE', 'AFTERMATH')
NUMBERS = ('success', 'collision', 'timeout', 'time', 'metric', 'path_clearance', 'contacts', 'clearance', 'operator_active')
WORDS = ('id', 'world', 'mode', 'setting')
# 500 runs of DWA on 50 of the worlds, recomputed from Daffan/the-barn-challenge's res/dwa_out.txt.
PUBLISHED = {'success': 0.850, 'collision': 0.056, 'timeout': 0.094, 'time': 34.1, 'metric': 0.159}
GOAL = (-2.25, 13.0)
RADIUS, LATTICE = 0.075, 0.15  # [m], of the cylinders


def read_runs(folder):
    """The rows of runs.csv, numbers as such."""
    return read_table(os.path.join(folder, 'runs.csv'), NUMBERS, WORDS)


def groups(rows):
    """{(mode, setting): rows}, settings in the order of their first run."""
    settings = list(dict.fromkeys(row['setting'] for row in rows))
    found = {(m, s): [r for r in rows if r['mode'] == m and r['setting'] == s] for s in settings for m in MODES}
    return {key: runs for key, runs in found.items() if runs}


def figures(runs):
    """The means of one group; time: of the successful runs, nan where there are none."""
    said = {name: float(np.mean([r[name] for r in runs])) for name in ('success', 'collision', 'timeout', 'metric')}
    times = [r['time'] for r in runs if r['success']]
    said['time'] = float(np.mean(times)) if times else float('nan')
    said['contacts'] = int(sum(r['contacts'] for r in runs))
    said['clearance'] = min(r['clearance'] for r in runs)
    said['operator_active'] = float(np.mean([r['operator_active'] for r in runs]))
    return said


def statements(rows):
    """A sentence for each mode and setting."""
    said = []
    for (mode, setting), runs in groups(rows).items():
        f = figures(runs)
        said.append(f'{mode}{"" if setting == "default" else f", {setting}"}: {len(runs)} worlds, success {f["success"]:.3f}, '
                    f'collision {f["collision"]:.3f}, timeout {f["timeout"]:.3f}, {f["time"]:.1f} s, metric {f["metric"]:.3f}, '
                    f'{f["contacts"]} contacts')
    return said


def table(rows):
    """All groups beside the published figures, as HTML."""
    head = ('', 'worlds', 'success', 'collision', 'timeout', 'time of successes [s]', 'metric', 'contacts',
            'smallest clearance [m]', 'person steers, mean [s]')
    lines = []
    for (mode, setting), runs in groups(rows).items():
        f = figures(runs)
        lines.append([mode if setting == 'default' else f'{mode}, {setting}', f'{len(runs)}', f'{f["success"]:.3f}',
                      f'{f["collision"]:.3f}', f'{f["timeout"]:.3f}', f'{f["time"]:.1f}', f'{f["metric"]:.3f}', f'{f["contacts"]}',
                      f'{f["clearance"]:.3f}', f'{f["operator_active"]:.1f}'])
    p = PUBLISHED
    lines.append(['DWA as published, in Gazebo', '50, ten runs each', f'{p["success"]:.3f}', f'{p["collision"]:.3f}',
                  f'{p["timeout"]:.3f}', f'{p["time"]:.1f}', f'{p["metric"]:.3f}', '', '', ''])
    return html_table(head, lines)


def load_cylinders(path):
    """{world: centres (n, 2) [m]} of a file of BARN worlds; its head gives the geometry."""
    worlds = {}
    try:
        for line in world_lines(path):
            index, cells, _ = line.split('|')
            pairs = np.array([[int(n) for n in cell.split(':')] for cell in cells.split()], float)
            worlds[str(int(index))] = np.column_stack([-0.5 * LATTICE - LATTICE * pairs[:, 0],
                                                       0.5 * LATTICE + LATTICE * pairs[:, 1]])
    except (OSError, ValueError, IndexError) as fault:
        raise ReportError(f'{path} cannot be read as BARN worlds: {fault}') from fault
    return worlds


def chosen(runs):
    """Up to five runs with why they are shown: the worst, the nearest to a cylinder, the typical one."""
    by_metric = sorted(runs, key=lambda r: (r['metric'], -r['time'], r['id']))
    shown = [('worst', by_metric[0])]
    shown += [(name, row) for name, row in (
        ('second worst', by_metric[min(1, len(runs) - 1)]),
        ('nearest to a cylinder', min(runs, key=lambda r: (r['clearance'], r['id']))),
        ('typical', by_metric[len(runs) // 2]),
        ('best', by_metric[-1])) if row['id'] not in [r['id'] for _, r in shown]]
    once = {}
    for name, row in shown:
        once.setdefault(row['id'], (name, row))
    return list(once.values())


def draw_ways(folder, rows, cylinders, out):
    """The chosen runs of each mode in the first setting. False where no ways were kept."""
    setting = rows[0]['setting']
    shown = {mode: [(name, row, way_of(folder, row)) for name, row in chosen(runs)]
             for (mode, s), runs in groups(rows).items() if s == setting}
    if not any(way for runs in shown.values() for _, _, way in runs):
        return False
    width = max(len(runs) for runs in shown.values())
    figure, axes = plt.subplots(len(shown), width, figsize=(2.6 * width, 5.6 * len(shown)), squeeze=False, constrained_layout=True)
    for ax in axes.flat:
        ax.axis('off')
    for line, (mode, runs) in zip(axes, shown.items()):
        for ax, (name, row, way) in zip(line, runs):
            if row['world'] in cylinders:
                ax.add_collection(PatchCollection([Circle(c, RADIUS) for c in cylinders[row['world']]], facecolor='#8a949e', lw=0))
            if way:
                points, steered = read_way(way)
                ax.plot(points[:, 0], points[:, 1], color=DRIVEN, lw=1.2)
                ax.plot(*np.where(steered[:, None], points, np.nan).T, color=STEERED_COLOUR, lw=1.4)
                ax.plot(*points[-1], 'o', color=INK, ms=4)
            ax.add_patch(Circle(GOAL, 1.0, fill=False, color='#2a9d3a', lw=1.0))
            ax.set_xlim(-5.0, 0.5)
            ax.set_ylim(2.0, 14.2)
            ax.set_aspect('equal')
            result = f'{row["time"]:.1f} s' if row['success'] else 'contact' if row['contacts'] else 'not within 100 s'
            ax.set_title(f'{mode}\nworld {row["world"]}, {name}\n{result}, metric {row["metric"]:.3f}', fontsize=8, loc='left')
    figure.savefig(out, dpi=100)
    plt.close(figure)
    return True


def draw_difficulty(rows, out):
    """Success and metric over the room that the worlds leave, in five classes of as many worlds each."""
    figure, axes = plt.subplots(1, 2, figsize=(11, 3.6), constrained_layout=True)
    setting = rows[0]['setting']
    for k, mode in enumerate(m for m in MODES if (m, setting) in groups(rows)):
        runs = sorted(groups(rows)[(mode, setting)], key=lambda r: (r['path_clearance'], r['id']))
        classes = [c for c in np.array_split(np.arange(len(runs)), 5) if len(c)]
        colour = (DRIVEN, '#2a9d3a', STEERED_COLOUR)[k]
        room = [np.mean([runs[i]['path_clearance'] for i in c]) for c in classes]
        for ax, measure in zip(axes, ('success', 'metric')):
            ax.plot(room, [np.mean([runs[i][measure] for i in c]) for c in classes], 'o-', color=colour, ms=4, label=mode, clip_on=False)
    for ax, measure in zip(axes, ('success', 'metric')):
        ax.set_title(measure, fontsize=10, loc='left')
        ax.set_xlabel('mean free space along the reference path [m]; hard worlds to the left')
        ax.set_ylim(0.0, 1.05 if measure == 'success' else 0.55)  # beyond 0.5 no metric goes
        ax.grid(lw=0.4)
        ax.legend(fontsize=8)
    figure.savefig(out, dpi=100)
    plt.close(figure)


def write_report(folder, worlds_path=None):
    """Writes report.html, difficulty.png and, where ways were kept, ways.png into the folder. Returns the page's path."""
    rows = read_runs(folder)
    difficulty, ways = (os.path.join(folder, name) for name in ('difficulty.png', 'ways.png'))
    draw_difficulty(rows, difficulty)
    has_ways = draw_ways(folder, rows, load_cylinders(worlds_path) if worlds_path else {}, ways)
    parts = ['<p>A Jackal in the dense fields of the BARN data set, in two dimensions: alone, and with a simulated person who '
             'helps or attacks. This is not the simulator of the BARN leaderboard: neither physics nor wheels that slip nor a '
             'laser that vibrates. What it says compares planners and settings within it; the published figures stand beside '
             'it for orientation only, and are of 50 worlds.</p>',
             '<h2>By mode</h2>', table(rows),
             '<p>Metric: success x OT / clip(time, 2 OT, 8 OT), OT the reference path at 2 m/s. Success: within 1 m of the goal, '
             'no contact, within 100 s. A drive with a hostile person is not meant to arrive: what counts there is that nothing '
             'is touched.</p>',
             '<h2>Over difficulty</h2>', embedded(difficulty)]
    if has_ways:
        parts += ['<h2>Ways driven</h2><p>Red where the person steered.</p>', embedded(ways)]
    return write_page(os.path.join(folder, 'report.html'), 'BARN-2D', parts)
