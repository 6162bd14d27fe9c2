# SPDX-License-Identifier: BSD-3-Clause
"""The picture of a drive: the map with plan and path, and beneath it what the person and the robot did over time."""
import numpy as np
import matplotlib
matplotlib.use('Agg')
import matplotlib.pyplot as plt
from matplotlib.collections import LineCollection
from matplotlib.colors import ListedColormap
from matplotlib.patches import Patch, Polygon

from . import geometry
from .drawing import DRIVEN, INK, STATE_NAMES, STEERED, STEERED_COLOUR
from .measure import first_plan

GRID = '#d9dee3'
PLANNED, REPLANNED, REGION, PEOPLE = '#2a9d3a', '#9bd6a3', '#e08a00', '#6a4c93'
STATE_COLOURS = ('#c9d6e4', '#d62728', '#f3a1a1', '#7b3294', '#22303c', '#b8860b', '#ff7f0e')
MARGIN = 2.5  # [m] of map around what was driven and planned


def draw(drive, report, path, name=None):
    """Writes the picture of the drive, with the report's figures in its title; `name` stands for map and operator there."""
    with plt.rc_context({'font.family': 'DejaVu Sans', 'font.size': 9, 'axes.edgecolor': INK, 'text.color': INK,
                         'axes.labelcolor': INK, 'xtick.color': INK, 'ytick.color': INK, 'axes.linewidth': 0.7,
                         'hatch.linewidth': 0.8}):
        turned, extent = _extent(drive)
        width, height = (extent[1] - extent[0], extent[3] - extent[2])
        tall = float(np.clip(11.2 * height / width, 3.2, 11.0))
        figure, axes = plt.subplots(5, 1, figsize=(12, tall + 6.0), constrained_layout=True,
                                    gridspec_kw={'height_ratios': [tall, 1.15, 1.15, 1.15, 0.45]})
        _map(axes[0], drive, turned, extent)
        _over_time(axes[1:], drive)
        figure.suptitle(_title(report, name), fontsize=12, fontweight='bold')
        figure.savefig(path, dpi=110)
        plt.close(figure)


def _title(report, name=None):
    arrived = {True: 'arrived', False: 'did not arrive', None: 'drove'}[report['arrived']]
    after = 'for' if report['arrived'] is None else 'after'
    regions = f", {report['regions_crossed']} of {report['regions']} regions crossed" if report['regions'] else ''
    people = f", {report['people']} people, {report['contacts_moving']} touched on the move" if report.get('people') else ''
    contacts = 'contacts not known' if report['contacts'] is None else f"{report['contacts']} contacts"
    estimate = (report.get('clearance_estimate') or {}).get('smallest_m')
    if report['contacts'] is None and estimate is not None:
        contacts += f', estimated clearance {estimate:.2f} m'
    return (f"{name or '{map}, operator: {operator}'.format(**report)} - {arrived} {after} {report['duration_s']:.1f} s and "
            f"{report['path_length_m']:.1f} m, {contacts}{people}{regions}{_turns(report)}")


def _turns(report):
    turns = report.get('turns') or {}
    if turns.get('acc_rms') is None:
        return ''
    return f"\nautonomy turned at {turns['acc_rms']:.2f} rad/s^2 (rms), {turns['acc_p99']:.2f} (99 %), jerk {turns['jerk_rms']:.1f} rad/s^3"


def _turn(points):
    """A quarter turn, for floors that are taller than wide."""
    return np.column_stack([points[:, 1], -points[:, 0]])


def _extent(drive):
    """Whether to draw the map turned, and [x0, x1, y0, y1] of what to show of it."""
    plan = first_plan(drive)
    seen = np.vstack([drive.driven()[:, 1:3], *([plan] if plan is not None else []), *drive.regions])
    low, high = seen.min(axis=0) - MARGIN, seen.max(axis=0) + MARGIN
    turned = bool(high[1] - low[1] > 1.2 * (high[0] - low[0]))
    if turned:
        return True, (low[1], high[1], -high[0], -low[0])
    return False, (low[0], high[0], low[1], high[1])


def _map(ax, drive, turned, extent):
    view = _turn if turned else (lambda points: points)
    if drive.grid is not None:
        _floor(ax, drive.grid, turned)
    elif drive.seen is not None:
        ax.plot(*view(drive.seen.floor(drive.goal_time, drive.result_time)).T, '.', color=INK, ms=1.0, alpha=0.35, zorder=1)
    for region in drive.regions:
        ax.add_patch(Polygon(view(region), facecolor=REGION + '30', edgecolor=REGION, hatch='////', lw=0.9, zorder=2))
    plan = first_plan(drive)
    if plan is not None:
        for time, points in drive.plans:
            if drive.goal_time < time <= drive.result_time:
                ax.plot(*view(points).T, color=REPLANNED, lw=0.5, alpha=0.5, zorder=3)
        ax.plot(*view(plan).T, color=PLANNED, lw=2.4, zorder=4)
    _people(ax, drive, view)
    _driven(ax, drive, view)
    _ends(ax, drive, view)
    ax.set(xlim=extent[:2], ylim=extent[2:], aspect='equal', xticks=[], yticks=[])
    _scale_bar(ax, extent)
    _legend(ax, drive)


def _floor(ax, grid, turned):
    # 0 unknown, 1 free, 2 occupied
    cells = np.where(grid.occupied, 2, np.where(grid.free, 1, 0))
    rows, columns = cells.shape
    x0, y0 = grid.origin
    x1, y1 = x0 + columns * grid.resolution, y0 + rows * grid.resolution
    colours = ListedColormap(['#e9ebee', '#ffffff', INK])
    if turned:
        ax.imshow(cells.T[::-1], origin='lower', extent=(y0, y1, -x1, -x0), cmap=colours, vmin=0, vmax=2,
                  interpolation='nearest')
    else:
        ax.imshow(cells, origin='lower', extent=(x0, x1, y0, y1), cmap=colours, vmin=0, vmax=2, interpolation='nearest')


def _steered(drive, times):
    """Whether the person gave input, at each time."""
    if len(drive.states) == 0:
        return np.zeros(len(times), bool)
    last = np.searchsorted(drive.states[:, 0], times, side='right') - 1
    indices = [STATE_NAMES.index(name) for name in STEERED]
    return (last >= 0) & np.isin(drive.states[np.maximum(last, 0), 1], indices)


def _driven(ax, drive, view):
    truth = drive.driven()
    points = view(truth[:, 1:3])
    segments = np.stack([points[:-1], points[1:]], axis=1)
    steered = _steered(drive, truth[:-1, 0])
    for chosen, colour, order in ((~steered, DRIVEN, 5), (steered, STEERED_COLOUR, 6)):
        ax.add_collection(LineCollection(segments[chosen], colors=colour, lw=1.7, zorder=order, capstyle='round'))


def _people(ax, drive, view):
    for person in drive.people:
        track = drive.during(person.track)
        if len(track):
            ax.plot(*view(track[:, 1:3]).T, color=PEOPLE, lw=0.8, alpha=0.35, zorder=2.5)
            ax.plot(*view(track[-1:, 1:3]).T, 'o', color=PEOPLE, ms=4, alpha=0.6, zorder=2.5)


def _ends(ax, drive, view):
    truth = drive.driven()
    if drive.footprint is not None:
        outline = view(geometry.placed(drive.footprint, *truth[-1, 1:4]))
        ax.add_patch(Polygon(outline, facecolor=DRIVEN + '40', edgecolor=DRIVEN, lw=1.0, zorder=7))
    ends = [(truth[0, 1:4], 'o', 'start')]
    if drive.info.get('goal') is not None:
        ends.append((np.array(drive.info['goal'], float), '*', 'goal'))
    for pose, marker, name in ends:
        at = view(pose[None, :2])[0]
        ax.plot(*at, marker=marker, ms=14 if marker == '*' else 8, mfc='#ffd23f', mec=INK, mew=0.9, zorder=8)
        ax.annotate(name, at, xytext=(8, 8), textcoords='offset points', fontsize=9, fontweight='bold', zorder=9,
                    bbox={'boxstyle': 'round,pad=0.15', 'fc': 'white', 'ec': 'none', 'alpha': 0.8})


def _scale_bar(ax, extent):
    length = 10.0 if extent[1] - extent[0] > 30.0 else 2.0
    x, y = extent[0] + 1.0, extent[2] + 0.8
    ax.plot([x, x + length], [y, y], color=INK, lw=3, solid_capstyle='butt', zorder=9)
    ax.annotate(f'{length:.0f} m', (x + length / 2, y), xytext=(0, 4), textcoords='offset points', ha='center', zorder=9)


def _legend(ax, drive):
    line = plt.Line2D
    entries = []
    if drive.demo or first_plan(drive) is not None:
        entries += [line([], [], color=PLANNED, lw=2.4, label='planned first'),
                    line([], [], color=REPLANNED, lw=1.0, label='replanned')]
    entries.append(line([], [], color=DRIVEN, lw=1.8, label='driven'))
    if drive.demo or len(drive.states):
        entries.append(line([], [], color=STEERED_COLOUR, lw=1.8, label='driven while the person steers'))
    if drive.people:
        entries.append(line([], [], color=PEOPLE, lw=1.0, alpha=0.5, marker='o', ms=4, label='people'))
    if drive.grid is None:
        entries.append(line([], [], color=INK, lw=0, marker='.', label='seen on the way'))
    if drive.regions:
        entries.append(Patch(facecolor=REGION + '30', edgecolor=REGION, hatch='////', label='to avoid; no sensor sees it'))
    ax.legend(handles=entries, loc='upper center', bbox_to_anchor=(0.5, 0.0), ncol=len(entries), frameon=False,
              borderaxespad=0.3)


def _over_time(axes, drive):
    start, end = 0.0, drive.result_time - drive.goal_time
    truth, commands, states = drive.driven(), drive.commands, drive.states
    v, omega, wanted, strip = axes
    v.plot(truth[:, 0] - drive.goal_time, truth[:, 4], color='#8fa3b8', lw=0.9, label='driven')
    v.step(commands[:, 0] - drive.goal_time, commands[:, 1], color=DRIVEN, lw=1.0, where='post', label='commanded')
    v.set_ylabel('v [m/s]')
    omega.plot(truth[:, 0] - drive.goal_time, truth[:, 5], color='#8fa3b8', lw=0.9)
    omega.step(commands[:, 0] - drive.goal_time, commands[:, 2], color=DRIVEN, lw=1.0, where='post')
    omega.set_ylabel('ω [rad/s]')
    if not len(states):
        wanted.text(0.5, 0.5, 'not recorded', transform=wanted.transAxes, ha='center', va='center', color=INK)
    wanted.step(states[:, 0] - drive.goal_time, states[:, 3], color=STEERED_COLOUR, lw=1.2, where='post')
    wanted.set_ylabel('$ω_h$ [rad/s]')
    v.legend(loc='lower right', bbox_to_anchor=(1.0, 0.97), ncol=2, frameon=False, fontsize=8, borderaxespad=0.0)
    for ax in axes[:3]:
        ax.grid(color=GRID, lw=0.6)
        ax.margins(y=0.12)
        ax.tick_params(labelbottom=False)
        for side in ('top', 'right'):
            ax.spines[side].set_visible(False)
    _state_strip(strip, drive)
    for ax in axes:
        ax.set_xlim(start, end)
    v.set_ylim(bottom=min(0.0, v.get_ylim()[0]))
    limit = max(1.0, *np.abs(omega.get_ylim()))
    for ax in (omega, wanted):
        ax.set_ylim(-1.1 * limit, 1.1 * limit)
    strip.set_xlabel('time [s]' if drive.arrived is None else 'time since the goal was given [s]')


def _state_strip(ax, drive):
    states = drive.states
    shown = []
    if len(states):
        changes = np.flatnonzero(np.r_[True, states[1:, 1] != states[:-1, 1]])
        times = np.append(states[changes, 0], max(states[-1, 0], drive.result_time)) - drive.goal_time
        for begin, end, state in zip(times, times[1:], states[changes, 1].astype(int)):
            ax.axvspan(begin, end, color=STATE_COLOURS[state], lw=0)
            if end > 0 and state not in shown:
                shown.append(state)
    ax.set(yticks=[], ylim=(0, 1), ylabel='state')
    if not shown:
        ax.text(0.5, 0.5, 'not recorded', transform=ax.transAxes, ha='center', va='center', color=INK)
        return
    ax.legend(handles=[Patch(color=STATE_COLOURS[i], label=STATE_NAMES[i]) for i in sorted(shown)], loc='upper center',
              bbox_to_anchor=(0.5, -1.1), ncol=7, frameon=False)
