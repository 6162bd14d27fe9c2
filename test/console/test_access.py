# SPDX-License-Identifier: BSD-3-Clause
"""Who is let in, and which messages are messages."""
import json
import random
import unittest

import paths  # noqa: F401
from hidwa_console import messages
from hidwa_console.access import Access, is_loopback
from hidwa_console.bounds import Bucket
from hidwa_console.options import parse


class Doors(unittest.TestCase):
    def test_hosts(self):
        access = Access(8790, ['robot.lan'])
        for host in ('localhost:8790', '127.0.0.1:8790', '[::1]:8790', 'ROBOT.lan:8790'):
            self.assertTrue(access.host_allowed(host), host)
        for host in ('evil.example:8790', 'localhost:80', 'localhost', '', None, 'localhost:8790@evil', 'a/localhost:8790',
                     'localhost.evil.example:8790', 'localhost:99999', '127.0.0.1.evil:8790', '[::1:8790'):
            self.assertFalse(access.host_allowed(host), host)

    def test_the_usual_port_may_be_left_out(self):
        self.assertTrue(Access(443, ['robot.lan'], secure=True).host_allowed('robot.lan'))
        self.assertFalse(Access(443, ['robot.lan']).host_allowed('robot.lan'))

    def test_origins(self):
        access = Access(8790)
        self.assertTrue(access.same_origin('http://localhost:8790', 'localhost:8790'))
        for origin in ('http://evil.example', 'https://localhost:8790', 'http://localhost:8791', 'null', '', None,
                       'http://localhost:8790.evil.example'):
            self.assertFalse(access.same_origin(origin, 'localhost:8790'), origin)

    def test_a_page_behind_a_proxy_or_a_forwarded_port(self):
        access = Access(8790, page_origins=['https://robot.example', 'http://localhost:9000', 'http://[::1]:8080/'])
        # The Host of the proxy, or its own, which the proxy has put there.
        for origin, host in (('https://robot.example', 'robot.example'), ('https://robot.example', 'robot.example:443'),
                             ('https://ROBOT.example:443', 'localhost:8790'), ('http://localhost:9000', 'localhost:9000'),
                             ('http://localhost:9000', 'localhost'),
                             ('http://localhost:9000', '127.0.0.1:8790'), ('http://[::1]:8080', '[::1]:8080'),
                             ('http://localhost:8790', 'localhost:8790')):
            self.assertTrue(access.host_allowed(host), host)
            self.assertTrue(access.same_origin(origin, host), origin)
        for host in ('robot.example:8790', 'robot.example:80', 'evil.example', '127.0.0.1', 'localhost:9001', 'robot.example.evil.example'):
            self.assertFalse(access.host_allowed(host), host)
        for origin in ('http://robot.example', 'https://robot.example:8443', 'https://evil.example', 'https://localhost:9000',
                       'http://localhost', 'https://robot.example.evil.example', 'https://robot.example@evil.example', 'null'):
            self.assertFalse(access.same_origin(origin, 'robot.example'), origin)
        self.assertFalse(Access(8790).same_origin('https://robot.example', 'localhost:8790'))

    def test_sockets_and_the_cookie_of_a_page_by_tls(self):
        access = Access(8790, page_origins=['https://robot.example'])
        self.assertEqual(access.sockets_of('localhost:8790'), ['ws://localhost:8790', 'wss://robot.example'])
        self.assertTrue(access.by_tls('https://robot.example'))
        self.assertFalse(access.by_tls('http://localhost:8790'))
        self.assertFalse(access.by_tls('https://evil.example'))
        self.assertFalse(access.by_tls(None))
        self.assertTrue(Access(443, secure=True).by_tls('https://localhost'))

    def test_who_opens_it_to_others_asks_for_a_token(self):
        self.assertFalse(parse(['--page-origin', 'http://localhost:9000']).token)
        self.assertTrue(parse(['--page-origin', 'http://localhost:9000', '--page-origin', 'https://robot.example']).token)

    def test_token_and_session(self):
        access = Access(8790, token='right')
        self.assertFalse(access.admitted(None))
        self.assertEqual(access.log_in('wrong', 0.0), '')
        self.assertEqual(access.log_in(7, 0.0), '')
        session = access.log_in('right', 0.0)
        self.assertTrue(access.admitted(session))
        self.assertFalse(access.admitted(session[:-1]))
        self.assertFalse(access.admitted('right'))

    def test_attempts_are_counted(self):
        access = Access(8790, token='right')
        said = [access.log_in('wrong', 1.0) for _ in range(12)]
        self.assertEqual(said, [''] * 10 + [None] * 2)
        self.assertIsNone(access.log_in('right', 1.5))  # 0.25 attempts came back in half a second
        self.assertTrue(access.log_in('right', 4.0))

    def test_foreign_programs(self):
        here = Access(8790, foreign_origins=['https://viewer.example'])
        for origin in (None, 'file://', 'http://localhost:8080', 'https://viewer.example'):
            self.assertTrue(here.foreign_allowed(origin, ''), origin)
        self.assertFalse(here.foreign_allowed('https://evil.example', ''))
        away = Access(8790, token='right', foreign_origins=['https://viewer.example'])
        self.assertTrue(away.foreign_allowed('https://viewer.example', 'right'))
        for origin, token in (('https://viewer.example', 'wrong'), ('https://evil.example', 'right'), ('http://localhost:8080', 'right')):
            self.assertFalse(away.foreign_allowed(origin, token), origin)
        self.assertFalse(Access(8790, token='right').foreign_allowed(None, 'right'))  # --allow-origin asks for it

    def test_addresses(self):
        self.assertTrue(all(map(is_loopback, ('127.0.0.1', '127.1.2.3', '::1', 'localhost'))))
        self.assertFalse(any(map(is_loopback, ('0.0.0.0', '192.168.1.2', '::', 'robot.lan'))))

    def test_elsewhere_than_on_loopback_a_token_is_asked_for(self):
        self.assertFalse(parse([]).token)
        self.assertTrue(parse(['--address', '192.168.1.2']).token)
        with self.assertRaises(SystemExit):
            parse(['--address', '0.0.0.0'])  # by which name?

    def test_poses_with_a_minus(self):
        self.assertEqual(parse(['--tour', '-1,2,0', '', '--tour=3,4,1']).tour, [(-1.0, 2.0, 0.0), (3.0, 4.0, 1.0)])

    def test_bucket(self):
        bucket = Bucket(10.0, 5)
        self.assertEqual([bucket.take(0.0) for _ in range(6)], [True] * 5 + [False])
        self.assertEqual([bucket.take(0.2) for _ in range(3)], [True, True, False])  # 0.2 s * 10/s = 2


class Messages(unittest.TestCase):
    GOOD = {'type': 'stick', 't': 12.5, 'left': 0.5, 'forward': -1, 'held': True}

    def test_a_good_one(self):
        self.assertEqual(messages.read(json.dumps(self.GOOD)),
                         ('stick', {'t': 12.5, 'left': 0.5, 'forward': -1.0, 'held': True, 'stop': False}))

    def test_bad_ones(self):
        bad = [{**self.GOOD, 'left': 1.01}, {**self.GOOD, 'left': True}, {**self.GOOD, 'left': '0'}, {**self.GOOD, 'held': 1},
               {**self.GOOD, 't': None}, {**self.GOOD, 'type': 'Stick'}, {**self.GOOD, 'type': ['stick']}, {'type': 'stick'}, [], 7,
               {'type': 'mode', 'mode': 'fly'}, {'type': 'hello', 'page': 'A' * 32}, {'type': 'goal', 'x': 1e9, 'y': 0},
               {'type': 'tune', 'values': {}}, {'type': 'tune', 'values': {'a b': 1}}, {'type': 'tune', 'values': {'a': [1]}},
               {'type': 'tune', 'values': {'a': 10 ** 400}}, {'type': 'tune', 'values': {'a': -2 ** 31}},
               {'type': 'give', 'to': 1.5}, {'type': 'stop', 't': 0, 'on': 'true'}]
        texts = [json.dumps(b) for b in bad] + ['', '{', 'NaN', '[' * 100000, json.dumps(self.GOOD).replace('0.5', 'NaN'),
                                                json.dumps(self.GOOD).replace('0.5', '1e999'), json.dumps({**self.GOOD, 'x': 'y' * 5000})]
        for text in texts:
            with self.assertRaises(messages.Malformed, msg=text[:80]):
                messages.read(text)
        with self.assertRaises(messages.Malformed):
            messages.read(json.dumps(self.GOOD).encode())

    def test_whatever_comes_it_is_a_message_or_malformed(self):
        dice = random.Random(1)
        text = json.dumps(self.GOOD)
        for _ in range(5000):
            letters = list(text)
            for _ in range(dice.randint(1, 4)):
                letters[dice.randrange(len(letters))] = chr(dice.choice([dice.randrange(32, 127), dice.randrange(0xd800)]))
            try:
                kind, fields = messages.read(''.join(letters))
            except messages.Malformed:
                continue
            self.assertEqual(kind, 'stick')
            self.assertTrue(-1.0 <= fields['left'] <= 1.0 and -1.0 <= fields['forward'] <= 1.0)

    def test_names_are_shown_as_text(self):
        _, fields = messages.read(json.dumps({'type': 'hello', 'page': 'a' * 32, 'name': '\x00\x1bA\n' + 'b' * 60}))
        self.assertEqual(fields['name'], 'A' + 'b' * 39)


if __name__ == '__main__':
    unittest.main()
