// SPDX-License-Identifier: BSD-3-Clause
// Pointers on the view from above: one finger or the mouse moves the map, two fingers and the wheel zoom, and while a goal
// is to be set, a press says where and a drag says which way to face there.

const HEADING_DRAG = 12; // [CSS pixels] a shorter drag is a click: it says no heading

export class MapPointer {
  /**
   * canvas: of the view; camera: a Camera2D; changed(): the view must be drawn again;
   * placed({x, y, yaw}): a goal was set, yaw null where the drag said none.
   */
  constructor(canvas, camera, changed, placed) {
    this.canvas = canvas;
    this.camera = camera;
    this.changed = changed;
    this.placed = placed;
    this.placing = false; // the next press sets a goal
    this.draft = null; // {x, y, yaw} while it is being set
    this.pointers = new Map();
    canvas.addEventListener('pointerdown', (event) => this.down(event));
    canvas.addEventListener('pointermove', (event) => this.move(event));
    for (const end of ['pointerup', 'pointercancel', 'lostpointercapture']) {
      canvas.addEventListener(end, (event) => this.up(event));
    }
    canvas.addEventListener('wheel', (event) => this.wheel(event), { passive: false });
  }

  arm(on) {
    this.placing = on;
    this.draft = null;
    this.canvas.classList.toggle('placing', on);
    this.changed();
  }

  at(event) {
    const box = this.canvas.getBoundingClientRect();
    return [event.clientX - box.left, event.clientY - box.top];
  }

  down(event) {
    const [px, py] = this.at(event);
    this.canvas.setPointerCapture(event.pointerId);
    this.pointers.set(event.pointerId, [px, py]);
    if (this.pointers.size > 1) {
      this.draft = null; // a second finger zooms
    } else if (this.placing) {
      const [x, y] = this.camera.toMap(px, py);
      this.draft = { x, y, yaw: null, px, py };
    }
    this.changed();
  }

  move(event) {
    const before = this.pointers.get(event.pointerId);
    if (!before) return;
    const [px, py] = this.at(event);
    if (this.pointers.size === 2) {
      this.pinch(event.pointerId, before, [px, py]);
    } else if (this.draft) {
      const drag = Math.hypot(px - this.draft.px, py - this.draft.py);
      this.draft.yaw = drag < HEADING_DRAG ? null : Math.atan2(this.draft.py - py, px - this.draft.px);
    } else if (!this.placing) {
      this.camera.pan(px - before[0], py - before[1]);
    }
    this.pointers.set(event.pointerId, [px, py]);
    this.changed();
  }

  pinch(id, before, now) {
    const other = [...this.pointers].find(([key]) => key !== id)[1];
    const was = Math.hypot(before[0] - other[0], before[1] - other[1]);
    const is = Math.hypot(now[0] - other[0], now[1] - other[1]);
    if (was > 1) this.camera.zoom(is / was, (now[0] + other[0]) / 2, (now[1] + other[1]) / 2);
  }

  up(event) {
    if (!this.pointers.delete(event.pointerId)) return;
    const draft = this.draft;
    this.draft = null;
    if (draft && event.type === 'pointerup') {
      this.arm(false);
      this.placed({ x: draft.x, y: draft.y, yaw: draft.yaw });
    }
    this.changed();
  }

  wheel(event) {
    event.preventDefault();
    const lines = event.deltaMode === 1 ? 16 : 1;
    const [px, py] = this.at(event);
    this.camera.zoom(Math.exp(-event.deltaY * lines * 0.0015), px, py);
    this.changed();
  }
}
