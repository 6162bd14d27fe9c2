// SPDX-License-Identifier: BSD-3-Clause
// A participant's way through a study: consent, what to do, the drive, the questions, thanks. The server says which stage it
// is; nothing is kept in the page.

const byId = (id) => document.getElementById(id);

const TITLES = { consent: 'Before we begin', ready: 'The next drive', questions: 'How was it?', done: 'Thank you' };

function button(text, main, action) {
  const result = Object.assign(document.createElement('button'), { type: 'button', textContent: text });
  if (main) result.className = 'main';
  result.addEventListener('click', action);
  return result;
}

/** A question with a slider. It counts as answered only once it was touched. */
function makeQuestion({ name, text, low, high, low_text: lowText, high_text: highText, step }) {
  const field = document.createElement('fieldset');
  const legend = Object.assign(document.createElement('legend'), { textContent: text });
  const slider = Object.assign(document.createElement('input'), { type: 'range', min: low, max: high, step: step || 1, value: (low + high) / 2, name });
  slider.setAttribute('aria-label', text);
  const value = document.createElement('output');
  const touch = () => {
    slider.dataset.answered = 'yes';
    value.textContent = slider.value;
  };
  for (const event of ['input', 'change', 'pointerup']) slider.addEventListener(event, touch);
  const ends = Object.assign(document.createElement('div'), { className: 'ends' });
  ends.append(...[lowText, null, highText].map((end) => (end === null ? value : Object.assign(document.createElement('span'), { textContent: end || '' }))));
  field.append(legend, slider, ends);
  return field;
}

export class StudyPanel {
  /** send(type, fields): to the server. */
  constructor(send) {
    this.send = send;
    this.dialog = byId('study');
    this.dialog.addEventListener('cancel', (event) => event.preventDefault()); // escape does not skip a page
  }

  answer(fields) {
    this.send('study', { answer: fields });
  }

  tick({ study }) {
    if (study === undefined) return;
    const key = JSON.stringify(study);
    if (key === this.key) return;
    this.key = key;
    if (!study || study.stage === 'drive') this.dialog.close();
    else this.draw(study);
  }

  draw(study) {
    byId('study-title').textContent = TITLES[study.stage] || '';
    byId('study-text').textContent = study.text;
    byId('study-error').textContent = '';
    byId('study-questions').replaceChildren(...(study.stage === 'questions' ? study.questions.map(makeQuestion) : []));
    byId('study-buttons').replaceChildren(...this.buttons(study));
    if (!this.dialog.open) this.dialog.showModal();
    this.dialog.scrollTop = 0;
  }

  buttons({ stage }) {
    if (stage === 'consent') {
      return [button('I agree', true, () => this.answer({ consent: true })), button('I do not take part', false, () => this.answer({ consent: false }))];
    }
    if (stage === 'ready') return [button('Start', true, () => this.answer({ start: true }))];
    if (stage === 'questions') return [button('Done', true, () => this.rate())];
    return [];
  }

  rate() {
    const sliders = [...this.dialog.querySelectorAll('input[type="range"]')];
    const open = sliders.filter((slider) => !slider.dataset.answered);
    if (open.length) {
      byId('study-error').textContent = `Please answer every question; ${open.length} ${open.length > 1 ? 'are' : 'is'} open.`;
      open[0].focus();
      return;
    }
    this.answer({ ratings: Object.fromEntries(sliders.map((slider) => [slider.name, Number(slider.value)])) });
  }
}
