import assert from 'node:assert/strict';
import test from 'node:test';
import {firstTriangle, meetsBall} from '../source/pick.js';

const kTwo = new Float32Array([-1, -1, 0, 1, -1, 0, 0, 1, 0, -1, -1, 2, 1, -1, 2, 0, 1, 2]);
const kTriangles = new Uint32Array([3, 4, 5, 0, 1, 2]);

test('the nearest of two counts, from both sides', () => {
  assert.deepEqual(firstTriangle(kTwo, kTriangles, [0, 0, -1], [0, 0, 1]), {triangle: 1, t: 1});
  assert.deepEqual(firstTriangle(kTwo, kTriangles, [0, 0, 5], [0, 0, -0.5]), {triangle: 0, t: 6});
});

test('what is beside, behind or in the plane of the ray is not met', () => {
  assert.equal(firstTriangle(kTwo, kTriangles, [3, 0, -1], [0, 0, 1]), null);
  assert.equal(firstTriangle(kTwo, kTriangles, [0, 0, 3], [0, 0, 1]), null);
  assert.equal(firstTriangle(kTwo, kTriangles, [-3, 0, 0], [1, 0, 0]), null);
});

test('what a cut hides is passed', () => {
  assert.deepEqual(firstTriangle(kTwo, kTriangles, [0, 0, -1], [0, 0, 1], (t) => t > 2), {triangle: 0, t: 3});
});

test('against all triangles of a random heap, by areas in the plane', () => {
  let seed = 1;
  const random = () => (seed = seed * 48271 % 2147483647) / 2147483647 * 2 - 1;
  const positions = Float32Array.from({length: 900}, random);
  const triangles = Uint32Array.from({length: 300}, (_, i) => i);
  for (let round = 0; round < 50; ++round) {
    const x = random(), y = random();
    let expected = null;
    for (let i = 0; i < 100; ++i) {
      const p = [0, 1, 2].map((k) => [...positions.subarray(9 * i + 3 * k, 9 * i + 3 * k + 3)]);
      const side = (a, b) => (p[b][0] - p[a][0]) * (y - p[a][1]) - (p[b][1] - p[a][1]) * (x - p[a][0]);
      const areas = [side(1, 2), side(2, 0), side(0, 1)], whole = areas[0] + areas[1] + areas[2];
      if (!areas.every((s) => s > 0) && !areas.every((s) => s < 0)) continue;
      const z = areas.reduce((sum, s, k) => sum + s / whole * p[k][2], 0);
      if (!expected || z < expected.z) expected = {triangle: i, z};
    }
    const found = firstTriangle(positions, triangles, [x, y, -5], [0, 0, 1]);
    assert.equal(found?.triangle ?? null, expected?.triangle ?? null);
    if (found) assert.ok(Math.abs(found.t - 5 - expected.z) < 1e-9);
  }
});

test('a ball is met by rays that come near it', () => {
  assert.ok(meetsBall([0, 0, 5], 1, [0, 0, 0], [0, 0, 2]));
  assert.ok(meetsBall([0, 0, 0], 1, [0, 0, 0.5], [0, 0, 1]), 'from inside');
  assert.ok(!meetsBall([0, 3, 5], 1, [0, 0, 0], [0, 0, 1]));
  assert.ok(!meetsBall([0, 0, -5], 1, [0, 0, 0], [0, 0, 1]), 'behind');
});
