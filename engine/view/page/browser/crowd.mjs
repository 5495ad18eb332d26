// A page of many bodies of one or two meshes that move in each frame, packed as graze::View packs it: what a heavy run
// asks of a browser, without a run.

import {readFileSync} from 'node:fs';
import {gzipSync} from 'node:zlib';

/** Vertices and triangles of a Wavefront file that has nothing but these. */
function meshOf(file) {
  const positions = [], indices = [];
  for (const line of readFileSync(file, 'utf8').split('\n')) {
    const [kind, ...rest] = line.trim().split(/\s+/);
    if (kind === 'v') positions.push(...rest.slice(0, 3).map(Number));
    if (kind === 'f') indices.push(...rest.slice(0, 3).map((corner) => parseInt(corner, 10) - 1));
  }
  return {positions, indices};
}

/** Arrays as words that each stand as the difference from the one `stride` before it. */
class Packer {
  constructor() {
    this.places = [];
    this.parts = [];
    this.length = 0;
  }

  words(list, stride = 1) {
    const count = list.length, bytes = new Uint8Array(4 * count);
    for (let i = 0; i < count; ++i) {
      const step = list[i] - (i < stride ? 0 : list[i - stride]) | 0, turned = step << 1 ^ step >> 31;
      for (let k = 0; k < 4; ++k) bytes[k * count + i] = turned >>> 8 * k;
    }
    this.places.push({offset: this.length, words: count, stride});
    this.parts.push(bytes);
    this.length += bytes.length;
    return this.places.length - 1;
  }

  floats(list, stride) {
    return this.words(new Uint32Array(Float32Array.from(list).buffer), stride);
  }
}

/** A turn about an axis, and a place. */
function pose([x, y, z], angle, at) {
  const size = Math.hypot(x, y, z), s = Math.sin(angle / 2) / size;
  return [s * x, s * y, s * z, Math.cos(angle / 2), ...at];
}

/**
 * @param {string} html the page without its data @param {string} file of the mesh
 * @param {{bodies: number, frames: number, meshes?: number}} settings in how many bodies and frames; each of `meshes`
 *   copies of the mesh has an equal part of the bodies
 */
export function crowd(html, file, {bodies, frames, meshes = 1}) {
  const {positions, indices} = meshOf(file), arrays = new Packer();
  const size = Math.max(...[0, 1, 2].map((k) => {
    const own = positions.filter((_, i) => i % 3 === k);
    return own.reduce((a, b) => Math.max(a, b), -Infinity) - own.reduce((a, b) => Math.min(a, b), Infinity);
  }));
  const all = arrays.words(Array.from({length: frames}, (_, f) => f));
  const side = Math.ceil(Math.cbrt(bodies)), spacing = 0.75 * size;
  const none = () => ({starts: arrays.words(new Uint32Array(frames + 1)), list: arrays.words([])});
  const page = {
    title: `${bodies} bodies of ${indices.length / 3} triangles`, unit: 'm', made_by: '', notes: [],
    meshes: Array.from({length: meshes}, () =>
      ({positions: arrays.floats(positions, 3), indices: arrays.words(indices, 3), origin: [0, 0, 0], scale: 1})),
    bodies: Array.from({length: bodies}, (_, b) => {
      const home = [b % side, Math.floor(b / side) % side, Math.floor(b / side / side)].map((x) => x * spacing);
      const poses = Array.from({length: frames}, (_, f) => pose([b % 3 - 1, b % 5 - 2, 1], 0.05 * f + b,
                                                                [home[0], home[1], home[2] + 0.2 * size * Math.sin(0.1 * f + b)]));
      return {name: `body ${b}`, mesh: b % meshes, frames: all, poses: arrays.floats(poses.flat(), 7)};
    }),
    places: [{center: [0, 0, 0], scale: 1}],
    frames: Array.from({length: frames}, (_, f) => ({label: '', state: f % 50 < 10 ? 'touching' : 'clear', facts: [], place: 0})),
    marks: {triangles: [], curves: none(), lines: none(), contacts: none(), gaps: none(), points: none(), planes: none(),
            pairs: none(), boxes: [], labels: []},
    arrays: arrays.places,
  };
  const json = Buffer.from(JSON.stringify(page)), head = Buffer.alloc(16);
  head.write('GRAZEVW1', 'latin1');
  head.writeUInt32LE(json.length, 8);
  head.writeUInt32LE(arrays.length, 12);
  const data = gzipSync(Buffer.concat([head, json, ...arrays.parts])).toString('base64');
  return html.replace('{{title}}', page.title).replace('{{data}}', data);
}
