// @ts-check
// The data of a page, as graze::View packs it (../../README.md): Base64 of gzip of a head, JSON and arrays of words.
// Everything is checked before it is drawn: what is damaged is refused with a sentence for people.

/** Says what is wrong with the data of a page, in words for people. */
export class DataError extends Error {}

const kMagic = 'GRAZEVW1';
const kHeadBytes = 16;

/**
 * @typedef {object} ArrayPlace where an array of 32-bit words lies
 * @property {number} offset bytes from the beginning of the arrays
 * @property {number} words how many words it has
 * @property {number} stride words back to the one that a word is told as the difference from
 *
 * @typedef {object} MeshData
 * @property {number} positions its array: floats, three a vertex, to be scaled and then moved by the origin
 * @property {number} indices its array: three a triangle
 * @property {number[]} origin
 * @property {number} scale
 * @property {number} [exact] its array: of each coordinate as it was given, a double, the low word and the high one
 * @property {boolean} [boundless] stands for something without an end: not looked at when a view is framed
 *
 * @typedef {object} BodyData
 * @property {string} name
 * @property {number} mesh
 * @property {string} [color]
 * @property {number} frames its array: the frames in which the body stands, ascending
 * @property {number} poses its array: floats, for each of these frames a quaternion (x, y, z, w) and a translation
 *
 * @typedef {object} FactData
 * @property {string} name
 * @property {number} value
 * @property {boolean} [length] the value is in the page's unit
 *
 * @typedef {object} FrameData
 * @property {string} label
 * @property {'touching'|'clear'|'unknown'|''} state
 * @property {string} [says]
 * @property {FactData[]} facts
 * @property {string} [note]
 * @property {boolean} [change] something begins or ends, though the state stays
 * @property {number} place
 *
 * @typedef {{center: number[], scale: number}} PlaceData numbers of a frame times `scale`, plus `center`, are the world's
 * @typedef {{starts: number, list: number, rows?: number}} MarkData arrays: those of frame f are starts[f] to
 *   starts[f + 1], of the list itself, or of `rows`, which say where each stands in the list, which then has
 *   all first numbers first, then the second ones: what stays from frame to frame stands there once
 * @typedef {{body: number, frames: number, starts: number, list: number}} TriangleMarkData of those frames alone in
 *   which there are some: those of the i-th are starts[i] to starts[i + 1]
 * @typedef {{frame: number, at: number[], text: string}} LabelData
 * @typedef {{body: number, level: number, list: number}} BoxData of a body, in the numbers of its mesh: of each box the
 *   middle and three half axes
 *
 * @typedef {object} PageData
 * @property {string} title
 * @property {string} unit
 * @property {string} made_by
 * @property {string[]} notes
 * @property {MeshData[]} meshes
 * @property {BodyData[]} bodies
 * @property {PlaceData[]} places
 * @property {FrameData[]} frames
 * @property {{triangles: TriangleMarkData[], curves: MarkData, lines: MarkData, contacts: MarkData, gaps: MarkData,
 *   points: MarkData, planes: MarkData, pairs: MarkData, boxes: BoxData[], labels: LabelData[]}} marks
 * @property {ArrayPlace[]} arrays
 */

/** @param {string} text @returns {Uint8Array<ArrayBuffer>} */
export function bytesOfBase64(text) {
  let binary;
  try {
    binary = atob(text.trim());
  } catch {
    throw new DataError('the data of this page is not Base64: the file is cut off or was changed');
  }
  const bytes = new Uint8Array(binary.length);
  for (let i = 0; i < binary.length; ++i) bytes[i] = binary.charCodeAt(i);
  return bytes;
}

/** @param {Uint8Array<ArrayBuffer>} packed @returns {Promise<Uint8Array<ArrayBuffer>>} */
export async function gunzip(packed) {
  if (typeof DecompressionStream === 'undefined')
    throw new DataError('this browser cannot decompress: a newer one is needed, of 2023 or later');
  try {
    const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream('gzip'));
    return new Uint8Array(await new Response(stream).arrayBuffer());
  } catch {
    throw new DataError('the data of this page cannot be decompressed: the file is cut off or was changed');
  }
}

/**
 * Words from their bytes, which stand lowest bytes of all words first, each word as its zigzag difference from the one
 * `stride` before it.
 * @param {Uint8Array} bytes @param {ArrayPlace} place @returns {Uint32Array<ArrayBuffer>}
 */
export function wordsOf(bytes, place) {
  const {offset, words: count, stride} = place;
  const words = new Uint32Array(count);
  const second = offset + count, third = second + count, fourth = third + count;
  for (let i = 0; i < count; ++i) {
    const zigzag =
        bytes[offset + i] | bytes[second + i] << 8 | bytes[third + i] << 16 | bytes[fourth + i] << 24;
    words[i] = (zigzag >>> 1 ^ -(zigzag & 1)) + (i < stride ? 0 : words[i - stride]);
  }
  return words;
}

/** @param {boolean} holds @param {string} what */
function need(holds, what) {
  if (!holds) throw new DataError(`the data of this page is damaged: ${what}`);
}

/** @param {unknown} value @param {number} below */
const isIndex = (value, below) =>
    typeof value === 'number' && Number.isInteger(value) && value >= 0 && value < below;

/** @param {unknown} value @param {number} count */
const isNumbers = (value, count) =>
    Array.isArray(value) && value.length === count && value.every((x) => typeof x === 'number');

/** The arrays of a page, decoded once, when they are first asked for. */
export class Arrays {
  /** @param {Uint8Array} bytes @param {ArrayPlace[]} places */
  constructor(bytes, places) {
    this.bytes = bytes;
    this.places = places;
    /** @type {(Uint32Array<ArrayBuffer>|undefined)[]} */
    this.known = [];
  }

  /** @param {number} index */
  words(index) {
    need(isIndex(index, this.places.length), `there is no array ${index}`);
    return this.known[index] ??= wordsOf(this.bytes, this.places[index]);
  }

  /** @param {number} index */
  floats(index) {
    return new Float32Array(this.words(index).buffer);
  }
}

/** @param {PageData} page @param {Arrays} arrays */
function checkMeshes(page, arrays) {
  page.meshes.forEach((mesh, m) => {
    need(isNumbers(mesh.origin, 3) && mesh.scale > 0, `mesh ${m} has no origin or no scale`);
    const positions = arrays.floats(mesh.positions), indices = arrays.words(mesh.indices);
    need(positions.length % 3 === 0 && indices.length % 3 === 0, `mesh ${m} is no list of triples`);
    need(positions.every(Number.isFinite), `mesh ${m} has a vertex that is not finite`);
    const vertices = positions.length / 3;
    need(indices.every((index) => index < vertices), `mesh ${m} has an index out of range`);
    need(mesh.exact === undefined || arrays.words(mesh.exact).length === 6 * vertices, `mesh ${m} has not all exact coordinates`);
  });
}

/** @param {PageData} page @param {Arrays} arrays */
function checkBodies(page, arrays) {
  page.bodies.forEach((body, b) => {
    need(typeof body.name === 'string' && isIndex(body.mesh, page.meshes.length), `body ${b} has no mesh`);
    const frames = arrays.words(body.frames), poses = arrays.floats(body.poses);
    need(poses.length === 7 * frames.length && poses.every(Number.isFinite), `body ${b} has no pose`);
    need(frames.every((frame, i) => frame < page.frames.length && (i === 0 || frames[i - 1] < frame)),
         `body ${b} stands in no frame`);
  });
}

/**
 * @param {number} count of frames @param {Arrays} arrays @param {MarkData} mark @param {number} width
 * @param {string} what
 */
function checkMark(count, arrays, mark, width, what) {
  need(typeof mark === 'object' && mark !== null, `there are no ${what}`);
  const starts = arrays.words(mark.starts), list = arrays.words(mark.list);
  need(starts.length === count + 1 && starts[0] === 0, `${what} have no frames`);
  need(starts.every((start, i) => i === 0 || starts[i - 1] <= start), `${what} are in disorder`);
  const last = starts[starts.length - 1];
  if (mark.rows === undefined) return need(last * width === list.length, `${what} are missing`);
  const rows = arrays.words(mark.rows);
  need(list.length % width === 0 && last === rows.length && rows.every((row) => row * width < list.length), `${what} are missing`);
}

/** @param {PageData} page @param {Arrays} arrays */
function checkMarks(page, arrays) {
  const {marks} = page;
  need(typeof marks === 'object' && marks !== null && Array.isArray(marks.triangles), 'there are no marks');
  marks.triangles.forEach((mark, i) => {
    need(isIndex(mark.body, page.bodies.length), `mark ${i} is of no body`);
    const frames = arrays.words(mark.frames);
    need(frames.every((frame, k) => frame < page.frames.length && (k === 0 || frames[k - 1] < frame)),
         'marked triangles are in no frame');
    checkMark(frames.length, arrays, mark, 1, 'marked triangles');
    const triangles = arrays.words(page.meshes[page.bodies[mark.body].mesh].indices).length / 3;
    need(arrays.words(mark.list).every((t) => t < triangles), `body ${mark.body} has no such triangle`);
  });
  checkMark(page.frames.length, arrays, marks.curves, 6, 'curves');
  checkMark(page.frames.length, arrays, marks.lines, 6, 'lines');
  checkMark(page.frames.length, arrays, marks.contacts, 7, 'contacts');
  checkMark(page.frames.length, arrays, marks.gaps, 7, 'gaps');
  checkMark(page.frames.length, arrays, marks.points, 3, 'points');
  checkMark(page.frames.length, arrays, marks.planes, 7, 'planes');
  checkMark(page.frames.length, arrays, marks.pairs, 2, 'pairs');
  need(arrays.words(marks.pairs.list).every((body) => body < page.bodies.length), 'a pair is of no body');
  need(Array.isArray(marks.boxes) &&
           marks.boxes.every(({body, level, list}) => isIndex(body, page.bodies.length) && isIndex(level, 100) &&
                                                      arrays.words(list).length % 12 === 0),
       'boxes are of no body');
  need(Array.isArray(marks.labels) &&
           marks.labels.every((label) => isIndex(label.frame, page.frames.length) && isNumbers(label.at, 3) &&
                              typeof label.text === 'string'),
       'labels have no place');
}

/** @param {PageData} page */
function checkFrames(page) {
  need(page.frames.length > 0, 'there is no frame');
  page.places.forEach((place, p) => need(isNumbers(place.center, 3) && place.scale > 0, `place ${p} is none`));
  page.frames.forEach((frame, f) =>
    need(isIndex(frame.place, page.places.length) && Array.isArray(frame.facts) && typeof frame.label === 'string',
         `frame ${f} has no place`));
}

/**
 * @param {Uint8Array} bytes decompressed
 * @returns {{page: PageData, arrays: Arrays}}
 */
export function readPage(bytes) {
  need(bytes.length >= kHeadBytes, 'it is too short');
  const magic = String.fromCharCode(...bytes.subarray(0, 8));
  need(magic === kMagic, magic.startsWith('GRAZEVW') ? 'it is of another version' : 'it does not begin as it should');
  const head = new DataView(bytes.buffer, bytes.byteOffset, kHeadBytes);
  const jsonBytes = head.getUint32(8, true), arrayBytes = head.getUint32(12, true);
  need(kHeadBytes + jsonBytes + arrayBytes === bytes.length, 'it has another length than it says');
  /** @type {PageData} */
  let page;
  try {
    page = JSON.parse(new TextDecoder().decode(bytes.subarray(kHeadBytes, kHeadBytes + jsonBytes)));
  } catch {
    throw new DataError('the data of this page is damaged: its description cannot be read');
  }
  for (const list of /** @type {const} */ (['meshes', 'bodies', 'places', 'frames', 'arrays', 'notes']))
    need(Array.isArray(page[list]), `it has no ${list}`);
  page.arrays.forEach((place, i) =>
    need(isIndex(place.offset, 2 ** 32) && isIndex(place.words, 2 ** 30) && isIndex(place.stride, 2 ** 16) &&
             place.stride > 0 && place.offset + 4 * place.words <= arrayBytes,
         `array ${i} lies outside`));
  const arrays = new Arrays(bytes.subarray(kHeadBytes + jsonBytes), page.arrays);
  checkFrames(page);
  checkMeshes(page, arrays);
  checkBodies(page, arrays);
  checkMarks(page, arrays);
  return {page, arrays};
}

/** @param {string} text Base64, as it stands in the page */
export async function unpack(text) {
  return readPage(await gunzip(bytesOfBase64(text)));
}
