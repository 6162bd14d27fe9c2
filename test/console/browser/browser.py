# SPDX-License-Identifier: BSD-3-Clause
"""Headless Chromium, driven by selenium, and what the tests need of it."""
import io
import os
import shutil
import tempfile
import time

from hidwa_tools.waiting import PATIENCE
from PIL import Image
from selenium import webdriver
from selenium.webdriver.chrome.options import Options
from selenium.webdriver.chrome.service import Service

DESKTOP = (1280, 720)
PHONE = (390, 844)
# A script for a page that draws seven frames a second, which leaves the processors to others: they draw it.
FEW_FRAMES = 'const everyFrame = requestAnimationFrame; window.requestAnimationFrame = (draw) => setTimeout(() => everyFrame(draw), 150);'


class Browser:
    """One Chromium with WebGL in software. scripts: sources that run in every page before its own; rules: Chromium's rules for
    resolving hosts, by which a proxy takes the place of a server without the page's noticing; arguments: more of Chromium's."""

    def __init__(self, size=DESKTOP, scripts=(), dark=False, scale=1.0, rules='', arguments=()):
        self.profile = tempfile.mkdtemp(prefix='console_browser_')
        options = Options()
        options.binary_location = shutil.which('chromium') or shutil.which('chromium-browser')
        for argument in ('--headless=new', '--no-sandbox', '--disable-dev-shm-usage', '--disable-gpu', '--enable-unsafe-swiftshader',
                         '--disable-background-networking', '--no-first-run', '--disable-extensions', '--mute-audio',
                         '--user-data-dir=' + self.profile, '--window-size=%d,%d' % size, *arguments):
            options.add_argument(argument)
        if rules:
            options.add_argument('--host-resolver-rules=' + rules)
        options.set_capability('goog:loggingPrefs', {'browser': 'ALL'})
        self.driver = webdriver.Chrome(service=Service(shutil.which('chromedriver')), options=options)
        self.driver.set_script_timeout(PATIENCE)
        self.cdp = self.driver.execute_cdp_cmd
        self.scale, self.mobile, self.size, self.dark, self.scripts = scale, size == PHONE, size, dark, scripts
        self.prepare()

    def prepare(self):
        """Size, colours and scripts of the tab that is looked at: a new tab has none of them."""
        self.resize(*self.size)
        self.cdp('Emulation.setEmulatedMedia', {'features': [{'name': 'prefers-color-scheme', 'value': 'dark' if self.dark else 'light'}]})
        if self.mobile:
            self.cdp('Emulation.setTouchEmulationEnabled', {'enabled': True, 'maxTouchPoints': 5})
        for script in self.scripts:
            self.cdp('Page.addScriptToEvaluateOnNewDocument', {'source': script})

    def resize(self, width, height):
        """Another size of the page [CSS pixels]."""
        self.cdp('Emulation.setDeviceMetricsOverride', {
            'width': width, 'height': height, 'deviceScaleFactor': self.scale, 'mobile': self.mobile})

    def open(self, address):
        """Opens a page and waits until it runs."""
        self.driver.get(address)
        self.until("return document.body.dataset.state !== undefined")
        self.app('app.loaded.then(() => true)')

    def js(self, script, *arguments):
        """The value of a function body in the page."""
        return self.driver.execute_script(script, *arguments)

    def app(self, expression):
        """The value of an expression (also a promise) in which `app` is the page's application."""
        result = self.driver.execute_async_script(
            'const done = arguments[arguments.length - 1];'
            "import('/main.js').then(async ({app}) => done({value: await (%s)}))"
            '.catch((error) => done({error: String(error.stack)}));' % expression)
        if 'error' in result:
            raise AssertionError(result['error'])
        return result['value']

    def until(self, script, seconds=PATIENCE):
        """Waits until a function body in the page says true."""
        self.wait(lambda: self.js(script), script, seconds)

    @staticmethod
    def wait(condition, what='the condition', seconds=PATIENCE):
        """Waits until condition() is true and returns its value."""
        end = time.monotonic() + seconds
        while True:
            value = condition()
            if value:
                return value
            if time.monotonic() > end:
                raise AssertionError('not within %g s: %s' % (seconds, what))
            time.sleep(0.03)

    def text(self, element):
        """What an element shows; empty while it is hidden."""
        return self.js('const e = document.getElementById(arguments[0]); return e.hidden ? "" : e.textContent', element)

    def click(self, element):
        """Presses a button."""
        self.js('document.getElementById(arguments[0]).click()', element)

    def middle(self, element):
        """The middle of an element, in CSS pixels of the page, and its size."""
        return self.js('const b = document.getElementById(arguments[0]).getBoundingClientRect();'
                       'return [b.x + b.width / 2, b.y + b.height / 2, b.width, b.height]', element)

    def mouse(self, kind, x, y, held=True):
        """A mouse event as a person makes it: mousePressed, mouseMoved or mouseReleased."""
        self.cdp('Input.dispatchMouseEvent', {
            'type': kind, 'x': x, 'y': y, 'button': 'left' if kind != 'mouseMoved' or held else 'none',
            'buttons': 1 if held and kind != 'mouseReleased' else 0, 'clickCount': 0 if kind == 'mouseMoved' else 1,
            'pointerType': 'mouse'})

    def key(self, kind, code, key):
        """keyDown or keyUp of a key."""
        self.cdp('Input.dispatchKeyEvent', {'type': kind, 'code': code, 'key': key})

    def picture(self):
        """What the browser shows, as a PIL image."""
        return Image.open(io.BytesIO(self.driver.get_screenshot_as_png())).convert('RGB')

    def crop(self, element):
        """What an element shows, in device pixels."""
        image = self.picture()
        x, y, width, height = self.middle(element)
        scale = image.width / self.js('return innerWidth')
        return image.crop([int(round(scale * value)) for value in (x - width / 2, y - height / 2, x + width / 2, y + height / 2)])

    def faults(self):
        """Errors in the page's console since the last call."""
        return [entry['message'] for entry in self.driver.get_log('browser') if entry['level'] == 'SEVERE']

    def end(self):
        """Ends the browser."""
        try:
            self.driver.quit()
        finally:
            shutil.rmtree(self.profile, ignore_errors=True)


def source_of(path):
    """The text of a script that the tests put into a page."""
    with open(path, encoding='utf-8') as file:
        return file.read()


def library():
    """The folder of the npm packages that the tests need (scripts/console_libraries --dev)."""
    space = os.environ.get('HIDWA_SPACE') or os.path.join(os.path.dirname(os.path.abspath(__file__)), '..', '..', '..')
    folder = os.path.join(space, 'build', 'console', 'node_modules')
    if not os.path.isdir(os.path.join(folder, 'iwer')):
        raise AssertionError("the page's libraries are missing: scripts/console_libraries --dev")
    return os.path.normpath(folder)
