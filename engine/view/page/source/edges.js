// @ts-check
// This says which edges of a mesh are drawn: corners and borders always, those between triangles when they are near.

/**
 * The lowest vertex in the same position, for each vertex.
 * @param {Float32Array} positions
 */
export function weld(positions) {
  const count = positions.length / 3;
  const bits = new Uint32Array(new Float32Array(positions.map((x) => x + 0)).buffer);  // -0 is 0
  const table = new Int32Array(tableSize(count)).fill(-1);
  const first = new Uint32Array(count);
  for (let v = 0; v < count; ++v) {
    let slot = hash(bits[3 * v], bits[3 * v + 1], bits[3 * v + 2]) & table.length - 1;
    for (;; slot = slot + 1 & table.length - 1) {
      const other = table[slot];
      if (other < 0) {
        table[slot] = v;
        first[v] = v;
        break;
      }
      if (bits[3 * v] === bits[3 * other] && bits[3 * v + 1] === bits[3 * other + 1] &&
          bits[3 * v + 2] === bits[3 * other + 2]) {
        first[v] = other;
        break;
      }
    }
  }
  return first;
}

/** @param {number} count */
function tableSize(count) {
  let size = 16;
  while (size < 2 * count) size *= 2;
  return size;
}

/** @param {number} a @param {number} b @param {number} c */
function hash(a, b, c) {
  let h = Math.imul(a, 0x9e3779b1) ^ Math.imul(b, 0x85ebca6b) ^ Math.imul(c, 0xc2b2ae35);
  h ^= h >>> 15;
  h = Math.imul(h, 0x2c1b3c6d);
  return (h ^ h >>> 12) >>> 0;
}

/** @param {Float32Array} p @param {Uint32Array} t @param {number} i @param {Float64Array} out unit normals */
function normalOf(p, t, i, out) {
  const a = 3 * t[3 * i], b = 3 * t[3 * i + 1], c = 3 * t[3 * i + 2];
  const ux = p[b] - p[a], uy = p[b + 1] - p[a + 1], uz = p[b + 2] - p[a + 2];
  const vx = p[c] - p[a], vy = p[c + 1] - p[a + 1], vz = p[c + 2] - p[a + 2];
  const x = uy * vz - uz * vy, y = uz * vx - ux * vz, z = ux * vy - uy * vx;
  const size = Math.hypot(x, y, z) || 1;
  out[3 * i] = x / size, out[3 * i + 1] = y / size, out[3 * i + 2] = z / size;
}

/**
 * Pairs of vertices: `sharp` where two triangles meet at more than `angle` radians, or where not just two meet;
 * `flat` all others, each once. Edges of one triangle without area are flat. `isClosed` if two triangles meet at each.
 * @param {Float32Array} positions @param {Uint32Array} triangles @param {number} angle
 */
export function meshEdges(positions, triangles, angle = 0.6) {
  const welded = weld(positions);
  const count = triangles.length / 3;
  const normals = new Float64Array(3 * count);
  for (let i = 0; i < count; ++i) normalOf(positions, triangles, i, normals);
  const size = tableSize(3 * count);
  const table = new Int32Array(size).fill(-1);
  const from = new Uint32Array(3 * count), to = new Uint32Array(3 * count);
  const owner = new Int32Array(3 * count);  // the first triangle
  const uses = new Uint8Array(3 * count);   // 1, 2, or 3 for more
  const isSharp = new Uint8Array(3 * count);
  let edges = 0;
  const least = Math.cos(angle);
  for (let i = 0; i < count; ++i) {
    for (let k = 0; k < 3; ++k) {
      const u = welded[triangles[3 * i + k]], v = welded[triangles[3 * i + (k + 1) % 3]];
      if (u === v) continue;
      const low = Math.min(u, v), high = Math.max(u, v);
      let slot = hash(low, high, 0) & size - 1;
      while (table[slot] >= 0 && (from[table[slot]] !== low || to[table[slot]] !== high)) slot = slot + 1 & size - 1;
      let edge = table[slot];
      if (edge < 0) {
        edge = table[slot] = edges++;
        from[edge] = low, to[edge] = high, owner[edge] = i, uses[edge] = 1;
        continue;
      }
      uses[edge] = Math.min(3, uses[edge] + 1);
      const a = 3 * owner[edge], b = 3 * i;
      const cosine = normals[a] * normals[b] + normals[a + 1] * normals[b + 1] + normals[a + 2] * normals[b + 2];
      if (cosine < least && isArea(normals, a) && isArea(normals, b)) isSharp[edge] = 1;
    }
  }
  return split(from, to, uses, isSharp, edges);
}

/** @param {Float64Array} normals @param {number} at */
const isArea = (normals, at) => normals[at] !== 0 || normals[at + 1] !== 0 || normals[at + 2] !== 0;

/**
 * @param {Uint32Array} from @param {Uint32Array} to @param {Uint8Array} uses @param {Uint8Array} isSharp
 * @param {number} edges
 */
function split(from, to, uses, isSharp, edges) {
  let sharpCount = 0;
  for (let e = 0; e < edges; ++e) if (isSharp[e] || uses[e] !== 2) ++sharpCount;
  const sharp = new Uint32Array(2 * sharpCount), flat = new Uint32Array(2 * (edges - sharpCount));
  let s = 0, f = 0;
  for (let e = 0; e < edges; ++e) {
    if (isSharp[e] || uses[e] !== 2) sharp[s++] = from[e], sharp[s++] = to[e];
    else flat[f++] = from[e], flat[f++] = to[e];
  }
  return {sharp, flat, isClosed: uses.subarray(0, edges).every((count) => count === 2)};
}

/**
 * A length between those of short and of long edges: by it one sees whether triangles can be told apart.
 * @param {Float32Array} positions @param {Uint32Array} triangles
 */
export function typicalEdge(positions, triangles) {
  const step = Math.max(1, Math.floor(triangles.length / 3 / 2000));
  const lengths = [];
  for (let i = 0; i < triangles.length / 3; i += step) {
    const a = 3 * triangles[3 * i], b = 3 * triangles[3 * i + 1];
    lengths.push(Math.hypot(positions[a] - positions[b], positions[a + 1] - positions[b + 1],
                            positions[a + 2] - positions[b + 2]));
  }
  lengths.sort((x, y) => x - y);
  return lengths[lengths.length >> 1] ?? 0;
}

/** Corners of a box by signs of its half axes, and the pairs of them that an edge joins. */
const kCorners = [0, 1, 2, 3, 4, 5, 6, 7].map((i) => [i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1]);
const kEdges = [0, 1, 2, 3, 4, 5, 6, 7].flatMap((i) => [1, 2, 4].filter((bit) => !(i & bit)).map((bit) => [i, i | bit]));

/**
 * The edges of boxes, six numbers each.
 * @param {Float32Array} boxes twelve numbers each: the middle and three half axes
 */
export function boxEdges(boxes) {
  const ends = new Float32Array(boxes.length / 12 * kEdges.length * 6);
  let at = 0;
  for (let i = 0; i < boxes.length; i += 12) {
    const corners = kCorners.map((signs) => [0, 1, 2].map(
        (x) => boxes[i + x] + signs[0] * boxes[i + 3 + x] + signs[1] * boxes[i + 6 + x] + signs[2] * boxes[i + 9 + x]));
    for (const edge of kEdges)
      for (const corner of edge)
        for (const x of corners[corner]) ends[at++] = x;
  }
  return ends;
}
