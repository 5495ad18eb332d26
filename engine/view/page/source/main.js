// @ts-check
// The page: reads its data, shows the first frame, and joins the parts.

import {DataError, unpack} from './unpack.js';
import {Stage} from './stage.js';
import {Overlay, element} from './overlay.js';
import {Panel} from './panel.js';
import {Player} from './player.js';
import {Chapters} from './chapters.js';
import {listenToKeys} from './keys.js';
import {fromHash, toHash} from './link.js';
import {Pairs} from './pairs.js';
import {hexFloat, length, number} from './units.js';
import {pictureOf} from './picture.js';

const kStates = {touching: 'touching', clear: 'clear', unknown: 'unknown', '': ''};

/** In place of the picture. @param {string} text */
function refuse(text) {
  const word = document.createElement('p');
  word.className = 'refusal';
  word.setAttribute('role', 'alert');
  word.textContent = text;
  element('view').hidden = true;
  document.body.append(word);
}

class Page {
  /** @param {import('./unpack.js').PageData} page @param {import('./unpack.js').Arrays} arrays */
  constructor(page, arrays) {
    this.page = page;
    element('view').hidden = false;
    this.stage = new Stage(/** @type {HTMLCanvasElement} */ (element('canvas')), page, arrays);
    this.overlay = new Overlay(this.stage);
    this.stage.onDrawn = () => {
      element('coarse').hidden = !this.stage.isCoarse;
      this.overlay.place();
    };
    this.stage.onTurned = () => this.keepLink();
    this.stage.covered = () => this.covered();
    this.panel = new Panel(this.stage, () => this.changed(), (body) => this.nearBodies([body]));
    this.player = new Player(page.frames, (frame) => this.show(frame), (frame) => this.tell(frame), (word) => this.overlay.say(word));
    this.pairs = new Pairs(page, arrays, {
      go: (frame) => this.player.go(frame),
      near: (bodies) => this.nearBodies(bodies),
      only: (bodies) => this.panel.isolate(bodies),
    });
    this.chapters = new Chapters(page.frames, (frame) => this.player.go(frame));
    /** @type {'light'|'dark'|undefined} as the user has chosen */
    this.theme = undefined;
    /** @type {{body: number, triangle: number, text: string}|null} what was picked last */
    this.picked = null;
    this.isHex = false;
    this.linkTimer = 0;
    this.tipTimer = 0;
    // Within another page there is nothing that a link could lead to.
    element('link').hidden = location.protocol === 'about:';
    this.write();
    this.listen();
    this.size();
    this.open(fromHash(location.hash));
    new ResizeObserver(() => this.size()).observe(element('stage'));
  }

  /** Words that stay. */
  write() {
    const {page} = this;
    document.title = page.title;
    element('title').textContent = page.title;
    element('made').textContent = `Coordinates in ${page.unit || 'units of the file'}, drawn as floats about the middle. ${page.made_by}`;
    element('notes-section').hidden = page.notes.length === 0;
    for (const note of page.notes) {
      const item = document.createElement('li');
      item.textContent = note;
      element('notes').append(item);
    }
  }

  /** @param {import('./link.js').ViewLink} link */
  open(link) {
    this.setTheme(link.theme);
    for (const body of link.hidden ?? []) this.panel.hide(body, true);
    for (const layer of link.off ?? []) this.panel.setLayer(/** @type {import('./stage.js').Layer} */ (layer), false);
    this.player.go(link.frame ?? 0);
    this.stage.look(link.camera);
    if (link.cut) this.panel.showCut(link.cut);
    if (link.level !== undefined) this.panel.showLevel(link.level);
  }

  /** @param {number} frame */
  show(frame) {
    this.stage.show(frame);
    this.overlay?.set(frame);
  }

  /** Says what there is to say about a frame. @param {number} frame */
  tell(frame) {
    const data = this.page.frames[frame];
    const state = element('state');
    state.textContent = data.says || kStates[data.state];
    state.dataset.state = data.state;
    element('title').textContent = data.label ? `${this.page.title} \u00b7 ${data.label}` : this.page.title;
    const facts = element('facts');
    facts.textContent = '';
    for (const fact of data.facts) {
      const term = document.createElement('dt'), value = document.createElement('dd');
      term.textContent = fact.name;
      value.textContent = fact.length ? length(fact.value, this.page.unit) : number(fact.value, 9);
      facts.append(term, value);
    }
    element('note').textContent = data.note ?? '';
    this.panel.refresh();
    this.chapters.show(frame);
    this.pairs.show(frame);
    this.keepLink();
  }

  changed() {
    this.overlay?.set(this.stage.frame);
    this.keepLink();
  }

  /** @returns {import('./link.js').ViewLink} */
  link() {
    const {stage} = this;
    return {
      frame: this.player.frame,
      camera: stage.sight(),
      hidden: stage.bodies.flatMap((body, b) => (body.isHidden ? [b] : [])),
      cut: stage.cut ?? undefined,
      off: [...this.panel.boxes].flatMap(([layer, box]) => (box.checked ? [] : [layer])),
      level: stage.boxes.level ?? undefined,
      theme: this.theme,
    };
  }

  /** The address bar follows, but not each move. */
  keepLink() {
    clearTimeout(this.linkTimer);
    this.linkTimer = window.setTimeout(() => {
      try {
        history.replaceState(null, '', `#${toHash(this.link())}`);
      } catch {
        // Some browsers let files have no history: copying a link still works.
      }
    }, 250);
  }

  async copyLink() {
    if (element('link').hidden) return;
    const text = `${location.href.split('#')[0]}#${toHash(this.link())}`;
    try {
      await navigator.clipboard.writeText(text);
      this.overlay.say('link copied');
    } catch {
      location.hash = toHash(this.link());
      this.overlay.say('the link stands in the address bar');
    }
  }

  /** @param {'light'|'dark'|undefined} theme */
  setTheme(theme) {
    this.theme = theme;
    const isDark = theme ? theme === 'dark' : matchMedia('(prefers-color-scheme: dark)').matches;
    document.documentElement.dataset.theme = isDark ? 'dark' : 'light';
    this.stage.paint(isDark);
    this.player.drawStrip();
  }

  turnTheme() {
    this.setTheme(document.documentElement.dataset.theme === 'dark' ? 'light' : 'dark');
    this.keepLink();
  }

  size() {
    const stage = element('stage');
    if (stage.clientWidth > 0 && stage.clientHeight > 0) this.stage.resize(stage.clientWidth, stage.clientHeight);
    this.player.drawStrip();
  }

  /** On a narrow screen words stand above the picture and tools below it, not beside it. */
  covered() {
    const head = element('head'), tools = element('tools'), {clientWidth, clientHeight} = element('stage');
    const isNarrow = head.offsetWidth + tools.offsetWidth + 2 * head.offsetLeft > 0.8 * clientWidth;
    if (!isNarrow) return {top: 0, bottom: 0};
    const isBelow = tools.offsetTop > clientHeight / 2;
    return {top: head.offsetTop + head.offsetHeight, bottom: isBelow ? clientHeight - tools.offsetTop : 0};
  }

  async savePicture() {
    const frame = this.page.frames[this.player.frame];
    const lines = [element('title').textContent ?? '', element('state').textContent ?? ''];
    const blob = await pictureOf(this.stage, lines);
    const anchor = document.createElement('a');
    anchor.href = URL.createObjectURL(blob);
    anchor.download = `${this.page.title}-${frame.label || 'view'}.png`.replace(/[^\w.-]+/g, '-');
    anchor.click();
    setTimeout(() => URL.revokeObjectURL(anchor.href), 1000);
    this.overlay.say('picture saved');
  }

  showKeys() {
    const keys = /** @type {HTMLDetailsElement} */ (element('keys'));
    if (!element('panel').classList.contains('is-open') && element('panel').offsetParent === null) this.toggleMore();
    keys.open = !keys.open;
    keys.scrollIntoView({block: 'nearest'});
    keys.querySelector('summary')?.focus();
  }

  toggleMore() {
    const isOpen = element('panel').classList.toggle('is-open');
    element('view').classList.toggle('has-lists', isOpen);
    element('open').setAttribute('aria-expanded', String(isOpen));
  }

  near() {
    if (!this.stage.fitMarks()) this.overlay.say('nothing is marked in this frame');
    this.keepLink();
  }

  /** @param {number[]} bodies */
  nearBodies(bodies) {
    this.stage.fitBodies(bodies);
    this.keepLink();
  }

  turnHex() {
    this.isHex = !this.isHex;
    element('exact').setAttribute('aria-pressed', String(this.isHex));
    this.writePicked();
  }

  fit() {
    this.stage.fit();
    this.keepLink();
  }

  listen() {
    element('fit').addEventListener('click', () => this.fit());
    element('near').addEventListener('click', () => this.near());
    element('theme').addEventListener('click', () => this.turnTheme());
    element('png').addEventListener('click', () => this.savePicture());
    element('link').addEventListener('click', () => this.copyLink());
    element('open').addEventListener('click', () => this.toggleMore());
    element('exact').addEventListener('click', () => this.turnHex());
    window.addEventListener('hashchange', () => this.open(fromHash(location.hash)));
    matchMedia('(prefers-color-scheme: dark)').addEventListener('change', () => this.setTheme(this.theme));
    this.listenToPointer();
    const {player, stage, panel} = this;
    listenToKeys({
      turn: (side, up, nearer) => {
        stage.turn(side, up, nearer);
        this.keepLink();
      },
      slide: (right, up) => {
        stage.slide(right, up);
        this.keepLink();
      },
      body: (b, isAlone) => {
        if (b >= stage.bodies.length) return;
        if (isAlone) panel.isolate([b]);
        else panel.hide(b, !stage.bodies[b].isHidden);
      },
      plain: {
        ' ': () => player.toggle(),
        ',': () => player.step(-1),
        '.': () => player.step(1),
        '[': () => player.change(-1),
        ']': () => player.change(1),
        Home: () => player.go(0),
        End: () => player.go(this.page.frames.length - 1),
        f: () => this.fit(),
        c: () => this.near(),
        s: () => player.nextSpeed(1),
        S: () => player.nextSpeed(-1),
        o: () => player.turnLoop(),
        x: () => panel.nextCut('x'),
        y: () => panel.nextCut('y'),
        z: () => panel.nextCut('z'),
        PageUp: () => panel.moveCut(0.02),
        PageDown: () => panel.moveCut(-0.02),
        b: () => panel.nextLevel(),
        i: () => this.pickMiddle(),
        Escape: () => element('canvas').focus(),
        '?': () => this.showKeys(),
        h: () => this.turnHex(),
        t: () => this.turnTheme(),
        p: () => this.savePicture(),
        l: () => this.copyLink(),
        m: () => this.toggleMore(),
      },
    });
  }

  listenToPointer() {
    const canvas = element('canvas');
    canvas.addEventListener('webglcontextlost', () =>
      this.overlay.say('the browser has taken the picture away, for want of memory perhaps: load the page again'));
    let x = 0, y = 0, pressedX = 0, pressedY = 0;
    canvas.addEventListener('pointerdown', (event) => { pressedX = event.offsetX, pressedY = event.offsetY; });
    canvas.addEventListener('pointermove', (event) => {
      x = event.offsetX, y = event.offsetY;
      element('tip').hidden = true;
      clearTimeout(this.tipTimer);
      if (event.buttons === 0 && event.pointerType === 'mouse') this.tipTimer = window.setTimeout(() => this.tip(x, y), 60);
    });
    canvas.addEventListener('pointerleave', () => {
      clearTimeout(this.tipTimer);
      element('tip').hidden = true;
    });
    canvas.addEventListener('pointerup', (event) => {
      if (Math.hypot(event.offsetX - pressedX, event.offsetY - pressedY) < 4) this.keepPick(event.offsetX, event.offsetY);
    });
  }

  /** @param {number} x @param {number} y */
  describe(x, y) {
    const hit = this.stage.pick(x, y);
    if (!hit) return null;
    const place = hit.world.map((value) => number(value, 6)).join(', ');
    return `${this.page.bodies[hit.body].name}\ntriangle ${hit.triangle}\n(${place}) ${this.page.unit}`;
  }

  /** @param {number} x @param {number} y */
  tip(x, y) {
    const text = this.describe(x, y), tip = element('tip');
    tip.hidden = text === null;
    if (text === null) return;
    tip.textContent = text;
    const {clientWidth, clientHeight} = element('stage');
    tip.style.left = `${Math.min(x + 14, clientWidth - tip.offsetWidth - 6)}px`;
    tip.style.top = `${Math.min(y + 14, clientHeight - tip.offsetHeight - 6)}px`;
  }

  /** For who has no pointer. */
  pickMiddle() {
    const {clientWidth, clientHeight} = element('canvas'), {top, bottom} = this.covered();
    const x = clientWidth / 2, y = (top + clientHeight - bottom) / 2;
    this.tip(x, y);
    this.keepPick(x, y);
    if (this.picked === null) this.overlay.say('nothing is in the middle of the picture');
  }

  /** @param {number} x @param {number} y */
  keepPick(x, y) {
    const text = this.describe(x, y);
    this.picked = text === null ? null : {.../** @type {{body: number, triangle: number}} */ (this.stage.pick(x, y)), text};
    this.writePicked();
    if (text !== null && element('panel').offsetParent === null) this.overlay.say(text.replaceAll('\n', ' \u00b7 '));
  }

  /** Writes what was picked, and the corners of the triangle as they were given. */
  writePicked() {
    element('picked-section').hidden = this.picked === null;
    if (this.picked === null) return;
    const {body, triangle, text} = this.picked;
    const corners = this.stage.bodies[body].shape.exactCorners(triangle);
    const words = corners === null
        ? 'The exact corners of so large a mesh are not in this page.'
        : `corners in its own frame:\n${corners.map((corner) => corner.map((x) => this.isHex ? hexFloat(x) : String(x)).join(this.isHex ? '\n' : ', ')).join(this.isHex ? '\n\n' : '\n')}`;
    element('exact').hidden = corners === null;
    element('picked').textContent = `${text}\n${words}`;
  }
}

async function begin() {
  try {
    const {page, arrays} = await unpack(element('data').textContent ?? '');
    const page_ = new Page(page, arrays);
    Object.assign(window, {grazePage: page_});
    document.documentElement.dataset.ready = 'yes';
  } catch (error) {
    if (error instanceof DataError) return refuse(`Nothing can be shown: ${error.message}.`);
    const text = error instanceof Error ? error.message : String(error);
    refuse(/webgl/i.test(text)
               ? 'Nothing can be shown: this browser offers no WebGL, which draws the picture. Another one, or other settings, may do.'
               : `Nothing can be shown: ${text}`);
  }
}

begin();
