# SPDX-License-Identifier: BSD-3-Clause
"""What people answered in a study: TLX, scales and choices, with the tests of Kalliokoski et al. (2022), section V."""
import csv
import os
from dataclasses import dataclass, field

import numpy as np

from .statistics import proportion, signed_ranks

ANSWERS, CHOICES = 'questionnaires.csv', 'choices.csv'
TLX = ('mental', 'physical', 'temporal', 'performance', 'effort', 'frustration')
SCALES = ('control', 'ease', 'comfort')
RANGES = {**dict.fromkeys(TLX, (0.0, 100.0)), **dict.fromkeys(SCALES, (1.0, 7.0))}
QUESTIONS = {'preferred': ('SJ', 'SW'), 'easier': ('SJ', 'SW'), 'preferred_of_three': ('SJ', 'SG', 'SW')}


class AnswersError(Exception):
    """A table of answers cannot be used; the text names the place and the remedy."""


@dataclass
class Answers:
    """Of real people alone."""
    ratings: dict = field(default_factory=dict)  # (participant, condition): {column: value}
    choices: dict = field(default_factory=dict)  # participant: {question: condition}
    remarks: list = field(default_factory=list)  # what is missing or left out


def _table(path, needed):
    with open(path, encoding='utf-8-sig', newline='') as text:
        reader = csv.DictReader(text, skipinitialspace=True)
        missing = [name for name in needed if name not in (reader.fieldnames or ())]
        if missing:
            raise AnswersError(f'{path} has no column {missing[0]}; docs/use/study.md lists the columns')
        return [(i, {key: (value or '').strip() for key, value in row.items() if key}) for i, row in enumerate(reader, 2)]


def _participant(path, line, row):
    if not row['participant'].isdigit():
        raise AnswersError(f"{path}, line {line}: '{row['participant']}' is no number of a participant")
    return int(row['participant'])


def _value(path, line, column, text):
    low, high = RANGES[column]
    try:
        value = float(text)
    except ValueError:
        value = np.nan
    if not low <= value <= high:
        raise AnswersError(f"{path}, line {line}: {column} is {low:g} to {high:g}, not '{text}'")
    return value


def read_answers(folder, drives, simulated=()):
    """The Answers in a folder, or None where there is no table; drives: {(participant, condition)} that were driven. AnswersError
    where a line makes no sense; what is missing is remarked."""
    paths = [os.path.join(folder, name) for name in (ANSWERS, CHOICES)]
    if not any(os.path.exists(path) for path in paths):
        return None
    answers, simulated, left_out = Answers(), set(simulated), set()
    if os.path.exists(paths[0]):
        for line, row in _table(paths[0], ('participant', 'condition')):
            who, condition = _participant(paths[0], line, row), row['condition']
            if condition not in QUESTIONS['preferred_of_three']:
                raise AnswersError(f"{paths[0]}, line {line}: condition is SJ, SG or SW, not '{condition}'")
            if (who, condition) in answers.ratings:
                raise AnswersError(f'{paths[0]}, line {line}: participant {who} has answered for {condition} already')
            values = {c: _value(paths[0], line, c, row[c]) for c in RANGES if row.get(c)}
            if who in simulated:
                left_out.add(who)
            else:
                answers.ratings[(who, condition)] = values
        _remark_ratings(answers, {key for key in drives if key[0] not in simulated})
    if os.path.exists(paths[1]):
        for line, row in _table(paths[1], ('participant',)):
            who, said = _participant(paths[1], line, row), {}
            for question, allowed in QUESTIONS.items():
                if row.get(question) and row[question] not in allowed:
                    raise AnswersError(f"{paths[1]}, line {line}: {question} is {' or '.join(allowed)}, not '{row[question]}'")
                if row.get(question):
                    said[question] = row[question]
            if who in answers.choices:
                raise AnswersError(f'{paths[1]}, line {line}: participant {who} has chosen already')
            if who in simulated:
                left_out.add(who)
            else:
                answers.choices[who] = said
        _remark_choices(answers, {who for who, _ in drives} - simulated)
    if left_out:
        answers.remarks.append(f'answers of simulated people are left out: {_list(left_out)}')
    return answers


def refuse_second_answers(folder, who, condition):
    """AnswersError if a participant has answered for a condition already."""
    path = os.path.join(folder, ANSWERS)
    if os.path.exists(path):
        for line, row in _table(path, ('participant', 'condition')):
            if (_participant(path, line, row), row['condition']) == (who, condition):
                raise AnswersError(f'{path}, line {line}: participant {who} has answered for {condition} already')


def add_answers(folder, who, condition, ratings):
    """Adds a line to questionnaires.csv; ratings: {column: value}. AnswersError where there is one already, or a column is missing."""
    path = os.path.join(folder, ANSWERS)
    refuse_second_answers(folder, who, condition)
    values = {'participant': who, 'condition': condition, **{name: f'{value:g}' for name, value in ratings.items()}}
    columns = list(values)
    if os.path.exists(path):
        with open(path, encoding='utf-8-sig', newline='') as text:
            columns = next(csv.reader(text, skipinitialspace=True))
        missing = [name for name in values if name not in columns]
        if missing:
            raise AnswersError(f'{path} has no column {missing[0]}; docs/use/study.md lists the columns')
    new = not os.path.exists(path)
    with open(path, 'a', encoding='utf-8', newline='') as out:
        writer = csv.DictWriter(out, columns, restval='')
        if new:
            writer.writeheader()
        writer.writerow(values)


def _list(people):
    return ', '.join(f'participant {who}' for who in sorted(people))


def _remark_ratings(answers, drives):
    for who, condition in sorted(drives - set(answers.ratings)):
        answers.remarks.append(f'{ANSWERS} has no line of participant {who} for {condition}')
    for who, condition in sorted(set(answers.ratings) - drives):
        answers.remarks.append(f'{ANSWERS}: participant {who} answered for {condition}, of which there is no drive')
    asked = {column for values in answers.ratings.values() for column in values}
    for (who, condition), values in sorted(answers.ratings.items()):
        missing = [column for column in RANGES if column in asked and column not in values]
        if missing:
            answers.remarks.append(f'{ANSWERS}: participant {who}, {condition}: no {", ".join(missing)}')


def _remark_choices(answers, people):
    for who in sorted(people - set(answers.choices)):
        answers.remarks.append(f'{CHOICES} has no line of participant {who}')
    asked = {question for said in answers.choices.values() for question in said}
    for who, said in sorted(answers.choices.items()):
        missing = [question for question in QUESTIONS if question in asked and question not in said]
        if missing:
            answers.remarks.append(f'{CHOICES}: participant {who}: no {", ".join(missing)}')


def pairs(answers, column, other):
    """Values (SJ, other) of those who rated both."""
    people = sorted({who for who, _ in answers.ratings})
    both = [who for who in people if all(column in answers.ratings.get((who, c), {}) for c in ('SJ', other))]
    return tuple([answers.ratings[(who, c)][column] for who in both] for c in ('SJ', other))


def statements(answers):
    """What the tests say, a sentence each: choices, then TLX and scales of SJ against SW and SG."""
    said = []
    for question, name in (('preferred', 'preferred SJ to SW'), ('easier', 'found SJ easier than SW')):
        given = [choice[question] for choice in answers.choices.values() if question in choice]
        if given:
            test = proportion(given.count('SJ'), len(given))
            said.append(f'{given.count("SJ")} of {len(given)} {name}: exact binomial p = {test.p_one_sided:.4f} (one-sided), '
                        f'{test.p_two_sided:.4f} (two-sided), 95 % interval {100 * test.low:.1f} % to {100 * test.high:.1f} %')
    three = [choice['preferred_of_three'] for choice in answers.choices.values() if 'preferred_of_three' in choice]
    if three:
        said.append('preferred of the three: ' + ', '.join(f'{c} {three.count(c)}' for c in QUESTIONS['preferred_of_three']))
    for other in ('SW', 'SG'):
        for column in (*TLX, *SCALES):
            first, second = pairs(answers, column, other)
            if not first:
                continue
            # The paper's hypothesis is that the workload is lower in SJ than in SW; all else is two-sided.
            side = 'less' if column in TLX and other == 'SW' else 'two-sided'
            test = signed_ranks(first, second, side)
            text = (f'{column}: mean {np.mean(first):.2f} (median {np.median(first):.1f}) in SJ, {np.mean(second):.2f} '
                    f'({np.median(second):.1f}) in {other}; ')
            text += 'no pair differs' if test.changed == 0 else (
                f'Wilcoxon signed-rank, {"one-sided (lower in SJ)" if side == "less" else side}, {test.pairs} pairs: Z = {test.z:.3f}, '
                f'p = {test.p:.4f} (exact), r = {test.r:.3f}')
            said.append(text)
    return said
