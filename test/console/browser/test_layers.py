# SPDX-License-Identifier: BSD-3-Clause
"""What is known is drawn: each part of the scene has pixels of its own in the views. In light and in dark, and on a phone."""
import unittest

import browser
import office
import test_page

# For each part of the scene: how many pixels of a view change where it is taken away, and their colours before. Nothing of the
# server's comes between, for all of it is one task.
LAYERS = """(() => {
    const {above, board, scene} = app;
    const flat = () => {
        above.dirty = true;
        above.draw();
        return above.canvas.getContext('2d').getImageData(0, 0, above.canvas.width, above.canvas.height).data;
    };
    const gl = board.renderer.getContext();
    const deep = () => {
        board.update();
        board.placeRobot();
        board.renderer.render(board.stage, board.eyes);
        const data = new Uint8Array(4 * gl.drawingBufferWidth * gl.drawingBufferHeight);
        gl.readPixels(0, 0, gl.drawingBufferWidth, gl.drawingBufferHeight, gl.RGBA, gl.UNSIGNED_BYTE, data);
        return data;
    };
    const still = {v: 0, omega: 0};
    const empty = {
        map: null, costmap: null, scan: new Float32Array(0), plan: [], predicted: [], candidates: [], movers: [], regions: [], goals: [],
        robot: null, wanted: {...scene.state, active: false}, command: {...scene.state, command: still},
    };
    const set = (part, value) => {
        const name = part in scene ? part : 'state';
        const before = scene[name];
        scene[name] = value;
        scene.version[name] = (scene.version[name] || 0) + 1;
        return before;
    };
    const changed = (before, after) => {
        let count = 0;
        const colours = {};
        for (let i = 0; i < before.length; i += 4) {
            const by = Math.max(...[0, 1, 2].map((k) => Math.abs(before[i + k] - after[i + k])));
            if (by <= 20) continue;
            count += 1;
            const colour = [before[i], before[i + 1], before[i + 2]].join();
            colours[colour] = (colours[colour] || 0) + 1;
        }
        const often = Object.entries(colours).sort((a, b) => b[1] - a[1]).map(([colour, n]) => [colour.split(',').map(Number), n]);
        return [count, often.slice(0, 400)];
    };
    const result = {};
    for (const view of [flat, deep]) {
        result[view.name] = {};
        const before = view();
        for (const [part, value] of Object.entries(empty)) {
            const kept = set(part, value);
            result[view.name][part] = changed(before, view());
            set(part, kept);
        }
    }
    return result;
})()"""
LUMINANCE = (0.2126, 0.7152, 0.0722)  # WCAG 2: of linear red, green and blue


def luminance(colour):
    """Of a colour [0, 255], as WCAG 2 has it."""
    parts = [value / 255.0 for value in colour]
    linear = [p / 12.92 if p <= 0.03928 else ((p + 0.055) / 1.055) ** 2.4 for p in parts]
    return sum(weight * value for weight, value in zip(LUMINANCE, linear))


def contrast(one, other):
    """Of two colours, 1 to 21."""
    low, high = sorted((luminance(one), luminance(other)))
    return (high + 0.05) / (low + 0.05)


class Layers(test_page.PageTest):
    def setUp(self):
        super().setUp()
        self.server.wants = False
        self.browser.click('candidates')
        self.browser.wait(lambda: self.server.wants)
        near = [office.ROBOT[0] + 2.0, office.ROBOT[1] - 0.5, 0.0]
        self.server.show(binary={'candidates': office.fan(office.ROBOT)},
                         goals={'active': near, 'waiting': [], 'start': None, 'outcome': '', 'text': ''})
        self.browser.wait(lambda: self.browser.app('app.scene.candidates.length') == 21, 'candidates')
        rest = 'Boolean(app.scene.scan.length && app.scene.goals.length === 1 && app.board && app.board.shown)'
        self.browser.wait(lambda: self.browser.app(rest), 'the whole scene')

    def scheme(self, name):
        self.browser.cdp('Emulation.setEmulatedMedia', {'features': [{'name': 'prefers-color-scheme', 'value': name}]})
        self.browser.until("return matchMedia('(prefers-color-scheme: %s)').matches" % name)
        self.browser.wait(lambda: self.browser.app("app.above.theme.plan === getComputedStyle(document.documentElement)"
                                                   ".getPropertyValue('--draw-plan').trim()"), 'the colours of ' + name)

    def colour(self, name):
        text = super().colour(name)
        return [int(text[i:i + 2], 16) for i in (1, 3, 5)]

    def test_light_and_dark_show_every_part_of_the_scene_and_can_be_read(self):
        self.addCleanup(self.scheme, 'light')
        for scheme in ('light', 'dark'):
            self.scheme(scheme)
            with self.subTest(scheme):
                self.check_layers()
                paper = self.check_text()
                self.assertTrue(paper > 0.5 if scheme == 'light' else paper < 0.1, paper)

    def check_layers(self):
        seen = self.browser.app(LAYERS)
        above = {part: count for part, (count, _) in seen['flat'].items()}
        # The least: the arc of what is asked for, 2 s at 0.5 m/s: 1 m, that is 44 pixels, 3 of them wide.
        self.assertEqual([part for part, count in above.items() if count < 40], [], above)
        board = {part: count for part, (count, _) in seen['deep'].items()}
        shown = ('map', 'costmap', 'plan', 'predicted', 'movers', 'regions', 'wanted', 'command')
        self.assertEqual([part for part in shown if board[part] < 20], [], board)
        red, green, blue = seen['flat']['plan'][1][0][0]
        self.assertEqual([red, green, blue], self.colour('plan'))
        self.assertGreater(green, max(red, blue) + 20, 'a green line, as in the paper')
        # From cheap to dear they go from green to red; what is rejected is grey. Their lines are thin: colours are mixed.
        colours = seen['flat']['candidates'][1]
        for kind, is_one in (('cheap', lambda r, g, b: g > r + 10), ('dear', lambda r, g, b: r > g + 40),
                             ('rejected', lambda r, g, b: max(r, g, b) - min(r, g, b) < 30)):
            self.assertGreater(sum(count for colour, count in colours if is_one(*colour)), 10, kind)

    def check_text(self):
        """WCAG 2, level AA; the luminance of the paper."""
        parse = "const rgb = (text) => text.match(/[0-9.]+/g).slice(0, 3).map(Number);"
        behind = ("const opaque = (e) => { for (let one = e; one; one = one.parentElement) { "
                  "const c = getComputedStyle(one).backgroundColor; "
                  "if (!/, 0\\)$|transparent/.test(c)) return rgb(c); } return [255, 255, 255]; };")
        for element in ('state-title', 'speed', 'who-text', 'stop', 'claim', 'tab-tuning', 'home'):
            ink, paper = self.browser.js(parse + behind + 'const e = document.getElementById(arguments[0]);'
                                         'return [rgb(getComputedStyle(e).color), opaque(e)]', element)
            self.assertGreater(contrast(ink, paper), 4.5, (element, ink, paper))
        return luminance(self.browser.js(parse + behind + 'return opaque(document.body)'))


class Phone(test_page.PageTest):
    size = browser.PHONE

    def test_all_of_it_is_on_the_screen(self):
        width, height = browser.PHONE
        self.assertLessEqual(self.browser.js('return document.documentElement.scrollWidth'), width)
        for element in ('stop', 'stick', 'state-title', 'speed', 'delay', 'above-canvas', 'go', 'home'):
            x, y, w, h = self.browser.middle(element)
            self.assertTrue(w / 2 <= x + 1 <= width - w / 2 + 2 and h / 2 <= y + 1 <= height - h / 2 + 2, (element, x, y, w, h))
            on_top = self.browser.js('const [element, x, y] = arguments;'
                                     'return document.getElementById(element).contains(document.elementFromPoint(x, y))', element, x, y)
            self.assertTrue(on_top, element + ' is covered')
        for element in ('stop', 'stick'):
            self.assertGreaterEqual(min(self.browser.middle(element)[2:]), 44, element + ' is for fingers')
        self.browser.click('stop')
        self.assertTrue(self.server.wait(lambda all: any(one['type'] == 'stop' for one in all)))


if __name__ == '__main__':
    unittest.main()
