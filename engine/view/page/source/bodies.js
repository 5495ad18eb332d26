// @ts-check
// Bodies as three.js draws them: surfaces, edges, marked triangles. Meshes are stored once, however many bodies have
// them and however many frames these stand in.

import * as THREE from 'three';
import {clustered, kGrids, levelFor} from './coarse.js';
import {kMarked} from './colors.js';
import {meshEdges, typicalEdge} from './edges.js';
import {placeIn} from './frames.js';

/** @typedef {import('./unpack.js').PageData} PageData */
/** @typedef {import('./unpack.js').Arrays} Arrays */

/** Pixels that a coarse body has at least if its edges are drawn. */
const kLeastForEdges = 160;

/** Holds what the bodies of one mesh share. */
export class MeshShape {
  /** @param {PageData} page @param {Arrays} arrays @param {number} index */
  constructor(page, arrays, index) {
    const data = page.meshes[index];
    this.isBoundless = data.boundless === true;
    this.origin = data.origin;
    this.scale = data.scale;
    this.positions = arrays.floats(data.positions);
    this.triangles = arrays.words(data.indices);
    this.exact = data.exact === undefined ? null : new Float64Array(arrays.words(data.exact).buffer);
    this.surface = new THREE.BufferGeometry();
    this.surface.setAttribute('position', new THREE.BufferAttribute(this.positions, 3));
    this.surface.setIndex(new THREE.BufferAttribute(this.triangles, 1));
    this.surface.computeBoundingSphere();
    this.surface.computeBoundingBox();
    const size = this.surface.boundingBox?.getSize(new THREE.Vector3()) ?? new THREE.Vector3();
    this.longest = Math.max(size.x, size.y, size.z);
    this.typicalEdge = typicalEdge(this.positions, this.triangles);
    const {sharp, flat, isClosed} = meshEdges(this.positions, this.triangles);
    this.isClosed = isClosed;
    this.sharp = this.edges(sharp);
    this.flat = this.edges(flat);
    /** @type {(THREE.BufferGeometry|undefined)[]} coarser ones, by level, made when first drawn */
    this.coarser = [];
  }

  /** Returns how many triangles are drawn at a level of detail. @param {number} level */
  countAt(level) {
    return (this.surfaceFor(level).getIndex()?.count ?? 0) / 3;
  }

  /** The surface for a level of detail; that of all triangles where a coarser one saves too little. @param {number} level */
  surfaceFor(level) {
    if (level >= kGrids.length) return this.surface;
    const known = this.coarser[level];
    if (known) return known;
    const kept = clustered(this.positions, this.triangles, kGrids[level]);
    let surface = this.surface;
    if (kept) {
      surface = new THREE.BufferGeometry();
      surface.setAttribute('position', this.surface.getAttribute('position'));
      surface.setIndex(new THREE.BufferAttribute(kept, 1));
      surface.boundingSphere = this.surface.boundingSphere;
    }
    return this.coarser[level] = surface;
  }

  /** @param {Uint32Array<ArrayBuffer>} pairs */
  edges(pairs) {
    const edges = new THREE.BufferGeometry();
    edges.setAttribute('position', this.surface.getAttribute('position'));
    edges.setIndex(new THREE.BufferAttribute(pairs, 1));
    edges.boundingSphere = this.surface.boundingSphere;
    return edges;
  }

  /** The corners of a triangle as they were given; null if the page has them as floats alone. @param {number} triangle */
  exactCorners(triangle) {
    const {exact} = this;
    if (exact === null) return null;
    return [0, 1, 2].map((k) => 3 * this.triangles[3 * triangle + k]).map((at) => [...exact.subarray(at, at + 3)]);
  }

  /** The corners of some triangles, one after the other. @param {ArrayLike<number>} which */
  corners(which) {
    const corners = new Float32Array(9 * which.length);
    for (let i = 0; i < which.length; ++i)
      for (let k = 0; k < 3; ++k)
        for (let x = 0; x < 3; ++x)
          corners[9 * i + 3 * k + x] = this.positions[3 * this.triangles[3 * which[i] + k] + x];
    return corners;
  }
}

/** One body: a group whose frame is that of its mesh's numbers. */
export class ShownBody {
  /**
   * @param {MeshShape} shape @param {string} color
   * @param {Uint32Array} frames in which it stands @param {Float32Array} poses of these
   * @param {THREE.Plane[]} cuts by which surfaces are cut
   */
  constructor(shape, color, frames, poses, cuts) {
    this.shape = shape;
    this.frames = frames;
    this.poses = poses;
    this.cuts = cuts;
    this.isHidden = false;
    this.isHere = false;
    this.group = new THREE.Group();
    this.group.matrixAutoUpdate = false;
    this.marked = new THREE.Group();
    this.group.add(this.marked);
    /** Of what has no end, which is seen through. */
    this.sheet = shape.isBoundless ? this.sheetOf(color) : null;
    /** True if others lie in it, as in a bin. */
    this.isHolder = false;
    this.color = new THREE.Color(color);
    /** Its numbers are those of the screen. */
    this.screenColor = new THREE.Color().setStyle(color, THREE.LinearSRGBColorSpace);
    this.isCoarse = false;
    /** @type {Cap|null} made when something is cut first */
    this.cap = null;
  }

  /** Others lie in it: it is seen through, so that they are seen. */
  hold() {
    if (this.sheet) return;
    this.isHolder = true;
    this.sheet = this.sheetOf(`#${this.color.getHexString()}`);
  }

  /** @param {string} color */
  sheetOf(color) {
    const material = new THREE.MeshLambertMaterial({
      color, flatShading: true, side: THREE.DoubleSide, clippingPlanes: this.cuts, transparent: true, opacity: 0.3, depthWrite: false,
    });
    const sheet = new THREE.Mesh(this.shape.surface, material);
    sheet.frustumCulled = false;
    this.group.add(sheet);
    return sheet;
  }

  /** Puts it where it stands in a frame. @param {number} frame @param {number} scale of the frame's numbers */
  stand(frame, scale) {
    const at = placeIn(this.frames, frame);
    this.isHere = at >= 0;
    this.group.visible = this.isHere && !this.isHidden;
    if (!this.isHere) return;
    const pose = this.poses.subarray(7 * at, 7 * at + 7);
    const turn = new THREE.Quaternion(pose[0], pose[1], pose[2], pose[3]).normalize();
    const ratio = this.shape.scale / scale;
    // The translation of the pose is already that of the mesh's origin.
    this.group.matrix.compose(new THREE.Vector3(pose[4], pose[5], pose[6]), turn,
                              new THREE.Vector3(ratio, ratio, ratio));
    this.group.matrixWorldNeedsUpdate = true;
    this.group.updateMatrixWorld(true);
  }

  /** @param {ArrayLike<number>} triangles */
  mark(triangles) {
    for (const mesh of [...this.marked.children]) {
      this.marked.remove(mesh);
      if (mesh instanceof THREE.Mesh) mesh.geometry.dispose();
    }
    if (triangles.length === 0) return;
    const geometry = new THREE.BufferGeometry();
    geometry.setAttribute('position', new THREE.BufferAttribute(this.shape.corners(triangles), 3));
    const front = new THREE.Mesh(geometry, markedMaterial(this.cuts));
    const through = new THREE.Mesh(geometry, throughMaterial(this.cuts));
    through.renderOrder = 2;
    for (const mesh of [front, through]) mesh.frustumCulled = false;
    this.marked.add(front, through);
  }

  /**
   * The plane within a closed body that a cut lays open.
   * @param {number} order of this body among all @param {THREE.Scene} scene @param {THREE.Box3} box around everything
   */
  fill(order, scene, box) {
    const [plane] = this.cuts;
    const isFilled = plane !== undefined && this.group.visible && this.shape.isClosed && !this.shape.isBoundless;
    if (isFilled && !this.cap) {
      this.cap = new Cap(this.shape.surface, this.color, this.cuts, order);
      this.group.add(this.cap.counts);
      scene.add(this.cap.plane);
    }
    this.cap?.show(isFilled);
    if (isFilled) this.cap?.lay(plane, box);
  }

  /** The point of its bounding ball that is nearest to the eye. @param {THREE.Vector3} eye */
  nearestTo(eye) {
    const ball = this.shape.surface.boundingSphere?.clone().applyMatrix4(this.group.matrix) ?? new THREE.Sphere();
    const sight = eye.clone().sub(ball.center);
    return ball.center.addScaledVector(sight.normalize(), Math.min(ball.radius, sight.length()));
  }

  /** Pixels of the longest side of the mesh's box, where a unit has some. @param {number} pixels */
  longest(pixels) {
    return pixels * this.group.matrix.getMaxScaleOnAxis() * this.shape.longest;
  }

  /**
   * @param {{pixels: number, nearest: number, cell: number, hasEdges: boolean, hasMarks: boolean, hasGlass: boolean}} look `pixels` of a
   *   unit at what is looked at, and at the body's `nearest` point; `cell`: so many of them may become one, 0 none
   * @param {import('./batches.js').Batches} batches that draw it
   */
  dress({pixels, nearest, cell, hasEdges, hasMarks, hasGlass}, batches) {
    this.marked.visible = hasMarks;
    const {shape, group: {matrix}} = this;
    if (this.sheet) this.sheet.visible = hasGlass || !this.isHolder;
    if (this.sheet?.visible) {
      this.isCoarse = false;
      if (this.isHolder && hasEdges) batches.addLines(shape.sharp, matrix, 0.6);
      return;
    }
    const whole = this.longest(nearest);
    const surface = shape.surfaceFor(cell > 0 ? levelFor(whole, cell) : kGrids.length);
    this.isCoarse = surface !== shape.surface;
    batches.addSurface(surface, matrix, this.screenColor);
    if (!hasEdges || (this.isCoarse && (cell > 1 || whole < kLeastForEdges))) return;
    const size = pixels * matrix.getMaxScaleOnAxis() * shape.typicalEdge;
    const part = (/** @type {number} */ from, /** @type {number} */ long) => Math.min(1, Math.max(0, (size - from) / long));
    batches.addLines(shape.sharp, matrix, 0.25 + 0.5 * part(1, 6));
    // Edges of triangles that are too small to be told apart would make the surface black.
    batches.addLines(shape.flat, matrix, 0.28 * part(7, 14));
  }
}

/**
 * The face of a cut through a closed body: its back faces behind the plane are counted up, its front faces down, and
 * where the count is not 0 the plane is inside.
 */
class Cap {
  /**
   * @param {THREE.BufferGeometry} surface @param {THREE.Color} color @param {THREE.Plane[]} cuts
   * @param {number} order
   */
  constructor(surface, color, cuts, order) {
    this.counts = new THREE.Group();
    for (const [side, count] of /** @type {const} */ ([[THREE.BackSide, THREE.IncrementWrapStencilOp],
                                                       [THREE.FrontSide, THREE.DecrementWrapStencilOp]])) {
      const material = new THREE.MeshBasicMaterial({side, clippingPlanes: cuts});
      Object.assign(material, {
        depthTest: false, depthWrite: false, colorWrite: false, stencilWrite: true, stencilFunc: THREE.AlwaysStencilFunc,
        stencilFail: count, stencilZFail: count, stencilZPass: count,
      });
      const mesh = new THREE.Mesh(surface, material);
      mesh.frustumCulled = false;
      mesh.renderOrder = -2 - order;
      this.counts.add(mesh);
    }
    const material = new THREE.MeshBasicMaterial({color: color.clone().multiplyScalar(0.62), side: THREE.DoubleSide});
    Object.assign(material, {
      stencilWrite: true, stencilFunc: THREE.NotEqualStencilFunc, stencilFail: THREE.ZeroStencilOp,
      stencilZFail: THREE.ZeroStencilOp, stencilZPass: THREE.ZeroStencilOp,
    });
    this.plane = new THREE.Mesh(new THREE.PlaneGeometry(2, 2), material);
    this.plane.frustumCulled = false;
    this.plane.renderOrder = -1.5 - order;
  }

  /** @param {boolean} isShown */
  show(isShown) {
    this.counts.visible = this.plane.visible = isShown;
  }

  /** @param {THREE.Plane} plane @param {THREE.Box3} box around everything */
  lay(plane, box) {
    const ball = box.getBoundingSphere(new THREE.Sphere());
    plane.projectPoint(ball.center, this.plane.position);
    this.plane.quaternion.setFromUnitVectors(new THREE.Vector3(0, 0, 1), plane.normal);
    this.plane.scale.setScalar(Math.max(ball.radius * 1.5, 1e-6));
  }
}

/** @param {THREE.Plane[]} cuts */
function markedMaterial(cuts) {
  return new THREE.MeshLambertMaterial({
    color: kMarked,
    emissive: kMarked,
    emissiveIntensity: 0.35,
    flatShading: true,
    side: THREE.DoubleSide,
    clippingPlanes: cuts,
  });
}

/** What is behind something else shines through. @param {THREE.Plane[]} cuts */
function throughMaterial(cuts) {
  return new THREE.MeshBasicMaterial({
    color: kMarked,
    transparent: true,
    opacity: 0.22,
    depthFunc: THREE.GreaterDepth,
    depthWrite: false,
    side: THREE.DoubleSide,
    clippingPlanes: cuts,
  });
}
