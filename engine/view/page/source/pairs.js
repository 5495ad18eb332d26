// @ts-check
// The list of pairs of bodies that touch: which do now, and where the others begin to.

import {nextBegin, pairsOf, placeIn} from './frames.js';
import {element} from './overlay.js';

/** Most lines: more nobody reads. */
const kMostLines = 200;

export class Pairs {
  /**
   * @param {import('./unpack.js').PageData} page @param {import('./unpack.js').Arrays} arrays
   * @param {{go: (frame: number) => void, near: (bodies: number[]) => void, only: (bodies: number[]) => void}} commands
   */
  constructor(page, arrays, commands) {
    this.page = page;
    this.commands = commands;
    this.frame = 0;
    this.pairs = pairsOf(arrays.words(page.marks.pairs.starts), arrays.words(page.marks.pairs.list))
                     .map((pair) => ({...pair, frames: pair.frames, at: Uint32Array.from(pair.frames)}));
    element('pairs-section').hidden = this.pairs.length === 0;
  }

  /** @param {number} frame */
  show(frame) {
    this.frame = frame;
    if (this.pairs.length === 0) return;
    const now = this.pairs.filter((pair) => placeIn(pair.at, frame) >= 0);
    const others = this.pairs.filter((pair) => placeIn(pair.at, frame) < 0);
    const list = element('pairs');
    list.textContent = '';
    const shown = [...now, ...others].slice(0, kMostLines);
    shown.forEach((pair, i) => list.append(this.line(pair, i < now.length)));
    element('pairs-head').textContent = `Pairs: ${now.length} of ${this.pairs.length} touch`;
    const left = this.pairs.length - shown.length;
    if (left > 0) {
      const word = document.createElement('li');
      word.textContent = `and ${left} more`;
      list.append(word);
    }
  }

  /** @param {{a: number, b: number, frames: number[]}} pair @param {boolean} isNow */
  line({a, b, frames}, isNow) {
    const names = [a, b].map((body) => this.page.bodies[body].name);
    const item = document.createElement('li'), go = document.createElement('button'), only = document.createElement('button');
    const text = document.createElement('span');
    text.textContent = names.join(' \u00b7 ');
    go.append(text);
    go.dataset.state = isNow ? 'touching' : 'clear';
    go.title = isNow ? `${text.textContent}: go near` : `${text.textContent}: go to where they begin to touch`;
    go.addEventListener('click', () => {
      if (!isNow) this.commands.go(nextBegin(frames, this.frame));
      this.commands.near([a, b]);
    });
    only.textContent = 'only';
    only.title = `Only ${names.join(' and ')}; again: all`;
    only.addEventListener('click', () => this.commands.only([a, b]));
    item.append(go, only);
    return item;
  }
}
