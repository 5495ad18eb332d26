// @ts-check
// Surfaces and edges as they are drawn: bodies that have the same triangles make one call, however many they are.

import * as THREE from 'three';
import {kBrightness} from './colors.js';
import {surfaceMaterial} from './shading.js';

/** Lines have this many opacities between none and full: each is a call. */
const kOpacities = 16;
const kLeastRoom = 8;

/** Lines of which many stand about: three.js draws whatever says that it is instanced so. */
class ManyLines extends THREE.LineSegments {
  /** @param {THREE.BufferGeometry} geometry @param {THREE.Material} material */
  constructor(geometry, material) {
    super(geometry, material);
    this.isInstancedMesh = true;
    this.instanceMatrix = new THREE.InstancedBufferAttribute(new Float32Array(0), 16);
    /** @type {THREE.InstancedBufferAttribute|null} */
    this.instanceColor = null;
    this.morphTexture = null;
    this.count = 0;
  }
}

/** All that stand about of one geometry. */
class Batch {
  /** @param {THREE.InstancedMesh|ManyLines} drawn */
  constructor(drawn) {
    this.drawn = drawn;
    this.drawn.frustumCulled = false;
    this.drawn.matrixAutoUpdate = false;
    this.room = 0;
    this.count = 0;
  }

  /** @param {number} count */
  reserve(count) {
    if (count <= this.room) return;
    this.room = Math.max(kLeastRoom, 2 * this.room, count);
    const {drawn} = this, matrices = new Float32Array(16 * this.room);
    matrices.set(drawn.instanceMatrix.array);
    // What the card has of the old ones goes with them.
    drawn.dispatchEvent(/** @type {any} */ ({type: 'dispose'}));
    drawn.instanceMatrix = new THREE.InstancedBufferAttribute(matrices, 16);
    drawn.instanceMatrix.setUsage(THREE.DynamicDrawUsage);
    if (drawn instanceof ManyLines) return;
    const colors = new Float32Array(3 * this.room);
    colors.set(drawn.instanceColor?.array ?? []);
    drawn.instanceColor = new THREE.InstancedBufferAttribute(colors, 3);
    drawn.instanceColor.setUsage(THREE.DynamicDrawUsage);
  }

  /** @param {THREE.Matrix4} matrix @param {THREE.Color|null} color */
  add(matrix, color) {
    this.reserve(this.count + 1);
    matrix.toArray(this.drawn.instanceMatrix.array, 16 * this.count);
    if (color && this.drawn.instanceColor) color.toArray(this.drawn.instanceColor.array, 3 * this.count);
    ++this.count;
  }

  end() {
    const {drawn} = this;
    drawn.count = this.count;
    drawn.visible = this.count > 0;
    this.count = 0;
    drawn.instanceMatrix.needsUpdate = true;
    if (drawn.instanceColor) drawn.instanceColor.needsUpdate = true;
  }
}

export class Batches {
  /** @param {THREE.Plane[]} cuts by which all is cut */
  constructor(cuts) {
    this.cuts = cuts;
    this.group = new THREE.Group();
    this.up = new THREE.Vector3();
    this.material = surfaceMaterial(cuts, this.up);
    /** @type {THREE.LineBasicMaterial[]} by opacity */
    this.inks = [];
    /** @type {Map<THREE.BufferGeometry, Batch>} */
    this.surfaces = new Map();
    /** @type {Map<THREE.BufferGeometry, Batch>[]} by opacity */
    this.lines = [];
  }

  /** @param {boolean} isDark */
  paint(isDark) {
    this.material.uniforms.brightness.value = kBrightness[isDark ? 'dark' : 'light'];
  }

  /** @param {THREE.BufferGeometry} geometry @param {THREE.Matrix4} matrix @param {THREE.Color} color as the screen has it */
  addSurface(geometry, matrix, color) {
    let batch = this.surfaces.get(geometry);
    if (!batch) {
      batch = this.begin(new THREE.InstancedMesh(geometry, this.material, 0));
      this.surfaces.set(geometry, batch);
    }
    batch.add(matrix, color);
  }

  /** @param {THREE.BufferGeometry} geometry @param {THREE.Matrix4} matrix @param {number} opacity none are drawn at 0 */
  addLines(geometry, matrix, opacity) {
    const step = Math.round(opacity * kOpacities);
    if (step <= 0) return;
    const ofOpacity = this.lines[step] ??= new Map();
    let batch = ofOpacity.get(geometry);
    if (!batch) {
      this.inks[step] ??= new THREE.LineBasicMaterial(
          {color: '#10202e', transparent: true, opacity: step / kOpacities, clippingPlanes: this.cuts});
      batch = this.begin(new ManyLines(geometry, this.inks[step]));
      ofOpacity.set(geometry, batch);
    }
    batch.add(matrix, null);
  }

  /** @param {THREE.InstancedMesh|ManyLines} drawn */
  begin(drawn) {
    this.group.add(drawn);
    return new Batch(drawn);
  }

  /** What was added since the last time is all that is drawn. @param {THREE.Camera} camera */
  end(camera) {
    this.up.copy(camera.up).transformDirection(camera.matrixWorldInverse);
    for (const batch of this.surfaces.values()) batch.end();
    for (const ofOpacity of this.lines)
      for (const batch of ofOpacity?.values() ?? []) batch.end();
  }
}
