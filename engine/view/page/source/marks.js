// @ts-check
// Curves, lines, contacts and gaps of one frame. They are seen through bodies, paler there.

import * as THREE from 'three';
import {LineMaterial} from 'three/examples/jsm/lines/LineMaterial.js';
import {LineSegments2} from 'three/examples/jsm/lines/LineSegments2.js';
import {LineSegmentsGeometry} from 'three/examples/jsm/lines/LineSegmentsGeometry.js';
import {kMarks} from './colors.js';
import {marksOf} from './frames.js';

/** @typedef {import('./unpack.js').Arrays} Arrays */

/** Pixels that a normal has at least, so that one sees where it points however shallow the contact. */
const kLeastNormal = 30;
/** So many contacts are drawn as large as that; more are smaller, and those that are hidden are not seen through. */
const kFewContacts = 60;
const kContactDot = 9, kTip = 11;

/** Thick lines, and the same where they are hidden. */
class Lines {
  /** @param {number} pixels @param {number} through opacity where something is before them */
  constructor(pixels, through) {
    this.front = new LineMaterial({linewidth: pixels});
    this.behind = new LineMaterial({linewidth: pixels, transparent: true, opacity: through, depthWrite: false});
    this.behind.depthFunc = THREE.GreaterDepth;
    // Each pixel once: the ends of pale lines would else be darker where they meet.
    Object.assign(this.behind, {
      stencilWrite: true, stencilRef: 1, stencilFunc: THREE.NotEqualStencilFunc, stencilZPass: THREE.ReplaceStencilOp,
    });
    this.group = new THREE.Group();
  }

  /** @param {string} color */
  paint(color) {
    this.front.color.set(color);
    this.behind.color.set(color);
  }

  /** @param {ArrayLike<number>} ends six numbers a line */
  set(ends) {
    for (const line of [...this.group.children]) {
      this.group.remove(line);
      if (line instanceof LineSegments2) line.geometry.dispose();
    }
    if (ends.length === 0) return;
    const geometry = new LineSegmentsGeometry();
    geometry.setPositions(ends instanceof Float32Array ? ends : new Float32Array(ends));
    for (const material of [this.front, this.behind]) {
      const line = new LineSegments2(geometry, material);
      line.frustumCulled = false;
      line.renderOrder = 3;
      this.group.add(line);
    }
  }
}

/** Discs of one size on the screen, over everything. */
class Dots {
  /** @param {number} pixels */
  constructor(pixels) {
    this.material = new THREE.PointsMaterial(
        {size: pixels, sizeAttenuation: false, depthTest: false, transparent: true, map: disc(), alphaTest: 0.1});
    this.points = new THREE.Points(new THREE.BufferGeometry(), this.material);
    this.points.frustumCulled = false;
    this.points.renderOrder = 5;
  }

  /** @param {number[]} at three numbers a dot */
  set(at) {
    this.points.geometry.dispose();
    this.points.geometry = new THREE.BufferGeometry();
    this.points.geometry.setAttribute('position', new THREE.Float32BufferAttribute(at, 3));
  }
}

function disc() {
  const canvas = document.createElement('canvas');
  canvas.width = canvas.height = 64;
  const pen = canvas.getContext('2d');
  if (pen) {
    pen.fillStyle = '#fff';
    pen.beginPath();
    pen.arc(32, 32, 30, 0, 2 * Math.PI);
    pen.fill();
  }
  return new THREE.CanvasTexture(canvas);
}

/** Squares that one sees through, with their borders. */
class Planes {
  constructor() {
    this.material = new THREE.MeshBasicMaterial({transparent: true, opacity: 0.18, side: THREE.DoubleSide, depthWrite: false});
    this.borders = new Lines(1.5, 0.5);
    this.squares = new THREE.Group();
    this.group = new THREE.Group();
    this.group.add(this.squares, this.borders.group);
  }

  /** @param {string} color */
  paint(color) {
    this.material.color.set(color);
    this.borders.paint(color);
  }

  /** @param {Float32Array} numbers of each a point, a unit normal, half of the side */
  set(numbers) {
    for (const square of [...this.squares.children]) {
      this.squares.remove(square);
      if (square instanceof THREE.Mesh) square.geometry.dispose();
    }
    const ends = [], corner = new THREE.Vector3();
    for (let i = 0; i < numbers.length; i += 7) {
      const square = new THREE.Mesh(new THREE.PlaneGeometry(2, 2), this.material);
      square.position.fromArray(numbers, i);
      square.quaternion.setFromUnitVectors(new THREE.Vector3(0, 0, 1), new THREE.Vector3().fromArray(numbers, i + 3));
      square.scale.setScalar(numbers[i + 6]);
      square.updateMatrix();
      square.frustumCulled = false;
      square.renderOrder = 2;
      this.squares.add(square);
      const around = [[-1, -1], [1, -1], [1, 1], [-1, 1]].map(([x, y]) => corner.set(x, y, 0).applyMatrix4(square.matrix).toArray());
      for (let k = 0; k < 4; ++k) ends.push(...around[k], ...around[(k + 1) % 4]);
    }
    this.borders.set(ends);
  }
}

export class FrameMarks {
  constructor() {
    this.curves = new Lines(3, 0.4);
    this.lines = new Lines(2, 0.3);
    this.depths = new Lines(5, 0.6);
    this.normals = new Lines(2, 0.6);
    this.gaps = new Lines(3, 0.6);
    this.contactDots = new Dots(kContactDot);
    this.gapDots = new Dots(8);
    this.dots = new Dots(8);
    this.planes = new Planes();
    this.tips = new THREE.InstancedMesh(new THREE.ConeGeometry(0.32, 1, 12),
                                        new THREE.MeshBasicMaterial({depthTest: false, transparent: true}), 1);
    this.tips.frustumCulled = false;
    this.tips.renderOrder = 4;
    this.contacts = new THREE.Group();
    this.contacts.add(this.depths.group, this.normals.group, this.tips, this.contactDots.points);
    this.gapGroup = new THREE.Group();
    this.gapGroup.add(this.gaps.group, this.gapDots.points);
    this.group = new THREE.Group();
    this.words = new THREE.Group();
    this.words.add(this.lines.group, this.dots.points);
    this.group.add(this.curves.group, this.words, this.contacts, this.gapGroup, this.planes.group);
    /** Of the size of few contacts. */
    this.part = 1;
    this.isCrowd = false;
    /** @type {Float32Array} */
    this.contactNumbers = new Float32Array();
    /** @type {Float32Array} */
    this.gapNumbers = new Float32Array();
  }

  /** @param {boolean} isDark */
  paint(isDark) {
    const {curve, contact, gap, line} = kMarks[isDark ? 'dark' : 'light'];
    this.curves.paint(curve);
    this.lines.paint(line);
    this.dots.material.color.set(line);
    this.planes.paint(gap);
    this.depths.paint(contact);
    this.normals.paint(contact);
    /** @type {THREE.MeshBasicMaterial} */ (this.tips.material).color.set(contact);
    this.contactDots.material.color.set(contact);
    this.gaps.paint(gap);
    this.gapDots.material.color.set(gap);
  }

  /**
   * @param {Arrays} arrays @param {import('./unpack.js').PageData['marks']} marks @param {number} frame
   */
  set(arrays, marks, frame) {
    this.curves.set(marksOf(arrays, marks.curves, 6, frame));
    this.lines.set(marksOf(arrays, marks.lines, 6, frame));
    this.dots.set([...marksOf(arrays, marks.points, 3, frame)]);
    this.planes.set(marksOf(arrays, marks.planes, 7, frame));
    this.contactNumbers = marksOf(arrays, marks.contacts, 7, frame);
    this.gapNumbers = marksOf(arrays, marks.gaps, 7, frame);
    const depths = [], dots = [], gaps = [], gapDots = [];
    for (let i = 0; i < this.contactNumbers.length; i += 7) {
      const [x, y, z, nx, ny, nz, depth] = this.contactNumbers.subarray(i, i + 7);
      const half = depth / 2;
      depths.push(x - half * nx, y - half * ny, z - half * nz, x + half * nx, y + half * ny, z + half * nz);
      dots.push(x, y, z);
    }
    for (let i = 0; i < this.gapNumbers.length; i += 7) {
      gaps.push(...this.gapNumbers.subarray(i, i + 6));
      gapDots.push(...this.gapNumbers.subarray(i, i + 6));
    }
    this.depths.set(depths);
    this.contactDots.set(dots);
    this.gaps.set(gaps);
    this.gapDots.set(gapDots);
    const count = this.contactNumbers.length / 7;
    this.shrink(count);
    if (this.tips.instanceMatrix.count < count) {
      this.tips.dispose();
      this.tips.instanceMatrix = new THREE.InstancedBufferAttribute(new Float32Array(16 * count), 16);
    }
    this.tips.count = count;
  }

  /**
   * Around curves, points, contacts and gaps of a frame.
   * @param {Arrays} arrays @param {import('./unpack.js').PageData['marks']} marks @param {number} frame
   */
  bounds(arrays, marks, frame) {
    const box = new THREE.Box3(), at = new THREE.Vector3(), ends = marksOf(arrays, marks.curves, 6, frame);
    for (let i = 0; i < ends.length; i += 3) box.expandByPoint(at.fromArray(ends, i));
    const points = marksOf(arrays, marks.points, 3, frame);
    for (let i = 0; i < points.length; i += 3) box.expandByPoint(at.fromArray(points, i));
    for (let i = 0; i < this.contactNumbers.length; i += 7) box.expandByPoint(at.fromArray(this.contactNumbers, i));
    for (let i = 0; i < this.gapNumbers.length; i += 7)
      for (const end of [0, 3]) box.expandByPoint(at.fromArray(this.gapNumbers, i + end));
    return box;
  }

  /** Thousands of contacts would hide what they are of. @param {number} count */
  shrink(count) {
    this.part = Math.min(1, Math.max(0.3, Math.sqrt(kFewContacts / Math.max(1, count))));
    this.isCrowd = count > 4 * kFewContacts;
    const materials = [this.contactDots.material, /** @type {THREE.MeshBasicMaterial} */ (this.tips.material)];
    for (const material of materials) material.depthTest = this.isCrowd;
    this.contactDots.material.size = kContactDot * this.part;
    for (const lines of [this.depths, this.normals]) lines.behind.visible = !this.isCrowd;
  }

  /**
   * Normals long enough to be seen.
   * @param {(at: THREE.Vector3) => number} unitOf the length of a pixel at a point
   */
  point(unitOf) {
    const ends = [];
    const at = new THREE.Vector3(), normal = new THREE.Vector3(), up = new THREE.Vector3(0, 1, 0);
    for (let i = 0; i < this.contactNumbers.length; i += 7) {
      const numbers = this.contactNumbers.subarray(i, i + 7);
      at.fromArray(numbers);
      normal.fromArray(numbers, 3);
      const pixel = unitOf(at);
      const long = Math.max(numbers[6] / 2, kLeastNormal * this.part * pixel);
      ends.push(at.x, at.y, at.z, at.x + long * normal.x, at.y + long * normal.y, at.z + long * normal.z);
      at.addScaledVector(normal, long);
      const size = kTip * this.part * pixel;
      this.tips.setMatrixAt(i / 7, new THREE.Matrix4().compose(at, new THREE.Quaternion().setFromUnitVectors(up, normal),
                                                               new THREE.Vector3(size, size, size)));
    }
    this.tips.instanceMatrix.needsUpdate = true;
    this.normals.set(ends);
  }
}
