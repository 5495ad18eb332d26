import assert from 'node:assert/strict';
import test from 'node:test';
import {boxEdges, meshEdges, typicalEdge, weld} from '../source/edges.js';

const kCube = new Float32Array([0, 1].flatMap((z) => [0, 1].flatMap((y) => [0, 1].flatMap((x) => [x, y, z]))));
const kCubeTriangles = new Uint32Array([
  0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6, 0, 1, 5, 0, 5, 4, 2, 6, 7, 2, 7, 3, 0, 4, 6, 0, 6, 2, 1, 3, 7, 1, 7, 5,
]);

/** Each triangle with corners of its own, as STL files have them. */
function soup(positions, triangles) {
  const corners = [...triangles].flatMap((v) => [...positions.subarray(3 * v, 3 * v + 3)]);
  return {positions: new Float32Array(corners), triangles: Uint32Array.from(triangles, (_, i) => i)};
}

test('a cube has twelve sharp edges and a diagonal on each face', () => {
  const {sharp, flat} = meshEdges(kCube, kCubeTriangles);
  assert.equal(sharp.length / 2, 12);
  assert.equal(flat.length / 2, 6);
  for (let e = 0; e < sharp.length; e += 2) {
    const apart = [0, 1, 2].filter((x) => kCube[3 * sharp[e] + x] !== kCube[3 * sharp[e + 1] + x]);
    assert.equal(apart.length, 1, 'along an axis');
  }
});

test('corners in one position are one corner, and -0 is 0', () => {
  const {positions, triangles} = soup(kCube, kCubeTriangles);
  for (let i = 0; i < positions.length; i += 5) if (positions[i] === 0) positions[i] = -0;
  assert.equal(new Set(weld(positions)).size, 8);
  const {sharp, flat} = meshEdges(positions, triangles);
  assert.deepEqual([sharp.length / 2, flat.length / 2], [12, 6]);
});

test('borders, and edges of three triangles, are sharp even in one plane', () => {
  const square = new Float32Array([0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0]);
  assert.deepEqual([4, 1].join(), (({sharp, flat}) => [sharp.length / 2, flat.length / 2].join())(
                                      meshEdges(square, new Uint32Array([0, 1, 2, 0, 2, 3]))));
  const {flat} = meshEdges(square, new Uint32Array([0, 1, 2, 0, 2, 3, 0, 1, 2]));
  assert.equal(flat.length / 2, 2, 'those of the two equal triangles; the diagonal has three');
});

test('the typical edge is one of the mesh', () => {
  const size = typicalEdge(kCube, kCubeTriangles);
  assert.ok(size >= 1 && size <= Math.SQRT2 + 1e-6);
});

test('a box has twelve edges, each as long as twice its half axis', () => {
  const ends = boxEdges(new Float32Array([10, 20, 30, 1, 0, 0, 0, 2, 0, 0, 0, 3]));
  assert.equal(ends.length, 12 * 6);
  const lengths = [];
  for (let i = 0; i < ends.length; i += 6) {
    const along = [0, 1, 2].map((x) => Math.abs(ends[i + 3 + x] - ends[i + x]));
    assert.equal(along.filter((x) => x > 0).length, 1, 'an edge is parallel to one axis');
    lengths.push(Math.max(...along));
    for (const end of [0, 3])
      assert.deepEqual([0, 1, 2].map((x) => Math.abs(ends[i + end + x] - [10, 20, 30][x])), [1, 2, 3], 'it joins corners');
  }
  assert.deepEqual(lengths.sort(), [2, 2, 2, 2, 4, 4, 4, 4, 6, 6, 6, 6]);
});
