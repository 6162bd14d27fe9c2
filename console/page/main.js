// SPDX-License-Identifier: BSD-3-Clause
// Puts the page together: scene, links, views, inputs, panels. docs/understand/console_protocol.md says what the server sends.
import { watchCuts } from './input/cuts.js';
import { Gamepads } from './input/gamepad.js';
import { HandSteering } from './input/hand_steering.js';
import { Headset } from './input/headset.js';
import { Keyboard } from './input/keyboard.js';
import { Steering } from './input/steering.js';
import { ScreenStick } from './input/stick.js';
import { Stop } from './input/stop.js';
import { CameraLink } from './link/camera_link.js';
import { ControlLink } from './link/control_link.js';
import { ViewLink } from './link/view_link.js';
import { emptyScene } from './model/scene.js';
import { announce, describe, inControl, MODES, refusal } from './model/words.js';
import { ControlPanel } from './panels/control.js';
import { GoalPanel } from './panels/goals.js';
import { setUpLayout } from './panels/layout.js';
import { admitted, admittedStill } from './panels/login.js';
import { RecordingPanel } from './panels/recording.js';
import { Status } from './panels/status.js';
import { StudyPanel } from './panels/study.js';
import { TuningPanel } from './panels/tuning.js';
import { AboveView } from './views/above.js';
import { BoardView } from './views/board.js';
import { HeadPanel } from './views/head_panel.js';
import { PictureView } from './views/onboard_picture.js';
import { VelocityView } from './views/velocity.js';

const THREE_URL = '/lib/three/build/three.module.js';

const byId = (id) => document.getElementById(id);

class App {
  constructor() {
    this.scene = emptyScene();
    this.frames = 0; // drawn since the start
    this.mode = null;
    this.rumble = 0; // [share of full]
    setUpLayout();
    this.status = new Status(this.scene);
    this.send = (type, fields, t) => this.control.command(type, fields, t);
    this.makeInputs();
    this.makeViews();
    this.makePanels();
    this.link();
    requestAnimationFrame((now) => this.draw(now));
  }

  makeInputs() {
    this.steering = new Steering(this.send);
    this.stop = new Stop(this.send);
    this.stick = new ScreenStick(byId('stick'), this.steering);
    this.keyboard = new Keyboard(this.steering, this.stop);
    this.gamepads = new Gamepads(this.steering, this.stop, () => this.toggleControl());
    this.hands = new HandSteering(this.send, this.steering, this.stop, () => this.toggleControl());
    this.steering.onChange(({ left, forward, held }) => this.status.set({ held, size: Math.hypot(left, forward) }));
    watchCuts((why) => this.cut(why), () => this.steering.wake());
    byId('stop').addEventListener('click', (event) => this.stop.press(event.timeStamp));
    byId('letgo').addEventListener('click', (event) => this.stop.letGo(event.timeStamp));
    byId('take').addEventListener('click', () => this.toggleControl());
    for (const [mode, [name, title]] of Object.entries(MODES)) {
      const button = Object.assign(document.createElement('button'), { type: 'button', textContent: name, title });
      button.dataset.mode = mode;
      button.addEventListener('click', () => this.send('mode', { mode }));
      byId('modes').append(button);
    }
  }

  /** Steering is released once, whatever steers; what stops the robot goes on. */
  cut(why) {
    if (!this.hands.cut(why)) this.steering.cut(why);
    else this.steering.quiet = true;
    this.keyboard.clear();
    this.stop.keep();
  }

  toggleControl() {
    this.send('take_control', { on: !inControl(this.scene.state) });
  }

  makeViews() {
    this.above = new AboveView(byId('above-canvas'), this.scene, (goal) => this.goals.placed(goal));
    this.velocity = new VelocityView(byId('velocity'), this.scene);
    this.picture = new PictureView(byId('picture-canvas'), this.scene);
    this.board = null;
    this.loaded = this.makeBoard();
    byId('picture-toggle').addEventListener('click', () => this.usePicture(byId('picture-canvas').hidden));
    const { camera } = this.above;
    const zoom = (factor) => {
      camera.zoom(factor, camera.width / 2, camera.height / 2);
      this.above.dirty = true;
    };
    byId('zoom-in').addEventListener('click', () => zoom(1.4));
    byId('zoom-out').addEventListener('click', () => zoom(1 / 1.4));
    byId('follow').addEventListener('click', () => {
      camera.following = !camera.following;
      this.above.dirty = true;
    });
    byId('candidates').addEventListener('click', (event) => {
      this.view.want(!this.view.wanted);
      event.currentTarget.setAttribute('aria-pressed', String(this.view.wanted));
    });
  }

  /** The view in three dimensions, where the library and WebGL are there; the page works without. */
  async makeBoard() {
    try {
      const three = await import(THREE_URL);
      this.board = new BoardView(three, byId('board-canvas'), this.scene);
      const panel = new HeadPanel(three, this.board, () => this.headText());
      this.headset = new Headset(this.board, this.hands, (why) => this.cut(why), panel);
      this.offerHeadset(); // a browser may take long to look for one; the page does not wait
    } catch (error) {
      console.warn('no view from on board:', error.message);
      byId('plain').hidden = false;
      document.querySelector('main').dataset.large = 'above';
    }
  }

  async offerHeadset() {
    if (!(await Headset.available())) return;
    byId('enter').hidden = false;
    byId('unwind-label').hidden = false;
    byId('enter').addEventListener('click', () => this.headset.enter().catch((error) => this.status.say(`The headset cannot be used: ${error.message}`)));
    byId('unwind').addEventListener('change', (event) => (this.board.unwind = event.target.checked));
  }

  headText() {
    const { state, robot } = this.scene;
    const { title, line } = describe(this.scene);
    const speed = robot ? `${Math.abs(robot.v).toFixed(1)} m/s` : '';
    const notice = byId('notice').hidden ? '' : byId('notice').textContent;
    return {
      title: `${title}   ${speed}`,
      line: notice || refusal(state) || announce(state) || line,
      colour: getComputedStyle(document.body).getPropertyValue('--state').trim(),
    };
  }

  makePanels() {
    const say = (text) => this.status.say(text);
    this.holder = new ControlPanel(this.send, say);
    this.goals = new GoalPanel(this.above.pointer, this.send, say);
    this.panels = [this.goals, new TuningPanel(byId('panel-tuning'), this.send, say), new RecordingPanel(this.send), new StudyPanel(this.send), this.status];
  }

  link() {
    this.control = new ControlLink('', {
      connection: (open) => this.connected(open),
      welcome: () => {},
      control: (message) => this.holds(message),
      claim: (message) => this.holder.claimed(message),
      steering: ({ state, age }) => this.status.set({ steering: state, age }),
      stop: (message) => this.stops(message),
      told: ({ text }) => text && this.status.say(text),
      delay: ({ delay }) => this.measured(delay),
      silent: (milliseconds) => this.status.delay(milliseconds),
      namesake: () => this.status.say('Another tab had the name of this one. They are two visitors now: ask for the controls.'),
      unsent: (type) => this.status.say(`This was not sent (${type}): a device gives what is no number.`),
    });
    this.view = new ViewLink(this.scene, {
      told: (tick) => this.tick(tick),
      connection: () => {},
    });
  }

  connected(open) {
    if (!open) {
      this.steering.cut('device'); // nothing can be sent; what is held must be centred first
      this.holder.gone();
      this.status.delay(null);
      admittedStill().then((refused) => this.status.set({ refused }));
    } else {
      this.steering.wake();
    }
    this.status.set(open ? { controlOpen: true, refused: '' } : { controlOpen: false });
  }

  holds(message) {
    this.holder.show(message);
    this.status.set({ mine: message.held, neutralNeeded: message.neutral_needed });
    // Who is alone here need not ask. Who had the controls and gave them back does not take them by itself.
    if (message.holder === null && message.visitors.length === 1 && !this.hadControls) this.send('claim');
    this.hadControls = this.hadControls || message.held;
    if (message.held && message.neutral_needed) this.centre();
  }

  /** The link's delay [ms], with every ping. What was centred before the clocks were compared did not count: centre again. */
  measured(delay) {
    this.status.delay(delay);
    if (this.status.facts.mine && this.status.facts.neutralNeeded) this.centre();
  }

  /** A connection that is new, or was cut, asks for neutral once. */
  centre() {
    this.steering.centre();
    if (this.mode === 'gesture' && this.hands.hand === null) this.send('hand', { left: 0, forward: 0, up: 0, grip: false });
  }

  stops(message) {
    this.stop.told(message.on);
    byId('stop').setAttribute('aria-pressed', String(message.on));
    byId('letgo').hidden = !message.on;
    this.status.set({ stop: message.on ? message : null });
  }

  tick(tick) {
    this.status.facts.headsetOnly = this.mode === 'gesture' && !(this.headset && this.headset.session);
    for (const panel of this.panels) panel.tick(tick);
    if (tick.mode !== undefined) this.showMode(tick.mode);
    if (tick.camera) this.showCamera(tick.camera);
    if (tick.rumble !== undefined) this.rumble = tick.rumble;
    if (this.rumble > 0) {
      // Again with each tick: it comes when it changes, and a motor stops by itself.
      this.gamepads.rumble(this.rumble);
      if (this.headset) this.headset.rumble(this.rumble);
    }
    const manual = inControl(this.scene.state);
    this.steering.manual = manual && this.holder.mine;
    byId('take').textContent = manual ? 'Give control back' : 'Take control';
  }

  showMode(mode) {
    this.mode = mode;
    for (const button of byId('modes').children) button.setAttribute('aria-pressed', String(button.dataset.mode === mode));
    byId('take').hidden = mode !== 'switching';
  }

  showCamera({ on, fault }) {
    this.cameraFault(fault);
    if (on === this.cameraOn) return;
    this.cameraOn = on;
    if (on && !this.camera) this.camera = new CameraLink(this.scene, (text) => this.cameraFault(text));
    byId('picture-toggle').hidden = !on;
    this.usePicture(on);
  }

  cameraFault(text) {
    byId('camera-fault').hidden = !text;
    byId('camera-fault').textContent = text ? `The camera's picture cannot be shown. ${text}` : '';
  }

  usePicture(on) {
    byId('picture-canvas').hidden = !on;
    byId('picture-toggle').setAttribute('aria-pressed', String(on));
  }

  draw(now) {
    requestAnimationFrame((next) => this.draw(next));
    this.frames += 1;
    if (this.headset && this.headset.session) return; // nobody looks at the page; the headset draws its own frames
    const follow = byId('follow');
    const following = String(this.above.camera.following);
    if (follow.getAttribute('aria-pressed') !== following) follow.setAttribute('aria-pressed', following);
    this.above.draw();
    this.velocity.draw();
    if (!byId('picture-canvas').hidden) this.picture.draw();
    else if (this.board) this.board.frame(now);
  }
}

await admitted().catch((error) => console.error(error.message)); // the page says it once it tries to connect
export const app = new App();
