# SPDX-License-Identifier: BSD-3-Clause
"""The page opened from another machine: by a name, with TLS and a token. A second console serves it; for the browser robot.lan is
this machine."""
import io
import os
import re
import subprocess
import sys
import time
import unittest

import browser
import stage
from hidwa_tools.processes import Child, free_port
from PIL import Image
from robot import ROOT

CAMERA = '/far_eye/image/compressed'
COLOUR = (200, 40, 160)


def jpeg():
    """A picture of one colour."""
    out = io.BytesIO()
    Image.new('RGB', (32, 24), COLOUR).save(out, 'JPEG', quality=95)
    return out.getvalue()


def setUpModule():
    stage.begin()


class Elsewhere(stage.DriveTest):
    def console(self, port):
        """(process, token) of a console that listens on every address."""
        folder = stage.robot.folder
        key, certificate, log = (os.path.join(folder, name) for name in ('key.pem', 'cert.pem', 'elsewhere.log'))
        if os.path.exists(log):
            os.remove(log)
        subprocess.run(['openssl', 'req', '-x509', '-newkey', 'rsa:2048', '-nodes', '-days', '2', '-subj', '/CN=robot.lan', '-addext',
                        'subjectAltName=DNS:robot.lan', '-keyout', key, '-out', certificate], check=True, capture_output=True)
        child = Child([sys.executable, os.path.join(ROOT, 'console', 'console'), '--address', '0.0.0.0', '--port', str(port), '--host-name',
                       'robot.lan', '--certfile', certificate, '--keyfile', key, '--camera', CAMERA, '--recordings', folder, '--page',
                       os.path.join(ROOT, 'console', 'page'), '__name:=elsewhere'], log, dict(os.environ, PYTHONUNBUFFERED='1'))
        self.addCleanup(child.stop)

        def token():
            with open(log, encoding='utf-8') as text:
                return re.search(r'https://robot\.lan:%d/#token=(\S+)' % port, text.read())
        found = stage.wait(lambda: token() or not child.running, 'the address with the token')
        self.assertIsNot(found, True, 'the console ended: ' + child.complaint())
        return child, found.group(1)

    def test_a_token_lets_in_and_the_page_steers(self):
        import rospy
        from sensor_msgs.msg import CompressedImage
        camera = rospy.Publisher(CAMERA, CompressedImage, queue_size=1)
        self.addCleanup(camera.unregister)
        port = free_port()
        child, token = self.console(port)
        page = browser.Browser(scale=0.5, rules='MAP robot.lan 127.0.0.1', arguments=('--ignore-certificate-errors',))
        self.addCleanup(page.end)
        address = 'https://robot.lan:%d/' % port

        page.driver.get(address + '#token=wrong')
        asked = "return document.getElementById('login').open"
        page.until(asked)
        self.assertEqual(page.js('return location.href'), address, 'the token is out of the address bar')
        enter = ("document.getElementById('login-error').textContent = ''; document.getElementById('token').value = arguments[0]; "
                 "document.querySelector('#login form').requestSubmit()")
        page.js(enter, 'wrong too')
        page.until("return document.getElementById('login-error').textContent === 'This is not the token.'")
        page.js(enter, token)
        self.at_the_controls(page)
        self.assertEqual(page.js('return document.cookie'), '', 'no script reads the cookie')
        self.assertTrue(page.js('return isSecureContext'), 'headsets need that')
        page.faults()  # the wrong tokens' answers

        page.driver.delete_all_cookies()
        page.driver.get('about:blank')
        page.driver.get(address + '#token=' + token)  # as a person opens what the node printed
        self.at_the_controls(page)
        self.assertFalse(page.js(asked))
        self.assertEqual(page.js('return location.href'), address)

        x, y = stage.robot.pose[:2]
        self.assertLess(max(abs(page.app('app.scene.robot.x') - x), abs(page.app('app.scene.robot.y') - y)), 0.15)
        began = time.monotonic()
        at = self.steer(-1, 0, lambda: any(joy.axes[0] > 0.9 for joy in stage.robot.since(stage.robot.joys, began)), page)
        page.mouse('mouseReleased', *at)

        message = CompressedImage(format='jpeg', data=jpeg())
        shown = ("const c = document.getElementById('picture-canvas'); return !c.hidden && c.width === 32 && "
                 "[...c.getContext('2d').getImageData(16, 12, 1, 1).data].slice(0, 3)")

        def colour():
            camera.publish(message)
            return page.js(shown)
        seen = page.wait(lambda: colour() or None, 'the compressed picture')
        self.assertLess(max(abs(a - b) for a, b in zip(seen, COLOUR)), 12)
        self.assertEqual(page.faults(), [])

        child.stop()
        page.wait(lambda: 'The link is cut' in page.text('notice'), 'that the link is cut')
        self.assertFalse(page.js(asked), 'nobody is there to ask')
        _, other = self.console(port)  # as roslaunch starts it anew, with another token
        page.until(asked)
        page.js(enter, token)
        page.until("return document.getElementById('login-error').textContent === 'This is not the token.'")
        page.js(enter, other)
        # Who had the controls of the console before takes them on purpose.
        page.until("return document.getElementById('who-text').textContent === 'Nobody has the controls.'")
        page.click('claim')
        self.at_the_controls(page)
        self.assertFalse(page.js(asked))

    @staticmethod
    def at_the_controls(page):
        page.until("return document.body.dataset.state !== undefined")
        page.app('app.loaded.then(() => true)')
        page.wait(lambda: page.app('Boolean(app.scene.robot && app.holder.mine && !app.status.facts.neutralNeeded)'), 'the controls')


if __name__ == '__main__':
    unittest.main()
