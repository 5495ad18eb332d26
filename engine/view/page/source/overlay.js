// @ts-check
// This draws what stands over the picture: words at places, the scale, the axes, the word for people.

import * as THREE from 'three';
import {length, roundLength} from './units.js';

/** @param {string} id @returns {HTMLElement} */
export function element(id) {
  const found = document.getElementById(id);
  if (!found) throw new Error(`the page has no #${id}`);
  return found;
}

/** Most words at contacts: more could not be read. */
const kMostWords = 8;

export class Overlay {
  /** @param {import('./stage.js').Stage} stage */
  constructor(stage) {
    this.stage = stage;
    /** @type {{at: THREE.Vector3, span: HTMLSpanElement}[]} */
    this.words = [];
    this.timer = 0;
    // These are as they were drawn last, so that nothing is laid out anew for a picture that has the same.
    this.scale = {width: '', text: ''};
    this.turn = new THREE.Quaternion(0, 0, 0, 0);
    this.axes = ['x', 'y', 'z'].map((name, i) => {
      const group = document.createElementNS('http://www.w3.org/2000/svg', 'g');
      const line = document.createElementNS('http://www.w3.org/2000/svg', 'line');
      const text = document.createElementNS('http://www.w3.org/2000/svg', 'text');
      line.setAttribute('stroke', ['#d55e00', '#009e73', '#0072b2'][i]);
      text.textContent = name;
      group.append(line, text);
      element('axes').append(group);
      return {group, line, text, axis: new THREE.Vector3().setComponent(i, 1)};
    });
  }

  /** The words of a frame. @param {number} frame */
  set(frame) {
    const {stage} = this, {page, marks} = stage;
    const {scale} = page.places[page.frames[frame].place];
    element('labels').textContent = '';
    this.words = [];
    if (stage.layers.has('gaps'))
      for (let i = 0; i < marks.gapNumbers.length; i += 7) {
        const g = marks.gapNumbers;
        this.add(new THREE.Vector3((g[i] + g[i + 3]) / 2, (g[i + 1] + g[i + 4]) / 2, (g[i + 2] + g[i + 5]) / 2),
                 length(g[i + 6] * scale, page.unit), 'gap');
      }
    if (stage.layers.has('contacts') && !marks.isCrowd)
      for (let i = 0; i < Math.min(kMostWords, marks.contactNumbers.length / 7); ++i)
        if (marks.contactNumbers[7 * i + 6] > 0)
          this.add(new THREE.Vector3().fromArray(marks.contactNumbers, 7 * i),
                   length(marks.contactNumbers[7 * i + 6] * scale, page.unit, 3), 'contact');
    if (stage.layers.has('labels'))
      for (const label of page.marks.labels)
        if (label.frame === frame) this.add(new THREE.Vector3().fromArray(label.at), label.text, '');
    this.place();
  }

  /** @param {THREE.Vector3} at @param {string} text @param {string} kind */
  add(at, text, kind) {
    const span = document.createElement('span');
    span.textContent = text;
    span.className = kind;
    element('labels').append(span);
    this.words.push({at, span});
  }

  /** After each picture. */
  place() {
    /** @type {{x: number, y: number}[]} */
    const taken = [];
    for (const {at, span} of this.words) {
      const seen = this.stage.onCanvas(at);
      const place = seen && {x: Math.round(seen.x + 10), y: Math.round(seen.y - 22)};
      // Of words that would cover each other the first stays.
      const isFree = place && !taken.some((other) => Math.abs(other.x - place.x) < 70 && Math.abs(other.y - place.y) < 17);
      span.style.display = place && isFree ? '' : 'none';
      if (!place || !isFree) continue;
      taken.push(place);
      span.style.transform = `translate(${place.x}px, ${place.y}px)`;
    }
    this.placeScale();
    this.placeAxes();
  }

  placeScale() {
    const unit = this.stage.unitsOfPixel();
    if (!(unit > 0) || !Number.isFinite(unit)) return;
    const long = roundLength(130 * unit);
    const width = `${Math.round(long / unit)}px`, text = length(long, this.stage.page.unit);
    if (width === this.scale.width && text === this.scale.text) return;
    this.scale = {width, text};
    element('scale-line').style.width = width;
    element('scale-text').textContent = text;
  }

  placeAxes() {
    const turn = this.stage.camera.quaternion.clone().invert();
    if (turn.equals(this.turn)) return;
    this.turn = turn;
    for (const {line, text, axis} of this.axes) {
      const {x, y} = axis.clone().applyQuaternion(turn);
      line.setAttribute('x2', String(20 * x));
      line.setAttribute('y2', String(-20 * y));
      text.setAttribute('x', String(28 * x));
      text.setAttribute('y', String(-28 * y));
    }
  }

  /** A word for two seconds. @param {string} text */
  say(text) {
    const word = element('word');
    word.textContent = text;
    word.hidden = false;
    clearTimeout(this.timer);
    this.timer = window.setTimeout(() => { word.hidden = true; }, 2200);
  }
}
