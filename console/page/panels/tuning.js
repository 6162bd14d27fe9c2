// SPDX-License-Identifier: BSD-3-Clause
// The tuning panel: parameters of the operator and the critics' weights, live, with undo and presets.

function element(tag, properties = {}, ...children) {
  const result = Object.assign(document.createElement(tag), properties);
  result.append(...children);
  return result;
}

/** The input of a parameter, and how its value is read; null where what stands there is no value. */
function makeInput(parameter) {
  if (parameter.type === 'bool') {
    return { input: element('input', { type: 'checkbox', checked: parameter.value }), read: (input) => input.checked };
  }
  if (parameter.type === 'enum') {
    const input = element('select', {}, ...parameter.choices.map(({ value, text }) => element('option', { value: String(value), textContent: text || String(value) })));
    input.value = String(parameter.value);
    return { input, read: (one) => parameter.choices[one.selectedIndex].value };
  }
  if (parameter.type === 'str') {
    return { input: element('input', { type: 'text', value: parameter.value }), read: (input) => input.value };
  }
  const input = element('input', { type: 'number', value: parameter.value, step: parameter.type === 'int' ? 1 : 'any' });
  if (Number.isFinite(parameter.min)) input.min = parameter.min;
  if (Number.isFinite(parameter.max)) input.max = parameter.max;
  return { input, read: (one) => (one.value === '' || !one.validity.valid ? null : Number(one.value)) };
}

export class TuningPanel {
  /** root: the panel; send(type, fields): to the server; say(text): to the person. */
  constructor(root, send, say) {
    this.root = root;
    this.send = send;
    this.say = say;
    root.append(element('p', { textContent: 'The planner says nothing of its parameters yet.' }));
  }

  tick({ tuning }) {
    if (!tuning) return;
    const key = JSON.stringify(tuning);
    if (key === this.key) return;
    this.key = key;
    this.draw(tuning);
  }

  draw({ parameters, undo, presets }) {
    const focused = document.activeElement && document.activeElement.id;
    const scroll = this.root.scrollTop;
    const actions = element('div', { className: 'actions' });
    const back = element('button', { type: 'button', id: 'undo', textContent: undo ? `Undo (${undo})` : 'Undo', disabled: undo === 0 });
    back.addEventListener('click', () => this.send('undo'));
    actions.append(back);
    for (const preset of presets) {
      const button = element('button', { type: 'button', textContent: preset.name.replaceAll('_', ' '), title: preset.text });
      button.addEventListener('click', () => this.send('preset', { name: preset.name }));
      actions.append(button);
    }
    const tabs = [...new Set(parameters.map(({ tab }) => tab))];
    const groups = tabs.flatMap((tab) => [
      element('h3', { textContent: tab === 'Critics' ? 'Weights' : tab }),
      ...parameters.filter((one) => one.tab === tab).map((one) => this.row(one)),
    ]);
    this.root.replaceChildren(actions, ...groups);
    this.root.scrollTop = scroll;
    if (focused && this.root.querySelector(`#${CSS.escape(focused)}`)) document.getElementById(focused).focus();
  }

  row(parameter) {
    const { input, read } = makeInput(parameter);
    input.id = `parameter-${parameter.name}`;
    input.addEventListener('change', () => {
      const value = read(input);
      if (value === null) this.say(`${parameter.name}: ${input.validationMessage || 'a number is needed'}`);
      else this.send('tune', { values: { [parameter.name]: value } });
    });
    const row = element('div', { className: 'row' },
      element('label', { htmlFor: input.id, textContent: parameter.name }), input, element('small', { textContent: parameter.text }));
    row.classList.toggle('changed', parameter.value !== parameter.default);
    return row;
  }
}
