// SPDX-License-Identifier: BSD-3-Clause
// The view from on board, in three dimensions: the walls of the map, what else the costmap holds, people, regions to avoid,
// goals, the plan on the floor and the motions. It runs in the page and in a headset.
import { arc, between } from '../model/geometry.js';
import { Watch } from '../model/scene.js';
import { Ribbon } from './ribbon.js';
import { baseMesh, floorMesh, goalMesh, moverMesh, regionMesh, wallMesh } from './solids.js';
import { onTheme } from './theme.js';
import { roomBehind, unexplained, wallFaces } from './walls.js';

const ARC_TIME = 2; // [s] as in the view from above
const EYES = { height: 1.6, behind: 1.15, tilt: -0.36, near: -0.2 }; // [m, m, rad, rad] of a screen's camera; near: tilts more in front of a wall
const WALL_MARGIN = 0.25; // [m] between that camera and a wall behind it
const WALL_HEIGHT = 2.4; // [m]
const OBSTACLE_HEIGHT = 0.9; // [m] of what the costmap alone knows
const GOAL_NEAR = 0.9; // [m] a nearer goal's post would stand in the eye
const FAR = 45; // [m]
const EASE = 0.06; // [s] in which the view follows the newest pose
const COAST = 0.15; // [s] for which the last velocity carries the pose on
const SLOW_FRAME = 32; // [ms] frames slower than this are drawn with fewer pixels

// Where the processor draws, each frame keeps the stick's events waiting: so few pixels, so long between two frames.
const SOFT_PIXELS = 45000;
const SOFT_RATIO = 0.3; // at least
const SOFT_PAUSE = 40; // [ms]

/** Whether the browser draws WebGL on the processor: then smooth edges cost too much. */
function drawsInSoftware() {
  const context = document.createElement('canvas').getContext('webgl2');
  const names = context && context.getExtension('WEBGL_debug_renderer_info');
  const name = names ? context.getParameter(names.UNMASKED_RENDERER_WEBGL) : '';
  if (context) context.getExtension('WEBGL_lose_context').loseContext();
  return /swiftshader|llvmpipe|software/i.test(name);
}

export class BoardView {
  /** three: the library; canvas: to draw on; scene: model/scene.js. Throws where the browser has no WebGL. */
  constructor(three, canvas, scene) {
    this.three = three;
    this.canvas = canvas;
    this.scene = scene;
    this.unwind = false;
    this.soft = drawsInSoftware();
    this.renderer = new three.WebGLRenderer({ canvas, antialias: !this.soft });
    this.renderer.xr.setFramebufferScaleFactor(this.soft ? 0.5 : 1);
    this.ratio = Math.min(1.5, window.devicePixelRatio || 1);
    this.frameTime = 0;
    this.frames = 0; // drawn since the start
    this.stage = new three.Scene();
    this.world = new three.Group(); // inside: coordinates of the map, z up
    this.world.rotation.x = -Math.PI / 2;
    this.stage.add(this.world, new three.HemisphereLight(0xffffff, 0x888888, 2.6));
    this.makeSeat();
    this.shown = null; // the pose that is drawn
    this.posed = { version: -1, at: 0 };
    onTheme((theme) => this.useTheme(theme));
    new ResizeObserver(() => this.resize()).observe(canvas.parentElement);
    this.resize();
  }

  /** The camera stands on the robot. The seat turns a camera's axes (y up, -z ahead) into the robot's (z up, x ahead). */
  makeSeat() {
    const { three } = this;
    this.rig = new three.Group();
    this.seat = new three.Group();
    const axes = new three.Matrix4().makeBasis(new three.Vector3(0, -1, 0), new three.Vector3(0, 0, 1), new three.Vector3(-1, 0, 0));
    this.seat.quaternion.setFromRotationMatrix(axes);
    this.eyes = new three.PerspectiveCamera(68, 1, 0.05, FAR * 1.5);
    this.behind = EYES.behind;
    this.seat.add(this.eyes);
    this.rig.add(this.seat);
    this.body = new three.Group();
    this.world.add(this.rig, this.body);
  }

  useTheme(theme) {
    const { three } = this;
    this.theme = theme;
    this.stage.background = new three.Color(theme.sky);
    this.stage.fog = new three.Fog(theme.sky, 10, FAR);
    for (const ribbon of Object.values(this.ribbons || {})) this.drop(ribbon.mesh);
    this.ribbons = {
      plan: new Ribbon(three, theme.plan, 0.1, 0.022),
      predicted: new Ribbon(three, theme.predicted, 0.5, 0.014, 0.25),
      command: new Ribbon(three, theme.command, 0.1, 0.03),
      wanted: new Ribbon(three, theme.wanted, 0.05, 0.036),
    };
    for (const ribbon of Object.values(this.ribbons)) this.world.add(ribbon.mesh);
    this.watch = new Watch(this.scene); // all else is made anew
    this.dirty = true;
  }

  /** After a headset's session the camera stands where it does on a screen. */
  leaveHeadset() {
    this.eyes.rotation.set(0, 0, 0);
    this.eyes.scale.set(1, 1, 1);
    this.resize();
  }

  drop(object) {
    if (!object) return;
    object.removeFromParent();
    object.traverse((one) => {
      if (one.geometry) one.geometry.dispose();
      if (one.material) one.material.dispose();
    });
  }

  /** Puts a group in the place of the one that had this name. */
  swap(name, group) {
    this.drop(this[name]);
    this[name] = group;
    if (group) this.world.add(group);
  }

  resize() {
    const box = this.canvas.parentElement.getBoundingClientRect();
    if (this.renderer.xr.isPresenting || box.width < 1 || box.height < 1) return;
    const most = this.soft ? Math.max(SOFT_RATIO, Math.sqrt(SOFT_PIXELS / (box.width * box.height))) : this.ratio;
    this.renderer.setPixelRatio(Math.min(this.ratio, most));
    this.renderer.setSize(box.width, box.height, false);
    this.eyes.aspect = box.width / box.height;
    this.eyes.updateProjectionMatrix();
    this.dirty = true;
  }

  /** Brings the world up to date with the scene; says whether something changed. */
  update() {
    const { scene, watch } = this;
    const parts = {
      map: () => this.updateMap(),
      costmap: () => this.updateObstacles(),
      regions: () => this.swap('regionGroup', this.group(scene.regions.map((one) => regionMesh(this.three, one.polygon, this.theme)))),
      goals: () => this.swap('goalGroup', this.group(scene.goals.map((goal) => {
        const mesh = goalMesh(this.three, this.theme);
        mesh.position.set(goal.x, goal.y, 0);
        return mesh;
      }))),
      outline: () => this.updateOutline(),
      movers: () => this.updateMovers(),
      plan: () => this.ribbons.plan.set(scene.plan),
      predicted: () => this.ribbons.predicted.set(scene.predicted.map(({ x, y }) => [x, y])),
      state: () => {},
    };
    let any = false;
    for (const [part, bring] of Object.entries(parts)) {
      if (!watch.changed(part)) continue;
      bring();
      any = true;
    }
    return any;
  }

  group(meshes) {
    const group = new this.three.Group();
    if (meshes.length) group.add(...meshes);
    return group;
  }

  updateMap() {
    const { map } = this.scene;
    this.swap('floor', map ? floorMesh(this.three, map, this.theme) : null);
    this.swap('walls', map ? this.upright(map, (i) => map.cells[i] >= 65, (i) => map.cells[i] >= 0, WALL_HEIGHT, this.theme.solid) : null);
  }

  updateObstacles() {
    const { costmap, map } = this.scene;
    if (!costmap) return this.swap('obstacles', null);
    const solid = unexplained(costmap, map);
    this.swap('obstacles', this.upright(costmap, (i) => solid[i] === 1, () => true, OBSTACLE_HEIGHT, this.theme.costmap));
  }

  upright(grid, solid, open, height, colour) {
    const faces = wallFaces(grid.width, grid.height, solid, open);
    return this.group([...faces.values()].map((tile) => wallMesh(this.three, tile, grid, height, colour)));
  }

  updateOutline() {
    this.drop(this.base);
    const { outline } = this.scene;
    this.base = outline.length > 2 ? baseMesh(this.three, outline, this.theme) : null;
    if (!this.base) return;
    this.body.add(this.base);
    const sides = outline.map(([, y]) => y);
    this.ribbons.predicted.width = Math.max(...sides) - Math.min(...sides);
  }

  updateMovers() {
    const { movers } = this.scene;
    if (this.moverTheme !== this.theme) this.swap('crowd', this.group([]));
    this.moverTheme = this.theme;
    while (this.crowd.children.length > movers.length) this.drop(this.crowd.children[this.crowd.children.length - 1]);
    while (this.crowd.children.length < movers.length) this.crowd.add(moverMesh(this.three, this.theme));
    movers.forEach((mover, i) => this.crowd.children[i].userData.update(mover));
  }

  /** Moves the drawn pose towards the newest one, which the robot's velocity carries on; says whether it moved. */
  follow(now, passed) {
    const { robot, version } = this.scene;
    if (!robot) return false;
    if (version.robot !== this.posed.version) this.posed = { version: version.robot, at: now };
    const coast = Math.min(COAST, (now - this.posed.at) / 1000);
    const [x, y] = arc(robot, robot.v, robot.omega, coast, 1)[1];
    const target = { x, y, yaw: robot.yaw + robot.omega * coast };
    const far = !this.shown || Math.hypot(target.x - this.shown.x, target.y - this.shown.y) > 1;
    const before = this.shown;
    this.shown = far ? target : between(this.shown, target, 1 - Math.exp(-passed / 1000 / EASE));
    return far || Math.hypot(this.shown.x - before.x, this.shown.y - before.y) > 2e-4 || Math.abs(this.shown.yaw - before.yaw) > 2e-4;
  }

  placeRobot() {
    const { shown, scene, ribbons } = this;
    if (!shown) return;
    const inHeadset = this.renderer.xr.isPresenting;
    this.rig.position.set(shown.x, shown.y, 0);
    // Unwound, the view turns only when the head does (Suomalainen et al. 2022, doi 10.5555/3523760.3523828).
    if (!(inHeadset && this.unwind)) this.rig.rotation.z = shown.yaw;
    if (!inHeadset) this.placeEyes();
    this.body.position.set(shown.x, shown.y, 0);
    this.body.rotation.z = shown.yaw;
    for (const goal of this.goalGroup ? this.goalGroup.children : []) goal.visible = Math.hypot(goal.position.x - shown.x, goal.position.y - shown.y) > GOAL_NEAR;
    const { state } = scene;
    ribbons.command.set(state ? arc(shown, state.command.v, state.command.omega, ARC_TIME) : []);
    ribbons.wanted.set(state && state.active ? arc(shown, state.wanted.v, state.wanted.omega, ARC_TIME) : []);
  }

  /** On a screen one looks over the robot's shoulder, as far behind it as the walls allow. */
  placeEyes() {
    const room = roomBehind(this.scene.map, this.shown, EYES.behind, WALL_MARGIN);
    this.behind += (room - this.behind) * (room < this.behind ? 0.5 : 0.08);
    this.eyes.position.set(0, EYES.height, this.behind);
    this.eyes.rotation.x = EYES.tilt + EYES.near * (1 - this.behind / EYES.behind);
  }

  /** One frame at the time now [ms]; says whether it drew. In a headset it always draws. */
  frame(now) {
    if (this.soft && now - this.last < SOFT_PAUSE && !this.renderer.xr.isPresenting) return false;
    const passed = Math.min(200, now - (this.last || now));
    this.last = now;
    const moved = this.follow(now, passed);
    const changed = this.update();
    if (!moved && !changed && !this.dirty && !this.renderer.xr.isPresenting) return false;
    this.dirty = false;
    this.frames += 1;
    this.placeRobot();
    const began = performance.now();
    this.renderer.render(this.stage, this.eyes);
    this.adapt(passed, performance.now() - began);
    return true;
  }

  /** Draws with fewer pixels where the machine is slow. */
  adapt(passed, drawing) {
    if (this.soft) return;
    this.frameTime += (Math.min(100, Math.max(passed, drawing)) - this.frameTime) * 0.05;
    if (this.frameTime < SLOW_FRAME || this.ratio <= 0.6 || this.renderer.xr.isPresenting) return;
    this.ratio = Math.max(0.6, this.ratio * 0.8);
    this.frameTime = SLOW_FRAME / 2;
    this.resize();
  }
}
