import assert from 'node:assert/strict';
import test from 'node:test';
import {clustered, kGrids, levelFor} from '../source/coarse.js';

/** A sphere of 2 n n triangles. */
function ball(n) {
  const positions = [], triangles = [];
  for (let i = 0; i <= n; ++i)
    for (let k = 0; k < n; ++k) {
      const up = Math.PI * i / n, around = 2 * Math.PI * k / n;
      positions.push(Math.sin(up) * Math.cos(around), Math.sin(up) * Math.sin(around), Math.cos(up));
    }
  for (let i = 0; i < n; ++i)
    for (let k = 0; k < n; ++k) {
      const a = i * n + k, b = i * n + (k + 1) % n;
      triangles.push(a, b, a + n, b, b + n, a + n);
    }
  return [new Float32Array(positions), new Uint32Array(triangles)];
}

test('coarser triangles are fewer, and no corner goes further than across its cell', () => {
  const [positions, triangles] = ball(100);
  let before = triangles.length;
  for (const cells of [...kGrids].reverse()) {
    const kept = clustered(positions, triangles, cells);
    if (!kept) continue;
    assert.ok(kept.length < before && kept.length > 0, `${kept.length / 3} of ${before / 3} with ${cells}`);
    before = kept.length;
    // Each vertex of the ball has one that is left within a cell's diagonal.
    const left = [...new Set(kept)].map((v) => positions.subarray(3 * v, 3 * v + 3));
    const most = 2 / cells * Math.sqrt(3) + 1e-6;
    for (let v = 0; v < positions.length / 3; v += 37) {
      const [x, y, z] = positions.subarray(3 * v, 3 * v + 3);
      assert.ok(left.some((w) => Math.hypot(w[0] - x, w[1] - y, w[2] - z) <= 2 * most), `${cells}`);
    }
  }
  assert.ok(before < triangles.length / 10, 'the coarsest has few');
});

test('what turns outward does so when it is coarse, and sheets without room between them go', () => {
  const [positions, triangles] = ball(100);
  const kept = clustered(positions, triangles, 16);
  let volume = 0;
  for (let i = 0; i < kept.length; i += 3) {
    const [a, b, c] = [0, 1, 2].map((k) => positions.subarray(3 * kept[i + k], 3 * kept[i + k] + 3));
    volume += (a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0])) / 6;
  }
  assert.ok(Math.abs(Math.abs(volume) / (4 / 3 * Math.PI) - 1) < 0.2, `${volume}`);
  // A second ball, turned inside out, within a thousandth: both fall into the same cells.
  const both = new Float32Array([...positions, ...positions.map((x) => x * 0.9999)]);
  const inner = [];
  for (let i = 0; i < triangles.length; i += 3)
    inner.push(...[triangles[i + 1], triangles[i], triangles[i + 2]].map((v) => v + positions.length / 3));
  const sheets = clustered(both, new Uint32Array([...triangles, ...inner]), 16);
  assert.ok(sheets.length < kept.length / 4, `${sheets.length} of ${kept.length}`);
});

test('no triangle is there twice, and none is a line', () => {
  const [positions, triangles] = ball(60);
  const kept = clustered(positions, triangles, 16);
  const keys = new Set();
  for (let i = 0; i < kept.length; i += 3) {
    const [a, b, c] = kept.subarray(i, i + 3);
    assert.ok(a !== b && b !== c && c !== a);
    const key = [a, b, c].sort((x, y) => x - y).join();
    assert.ok(!keys.has(key));
    keys.add(key);
  }
});

test('small meshes and points are left as they are', () => {
  const [positions, triangles] = ball(20);
  assert.equal(clustered(positions, triangles, 8), null);
  assert.equal(clustered(new Float32Array(9), new Uint32Array(9000), 8), null);
});

test('the level fits the size on the screen', () => {
  assert.deepEqual([4, 8, 9, 16, 100, 128, 129, 4000].map((pixels) => levelFor(pixels, 1)), [0, 1, 2, 2, 5, 5, 6, 6]);
  assert.equal(levelFor(30, 4), 1);
});
