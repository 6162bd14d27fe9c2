// SPDX-License-Identifier: BSD-3-Clause
// A board in the headset's view, low ahead of the robot: who is in control, why a wish is refused, and the speed.

const SIZE = [1024, 256]; // [pixels]

export class HeadPanel {
  /** text(): {title, line, colour} of now. */
  constructor(three, board, text) {
    this.text = text;
    this.canvas = document.createElement('canvas');
    [this.canvas.width, this.canvas.height] = SIZE;
    this.texture = new three.CanvasTexture(this.canvas);
    this.texture.colorSpace = three.SRGBColorSpace;
    const material = new three.MeshBasicMaterial({ map: this.texture, fog: false, depthTest: false, transparent: true });
    this.mesh = new three.Mesh(new three.PlaneGeometry(1.2, 0.3), material);
    this.mesh.position.set(0, 0.75, -1.5); // [m] in the seat: x right, y up, z back
    this.mesh.rotation.x = -0.5;
    this.mesh.renderOrder = 1; // before everything, whatever stands in between
    this.mesh.visible = false;
    board.seat.add(this.mesh);
  }

  show(on) {
    this.mesh.visible = on;
  }

  update() {
    const { title, line, colour } = this.text();
    const key = `${title}|${line}|${colour}`;
    if (key === this.drawn) return;
    this.drawn = key;
    const context = this.canvas.getContext('2d');
    context.fillStyle = colour;
    context.fillRect(0, 0, ...SIZE);
    context.fillStyle = '#fff';
    context.font = '700 92px system-ui, sans-serif';
    context.fillText(title, 36, 110, SIZE[0] - 72);
    context.font = '500 56px system-ui, sans-serif';
    context.fillText(line, 36, 204, SIZE[0] - 72);
    this.texture.needsUpdate = true;
  }
}
