// SPDX-License-Identifier: BSD-3-Clause
// Recording a drive, and the report of the last one.
import { duration } from '../model/words.js';

const byId = (id) => document.getElementById(id);

const REPORTS = { none: '', making: 'The report is being made …', ready: '', failed: 'The report could not be made.' };

export class RecordingPanel {
  constructor(send) {
    this.on = false;
    byId('record').addEventListener('click', () => send('record', { on: !this.on }));
    byId('report').addEventListener('click', () => this.open());
    byId('report-picture').addEventListener('error', ({ target }) => { target.hidden = true; }); // the figures say why
  }

  tick({ record }) {
    if (!record) return;
    this.on = record.on;
    byId('record').setAttribute('aria-pressed', String(record.on));
    byId('record').textContent = record.on ? `Recording, ${duration(record.seconds)}: end it` : 'Record the drive';
    byId('record-text').textContent = [record.file, record.text, REPORTS[record.report]].filter(Boolean).join('\n');
    byId('report').hidden = record.report !== 'ready';
  }

  async open() {
    byId('report-picture').hidden = false;
    byId('report-picture').src = `/report/report.png?${Date.now()}`; // not the one of the drive before
    const answer = await fetch('/report/report.json', { cache: 'no-store' });
    const figures = answer.ok ? await answer.json() : {};
    const rows = Object.entries(figures).filter(([, value]) => ['string', 'number', 'boolean'].includes(typeof value)).map(([name, value]) => {
      const row = document.createElement('tr');
      for (const text of [name.replaceAll('_', ' '), Number.isFinite(value) ? Number(value.toFixed(3)) : value]) row.insertCell().textContent = String(text);
      return row;
    });
    byId('report-figures').replaceChildren(...rows);
    byId('report-dialog').showModal();
  }
}
