// @ts-check
// The list of bodies, the layers and the cut.

import {element} from './overlay.js';
import {kPalette} from './colors.js';

/** @typedef {import('./stage.js').Layer} Layer */

/** @type {[Layer, string, string][]} */
const kLayers = [
  ['triangles', 'intersecting triangles', '<path d="M4 12 11 2l7 10z" fill="#d3203c" stroke="none"/>'],
  ['curves', 'curves of intersection', '<path d="M2 10C8-2 13 16 20 4" stroke-width="2.500"/>'],
  ['contacts', 'contacts, normals, depths', '<path d="M4 11 15 4M15 4l-5 .5M15 4l-2 4.500" style="stroke:var(--contact)"/>'],
  ['gaps', 'nearest points, gap', '<path d="M3 7h16M3 3v8M19 3v8" style="stroke:var(--gap)"/>'],
  ['edges', 'edges', '<path d="M3 11 8 2l11 3-5 7z" stroke-width="1.300"/>'],
  ['glass', 'see into containers', '<path d="M3 2h16l-3 10H6z" fill="currentColor" fill-opacity=".15" stroke-width="1.300"/>'],
  ['planes', 'separating planes', '<path d="M4 10 9 3h10l-5 7z" style="stroke:var(--gap);fill:var(--gap);fill-opacity:.25"/>'],
  ['labels', 'lines, points, words', '<path d="M4 3h13M10.500 3v9"/>'],
];

/**
 * Returns whether any frame has some of it.
 * @param {Layer} layer @param {import('./stage.js').Stage} stage
 */
function isEver(layer, {page: {marks}, arrays, bodies}) {
  if (layer === 'glass') return bodies.some(({isHolder}) => isHolder);
  if (layer === 'triangles') return marks.triangles.length > 0;
  if (layer === 'labels') return marks.labels.length > 0 || [marks.lines, marks.points].some(({list}) => arrays.words(list).length > 0);
  return layer === 'edges' || arrays.words(marks[layer].list).length > 0;
}

export class Panel {
  /**
   * @param {import('./stage.js').Stage} stage @param {() => void} onChange
   * @param {(body: number) => void} goTo
   */
  constructor(stage, onChange, goTo) {
    this.stage = stage;
    this.goTo = goTo;
    this.onChange = onChange;
    this.rows = stage.page.bodies.map((body, b) => this.row(body, b));
    this.boxes = new Map(kLayers.map(([layer, name, icon]) => [layer, this.layer(layer, name, icon)]));
    for (const button of this.axisButtons())
      button.addEventListener('click', () => this.setCut(button.dataset.axis ?? ''));
    element('flip').addEventListener('click', () => this.flip());
    element('tree-section').hidden = stage.boxes.depth === 0;
    const level = /** @type {HTMLInputElement} */ (element('level'));
    level.max = String(stage.boxes.depth);
    level.addEventListener('input', () => this.showLevel(Number(level.value) - 1 < 0 ? null : Number(level.value) - 1));
    this.slider = /** @type {HTMLInputElement} */ (element('cut-at'));
    this.slider.addEventListener('input', () => {
      if (stage.cut) stage.setCut({...stage.cut, at: Number(this.slider.value)});
      onChange();
    });
  }

  /** @param {import('./unpack.js').BodyData} body @param {number} b */
  row(body, b) {
    const item = document.createElement('li');
    const box = document.createElement('input');
    box.type = 'checkbox';
    box.checked = true;
    box.setAttribute('aria-label', `Show ${body.name}`);
    const swatch = document.createElement('span');
    swatch.className = 'swatch';
    swatch.style.background = body.color ?? kPalette[b % kPalette.length];
    const name = document.createElement('button');
    name.className = 'name';
    name.textContent = body.name;
    name.title = `${body.name}: go near`;
    name.addEventListener('click', () => {
      if (this.stage.bodies[b].isHidden) this.hide(b, false);
      this.goTo(b);
    });
    const size = document.createElement('small');
    const triangles = this.stage.bodies[b].shape.triangles.length / 3;
    size.textContent = `${triangles.toLocaleString('en')} triangle${triangles === 1 ? '' : 's'}`;
    name.append(size);
    const only = document.createElement('button');
    only.textContent = 'only';
    only.title = `Only ${body.name}; again: all`;
    box.addEventListener('change', () => this.hide(b, !box.checked));
    only.addEventListener('click', () => this.isolate([b]));
    item.append(box, swatch, name, only);
    element('bodies').append(item);
    return {item, box, isHere: true};
  }

  /** @param {Layer} layer @param {string} name @param {string} icon of this file, never of the data */
  layer(layer, name, icon) {
    const label = document.createElement('label');
    const box = document.createElement('input');
    box.type = 'checkbox';
    box.checked = true;
    const drawing = document.createElementNS('http://www.w3.org/2000/svg', 'svg');
    drawing.setAttribute('viewBox', '0 0 22 14');
    drawing.innerHTML = icon;
    box.addEventListener('change', () => this.setLayer(layer, box.checked));
    label.append(box, drawing, name);
    label.hidden = !isEver(layer, this.stage);
    element('layers').append(label);
    return box;
  }

  /** @param {Layer} layer @param {boolean} isOn */
  setLayer(layer, isOn) {
    const box = this.boxes.get(layer);
    if (!box) return;
    box.checked = isOn;
    if (isOn) this.stage.layers.add(layer);
    else this.stage.layers.delete(layer);
    this.stage.ask();
    this.onChange();
  }

  /** @param {number} b @param {boolean} isHidden */
  hide(b, isHidden) {
    if (!this.rows[b]) return;
    this.rows[b].box.checked = !isHidden;
    this.stage.hide(b, isHidden);
    this.onChange();
  }

  /** Shows some bodies alone; again: all. @param {number[]} which */
  isolate(which) {
    const isAlone = this.stage.bodies.every((body, i) => body.isHidden === !which.includes(i) || !body.isHere);
    this.rows.forEach((_, i) => this.hide(i, !isAlone && !which.includes(i)));
  }

  /** The boxes of a level of the trees. @param {number|null} level */
  showLevel(level) {
    const {boxes} = this.stage;
    this.stage.setLevel(level);
    const slider = /** @type {HTMLInputElement} */ (element('level'));
    slider.value = String(boxes.level === null ? 0 : boxes.level + 1);
    element('level-text').textContent =
        boxes.level === null ? 'none' : `level ${boxes.level}: ${boxes.count().toLocaleString('en')} box${boxes.count() === 1 ? '' : 'es'}`;
    this.onChange();
  }

  /** One level further down, after the last one none. */
  nextLevel() {
    const {level} = this.stage.boxes;
    this.showLevel(level === null ? 0 : level + 1);
  }

  /** Bodies that do not stand in the frame are paler, or where there are many not there. */
  refresh() {
    // Of pictures that have nothing to do with each other each has its own bodies.
    const isFew = this.stage.bodies.length <= 40 && this.stage.page.places.length === 1;
    this.rows.forEach((row, b) => {
      const {isHere} = this.stage.bodies[b];
      if (row.isHere === isHere) return;
      row.isHere = isHere;
      row.item.classList.toggle('away', !isHere);
      row.item.hidden = !isFew && !isHere;
    });
  }

  axisButtons() {
    return /** @type {HTMLButtonElement[]} */ ([...element('cut').querySelectorAll('[data-axis]')]);
  }

  /** @param {string} axis x, y, z, or nothing */
  setCut(axis) {
    this.showCut(axis === '' ? null : {
      axis: /** @type {'x'|'y'|'z'} */ (axis),
      at: this.stage.cut?.at ?? 0.5,
      isFlipped: this.stage.cut?.isFlipped ?? false,
    });
  }

  /** A cut, the other half, none. @param {'x'|'y'|'z'} axis */
  nextCut(axis) {
    const {cut} = this.stage;
    if (cut?.axis !== axis) this.showCut({axis, at: 0.5, isFlipped: false});
    else if (!cut.isFlipped) this.flip();
    else this.setCut('');
  }

  /** @param {number} by parts of what is there */
  moveCut(by) {
    const {cut} = this.stage;
    if (cut) this.showCut({...cut, at: Math.min(1, Math.max(0, cut.at + by))});
  }

  flip() {
    const {cut} = this.stage;
    if (cut) this.showCut({...cut, isFlipped: !cut.isFlipped});
  }

  /** @param {import('./stage.js').Cut|null} cut */
  showCut(cut) {
    this.stage.setCut(cut);
    for (const button of this.axisButtons())
      button.setAttribute('aria-pressed', String(button.dataset.axis === (cut?.axis ?? '')));
    this.slider.disabled = /** @type {HTMLButtonElement} */ (element('flip')).disabled = cut === null;
    if (cut) this.slider.value = String(cut.at);
    this.onChange();
  }
}
