import assert from 'node:assert/strict';
import test from 'node:test';
import {gzipSync} from 'node:zlib';
import {marksOf} from '../source/frames.js';
import {DataError, readPage, unpack, wordsOf} from '../source/unpack.js';

/** As the library writes them: difference, sign lowest, bytes of all words plane by plane. */
function packWords(words, stride) {
  const bytes = new Uint8Array(4 * words.length);
  words.forEach((word, i) => {
    const difference = (word - (i < stride ? 0 : words[i - stride])) | 0;
    const zigzag = (difference << 1 ^ difference >> 31) >>> 0;
    for (let plane = 0; plane < 4; ++plane) bytes[plane * words.length + i] = zigzag >>> 8 * plane & 0xff;
  });
  return bytes;
}

class Writer {
  constructor() {
    this.places = [];
    this.bytes = [];
  }
  words(words, stride = 1) {
    this.places.push({offset: this.bytes.length, words: words.length, stride});
    this.bytes.push(...packWords(words, stride));
    return this.places.length - 1;
  }
  floats(floats, stride) {
    return this.words([...new Uint32Array(new Float32Array(floats).buffer)], stride);
  }
}

/** A page of one triangle in one frame; `change` may break it. */
function pageBytes(change = () => {}) {
  const out = new Writer();
  const empty = (width) => ({starts: out.words([0, 0]), list: out.floats([], width)});
  const page = {
    title: 't', unit: 'm', made_by: 'graze', notes: [],
    meshes: [{positions: out.floats([0, 0, 0, 1, 0, 0, 0, 1, 0], 3), indices: out.words([0, 1, 2], 3),
              origin: [0, 0, 0], scale: 1}],
    bodies: [{name: '<script>alert(1)</script>', mesh: 0, frames: out.words([0]),
              poses: out.floats([0, 0, 0, 1, 0, 0, 0], 7)}],
    places: [{center: [0, 0, 0], scale: 1}],
    frames: [{label: '', state: 'clear', facts: [], place: 0}],
    marks: {
      triangles: [{body: 0, frames: out.words([0]), starts: out.words([0, 1]), list: out.words([0])}],
      curves: empty(6), lines: empty(6), points: empty(3), contacts: empty(7), gaps: empty(7), planes: empty(7),
      pairs: empty(2), boxes: [], labels: [],
    },
  };
  const parts = {page, out, magic: 'GRAZEVW1', cut: 0};
  change(parts);
  page.arrays = out.places;
  const text = new TextEncoder().encode(JSON.stringify(page)), arrays = Uint8Array.from(out.bytes);
  const bytes = new Uint8Array(16 + text.length + arrays.length);
  bytes.set(new TextEncoder().encode(parts.magic));
  new DataView(bytes.buffer).setUint32(8, text.length, true);
  new DataView(bytes.buffer).setUint32(12, arrays.length, true);
  bytes.set(text, 16);
  bytes.set(arrays, 16 + text.length);
  return bytes.subarray(0, bytes.length - parts.cut);
}

test('words are what was packed, from the least to the greatest', () => {
  const words = [0, 1, 0xffffffff, 0x80000000, 0x7fffffff, 5, 4, 3];
  for (const stride of [1, 2, 3, 7])
    assert.deepEqual([...wordsOf(packWords(words, stride), {offset: 0, words: words.length, stride})], words);
});

test('a page is read, names as they are', async () => {
  const {page, arrays} = await unpack(Buffer.from(gzipSync(pageBytes())).toString('base64'));
  assert.equal(page.bodies[0].name, '<script>alert(1)</script>');
  assert.deepEqual([...arrays.floats(page.meshes[0].positions)], [0, 0, 0, 1, 0, 0, 0, 1, 0]);
});

test('marks that stay stand there once, and frames say which they have', () => {
  const row = [1, 2, 3, 0, 0, 1, 0.5], other = [4, 5, 6, 1, 0, 0, 0.25];
  const {page, arrays} = readPage(pageBytes(({page, out}) => {
    page.marks.contacts = {starts: out.words([0, 3]), rows: out.words([1, 0, 1]), list: out.floats(row.flatMap((x, k) => [x, other[k]]), 1)};
  }));
  assert.deepEqual([...marksOf(arrays, page.marks.contacts, 7, 0)], [...other, ...row, ...other]);
});

const kDamages = {
  'another version': (p) => { p.magic = 'GRAZEVW2'; },
  'another file': (p) => { p.magic = 'PNGPNGPN'; },
  'cut off': (p) => { p.cut = 5; },
  'an index out of range': (p) => { p.page.meshes[0].indices = p.out.words([0, 1, 3], 3); },
  'a coordinate that is not finite': (p) => { p.page.meshes[0].positions = p.out.floats([0, 0, 0, NaN, 0, 0, 0, 1, 0], 3); },
  'a body without a mesh': (p) => { p.page.bodies[0].mesh = 1; },
  'a body in a frame that is not there': (p) => { p.page.bodies[0].frames = p.out.words([1]); },
  'a pose too few': (p) => { p.page.bodies[0].poses = p.out.floats([], 7); },
  'a marked triangle that is not there': (p) => { p.page.marks.triangles[0].list = p.out.words([1]); },
  'marks of more frames': (p) => { p.page.marks.curves.starts = p.out.words([0, 0, 0]); },
  'marks in disorder': (p) => { p.page.marks.gaps.starts = p.out.words([0, 4]); },
  'rows too few': (p) => { p.page.marks.contacts = {starts: p.out.words([0, 2]), rows: p.out.words([0]), list: p.out.floats([1, 2, 3, 4, 5, 6, 7], 7)}; },
  'a row that is not there': (p) => { p.page.marks.contacts = {starts: p.out.words([0, 1]), rows: p.out.words([1]), list: p.out.floats([1, 2, 3, 4, 5, 6, 7], 7)}; },
  'a row that is cut off': (p) => { p.page.marks.contacts = {starts: p.out.words([0, 1]), rows: p.out.words([0]), list: p.out.floats([1, 2, 3], 7)}; },
  'a pair of a body that is not there': (p) => {
    p.page.marks.pairs = {starts: p.out.words([0, 1]), list: p.out.words([0, 1])};
  },
  'boxes of a body that is not there': (p) => { p.page.marks.boxes = [{body: 1, level: 0, list: p.out.floats([], 12)}]; },
  'a box that is cut off': (p) => { p.page.marks.boxes = [{body: 0, level: 0, list: p.out.floats([1, 2, 3], 12)}]; },
  'too few exact coordinates': (p) => { p.page.meshes[0].exact = p.out.words([1, 2], 6); },
  'no frame': (p) => { p.page.frames = []; },
  'a place that is none': (p) => { p.page.places[0].scale = 0; },
  'an array that is not there': (p) => { p.page.meshes[0].positions = 99; },
  'an array that lies outside': (p) => { p.out.places[0].offset = 1e6; },
  'no list of bodies': (p) => { p.page.bodies = 'none'; },
  'no marks': (p) => { delete p.page.marks; },
};
for (const [what, damage] of Object.entries(kDamages))
  test(`refused with a word: ${what}`, () => assert.throws(() => readPage(pageBytes(damage)), DataError));

test('what is no Base64, and no gzip, is refused with a word', async () => {
  await assert.rejects(unpack('!'), DataError);
  await assert.rejects(unpack('AAAA'), DataError);
  const whole = Buffer.from(gzipSync(pageBytes())).toString('base64');
  await assert.rejects(unpack(whole.slice(0, whole.length / 2 & ~3)), DataError);
});
