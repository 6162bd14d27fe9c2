// SPDX-License-Identifier: BSD-3-Clause
// A flat band along a line on the floor, rewritten in place when the line changes.

const MOST = 512; // points; longer lines are thinned

export class Ribbon {
  /** width [m], z above the floor [m]; coordinates of the map. */
  constructor(three, colour, width, z, opacity = 1) {
    this.width = width;
    this.z = z;
    this.positions = new Float32Array(MOST * 6);
    const geometry = new three.BufferGeometry();
    this.attribute = new three.BufferAttribute(this.positions, 3).setUsage(three.DynamicDrawUsage);
    geometry.setAttribute('position', this.attribute);
    const indices = [];
    for (let i = 0; i + 1 < MOST; ++i) indices.push(2 * i, 2 * i + 1, 2 * i + 2, 2 * i + 2, 2 * i + 1, 2 * i + 3);
    geometry.setIndex(indices);
    const material = new three.MeshBasicMaterial({ color: colour, side: three.DoubleSide, transparent: opacity < 1, opacity, depthWrite: opacity >= 1 });
    this.mesh = new three.Mesh(geometry, material);
    this.mesh.frustumCulled = false;
    this.mesh.visible = false;
  }

  /** points: [[x, y], ...] */
  set(points) {
    const step = Math.max(1, Math.ceil(points.length / (MOST - 1)));
    const kept = points.filter((_, i) => i % step === 0 || i === points.length - 1);
    this.mesh.visible = kept.length > 1;
    if (kept.length < 2) return;
    kept.forEach(([x, y], i) => {
      const [ax, ay] = kept[Math.max(0, i - 1)];
      const [bx, by] = kept[Math.min(kept.length - 1, i + 1)];
      const long = Math.hypot(bx - ax, by - ay) || 1;
      const nx = (-(by - ay) / long) * (this.width / 2);
      const ny = ((bx - ax) / long) * (this.width / 2);
      this.positions.set([x + nx, y + ny, this.z, x - nx, y - ny, this.z], i * 6);
    });
    this.attribute.needsUpdate = true;
    this.mesh.geometry.setDrawRange(0, (kept.length - 1) * 6);
  }
}
