// @ts-check
// The picture: bodies and marks of a frame, seen by a camera that mouse, fingers and keys turn.

import * as THREE from 'three';
import {OrbitControls} from 'three/examples/jsm/controls/OrbitControls.js';
import {MeshShape, ShownBody} from './bodies.js';
import {Batches} from './batches.js';
import {TreeBoxes} from './boxes.js';
import {kPalette} from './colors.js';
import {placeIn} from './frames.js';
import {findHolders} from './holders.js';
import {FrameMarks} from './marks.js';
import {firstTriangle, meetsBall} from './pick.js';
import {Quality} from './quality.js';
import {SmoothPicture, contextOf, isSoftware} from './software.js';

/** @typedef {{axis: 'x'|'y'|'z', at: number, isFlipped: boolean}} Cut */
/** @typedef {'edges'|'triangles'|'curves'|'contacts'|'gaps'|'planes'|'labels'|'glass'} Layer */

const kAxes = /** @type {const} */ (['x', 'y', 'z']);
/** Milliseconds without a motion after which it is finer. */
const kStillAfter = 600;
/** From where a frame is looked at first. */
const kFirstSight = new THREE.Vector3(0.62, -1, 0.62).normalize();

export class Stage {
  /**
   * @param {HTMLCanvasElement} canvas @param {import('./unpack.js').PageData} page
   * @param {import('./unpack.js').Arrays} arrays
   */
  constructor(canvas, page, arrays) {
    this.canvas = canvas;
    this.page = page;
    this.arrays = arrays;
    this.frame = 0;
    /** @type {Set<Layer>} */
    this.layers = new Set(['edges', 'triangles', 'curves', 'contacts', 'gaps', 'planes', 'labels', 'glass']);
    /** @type {Cut|null} */
    this.cut = null;
    /** @type {() => void} called after each picture */
    this.onDrawn = () => {};
    /** @type {() => {top: number, bottom: number}} pixels of the canvas that words cover from side to side */
    this.covered = () => ({top: 0, bottom: 0});
    /** @type {() => void} called when the user has turned the camera */
    this.onTurned = () => {};
    // Where a processor draws, smooth borders cost as much as all the rest: only what stands still has them.
    this.smooth = isSoftware() ? new SmoothPicture() : null;
    this.renderer = new THREE.WebGLRenderer({canvas, context: contextOf(canvas, !this.smooth)});
    this.renderer.localClippingEnabled = true;
    this.camera = new THREE.PerspectiveCamera(32, 1, 0.01, 100);
    this.camera.up.set(0, 0, 1);
    this.controls = new OrbitControls(this.camera, canvas);
    this.controls.enableDamping = false;
    this.controls.zoomToCursor = true;
    this.controls.addEventListener('change', () => {
      this.move();
      this.ask();
    });
    this.controls.addEventListener('end', () => this.onTurned());
    this.scene = new THREE.Scene();
    this.scene.add(new THREE.HemisphereLight('#ffffff', '#8a97a6', 1.5));
    this.lamp = new THREE.DirectionalLight('#ffffff', 2.1);
    this.scene.add(this.lamp, this.lamp.target);
    this.plane = new THREE.Plane();
    /** @type {THREE.Plane[]} shared by all materials; empty where nothing is cut */
    this.cuts = [];
    this.batches = new Batches(this.cuts);
    this.scene.add(this.batches.group);
    const shapes = page.meshes.map((_, m) => new MeshShape(page, arrays, m));
    this.bodies = page.bodies.map((body, b) => {
      const shown = new ShownBody(shapes[body.mesh], body.color ?? kPalette[b % kPalette.length],
                                  arrays.words(body.frames), arrays.floats(body.poses), this.cuts);
      this.scene.add(shown.group);
      return shown;
    });
    findHolders(this.bodies, page);
    this.marks = new FrameMarks();
    this.scene.add(this.marks.group);
    this.boxes = new TreeBoxes(page, arrays, this.bodies);
    this.isAsked = false;
    this.quality = new Quality();
    this.isMoving = false;
    this.isCoarse = false;
    this.stillTimer = 0;
    this.move();
  }

  /** @param {boolean} isDark */
  paint(isDark) {
    this.renderer.setClearColor(getComputedStyle(document.documentElement).getPropertyValue('--ground').trim());
    this.batches.paint(isDark);
    this.marks.paint(isDark);
    this.boxes.paint(isDark);
    this.ask();
  }

  /** @param {number} frame */
  show(frame) {
    const isElsewhere = this.page.frames[frame].place !== this.page.frames[this.frame].place;
    if (frame !== this.frame) this.move();
    this.frame = frame;
    const {scale} = this.page.places[this.page.frames[frame].place];
    for (const body of this.bodies) body.stand(frame, scale);
    for (const {body, frames, starts, list} of this.page.marks.triangles) {
      const at = placeIn(this.arrays.words(frames), frame), from = this.arrays.words(starts);
      this.bodies[body].mark(at < 0 ? [] : this.arrays.words(list).subarray(from[at], from[at + 1]));
    }
    this.marks.set(this.arrays, this.page.marks, frame);
    this.placeCut();
    if (isElsewhere) this.fit();
    this.ask();
  }

  /** @param {number} body @param {boolean} isHidden */
  hide(body, isHidden) {
    this.bodies[body].isHidden = isHidden;
    this.bodies[body].group.visible = this.bodies[body].isHere && !isHidden;
    this.ask();
  }

  /** @param {Cut|null} cut */
  setCut(cut) {
    this.cut = cut;
    this.placeCut();
    this.ask();
  }

  placeCut() {
    const had = this.cuts.length;
    this.cuts.length = 0;
    if (this.cut) {
      const {axis, at, isFlipped} = this.cut, i = kAxes.indexOf(axis);
      const box = this.bounds(() => true);
      const low = box.min.getComponent(i), high = box.max.getComponent(i), sign = isFlipped ? 1 : -1;
      this.plane.normal.set(0, 0, 0).setComponent(i, sign);
      this.plane.constant = -sign * (low + at * (high - low));
      this.cuts.push(this.plane);
    }
    if (had !== this.cuts.length)
      this.scene.traverse((object) => {
        if (object instanceof THREE.Mesh || object instanceof THREE.LineSegments) object.material.needsUpdate = true;
      });
  }

  /** Of the bodies that stand in the frame, but for those without an end. @param {(body: ShownBody) => boolean} counts */
  bounds(counts) {
    const box = new THREE.Box3();
    for (const body of this.bodies) {
      const own = body.shape.surface.boundingBox;
      if (body.isHere && !body.shape.isBoundless && counts(body) && own)
        box.union(own.clone().applyMatrix4(body.group.matrix));
    }
    if (box.isEmpty()) box.set(new THREE.Vector3(-1, -1, -1), new THREE.Vector3(1, 1, 1));
    return box;
  }

  /** Looks at all that is shown, from where it is looked at now. */
  fit() {
    const isAny = this.bodies.some((body) => body.isHere && !body.isHidden);
    this.frameBox(this.bounds((body) => !isAny || !body.isHidden));
  }

  /** @param {THREE.Box3} box */
  frameBox(box) {
    const ball = box.getBoundingSphere(new THREE.Sphere());
    const half = Math.tan(THREE.MathUtils.degToRad(this.camera.fov / 2)) * Math.min(this.center(), this.camera.aspect);
    const away = Math.max(ball.radius, 1e-6) / Math.sin(Math.atan(half)) * 1.02;
    const sight = this.camera.position.clone().sub(this.controls.target);
    if (sight.lengthSq() === 0) sight.copy(kFirstSight);
    this.controls.target.copy(ball.center);
    this.camera.position.copy(ball.center).addScaledVector(sight.normalize(), away);
    this.controls.update();
    this.ask();
  }

  /** Puts what is looked at into the middle of what no words cover. The part of the height that this is. */
  center() {
    const {clientWidth, clientHeight} = this.canvas, {top, bottom} = this.covered();
    const height = Math.max(1, clientHeight), isCovered = top + bottom > 0 && top + bottom < 0.6 * height;
    if (isCovered) this.camera.setViewOffset(clientWidth, height, 0, (bottom - top) / 2, clientWidth, height);
    else this.camera.clearViewOffset();
    return isCovered ? 1 - (top + bottom) / height : 1;
  }

  /** Looks at some bodies. @param {number[]} which */
  fitBodies(which) {
    this.frameBox(this.bounds((body) => which.includes(this.bodies.indexOf(body))));
  }

  /** @param {number|null} level of trees whose boxes are drawn */
  setLevel(level) {
    this.boxes.show(level);
    this.ask();
  }

  /** Goes near what is marked in this frame. Whether there is anything. */
  fitMarks() {
    const box = this.marks.bounds(this.arrays, this.page.marks, this.frame);
    if (box.isEmpty()) return false;
    const whole = this.bounds(() => true).getBoundingSphere(new THREE.Sphere()).radius;
    const size = box.getBoundingSphere(new THREE.Sphere()).radius;
    this.frameBox(box.expandByScalar(Math.max(0.5 * size, 0.05 * whole)));
    return true;
  }

  /** Turns about the target by angles, or moves nearer. @param {number} side @param {number} up @param {number} nearer */
  turn(side, up, nearer) {
    const sight = this.camera.position.clone().sub(this.controls.target);
    const ball = new THREE.Spherical().setFromVector3(new THREE.Vector3(sight.x, sight.z, -sight.y));
    ball.theta += side;
    ball.phi = Math.min(Math.PI - 0.01, Math.max(0.01, ball.phi + up));
    ball.radius *= nearer;
    const turned = new THREE.Vector3().setFromSpherical(ball);
    this.camera.position.copy(this.controls.target).add(new THREE.Vector3(turned.x, -turned.z, turned.y));
    this.controls.update();
    this.ask();
  }

  /** Moves target and camera, in parts of what is seen. @param {number} right @param {number} up */
  slide(right, up) {
    const away = this.camera.position.distanceTo(this.controls.target);
    const step = new THREE.Vector3(right, up, 0).multiplyScalar(away / 4).applyQuaternion(this.camera.quaternion);
    this.camera.position.add(step);
    this.controls.target.add(step);
    this.controls.update();
    this.ask();
  }

  /** @returns {number[]} eye and target */
  sight() {
    return [...this.camera.position.toArray(), ...this.controls.target.toArray()];
  }

  /** @param {number[]|undefined} sight */
  look(sight) {
    this.center();
    if (sight) {
      this.camera.position.fromArray(sight);
      this.controls.target.fromArray(sight, 3);
      this.controls.update();
    } else {
      this.camera.position.copy(kFirstSight);
      this.controls.target.set(0, 0, 0);
      this.fit();
    }
    this.ask();
  }

  /** @param {number} width @param {number} height of the canvas, pixels of the page */
  resize(width, height) {
    this.setResolution();
    this.renderer.setSize(width, height, false);
    this.camera.aspect = width / Math.max(1, height);
    this.center();
    this.draw();
  }

  /** A picture soon: many changes before it make one. */
  ask() {
    if (this.isAsked) return;
    this.isAsked = true;
    requestAnimationFrame(() => {
      if (this.isAsked) this.draw();
    });
  }

  /** Returns how long a pixel is at a point. @param {THREE.Vector3} at */
  pixelAt(at) {
    const away = Math.max(this.camera.near, at.clone().applyMatrix4(this.camera.matrixWorldInverse).z * -1);
    return 2 * Math.tan(THREE.MathUtils.degToRad(this.camera.fov / 2)) * away / Math.max(1, this.canvas.clientHeight);
  }

  /** Something moves: a picture that is coarser, and soon one that is finer. */
  move() {
    this.isMoving = true;
    clearTimeout(this.stillTimer);
    this.stillTimer = window.setTimeout(() => {
      this.isMoving = false;
      if (this.isCoarse || this.smooth || this.quality.resolution < 1) this.ask();
    }, kStillAfter);
  }

  /** @param {number} pixels of a unit at what is looked at */
  dressBodies(pixels) {
    const shown = this.bodies.filter((body) => body.group.visible).map((body) => {
      const nearest = 1 / this.pixelAt(body.nearestTo(this.camera.position));
      return {body, nearest, pixels: body.longest(nearest), countAt: (/** @type {number} */ level) => body.shape.countAt(level)};
    });
    // Near bodies are drawn first: what they cover then takes no time.
    shown.sort((a, b) => b.nearest - a.nearest);
    const cell = this.quality.cell(shown, this.isMoving);
    const look = {hasEdges: this.layers.has('edges'), hasMarks: this.layers.has('triangles'), hasGlass: this.layers.has('glass'),
                  cell, pixels};
    for (const {body, nearest} of shown) body.dress({...look, nearest}, this.batches);
    this.batches.end(this.camera);
    this.isCoarse = shown.some(({body}) => body.isCoarse);
  }

  /** Fewer pixels while something moves on a slow machine. */
  setResolution() {
    const full = Math.min(2, window.devicePixelRatio || 1);
    const ratio = this.isMoving ? full * this.quality.resolution : full;
    if (ratio !== this.renderer.getPixelRatio()) this.renderer.setPixelRatio(ratio);
  }

  /** As nothing that moves is drawn. */
  drawFine() {
    this.isMoving = false;
    this.draw();
  }

  /** Measures how long pictures take while something moves: from one to the next, for the card draws when it can. */
  measure() {
    if (!this.isMoving) return;
    const began = performance.now();
    requestAnimationFrame(() => requestAnimationFrame(() => this.quality.took((performance.now() - began) / 2)));
  }

  draw() {
    this.isAsked = false;
    this.setResolution();
    const box = this.bounds(() => true);
    const ball = box.getBoundingSphere(new THREE.Sphere());
    const away = this.camera.position.distanceTo(ball.center);
    const near = this.camera.position.distanceTo(this.controls.target);
    const reach = Math.max(ball.radius * 3, 1e-6);
    this.camera.near = Math.max(near * 2e-3, away - reach);
    this.camera.far = Math.max(away + reach, this.camera.near * 2);
    this.camera.updateProjectionMatrix();
    this.camera.updateMatrixWorld();
    this.lamp.position.copy(this.camera.position)
        .add(new THREE.Vector3(-0.35, 0.5, 0).multiplyScalar(near).applyQuaternion(this.camera.quaternion));
    this.lamp.target.position.copy(this.controls.target);
    const pixels = 1 / this.pixelAt(this.controls.target);
    this.dressBodies(pixels);
    for (const [b, body] of this.bodies.entries()) body.fill(b, this.scene, box);
    this.marks.curves.group.visible = this.layers.has('curves');
    this.marks.words.visible = this.layers.has('labels');
    this.marks.planes.group.visible = this.layers.has('planes');
    this.marks.contacts.visible = this.layers.has('contacts');
    this.marks.gapGroup.visible = this.layers.has('gaps');
    if (this.layers.has('contacts')) this.marks.point((at) => this.pixelAt(at));
    if (this.smooth && !this.isMoving) this.smooth.draw(this.renderer, this.scene, this.camera);
    else this.renderer.render(this.scene, this.camera);
    this.measure();
    this.onDrawn();
  }

  /**
   * Returns what is seen at a place of the canvas.
   * @param {number} x @param {number} y pixels from its left upper corner
   * @returns {{body: number, triangle: number, at: THREE.Vector3, world: number[]}|null}
   */
  pick(x, y) {
    const eye = this.camera.position;
    const through = new THREE.Vector3(2 * x / this.canvas.clientWidth - 1, 1 - 2 * y / this.canvas.clientHeight, 0.5)
                        .unproject(this.camera);
    const direction = through.sub(eye).normalize();
    let best = null, nearest = Infinity;
    const toOwn = new THREE.Matrix4(), from = new THREE.Vector3(), along = new THREE.Vector3();
    for (const [b, body] of this.bodies.entries()) {
      const ball = body.shape.surface.boundingSphere;
      if (!body.group.visible || !ball || body.sheet?.visible) continue;
      toOwn.copy(body.group.matrix).invert();
      from.copy(eye).applyMatrix4(toOwn);
      along.copy(direction).add(eye).applyMatrix4(toOwn).sub(from);
      if (!meetsBall(ball.center.toArray(), ball.radius, from.toArray(), along.toArray())) continue;
      const isSeen = (/** @type {number} */ t) =>
          t < nearest && this.cuts.every((cut) => cut.distanceToPoint(eye.clone().addScaledVector(direction, t)) >= 0);
      const hit = firstTriangle(body.shape.positions, body.shape.triangles, from.toArray(), along.toArray(), isSeen);
      if (hit && hit.t < nearest) {
        nearest = hit.t;
        best = {body: b, triangle: hit.triangle};
      }
    }
    if (!best) return null;
    const at = eye.clone().addScaledVector(direction, nearest);
    return {...best, at, world: this.worldOf(at)};
  }

  /** The numbers of the world, for those of a frame. @param {THREE.Vector3} at */
  worldOf(at) {
    const {center, scale} = this.page.places[this.page.frames[this.frame].place];
    return at.toArray().map((x, i) => center[i] + scale * x);
  }

  /** Returns where a point is on the canvas, or null if it is behind the eye. @param {THREE.Vector3} at */
  onCanvas(at) {
    const seen = at.clone().project(this.camera);
    if (seen.z > 1 || seen.z < -1) return null;
    return {x: (seen.x + 1) / 2 * this.canvas.clientWidth, y: (1 - seen.y) / 2 * this.canvas.clientHeight};
  }

  /** The length of the page's unit that a pixel at the target has. */
  unitsOfPixel() {
    return this.pixelAt(this.controls.target) * this.page.places[this.page.frames[this.frame].place].scale;
  }
}
