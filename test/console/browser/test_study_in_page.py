# SPDX-License-Identifier: BSD-3-Clause
"""A participant's condition in the page, started as scripts/study live --console starts it: consent, the drive, the questions."""
import csv
import os
import re
import sys
import tempfile
import unittest

import browser
from hidwa_tools.processes import Child
from robot import ROOT
from stage import STOP_DELAY


class Study(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix='console_study_')
        self.addCleanup(folder.cleanup)
        self.out, self.log = os.path.join(folder.name, 'study'), os.path.join(folder.name, 'log')
        environment = dict(os.environ, PYTHONPATH=os.pathsep.join([os.path.join(ROOT, 'scripts', 'lib'), os.environ['PYTHONPATH']]))
        page = os.path.join(ROOT, 'console', 'page')
        # A short way: 1.2 m straight ahead of the start.
        console = '--console-options=--port 0 --stop-delay %g --page %s' % (STOP_DELAY, page)
        self.child = Child([sys.executable, '-m', 'hidwa_tools.study_live', '--participant', '1', '--condition', 'SJ', '--out', self.out,
                            '--console', '--yes', '--goal', '5.5,3.7,1.57', console],
                           self.log, environment)
        self.addCleanup(self.child.stop)
        self.page = browser.Browser()
        self.addCleanup(self.page.end)
        self.page.open(self.page.wait(self.address, 'the address'))

    def said(self):
        with open(self.log, encoding='utf-8') as text:
            return text.read()

    def address(self):
        found = re.search(r'open (http://localhost:\d+/)', self.said())
        self.assertTrue(found or self.child.running, self.said())
        return found and found.group(1)

    def press(self, text):
        self.page.js("[...document.querySelectorAll('#study-buttons button')].find((one) => one.textContent === arguments[0]).click()",
                     text)

    def titled(self, title):
        self.page.wait(lambda: self.page.js("return document.getElementById('study').open") and self.page.text('study-title') == title,
                       'the page "%s"; it is "%s"' % (title, self.page.text('study-title')))

    def is_fixed(self, wish):
        """Whether the page says that a study fixes what is wished. What is more urgent, as a slow link, may hide it for a while."""
        self.page.app('(app.status.set({told: null}), app.send(%s))' % wish)
        for _ in range(20):
            if self.page.text('notice') == 'in a study this is fixed':
                return True
        print('the page says "%s"' % self.page.text('notice'))
        return False

    def test_consent_drive_questions_thanks(self):
        page = self.page
        self.titled('Before we begin')
        # What is stored is said on the first page.
        for fact in ('What is stored: a number in place of your name', 'No picture, no sound', 'nothing is stored'):
            self.assertIn(fact, page.text('study-text'))
        page.wait(lambda: page.app('Boolean(app.holder.mine)'), 'the controls')
        self.press('I agree')
        self.titled('The next drive')
        self.assertIn('Deflect the stick to a side', page.text('study-text'))
        for wish in ("'goal', {x: 9, y: 9, yaw: null, append: false}", "'mode', {mode: 'off'}"):
            page.wait(lambda: self.is_fixed(wish), 'that it is fixed: %s' % wish)
        self.press('Start')
        page.wait(lambda: not page.js("return document.getElementById('study').open"), 'the drive')
        page.wait(lambda: page.text('state-title') == 'The robot drives itself', 'a robot that drives')
        self.titled('How was it?')
        names = page.js("return [...document.querySelectorAll('#study input')].map((one) => one.name)")
        self.press('Done')
        page.wait(lambda: '%d are open' % len(names) in page.text('study-error'), 'that every question is to be answered')
        page.js("for (const one of document.querySelectorAll('#study input')) { one.value = one.min === '0' ? 35 : 4; "
                "one.dispatchEvent(new Event('input')); }")
        self.press('Done')
        self.titled('Thank you')
        browser.Browser.wait(lambda: not self.child.running, 'its end')
        self.assertGreater(os.path.getsize(os.path.join(self.out, 'p01_o1_SJ.bag')), 10000, self.said())
        with open(os.path.join(self.out, 'questionnaires.csv'), encoding='utf-8', newline='') as text:
            rows = list(csv.DictReader(text))
        self.assertEqual(len(rows), 1)
        self.assertEqual({name: float(rows[0][name]) for name in names}, {name: 4.0 if name in ('control', 'ease', 'comfort') else 35.0
                                                                          for name in names})
        self.assertEqual((rows[0]['participant'], rows[0]['condition'], len(names)), ('1', 'SJ', 9))


if __name__ == '__main__':
    unittest.main()
