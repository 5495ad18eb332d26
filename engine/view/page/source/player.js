// @ts-check
// The slider over frames: play, speed, loop, and jumps to where something begins or ends.

import {advance, chaptersOf, nextChange, stretches} from './frames.js';
import {element} from './overlay.js';

const kSpeeds = [1, 2, 5, 10, 20, 30, 60];
const kPlay = 'M7 4l13 8-13 8z', kStop = 'M6 5h4v14H6zM14 5h4v14h-4z';
/** Seconds that all frames take at the speed that is chosen at first, about. */
const kWhole = 6;
/** Milliseconds after which words follow a picture while it plays: nobody reads faster, and to lay them out takes time. */
const kWordsEvery = 120;

export class Player {
  /**
   * @param {import('./unpack.js').FrameData[]} frames @param {(frame: number) => void} onFrame a picture is due
   * @param {(frame: number) => void} onWords so are words about it @param {(word: string) => void} say
   */
  constructor(frames, onFrame, onWords, say) {
    this.frames = frames;
    this.onFrame = onFrame;
    this.onWords = onWords;
    this.told = 0;
    this.say = say;
    this.frame = 0;
    this.isPlaying = false;
    this.due = 0;
    this.last = 0;
    this.slider = /** @type {HTMLInputElement} */ (element('slider'));
    this.speed = /** @type {HTMLSelectElement} */ (element('speed'));
    this.loop = /** @type {HTMLInputElement} */ (element('loop'));
    element('time').hidden = frames.length < 2;
    this.slider.max = String(frames.length - 1);
    this.slider.addEventListener('input', () => this.go(Number(this.slider.value)));
    // Pictures that have nothing to do with each other are no motion.
    const longest = Math.max(...chaptersOf(frames).map(({count}) => count));
    const fitting = kSpeeds.find((speed) => longest / speed <= kWhole) ?? 60;
    for (const speed of kSpeeds) {
      const option = new Option(`${speed} / s`, String(speed), false, speed === fitting);
      this.speed.append(option);
    }
    element('play').addEventListener('click', () => this.toggle());
    element('step-back').addEventListener('click', () => this.step(-1));
    element('step-on').addEventListener('click', () => this.step(1));
    element('change-back').addEventListener('click', () => this.change(-1));
    element('change-on').addEventListener('click', () => this.change(1));
    this.drawStrip();
  }

  /** @param {number} frame */
  go(frame) {
    this.frame = Math.min(this.frames.length - 1, Math.max(0, frame));
    this.onFrame(this.frame);
    if (!this.isPlaying || performance.now() - this.told > kWordsEvery) this.tell();
  }

  tell() {
    this.told = performance.now();
    this.slider.value = String(this.frame);
    element('count').textContent = `${this.frame + 1} / ${this.frames.length}`;
    this.onWords(this.frame);
  }

  /** @param {number} by */
  step(by) {
    this.stop();
    this.go(this.frame + by);
  }

  /** @param {1|-1} direction */
  change(direction) {
    this.stop();
    const next = nextChange(this.frames, this.frame, direction);
    if (next === null) this.say(direction > 0 ? 'nothing changes after this frame' : 'nothing changes before this frame');
    else this.go(next);
  }

  /** The next one of the list; behind the last the first. @param {1|-1} by */
  nextSpeed(by) {
    const {speed} = this, count = speed.options.length;
    speed.selectedIndex = (speed.selectedIndex + by + count) % count;
    this.say(`${speed.value} frames a second`);
  }

  turnLoop() {
    this.loop.checked = !this.loop.checked;
    this.say(this.loop.checked ? 'plays again and again' : 'plays once');
  }

  toggle() {
    if (this.frames.length < 2) return;
    if (this.isPlaying) return this.stop();
    this.isPlaying = true;
    if (this.frame === this.frames.length - 1) this.go(0);
    this.due = 0;
    this.last = performance.now();
    this.dress();
    requestAnimationFrame((now) => this.tick(now));
  }

  stop() {
    if (this.isPlaying) this.tell();
    this.isPlaying = false;
    this.dress();
  }

  dress() {
    element('play-path').setAttribute('d', this.isPlaying ? kStop : kPlay);
    element('play').setAttribute('aria-label', this.isPlaying ? 'Stop' : 'Play');
  }

  /** @param {number} now */
  tick(now) {
    if (!this.isPlaying) return;
    this.due += Math.max(0, now - this.last) / 1000 * Number(this.speed.value);
    this.last = now;
    if (this.due >= 1) {
      const {frame, left, isEnd} = advance(this.frame, this.due, this.frames.length, this.loop.checked);
      this.due = left;
      this.go(frame);
      if (isEnd) return this.stop();
    }
    requestAnimationFrame((next) => this.tick(next));
  }

  /** Draws where bodies touch, in colour and by height. */
  drawStrip() {
    const strip = /** @type {HTMLCanvasElement} */ (element('strip'));
    const pen = strip.getContext('2d');
    const width = strip.width = Math.max(1, Math.round(strip.clientWidth * (window.devicePixelRatio || 1)));
    const height = strip.height = 20;
    if (!pen) return;
    const style = getComputedStyle(strip);
    const colors = {touching: '--touch', clear: '--clear', unknown: '--unknown', '': '--line'};
    for (const {state, first, count} of stretches(this.frames)) {
      const from = width * first / this.frames.length, long = Math.max(1, width * count / this.frames.length);
      const high = state === 'touching' ? height : state === 'clear' ? height / 4 : height / 2;
      pen.fillStyle = style.getPropertyValue(colors[state]).trim();
      pen.globalAlpha = state === 'clear' ? 0.6 : 1;
      pen.fillRect(from, height - high, long, high);
    }
  }
}
