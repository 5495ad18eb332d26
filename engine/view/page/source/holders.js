// @ts-check
// Bodies in which others lie, as in a bin: they are seen through, so that what lies in them is seen.

import * as THREE from 'three';

/** So many frames are looked at, and so many others at least lie in a body that holds them. */
const kFramesLookedAt = 24, kLeastHeld = 3;

/**
 * Finds bodies in which others lie in some frame, as in a bin: closed ones whose box holds theirs.
 * @param {import('./bodies.js').ShownBody[]} bodies @param {import('./unpack.js').PageData} page
 */
export function findHolders(bodies, page) {
  const of = (/** @type {import('./bodies.js').ShownBody} */ {shape, group}) =>
      (shape.surface.boundingBox ?? new THREE.Box3()).clone().applyMatrix4(group.matrix);
  const step = Math.max(1, Math.floor(page.frames.length / kFramesLookedAt));
  for (let frame = page.frames.length - 1; frame >= 0 && bodies.length > kLeastHeld; frame -= step) {
    const {scale} = page.places[page.frames[frame].place];
    for (const body of bodies) body.stand(frame, scale);
    const boxes = bodies.filter(({isHere, shape}) => isHere && !shape.isBoundless).map((body) => ({body, box: of(body)}));
    const size = (/** @type {THREE.Box3} */ box) => box.getSize(new THREE.Vector3()).length();
    boxes.sort((a, b) => size(b.box) - size(a.box));
    for (const {body, box} of boxes.slice(0, 2))
      if (body.shape.isClosed && boxes.filter((other) => box.containsBox(other.box)).length > kLeastHeld) body.hold();
  }
}
