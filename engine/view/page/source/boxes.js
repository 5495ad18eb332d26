// @ts-check
// Boxes around parts of bodies, a level of a tree at a time: lines that go with the body.

import * as THREE from 'three';
import {kMarks} from './colors.js';
import {boxEdges} from './edges.js';

export class TreeBoxes {
  /**
   * @param {import('./unpack.js').PageData} page @param {import('./unpack.js').Arrays} arrays
   * @param {import('./bodies.js').ShownBody[]} bodies
   */
  constructor(page, arrays, bodies) {
    this.material = new THREE.LineBasicMaterial({transparent: true, opacity: 0.8});
    this.levels = page.marks.boxes.map(({body, level, list}) => {
      const lines = new THREE.LineSegments(new THREE.BufferGeometry(), this.material);
      lines.geometry.setAttribute('position', new THREE.BufferAttribute(boxEdges(arrays.floats(list)), 3));
      lines.frustumCulled = false;
      lines.visible = false;
      bodies[body].group.add(lines);
      return {level, lines, count: arrays.floats(list).length / 12};
    });
    /** The number of levels. */
    this.depth = this.levels.reduce((most, {level}) => Math.max(most, level + 1), 0);
    /** @type {number|null} */
    this.level = null;
  }

  /** @param {boolean} isDark */
  paint(isDark) {
    this.material.color.set(kMarks[isDark ? 'dark' : 'light'].box);
  }

  /** @param {number|null} level */
  show(level) {
    this.level = level === null || level >= this.depth ? null : level;
    for (const each of this.levels) each.lines.visible = each.level === this.level;
  }

  /** Returns the number of boxes of the level that is shown. */
  count() {
    return this.levels.reduce((sum, {level, count}) => sum + (level === this.level ? count : 0), 0);
  }
}
