// @ts-check
// This finds what a ray meets first, in a body's own frame: Möller and Trumbore, "Fast, minimum storage ray-triangle
// intersection", 1997, in doubles. It serves the eye; which bodies touch has been decided before.

/**
 * @param {Float32Array} positions @param {Uint32Array} triangles
 * @param {number[]} origin @param {number[]} direction of any length
 * @param {(t: number) => boolean} isSeen whether what is met there counts: a cut hides what is before it
 * @returns {{triangle: number, t: number}|null}
 */
export function firstTriangle(positions, triangles, origin, direction, isSeen = () => true) {
  const [ox, oy, oz] = origin, [dx, dy, dz] = direction;
  let best = Infinity, found = -1;
  for (let i = 0; i < triangles.length; i += 3) {
    const a = 3 * triangles[i], b = 3 * triangles[i + 1], c = 3 * triangles[i + 2];
    const ax = positions[a], ay = positions[a + 1], az = positions[a + 2];
    const ux = positions[b] - ax, uy = positions[b + 1] - ay, uz = positions[b + 2] - az;
    const vx = positions[c] - ax, vy = positions[c + 1] - ay, vz = positions[c + 2] - az;
    const px = dy * vz - dz * vy, py = dz * vx - dx * vz, pz = dx * vy - dy * vx;
    const det = ux * px + uy * py + uz * pz;
    if (det === 0) continue;
    const sx = ox - ax, sy = oy - ay, sz = oz - az;
    const u = (sx * px + sy * py + sz * pz) / det;
    if (!(u >= 0 && u <= 1)) continue;
    const qx = sy * uz - sz * uy, qy = sz * ux - sx * uz, qz = sx * uy - sy * ux;
    const v = (dx * qx + dy * qy + dz * qz) / det;
    if (!(v >= 0 && u + v <= 1)) continue;
    const t = (vx * qx + vy * qy + vz * qz) / det;
    if (t > 0 && t < best && isSeen(t)) {
      best = t;
      found = i / 3;
    }
  }
  return found < 0 ? null : {triangle: found, t: best};
}

/**
 * Returns whether a ray comes near a ball at all.
 * @param {number[]} centre @param {number} radius @param {number[]} origin @param {number[]} direction
 */
export function meetsBall(centre, radius, origin, direction) {
  const [x, y, z] = [0, 1, 2].map((i) => centre[i] - origin[i]);
  const size = Math.hypot(...direction);
  const along = (x * direction[0] + y * direction[1] + z * direction[2]) / size;
  const away = x * x + y * y + z * z - along * along;
  return away <= radius * radius * (1 + 1e-9) && along >= -radius;
}
