// SPDX-License-Identifier: BSD-3-Clause
// Meshes of the view from on board. Coordinates are those of the map, z up [m]; `three` is the library.
import { rgb } from './theme.js';

function shade(colour, factor) {
  return rgb(colour).map((value) => (value / 255) ** 2.2 * factor); // three works in linear light
}

/** Faces (walls.js) of one tile as a mesh of the given height. Lower edges are darker, as in a room. */
export function wallMesh(three, faces, grid, height, colour) {
  const positions = new Float32Array(faces.length * 12);
  const colours = new Float32Array(faces.length * 12);
  const indices = new Uint32Array(faces.length * 6);
  const c = Math.cos(grid.origin.yaw) * grid.resolution;
  const s = Math.sin(grid.origin.yaw) * grid.resolution;
  faces.forEach(([x0, y0, x1, y1], i) => {
    const ends = [[x0, y0], [x1, y1]].map(([x, y]) => [grid.origin.x + c * x - s * y, grid.origin.y + s * x + c * y]);
    const light = y0 === y1 ? 1 : 0.78;
    [[0, 0], [1, 0], [1, 1], [0, 1]].forEach(([end, top], k) => {
      positions.set([ends[end][0], ends[end][1], top * height], i * 12 + k * 3);
      colours.set(shade(colour, light * (top ? 1 : 0.55)), i * 12 + k * 3);
    });
    // The occupied side is on the left of the way from the first end to the second, so the face looks to the right.
    indices.set([0, 1, 2, 0, 2, 3].map((k) => i * 4 + k), i * 6);
  });
  const geometry = new three.BufferGeometry();
  geometry.setAttribute('position', new three.BufferAttribute(positions, 3));
  geometry.setAttribute('color', new three.BufferAttribute(colours, 3));
  geometry.setIndex(new three.BufferAttribute(indices, 1));
  return new three.Mesh(geometry, new three.MeshBasicMaterial({ vertexColors: true }));
}

/** A floor with a line every metre, so that motion is seen. */
export function floorMesh(three, grid, theme) {
  const canvas = document.createElement('canvas');
  canvas.width = canvas.height = 128;
  const context = canvas.getContext('2d');
  context.fillStyle = theme.floor;
  context.fillRect(0, 0, 128, 128);
  context.fillStyle = theme['floor-line'];
  context.fillRect(0, 0, 128, 2);
  context.fillRect(0, 0, 2, 128);
  const texture = new three.CanvasTexture(canvas);
  texture.wrapS = texture.wrapT = three.RepeatWrapping;
  texture.colorSpace = three.SRGBColorSpace;
  texture.anisotropy = 4;
  const [width, height] = [grid.width * grid.resolution, grid.height * grid.resolution];
  texture.repeat.set(width, height);
  const mesh = new three.Mesh(new three.PlaneGeometry(width, height), new three.MeshBasicMaterial({ map: texture }));
  const c = Math.cos(grid.origin.yaw);
  const s = Math.sin(grid.origin.yaw);
  mesh.position.set(grid.origin.x + (c * width - s * height) / 2, grid.origin.y + (s * width + c * height) / 2, 0);
  mesh.rotation.z = grid.origin.yaw;
  return mesh;
}

/** A region to avoid: red floor with a low fence, which is seen from far too. */
export function regionMesh(three, polygon, theme) {
  const group = new three.Group();
  const colour = new three.Color(theme.region);
  const shape = new three.Shape(polygon.map(([x, y]) => new three.Vector2(x, y)));
  const material = { color: colour, transparent: true, depthWrite: false, side: three.DoubleSide };
  const floor = new three.Mesh(new three.ShapeGeometry(shape), new three.MeshBasicMaterial({ ...material, opacity: 0.42 }));
  floor.position.z = 0.01;
  const fence = new three.BufferGeometry();
  const positions = [];
  polygon.forEach(([x, y], i) => {
    const [nx, ny] = polygon[(i + 1) % polygon.length];
    positions.push(x, y, 0, nx, ny, 0, nx, ny, 0.3, x, y, 0, nx, ny, 0.3, x, y, 0.3);
  });
  fence.setAttribute('position', new three.Float32BufferAttribute(positions, 3));
  group.add(floor, new three.Mesh(fence, new three.MeshBasicMaterial({ ...material, opacity: 0.3 })));
  return group;
}

/** Somebody who moves: a figure of the disc's radius, its disc on the floor, and where it goes in the next second. */
export function moverMesh(three, theme) {
  const group = new three.Group();
  const skin = new three.MeshLambertMaterial({ color: theme.mover });
  const body = new three.Mesh(new three.CapsuleGeometry(0.2, 1.0, 4, 12), skin);
  body.rotation.x = Math.PI / 2;
  body.position.z = 0.75;
  const head = new three.Mesh(new three.SphereGeometry(0.14, 12, 8), skin);
  head.position.z = 1.6;
  const flat = new three.MeshBasicMaterial({ color: theme.mover, transparent: true, opacity: 0.35, depthWrite: false });
  const disc = new three.Mesh(new three.CircleGeometry(1, 24), flat);
  disc.position.z = 0.015;
  const way = new three.Mesh(new three.PlaneGeometry(1, 0.1).translate(0.5, 0, 0.018), flat);
  group.add(body, head, disc, way);
  group.userData.update = ({ x, y, vx, vy, radius }) => {
    const speed = Math.hypot(vx, vy);
    group.position.set(x, y, 0);
    disc.scale.set(radius, radius, 1);
    body.scale.set(Math.min(1.5, radius / 0.2), 1, Math.min(1.5, radius / 0.2));
    way.visible = speed > 0.05;
    way.scale.x = Math.max(speed, 0.01);
    way.rotation.z = Math.atan2(vy, vx);
  };
  return group;
}

/** A goal: a post with a ring on the floor; the one that is driven to is the brightest. */
export function goalMesh(three, theme) {
  const group = new three.Group();
  const material = new three.MeshBasicMaterial({ color: theme.goal, transparent: true, opacity: 0.85 });
  const post = new three.Mesh(new three.CylinderGeometry(0.04, 0.04, 1.8, 8), material);
  post.rotation.x = Math.PI / 2;
  post.position.z = 0.9;
  const top = new three.Mesh(new three.SphereGeometry(0.14, 12, 8), material);
  top.position.z = 1.85;
  const ring = new three.Mesh(new three.RingGeometry(0.25, 0.35, 24), material);
  ring.position.z = 0.02;
  group.add(post, top, ring);
  return group;
}

/** The robot's own base: its outline, 0.3 m high and half transparent, with a nose. */
export function baseMesh(three, outline, theme) {
  const shape = new three.Shape(outline.map(([x, y]) => new three.Vector2(x, y)));
  const solid = new three.ExtrudeGeometry(shape, { depth: 0.22, bevelEnabled: false });
  solid.translate(0, 0, 0.05);
  const material = new three.MeshBasicMaterial({ color: theme.robot, transparent: true, opacity: 0.6 });
  const group = new three.Group();
  const edges = new three.LineSegments(new three.EdgesGeometry(solid, 30), new three.LineBasicMaterial({ color: theme['robot-edge'] }));
  const front = Math.max(...outline.map(([x]) => x));
  const nose = new three.BufferGeometry();
  nose.setAttribute('position', new three.Float32BufferAttribute(
    [front * 0.85, 0, 0.28, front * 0.1, front * 0.45, 0.28, front * 0.1, -front * 0.45, 0.28], 3));
  group.add(new three.Mesh(solid, material), edges, new three.Mesh(nose, new three.MeshBasicMaterial({ color: theme['robot-edge'] })));
  return group;
}
