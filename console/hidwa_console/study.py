# SPDX-License-Identifier: BSD-3-Clause
"""A participant's condition in the page: consent, the drive, the questionnaire. scripts/study live --console keeps the study; the two
talk by files in one folder, each written by one side: session.json and answers.json."""
import math
import os

from hidwa_tools.exchange import read, write

TEXTS = {
    'consent': 'This is a study of how people and robots share control. You will drive a simulated robot once, for a few minutes, and '
               'then answer some questions. What is stored: a number in place of your name, the way of the robot, what you did with '
               'stick or hand, and your answers. No picture, no sound. You may stop at any time, without a reason: close the page then, '
               'and tell who asked you here. If you do not agree now, nothing is stored. Do you agree?',
    'done': 'Thank you. That was all; you may close the page.',
    'ended': 'Nothing was stored. You may close the page.'}
HOW = {
    'SJ': 'The robot drives by itself. Deflect the stick to a side, and it bends its way to that side; let go, and it drives on by itself.',
    'SG': 'The robot drives by itself. Hold the grip and move your hand to a side, and it bends its way to that side; open your hand, '
          'and it drives on by itself.',
    'SW': 'The robot drives by itself. Take control with the button, drive with the stick, and give control back with the button.'}
TASK = 'Keep it out of the marked regions: the robot does not see them. The red button stops it.'
LITTLE, MUCH = 'very little', 'very much'
# Columns of questionnaires.csv: the NASA task load index, 0 to 100, and the scales of Kalliokoski et al. (2022), 1 to 7; low is good.
LOAD = (('mental', 'How much thinking, deciding and looking did it take?', LITTLE, MUCH),
        ('physical', 'How much bodily effort did it take?', LITTLE, MUCH),
        ('temporal', 'How hurried did you feel?', LITTLE, MUCH),
        ('performance', 'How well did you do what you were asked to do?', 'perfectly', 'not at all'),
        ('effort', 'How hard did you have to work for it?', LITTLE, MUCH),
        ('frustration', 'How annoyed, discouraged or stressed were you?', LITTLE, MUCH))
SCALES = (('control', 'Did you feel in control of the robot?'), ('ease', 'Was it easy to drive?'),
          ('comfort', 'Was the ride comfortable?'))
QUESTIONS = [{'name': name, 'text': text, 'low': 0, 'high': 100, 'step': 5, 'low_text': low, 'high_text': high}
             for name, text, low, high in LOAD]
QUESTIONS += [{'name': name, 'text': text, 'low': 1, 'high': 7, 'step': 1, 'low_text': 'fully', 'high_text': 'not at all'}
              for name, text in SCALES]


class Session:
    """One participant in one condition. The folder's session.json holds participant, condition, place, and `driven` once the drive
    is over."""

    def __init__(self, folder):
        self._session, self._answers = os.path.join(folder, 'session.json'), os.path.join(folder, 'answers.json')
        self._about, self._said = read(self._session), read(self._answers)  # a console that starts anew goes on where it was

    @property
    def stage(self):
        """Where the participant is."""
        said = self._said
        if said.get('consent') is False:
            return 'ended'
        if 'ratings' in said:
            return 'done'
        if self._about.get('driven'):
            return 'questions'
        return 'drive' if said.get('start') else 'ready' if said.get('consent') else 'consent'

    def tick(self):
        """Once a second: whether the drive is over."""
        self._about = read(self._session) or self._about

    def answer(self, answer):
        """What the participant says: (ok, text)."""
        asked = {'consent': 'consent', 'ready': 'start', 'questions': 'ratings'}.get(self.stage)
        if asked is None or list(answer) != [asked]:
            return False, 'this is not asked now'
        if asked == 'ratings':
            fault = fault_of(answer['ratings'])
            if fault:
                return False, fault
        elif not isinstance(answer[asked], bool) or (asked == 'start' and not answer[asked]):
            return False, 'answer yes or no'
        self._said = {**self._said, **answer}
        write(self._answers, self._said)
        return True, ''

    def report(self):
        """The page's `study`."""
        stage, about = self.stage, self._about
        how = HOW.get(about.get('condition'), '')
        text = TEXTS.get(stage) or {
            'ready': f'{how} {TASK} Take the controls, centre the stick, and begin.', 'drive': f'{how} {TASK}',
            'questions': 'The drive is over. Please answer every question.'}[stage]
        return {'stage': stage, 'text': text, 'questions': QUESTIONS if stage == 'questions' else [],
                **{name: about.get(name) for name in ('participant', 'condition', 'place')}}


def fault_of(ratings):
    """What is wrong with ratings; '' where nothing is."""
    if not isinstance(ratings, dict) or set(ratings) != {q['name'] for q in QUESTIONS}:
        return 'please answer every question'
    for question in QUESTIONS:
        value = ratings[question['name']]
        if isinstance(value, bool) or not isinstance(value, (int, float)) or not math.isfinite(value) \
                or not question['low'] <= value <= question['high']:
            return f'{question["name"]} is {question["low"]} to {question["high"]}'
    return ''
