# SPDX-License-Identifier: BSD-3-Clause
"""The tuning panel: the planner's parameters of the tab Operator and the weights, by dynamic_reconfigure. No other parameter can
be set from the page."""
import ast
import glob
import os
import re

import rospy
import yaml
from dynamic_reconfigure.msg import (BoolParameter, Config, ConfigDescription, DoubleParameter, IntParameter, StrParameter)
from dynamic_reconfigure.srv import Reconfigure

TABS = {'Operator input': 'Operator', 'Operator_input': 'Operator', 'Operator': 'Operator', 'Critics': 'Critics'}
WEIGHT = re.compile(r'.*_scale')
UNDOS = 20
KINDS = {'double': ('doubles', DoubleParameter, float), 'int': ('ints', IntParameter, int),
         'bool': ('bools', BoolParameter, bool), 'str': ('strs', StrParameter, str)}


def values_of(config):
    """{name: value} of a dynamic_reconfigure/Config."""
    return {p.name: p.value for part in (config.doubles, config.ints, config.bools, config.strs) for p in part}


def read_presets(folder):
    """[{name, text, values}] of the presets' files; text is a file's first comment."""
    found = []
    for path in sorted(glob.glob(os.path.join(folder, '*.yaml'))):
        with open(path, encoding='utf-8') as file:
            content = file.read()
        values = (yaml.safe_load(content) or {}).get('HIDWAPlannerROS', {})
        text = content.split('\n', 1)[0].lstrip('# ') if content.startswith('#') else ''
        found.append({'name': os.path.splitext(os.path.basename(path))[0], 'text': text, 'values': values})
    return found


def described(description):
    """[{name, type, ...}] of a ConfigDescription: what the panel shows, without values."""
    low, high, default = (values_of(c) for c in (description.min, description.max, description.dflt))
    found = []
    for group in description.groups:
        tab = TABS.get(group.name)
        for p in group.parameters if tab else ():
            if tab == 'Critics' and not WEIGHT.fullmatch(p.name):
                continue
            entry = {'name': p.name, 'type': p.type, 'default': default.get(p.name), 'tab': tab, 'text': p.description}
            if p.type in ('double', 'int'):
                entry.update(min=low.get(p.name), max=high.get(p.name))
            if p.edit_method:
                choices = ast.literal_eval(p.edit_method).get('enum', [])
                entry.update(type='enum', choices=[{'value': c['value'], 'text': c['description']} for c in choices])
            found.append(entry)
    return found


class Tuning:
    """`planner`: the planner's namespace. Messages arrive in rospy's threads and replace whole values."""

    def __init__(self, planner, presets=()):
        self._described, self._undo, self._presets = [], [], list(presets)
        found = rospy.get_param(planner, {})
        self.values = dict(found) if isinstance(found, dict) else {}
        self._service = rospy.ServiceProxy(planner + '/set_parameters', Reconfigure)
        rospy.Subscriber(planner + '/parameter_descriptions', ConfigDescription, self._describe, queue_size=1)
        rospy.Subscriber(planner + '/parameter_updates', Config, self._update, queue_size=1)

    def _describe(self, message):
        self._described = described(message)

    def _update(self, message):
        self.values = {**self.values, **values_of(message)}

    def parameters(self):
        """The planner's parameters in force."""
        return self.values

    def tune(self, values):
        """Sets parameters of the panel, all or none; may block. (ok, text)"""
        known = {entry['name']: entry for entry in self._described}
        if not known:
            return False, 'the planner has not said which parameters it has'
        foreign = [name for name in values if name not in known]
        if foreign:
            return False, f'{", ".join(foreign)} cannot be set here'
        before = {name: self.values[name] for name in values if name in self.values}
        ok, text = self.set(values)
        if ok:
            self._undo = [*self._undo[-(UNDOS - 1):], before]
        return ok, text

    def undo(self):
        """Takes the last change back; may block. (ok, text)"""
        if not self._undo:
            return False, 'nothing was changed here'
        ok, text = self.set(self._undo[-1])
        if ok:
            self._undo = self._undo[:-1]
        return ok, text

    def preset(self, name):
        """Sets a preset's values. (ok, text)"""
        for preset in self._presets:
            if preset['name'] == name:
                return self.tune(preset['values'])
        return False, f'there is no preset {name}'

    def set(self, values):
        """Sets parameters of the planner, whatever they are. (ok, text)"""
        config = Config()
        for name, value in values.items():
            kind = self._kind(name, value)
            part, message, convert = KINDS[kind]
            try:
                getattr(config, part).append(message(name, convert(value)))
            except (TypeError, ValueError):
                return False, f'{name}: {value} is no {kind}'
        try:
            answer = values_of(self._service(config).config)
        except (rospy.ServiceException, rospy.ROSException) as fault:
            return False, f'the planner does not answer: {fault}'
        refused = [name for name, value in values.items() if not self._same(answer.get(name), value)]
        self.values = {**self.values, **answer}
        return not refused, f'the planner did not take {", ".join(refused)}; its log says why' if refused else ''

    def _kind(self, name, value):
        for entry in self._described:
            if entry['name'] == name:
                return 'str' if entry['type'] == 'enum' else entry['type']
        known = self.values.get(name, value)
        return 'bool' if isinstance(known, bool) else 'int' if isinstance(known, int) else 'double' if isinstance(known, float) else 'str'

    @staticmethod
    def _same(a, b):
        if isinstance(a, (int, float)) and isinstance(b, (int, float)):
            return abs(a - b) <= 1e-9 * max(1.0, abs(b))
        return a == b

    def report(self):
        """The page's `tuning`."""
        entries = [{**entry, 'value': self.values.get(entry['name'], entry['default'])} for entry in self._described]
        return {'parameters': entries, 'undo': len(self._undo), 'presets': self._presets}
