# SPDX-License-Identifier: BSD-3-Clause
"""The report of a study, of hidwa_study's people or of real ones: what is in its folder, as one self-contained page and its
pictures."""
import glob
import html
import json
import os
import sys

import numpy as np
import yaml
import matplotlib
matplotlib.use('Agg')
import matplotlib.image as image
import matplotlib.pyplot as plt

from . import barn_report, encounter_report
from .drawing import DRIVEN, INK, STEERED_COLOUR
from .questionnaires import AnswersError, read_answers, statements as answers_statements
from .statistics import normality, proportion, signed_ranks
from .study_page import ReportError, embedded, html_table, read_table, read_way, write_page

CONDITIONS = ('SJ', 'SG', 'SW')
NAMES = {'SJ': 'SJ, shared control by joystick', 'SG': 'SG, shared control by gesture', 'SW': 'SW, switching'}
MEASURES = (('duration', 'time [s]'), ('length', 'length [m]'), ('regions_crossed', 'regions crossed'),
            ('contacts', 'contacts'), ('operator_active', 'operator active [s]'), ('interventions', 'interventions'),
            ('omega_change', 'mean change of omega [rad/s]'), ('agreement', 'mean agreement'),
            ('clearance', 'smallest clearance [m]'))
# Kalliokoski et al. 2022, section V: means of 32 people; contacts in all.
PAPER = {'SJ': {'duration': 172.37, 'regions_crossed': 0.219, 'contacts': 0},
         'SW': {'duration': 187.17, 'regions_crossed': 0.406, 'contacts': 3}}


def read_runs(folder):
    """The rows of runs.csv, numbers as such, nan where a cell is empty."""
    return read_table(os.path.join(folder, 'runs.csv'), tuple(dict(MEASURES)), ('condition', 'participant', 'setting'))


def of(rows, condition, setting):
    """The runs of one condition and setting, by participant."""
    return {row['participant']: row for row in rows if row['condition'] == condition and row['setting'] == setting}


def compare(first, second, measure):
    """The paired test of a measure over the people who drove both and of whom it is known; None where there is nobody."""
    both = paired(first, second, measure)
    if not both:
        return None
    return signed_ranks([first[p][measure] for p in both], [second[p][measure] for p in both])


def paired(first, second, measure):
    """The participants with a known value in both."""
    return [p for p in sorted(set(first) & set(second), key=int) if not np.isnan(first[p][measure] + second[p][measure])]


def known(group, measure):
    """The known values of a measure in a group of runs."""
    return [row[measure] for row in group.values() if not np.isnan(row[measure])]


def settings_of(rows):
    """Settings in the order of their first run."""
    return list(dict.fromkeys(row['setting'] for row in rows))


def statements(rows):
    """What the tests say of SJ against SW and SG, a sentence each, in the default setting or the only one."""
    setting = settings_of(rows)[0]
    said = []
    for other in ('SW', 'SG'):
        joystick, second = of(rows, 'SJ', setting), of(rows, other, setting)
        for measure, name in (('duration', 'time'), ('regions_crossed', 'regions crossed'), ('contacts', 'contacts')):
            test = compare(joystick, second, measure)
            if test is None:
                continue
            means = [np.mean(known(group, measure)) for group in (joystick, second)]
            text = f'{name}: mean {means[0]:.3f} in SJ, {means[1]:.3f} in {other}; '
            if test.changed == 0:
                said.append(text + 'no pair differs')
                continue
            said.append(text + f'Wilcoxon signed-rank, two-sided, of {test.changed} pairs that differ: '
                        f'Z = {test.z:.3f}, p = {test.p:.4f} (exact), r = {test.r:.3f}')
        both = sorted(set(joystick) & set(second), key=int)
        quicker = sum(joystick[p]['duration'] < second[p]['duration'] for p in both)
        differ = sum(joystick[p]['duration'] != second[p]['duration'] for p in both)
        if differ:
            share = proportion(quicker, differ)
            said.append(f'SJ was quicker than {other} for {quicker} of {differ}: exact binomial p = {share.p_two_sided:.4f} '
                        f'(two-sided), 95 % interval {100 * share.low:.1f} % to {100 * share.high:.1f} %')
    for condition in CONDITIONS:
        w, p = normality(known(of(rows, condition, setting), 'duration'))
        if np.isfinite(w):
            said.append(f'Shapiro-Wilk of the times in {condition}: W = {w:.3f}, p = {p:.4f}')
    return said


def verdict(rows):
    """In plain words, whether the order of the paper came out."""
    setting = settings_of(rows)[0]
    joystick, switching = of(rows, 'SJ', setting), of(rows, 'SW', setting)
    test = compare(joystick, switching, 'duration')
    if test is None:
        return ''
    ratio, paper = _ratio(joystick, switching), PAPER['SJ']['duration'] / PAPER['SW']['duration']
    order = {None: 'No difference in time shown between SJ and SW, unlike in the paper', 'SJ': 'SJ is faster than SW, as in the paper',
             'SW': 'SJ is not faster than SW, unlike in the paper: SW is'}[faster(test)]
    return f'{order}: the mean time in SJ is {ratio:.3f} of that in SW (the paper: {paper:.3f}), p = {test.p:.4f}.'


def faster(test):
    """SJ or SW, by the test of their times; None where it shows no difference."""
    return None if test.p >= 0.05 else 'SJ' if test.z < 0.0 else 'SW'


def caution(simulated):
    """What the figures are no evidence of."""
    text = 'The paper states neither speed nor length of the route, so that only ratio and order compare.'
    return text + (' The people here are a model: they say nothing about preference, workload, comfort or sickness, and what '
                   'docs/use/study.md lists as not modelled is what can turn the order round.' if simulated else '')


def _ratio(joystick, switching):
    return np.mean(known(joystick, 'duration')) / np.mean(known(switching, 'duration'))


def differences(rows):
    """[(what, here, in the paper)] of SJ and SW, in the default setting or the only one; empty without both."""
    setting = settings_of(rows)[0]
    joystick, switching = of(rows, 'SJ', setting), of(rows, 'SW', setting)
    if not paired(joystick, switching, 'duration'):
        return []
    lines = []
    for measure, name, form in (('duration', 'mean time', '{:.2f} s'), ('regions_crossed', 'regions crossed, mean', '{:.3f}'),
                                ('contacts', 'contacts, in all', '{:.0f}')):
        for condition, group in (('SJ', joystick), ('SW', switching)):
            values = known(group, measure)
            here = 'not known' if not values else form.format(sum(values) if measure == 'contacts' else np.mean(values))
            if values and len(values) < len(group):
                here += f' (known of {len(values)} of {len(group)})'
            lines.append((f'{name}, {condition}', here, form.format(PAPER[condition][measure])))
        if measure == 'duration':
            times = [PAPER[c]['duration'] for c in ('SJ', 'SW')]
            test = compare(joystick, switching, 'duration')
            lines.append(('ratio SJ / SW', f'{_ratio(joystick, switching):.3f}', f'{times[0] / times[1]:.3f}'))
            lines.append(('faster', f'{faster(test) or "no difference shown"}, p = {test.p:.4f}', 'SJ, p < 0.001'))
    return lines


def reasons(rows, simulated):
    """Why the times differ as they do, as far as the runs themselves show it, a sentence each."""
    setting = settings_of(rows)[0]
    joystick, switching = of(rows, 'SJ', setting), of(rows, 'SW', setting)
    both = paired(joystick, switching, 'duration')
    if not both:
        return []
    later, by_length = [], []
    for p in both:
        first, second = joystick[p], switching[p]
        later.append(second['duration'] - first['duration'])
        # The time by which the other length is driven at SJ's mean speed; what is left is speed.
        by_length.append((second['length'] - first['length']) * first['duration'] / first['length'])
    gain, length = np.mean(later), np.mean(by_length)
    test = compare(joystick, switching, 'duration')
    order = {None: 'SJ is not faster here: no difference is shown', 'SJ': 'SJ is faster here',
             'SW': 'SJ is not faster here, SW is'}[faster(test)]
    speeds = [np.mean([group[p]['length'] / group[p]['duration'] for p in both]) for group in (joystick, switching)]
    said = [f'{order}. SW takes {gain:+.2f} s against SJ, of which {length:+.2f} s by the length of the way and {gain - length:+.2f} s by '
            f'the mean speed ({speeds[0]:.3f} m/s in SJ, {speeds[1]:.3f} m/s in SW).']
    if speeds[1] > 0.98 * speeds[0]:
        longer = 100.0 * (PAPER['SW']['duration'] / PAPER['SJ']['duration'] - 1.0)
        said.append(f"Driving by hand costs these people next to no speed. The paper's took {longer:.1f} % longer in SW; whether by speed, "
                    'way or pauses it does not say.')
    steering = [known(group, 'operator_active') for group in (joystick, switching)]
    if all(steering):
        said.append(f'In SJ the person steers for {np.mean(steering[0]):.1f} s, '
                    f'in SW they are in control for {np.mean(steering[1]):.1f} s.')
    crossed = [known(group, 'regions_crossed') for group in (joystick, switching)]
    if all(crossed):
        contacts = [known(group, 'contacts') for group in (joystick, switching)]
        touched = f'; {sum(contacts[0]):.0f} and {sum(contacts[1]):.0f} contacts' if all(contacts) else ''
        said.append(f'{sum(map(bool, crossed[0]))} of {len(crossed[0])} runs in SJ '
                    f'and {sum(map(bool, crossed[1]))} of {len(crossed[1])} in SW '
                    f'crossed a region{touched}.')
    errors = [float(row['mode_errors']) for row in switching.values() if row.get('mode_errors')]
    if errors:
        said.append(f'Mode errors in SW: {sum(errors):.0f} in {len(errors)} runs.')
    if simulated:
        said.append('Simulated people see where everything is, do not hesitate and hardly err: what would cost time and contacts in SW '
                    'is what the model leaves out (docs/use/study.md, "Not modelled").')
    return said


def load_floor(path):
    """(image, extent) of a map_server map, or None where there is none."""
    if not path:
        return None
    try:
        with open(path, encoding='utf-8') as text:
            info = yaml.safe_load(text)
        picture = image.imread(os.path.join(os.path.dirname(path), info['image']))
    except (OSError, KeyError, TypeError, yaml.YAMLError) as fault:
        raise ReportError(f'{path} cannot be read as a map: {fault}') from fault
    if picture.ndim == 3:
        picture = picture[:, :, 0]
    height, width = picture.shape[:2]
    x, y = info['origin'][:2]
    return picture, (x, x + width * info['resolution'], y, y + height * info['resolution'])


def picture_of(grid):
    """(image, extent) of a recorded map (bag.Grid), as load_floor makes it of a file."""
    rows, columns = grid.occupied.shape
    x, y = grid.origin
    shades = np.where(grid.occupied, 0.0, np.where(grid.free, 1.0, 0.8))[::-1]
    return shades, (x, x + columns * grid.resolution, y, y + rows * grid.resolution)


def draw_ways(folder, rows, floor, out):
    """All ways of each condition over the floor, red where the person steered. False where no ways were kept."""
    shown = [c for c in CONDITIONS if any(row['condition'] == c for row in rows)]
    ways = {c: [path for row in rows if row['condition'] == c
                for path in glob.glob(os.path.join(glob.escape(folder), 'paths', glob.escape(row['id']) + '.csv'))] for c in shown}
    if not any(ways.values()):
        return False
    figure, axes = plt.subplots(len(shown), 1, figsize=(11, 5.2 * len(shown)), squeeze=False, constrained_layout=True)
    for ax, condition in zip(axes[:, 0], shown):
        if floor:
            ax.imshow(floor[0], cmap='gray', extent=floor[1], origin='upper', alpha=0.8)
        for path in ways[condition]:
            points, steered = read_way(path)
            ax.plot(points[:, 0], points[:, 1], color=DRIVEN, lw=0.5, alpha=0.5)
            ax.plot(*np.where(steered[:, None], points, np.nan).T, color=STEERED_COLOUR, lw=1.0, alpha=0.7)
        ax.set_aspect('equal')
        ax.set_title(f'{NAMES[condition]}: {len(ways[condition])} runs, red where the person steered', fontsize=10, loc='left')
        ax.set_xlabel('x [m]')
        ax.set_ylabel('y [m]')
    figure.savefig(out, dpi=100)
    plt.close(figure)
    return True


def draw_distributions(rows, out):
    """A box and every run of the main measures, by condition and setting."""
    groups = [(s, c) for s in settings_of(rows) for c in CONDITIONS if of(rows, c, s)]
    several = len(settings_of(rows)) > 1
    labels = [f'{c}\n{s}' if several else c for s, c in groups]
    shown = ('duration', 'regions_crossed', 'contacts', 'operator_active', 'interventions', 'clearance')
    figure, axes = plt.subplots(2, 3, figsize=(max(11.0, 0.9 * len(groups) * 3), 6.5), constrained_layout=True)
    scatter = np.random.default_rng(1)
    for ax, measure in zip(axes.flat, shown):
        values = [known(of(rows, c, s), measure) for s, c in groups]
        ax.boxplot(values, labels=labels, showfliers=False, medianprops={'color': INK})
        for i, group in enumerate(values):
            ax.plot(i + 1 + scatter.uniform(-0.15, 0.15, len(group)), group, '.', color=DRIVEN, ms=4, alpha=0.6)
        ax.set_title(dict(MEASURES)[measure], fontsize=10, loc='left')
        ax.grid(axis='y', lw=0.4)
        if not np.any(np.concatenate(values)):  # nothing but zeros, or nothing
            ax.set_ylim(-0.05, 1.0)
    figure.savefig(out, dpi=100)
    plt.close(figure)


def table(rows):
    """Means and standard deviations by setting and condition, beside the paper's, as HTML."""
    settings = settings_of(rows)
    head = ['measure'] + [(f'{s}: ' if len(settings) > 1 else '') + c for s in settings for c in CONDITIONS if of(rows, c, s)]
    paper = [c for c in PAPER if any(row['condition'] == c for row in rows)]
    lines = []
    for measure, name in MEASURES:
        cells = [name]
        for s in settings:
            for c in CONDITIONS:
                if not of(rows, c, s):
                    continue
                values = known(of(rows, c, s), measure)
                if not values:
                    cells.append('not known')
                    continue
                cells.append(f'{sum(values):.0f} in all' if measure == 'contacts' else
                             f'{np.mean(values):.3f} ({np.std(values, ddof=1) if len(values) > 1 else 0.0:.3f}), '
                             f'median {np.median(values):.3f}')
        for c in paper:
            value = PAPER[c].get(measure)
            cells.append('' if value is None else f'{value} in all' if measure == 'contacts' else f'{value}')
        lines.append(cells)
    return html_table(head + [f'paper: {c}' for c in paper], lines)


def about_study(folder):
    """What study.json says; empty where there is none."""
    path = os.path.join(folder, 'study.json')
    if not os.path.exists(path):
        return {}
    with open(path, encoding='utf-8') as text:
        return json.load(text)


def who_drove(rows, about):
    """(the page's title, whether simulated people are among those who drove)."""
    if about.get('experiment') != 'live':
        return 'A study with simulated people', True
    simulated, people = set(about['simulated']), {int(row['participant']) for row in rows}
    if not simulated:
        return 'A study', False
    return ('Drives with simulated people' if people <= simulated else
            f'A study; simulated: participant {", ".join(map(str, sorted(simulated)))}'), True


def answers_of(folder, rows, about):
    """What people answered, or None; only people of a study that was driven can have."""
    if about.get('experiment') != 'live':
        return None
    drives = {(int(row['participant']), row['condition']) for row in rows}
    try:
        return read_answers(folder, drives, about['simulated'])
    except AnswersError as fault:
        raise ReportError(str(fault)) from fault


def _items(texts):
    return ''.join(f'<li>{html.escape(text)}</li>' for text in texts)


def write_report(folder, map_path=None, floor=None):
    """Writes report.html, distributions.png and, where ways were kept, ways.png into the folder. `floor` is what load_floor
    makes of a map, where there is no map file. Returns the page's path."""
    rows, about = read_runs(folder), about_study(folder)
    answers, (title, simulated) = answers_of(folder, rows, about), who_drove(rows, about)
    distributions, ways = (os.path.join(folder, name) for name in ('distributions.png', 'ways.png'))
    draw_distributions(rows, distributions)
    has_ways = draw_ways(folder, rows, load_floor(map_path) or floor, ways)
    arrived = sum(row.get('arrived') == '1' for row in rows)
    asked = ', '.join(f'{key} {value}' for key, value in about.items() if key in ('experiment', 'participants', 'seed', 'profile', 'guard'))
    parts = [f'<p>{len(rows)} runs, {arrived} arrived. {html.escape(asked)}</p>',
             f'<p>{html.escape(verdict(rows))}</p><p>{html.escape(caution(simulated))}</p>']
    if about.get('remarks'):
        parts += ['<h2>Remarks</h2><ul>', _items(about['remarks']), '</ul>']
    if differences(rows):
        parts += ['<h2>What differs from the paper, and why</h2>', html_table(('', 'here', 'the paper'), differences(rows)),
                  '<ul>', _items(reasons(rows, simulated)), '</ul>']
    parts += ['<h2>By condition</h2><p>Mean (standard deviation), median.</p>', table(rows),
              '<h2>Tests</h2><ul>', _items(statements(rows)), '</ul>']
    if answers:
        parts += ['<h2>What people answered</h2>',
                  '<p>Of real people alone; the tests are not corrected for their number, as in the paper.</p>', '<ul>',
                  _items(answers_statements(answers)), '</ul><ul>', _items(answers.remarks), '</ul>']
    parts += ['<h2>Distributions</h2>', embedded(distributions)]
    if has_ways:
        parts += ['<h2>Ways driven</h2>', embedded(ways)]
    return write_page(os.path.join(folder, 'report.html'), html.escape(title), parts)


def say(folder, page):
    """Prints what the page says in words."""
    rows, about = read_runs(folder), about_study(folder)
    _, simulated = who_drove(rows, about)
    answers = answers_of(folder, rows, about)
    lines = [verdict(rows), *(f'{what}: {here} (the paper: {paper})' for what, here, paper in differences(rows)),
             *reasons(rows, simulated), *statements(rows), caution(simulated)]
    if answers:
        lines += [*answers_statements(answers), *answers.remarks]
    for line in lines:
        if line:
            print(line)
    print(f'==> {page}')


def main(arguments=None):
    """study_report DIR [MAP.yaml], for BARN-2D DIR [WORLDS.txt]"""
    arguments = sys.argv[1:] if arguments is None else arguments
    if not arguments or len(arguments) > 2:
        print('scripts/study report DIR [MAP.yaml | WORLDS.txt]', file=sys.stderr)
        return 2
    try:
        experiment = about_study(arguments[0]).get('experiment')
        if experiment in ('dynabarn', 'crowd'):
            page = encounter_report.write_report(*(arguments if experiment == 'dynabarn' else arguments[:1]))
            print('\n'.join([*encounter_report.statements(encounter_report.read_runs(arguments[0]), experiment == 'crowd'), f'==> {page}']))
        elif experiment == 'barn':
            page = barn_report.write_report(*arguments)
            print('\n'.join([*filter(None, barn_report.statements(barn_report.read_runs(arguments[0]))), f'==> {page}']))
        else:
            say(arguments[0], write_report(*arguments))
    except ReportError as fault:
        print(f'scripts/study: {fault}', file=sys.stderr)
        return 2
    return 0


if __name__ == '__main__':
    sys.exit(main())
