// @ts-check
// Coarser triangles for bodies that are small on the screen: vertices that share a cell of a grid become one (Rossignac
// and Borrel, "Multi-resolution 3D approximations for rendering complex scenes", 1993). For the eye alone: what is
// marked, picked or cut comes from all triangles.

/** Cells along the longest side of a mesh's box, by level. */
export const kGrids = /** @type {const} */ ([4, 8, 16, 32, 64, 128]);
/** Meshes of fewer triangles are always drawn whole. */
const kLeastTriangles = 2000;
/** A coarser mesh that has more than this part of the triangles is not worth its memory. */
const kWorth = 0.7;

/**
 * The triangles that are left when vertices of a cell become the first of them; null if hardly fewer are.
 * @param {Float32Array} positions @param {Uint32Array} triangles @param {number} cells along the longest side
 * @returns {Uint32Array<ArrayBuffer>|null}
 */
export function clustered(positions, triangles, cells) {
  if (triangles.length < 3 * kLeastTriangles) return null;
  const low = [Infinity, Infinity, Infinity], high = [-Infinity, -Infinity, -Infinity];
  for (let i = 0; i < positions.length; ++i) {
    low[i % 3] = Math.min(low[i % 3], positions[i]);
    high[i % 3] = Math.max(high[i % 3], positions[i]);
  }
  const size = Math.max(...high.map((x, k) => x - low[k])) / cells;
  if (!(size > 0)) return null;
  const count = positions.length / 3, row = cells + 1;
  /** @type {Map<number, number>} */
  const first = new Map();
  const of = new Uint32Array(count);
  for (let v = 0; v < count; ++v) {
    let cell = 0;
    for (let k = 0; k < 3; ++k) cell = cell * row + Math.min(cells, Math.floor((positions[3 * v + k] - low[k]) / size));
    const known = first.get(cell);
    if (known === undefined) first.set(cell, v);
    of[v] = known ?? v;
  }
  // Of triangles with the same corners those from one side and those from the other cancel each other out: between
  // them there was nothing, and of the rest one is enough.
  /** @type {Map<string, {corners: number[], sum: number}>} */
  const sides = new Map();
  for (let i = 0; i < triangles.length; i += 3) {
    const corners = [of[triangles[i]], of[triangles[i + 1]], of[triangles[i + 2]]];
    const [a, b, c] = corners, sorted = [...corners].sort((x, y) => x - y);
    if (sorted[0] === sorted[1] || sorted[1] === sorted[2]) continue;
    const isEven = (a < b && b < c) || (b < c && c < a) || (c < a && a < b);
    const key = sorted.join(), known = sides.get(key);
    if (known) known.sum += isEven ? 1 : -1;
    else sides.set(key, {corners: sorted, sum: isEven ? 1 : -1});
  }
  const kept = [];
  for (const {corners: [a, b, c], sum} of sides.values()) {
    if (sum > 0) kept.push(a, b, c);
    if (sum < 0) kept.push(b, a, c);
  }
  return kept.length < kWorth * triangles.length ? Uint32Array.from(kept) : null;
}

/**
 * The coarsest level whose cells are no longer than `cell` pixels on the screen; kGrids.length: all triangles.
 * @param {number} pixels that the longest side of a mesh's box has there @param {number} cell
 */
export function levelFor(pixels, cell) {
  const level = kGrids.findIndex((cells) => pixels <= cell * cells);
  return level < 0 ? kGrids.length : level;
}
