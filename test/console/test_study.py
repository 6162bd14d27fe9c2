# SPDX-License-Identifier: BSD-3-Clause
"""A participant in the page: what is asked when, and what No means. test_study_in_page.py sits through a whole condition."""
import os
import sys
import tempfile
import unittest

import paths
from hidwa_console.study import QUESTIONS, Session
from hidwa_tools.exchange import read, write
from hidwa_tools.processes import Child
from hidwa_tools.questionnaires import RANGES, AnswersError, add_answers, read_answers

from page_twin import Page, View, port_of, until

RATINGS = {q['name']: q['low'] + i for i, q in enumerate(QUESTIONS[:6])}
RATINGS.update({q['name']: 7 - i for i, q in enumerate(QUESTIONS[6:])})


class Stages(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name
        self.about = {'participant': 3, 'condition': 'SW', 'place': 2}
        self.put(**self.about)
        self.session = Session(self.folder)

    def put(self, **content):
        write(os.path.join(self.folder, 'session.json'), content)

    def test_from_consent_to_thanks(self):
        self.assertEqual(self.session.stage, 'consent')
        self.assertFalse(self.session.answer({'start': True})[0])
        self.assertTrue(self.session.answer({'consent': True})[0])
        self.assertTrue(self.session.answer({'start': True})[0])
        self.assertEqual(self.session.stage, 'drive')
        self.assertFalse(self.session.answer({'ratings': RATINGS})[0])
        self.put(**self.about, driven=True)
        self.session.tick()
        self.assertEqual([q['name'] for q in self.session.report()['questions']], list(RANGES))
        self.assertTrue(self.session.answer({'ratings': RATINGS})[0])
        self.assertEqual(self.session.stage, 'done')
        self.assertEqual(read(os.path.join(self.folder, 'answers.json'))['ratings'], RATINGS)

    def test_no_ends_it(self):
        self.session.answer({'consent': False})
        self.assertEqual(self.session.stage, 'ended')
        self.assertFalse(self.session.answer({'consent': True})[0])

    def test_answers_that_are_none(self):
        for answer in ({'consent': True}, {'start': True}):
            self.session.answer(answer)
        self.put(**self.about, driven=True)
        self.session.tick()
        for wrong in ({}, {**RATINGS, 'mental': 101}, {**RATINGS, 'control': 0}, {**RATINGS, 'more': 1}, {**RATINGS, 'ease': True}):
            self.assertFalse(self.session.answer({'ratings': wrong})[0], wrong)
        self.assertEqual(self.session.stage, 'questions')

    def test_a_console_that_starts_anew_goes_on(self):
        self.session.answer({'consent': True})
        self.session.answer({'start': True})
        self.assertEqual(Session(self.folder).stage, 'drive')

    def test_questions_are_the_columns_in_their_ranges(self):
        self.assertEqual({q['name']: (float(q['low']), float(q['high'])) for q in QUESTIONS}, RANGES)

    def test_lines_of_the_table(self):
        add_answers(self.folder, 1, 'SJ', RATINGS)
        add_answers(self.folder, 1, 'SW', RATINGS)
        with self.assertRaises(AnswersError):
            add_answers(self.folder, 1, 'SJ', RATINGS)
        answers = read_answers(self.folder, {(1, 'SJ'), (1, 'SW')})
        self.assertEqual(answers.ratings[(1, 'SJ')], {name: float(value) for name, value in RATINGS.items()})
        self.assertEqual(answers.remarks, [])


class Live(unittest.IsolatedAsyncioTestCase):
    def start(self, out, condition):
        log = os.path.join(out, 'log')
        environment = {**os.environ, 'PYTHONPATH': os.pathsep.join([os.path.join(paths.ROOT, 'scripts', 'lib'), os.environ['PYTHONPATH']])}
        child = Child([sys.executable, '-m', 'hidwa_tools.study_live', '--participant', '1', '--condition', condition, '--out',
                       os.path.join(out, 'study'), '--console', '--yes', '--goal', '5.5,3.7,1.57',
                       f'--console-options=--port 0 --page {out}'], log, environment)
        self.addCleanup(child.stop)
        return child, log

    async def test_no(self):
        with tempfile.TemporaryDirectory() as out:
            with open(os.path.join(out, 'index.html'), 'w', encoding='utf-8') as page:
                page.write('<!doctype html><title>empty</title>')
            child, log = self.start(out, 'SJ')
            page = await Page(await port_of(child, log), 'a' * 32).open()
            view = await View(page).open()
            await page.claim()
            page.say('study', answer={'consent': False})
            await until(lambda: not child.running, 'the end')
            with open(log, encoding='utf-8') as text:
                self.assertIn('nothing was stored', text.read())
            self.assertEqual(os.listdir(os.path.join(out, 'study')), [])
            view.close()


if __name__ == '__main__':
    unittest.main()
