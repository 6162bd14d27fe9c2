// SPDX-License-Identifier: BSD-3-Clause
// The head of the page: who is in control, why a wish is refused, what comes next, speed, link and goal; and one notice above
// all where something is wrong.
import { announce, describe, duration, refusal } from '../model/words.js';

const SLOW_LINK = 300; // [ms] shown as bad above this
const DEFLECTED = 0.5; // beyond every dead zone that makes sense
const FOLLOWS = 700; // [ms] within which the planner takes what is steered; some cycles and the way there and back

const byId = (id) => document.getElementById(id);

function write(id, text) {
  const element = byId(id);
  if (element.textContent !== text) element.textContent = text;
}

function writeOrHide(id, text) {
  write(id, text);
  byId(id).hidden = text === '';
}

/** What is wrong, the worst first: each {when(facts), text(facts), bad}. */
const NOTICES = [
  { when: (f) => !f.controlOpen && f.refused, text: (f) => f.refused, bad: true },
  { when: (f) => !f.controlOpen, text: () => 'The link is cut. Steering has ended; a stop stays. Connecting again …', bad: true },
  { when: (f) => f.unheard && f.unheard.what.includes('stop'), text: (f) => `Nobody hears this page: ${f.unheard.text}.`, bad: true },
  { when: (f) => f.lost, text: () => 'LOST: your steering did not reach the robot. It stops turning. Centre the stick once.', bad: true },
  { when: (f) => f.steering === 'late', text: (f) => `Too late: your commands were ${Math.round(f.age)} ms old and did not count.`, bad: true },
  { when: (f) => f.stop && f.stop.why === 'delay', text: () => 'The link is too slow: the robot was asked to stop.', bad: true },
  { when: (f) => f.headsetOnly, text: () => 'Mode Hand: steer in a headset, or choose mode Stick.' },
  { when: (f) => f.mine && f.neutralNeeded && f.held, text: () => 'Let go of the stick once, then steer.' },
  { when: (f) => f.steering === 'unheard' && f.held, text: () => 'You steer, and nobody hears it.', bad: true },
  { when: (f) => f.steering === 'watching' && f.held, text: () => 'You are watching. Take the controls to steer.' },
  { when: (f) => f.ignored, text: (f) => `You steer, but the robot takes none of it. ${f.said || 'The planner does not say why.'}`, bad: true },
  { when: (f) => f.told, text: (f) => f.told },
  { when: (f) => f.unheard, text: (f) => `Nobody hears: ${f.unheard.text}.`, bad: true },
];

export class Status {
  constructor(scene) {
    this.scene = scene;
    this.facts = { controlOpen: true, held: false };
    this.takenAt = 0; // [ms] when the planner last took what is steered, or nothing was
  }

  /** New facts: controlOpen, refused, lost, steering, age, stop, mine, neutralNeeded, held, size (of the deflection), told. */
  set(facts) {
    Object.assign(this.facts, facts);
    this.show();
  }

  /** Something to say for a few seconds. */
  say(text) {
    clearTimeout(this.timer);
    this.set({ told: text });
    this.timer = setTimeout(() => this.set({ told: '' }), 5000);
  }

  tick({ progress, unheard, said }) {
    if (progress !== undefined) this.progress = progress;
    if (unheard !== undefined) this.facts.unheard = unheard;
    if (said !== undefined) this.facts.said = said;
    this.watchSteering();
    this.show();
  }

  /** What this page steers, and the planner does not take. */
  watchSteering() {
    const { facts, scene } = this;
    const now = performance.now();
    // Where no cycle runs, steering begins one only without a goal, and only if the parameter says so.
    const idle = !scene.state && (scene.goals.length > 0 || !scene.limits.driveWithoutGoal);
    const taken = idle || (scene.state && scene.state.active) || facts.steering !== 'steers' || !facts.held || facts.size < DEFLECTED;
    if (taken) this.takenAt = now;
    facts.ignored = now - this.takenAt > FOLLOWS;
  }

  delay(milliseconds) {
    write('delay', milliseconds === null ? '–' : `${Math.round(milliseconds)} ms`);
    byId('delay').parentElement.classList.toggle('bad', milliseconds > SLOW_LINK);
  }

  show() {
    const { state, robot } = this.scene;
    const { key, title, line } = describe(this.scene);
    if (document.body.dataset.state !== key) document.body.dataset.state = key;
    this.facts.lost = key === 'LOST';
    write('state-title', title);
    write('state-line', line);
    writeOrHide('refusal', refusal(state));
    write('next', announce(state));
    write('speed', robot ? `${Math.abs(robot.v).toFixed(2)} m/s` : '–');
    const { progress } = this;
    write('left', progress ? `${progress.to_go.toFixed(1)} m${Number.isFinite(progress.time_left) && progress.time_left !== null ? `, ${duration(progress.time_left)}` : ''}` : '–');
    write('agreement', state && state.active ? `The robot does ${Math.round(state.agreement * 100)} % of what you ask for.` : '');
    write('said', this.facts.said ? `The planner: ${this.facts.said}` : '');
    this.showNotice();
  }

  showNotice() {
    const notice = NOTICES.find(({ when }) => when(this.facts));
    writeOrHide('notice', notice ? notice.text(this.facts) : '');
    byId('notice').classList.toggle('bad', Boolean(notice && notice.bad));
  }
}
