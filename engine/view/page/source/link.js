// @ts-check
// A link tells the view behind its #, so that another sees the same.

/**
 * @typedef {object} ViewLink all of it may be missing
 * @property {number} [frame]
 * @property {number[]} [camera] eye and target in the frame's numbers, six
 * @property {number[]} [hidden] bodies
 * @property {{axis: 'x'|'y'|'z', at: number, isFlipped: boolean}} [cut]
 * @property {string[]} [off] layers that are not shown
 * @property {number} [level] of trees
 * @property {'light'|'dark'} [theme]
 */

/** @param {ViewLink} view @returns {string} without the # */
export function toHash(view) {
  const parts = [];
  if (view.frame) parts.push(`frame=${view.frame}`);
  if (view.camera) parts.push(`camera=${view.camera.map((x) => Number(x.toPrecision(5))).join(',')}`);
  if (view.hidden?.length) parts.push(`hide=${view.hidden.join(',')}`);
  if (view.cut) parts.push(`cut=${view.cut.isFlipped ? '-' : ''}${view.cut.axis},${Number(view.cut.at.toPrecision(4))}`);
  if (view.off?.length) parts.push(`off=${view.off.join(',')}`);
  if (view.level !== undefined) parts.push(`level=${view.level}`);
  if (view.theme) parts.push(`theme=${view.theme}`);
  return parts.join('&');
}

/** @param {string} text */
const numbersIn = (text) => text.split(',').map(Number);

/**
 * Returns what can be understood of a link; the rest is as if it were not there.
 * @param {string} hash with or without the # @returns {ViewLink}
 */
export function fromHash(hash) {
  /** @type {ViewLink} */
  const view = {};
  for (const part of hash.replace(/^#/, '').split('&')) {
    const [key, value = ''] = part.split('=');
    if (key === 'frame' && /^\d{1,9}$/.test(value)) view.frame = Number(value);
    if (key === 'camera') {
      const numbers = numbersIn(value);
      if (numbers.length === 6 && numbers.every(Number.isFinite)) view.camera = numbers;
    }
    if (key === 'hide') {
      const bodies = numbersIn(value);
      if (bodies.every((x) => Number.isInteger(x) && x >= 0)) view.hidden = bodies;
    }
    if (key === 'cut') {
      const found = /^(-?)([xyz]),([-+.\de]+)$/.exec(value);
      const at = found ? Number(found[3]) : NaN;
      if (found && at >= 0 && at <= 1)
        view.cut = {axis: /** @type {'x'|'y'|'z'} */ (found[2]), at, isFlipped: found[1] === '-'};
    }
    if (key === 'off') view.off = value.split(',').filter((word) => /^[a-z]+$/.test(word));
    if (key === 'level' && /^\d{1,2}$/.test(value)) view.level = Number(value);
    if (key === 'theme' && (value === 'light' || value === 'dark')) view.theme = value;
  }
  return view;
}
