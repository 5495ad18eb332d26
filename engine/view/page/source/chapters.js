// @ts-check
// A list of what stands apart: of a folder of cases each is a line, however many frames it has.

import {element} from './overlay.js';
import {chaptersOf} from './frames.js';

export class Chapters {
  /** @param {import('./unpack.js').FrameData[]} frames @param {(frame: number) => void} go */
  constructor(frames, go) {
    this.chapters = chaptersOf(frames);
    element('chapters-section').hidden = this.chapters.length < 2;
    this.here = -1;
    this.buttons = this.chapters.length < 2 ? [] : this.chapters.map(({first, state}) => {
      const item = document.createElement('li'), button = document.createElement('button');
      const text = document.createElement('span');
      text.textContent = frames[first].label || `picture ${first + 1}`;
      button.title = text.textContent;
      button.dataset.state = state;
      button.append(text);
      button.addEventListener('click', () => go(first));
      item.append(button);
      element('chapters').append(item);
      return button;
    });
  }

  /** @param {number} frame */
  show(frame) {
    const here = this.chapters.findIndex(({first, count}) => frame >= first && frame < first + count);
    if (here === this.here || !this.buttons[here]) return;
    this.buttons[this.here]?.removeAttribute('aria-current');
    this.buttons[here].setAttribute('aria-current', 'true');
    // By itself: scrollIntoView() would move a page around this one, too.
    const list = element('chapters'), {offsetTop, offsetHeight} = this.buttons[here];
    const top = offsetTop - list.offsetTop;
    list.scrollTop = Math.min(top, Math.max(list.scrollTop, top + offsetHeight - list.clientHeight));
    this.here = here;
  }
}
