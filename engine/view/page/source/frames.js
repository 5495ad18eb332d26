// @ts-check
// Frames one after the other: which body stands where, and where something begins or ends.

/** @typedef {import('./unpack.js').FrameData} FrameData */

/**
 * Returns where in `frames`, ascending, a frame is, or -1 if it is not there.
 * @param {Uint32Array} frames @param {number} frame
 */
export function placeIn(frames, frame) {
  let low = 0, high = frames.length;
  while (low < high) {
    const middle = low + high >> 1;
    if (frames[middle] < frame) low = middle + 1;
    else high = middle;
  }
  return frames[low] === frame ? low : -1;
}

/**
 * The next frame, or the last before, in which something changes or whose state is another than that of the frame
 * before it; null if there is none.
 * @param {FrameData[]} frames @param {number} from @param {1|-1} step
 */
export function nextChange(frames, from, step) {
  for (let f = from + step; f > 0 && f < frames.length; f += step)
    if (frames[f].change || frames[f].state !== frames[f - 1].state) return f;
  return step < 0 && from > 0 ? 0 : null;
}

/**
 * Stretches of frames of one state, for a strip of colours.
 * @param {FrameData[]} frames
 */
export function stretches(frames) {
  /** @type {{state: FrameData['state'], first: number, count: number}[]} */
  const found = [];
  frames.forEach(({state}, f) => {
    const last = found[found.length - 1];
    if (last && last.state === state) ++last.count;
    else found.push({state, first: f, count: 1});
  });
  return found;
}

/**
 * Frames that share a place, one after the other; touching if any of them is.
 * @param {FrameData[]} frames
 */
export function chaptersOf(frames) {
  /** @type {{state: FrameData['state'], first: number, count: number}[]} */
  const found = [];
  frames.forEach(({state, place}, f) => {
    const last = found[found.length - 1];
    if (!last || frames[f - 1].place !== place) found.push({state, first: f, count: 1});
    else {
      ++last.count;
      if (state === 'touching') last.state = state;
    }
  });
  return found;
}

/**
 * Takes a player so many frames on, and returns what is left over of a frame. From the last frame a loop goes to the
 * first.
 * @param {number} frame @param {number} due frames and parts of one @param {number} count @param {boolean} isLoop
 */
export function advance(frame, due, count, isLoop) {
  const whole = Math.floor(due);
  const next = frame + whole;
  if (next < count) return {frame: next, left: due - whole, isEnd: false};
  return isLoop ? {frame: next % count, left: due - whole, isEnd: false} : {frame: count - 1, left: 0, isEnd: true};
}

/**
 * The pairs of a run, in the order in which they first touch, each with the frames in which it does.
 * @param {ArrayLike<number>} starts of each frame in the list, and its end @param {ArrayLike<number>} list two bodies each
 */
export function pairsOf(starts, list) {
  /** @type {Map<string, {a: number, b: number, frames: number[]}>} */
  const found = new Map();
  for (let f = 0; f + 1 < starts.length; ++f) {
    for (let i = starts[f]; i < starts[f + 1]; ++i) {
      const a = list[2 * i], b = list[2 * i + 1], key = `${a} ${b}`;
      const known = found.get(key);
      if (known) known.frames.push(f);
      else found.set(key, {a, b, frames: [f]});
    }
  }
  return [...found.values()];
}

/**
 * Returns where a pair next begins to touch after a frame, or the first such frame after the last time.
 * @param {number[]} frames in which it touches, ascending @param {number} from
 */
export function nextBegin(frames, from) {
  return frames.find((f, i) => f > from && (i === 0 || frames[i - 1] < f - 1)) ?? frames[0];
}

/**
 * The numbers of what is marked in a frame.
 * @param {import('./unpack.js').Arrays} arrays @param {import('./unpack.js').MarkData} mark @param {number} width
 * @param {number} frame
 */
export function marksOf(arrays, mark, width, frame) {
  const starts = arrays.words(mark.starts), list = arrays.floats(mark.list);
  if (mark.rows === undefined) return list.subarray(width * starts[frame], width * starts[frame + 1]);
  const rows = arrays.words(mark.rows).subarray(starts[frame], starts[frame + 1]), column = list.length / width;
  const numbers = new Float32Array(width * rows.length);
  rows.forEach((row, i) => {
    for (let k = 0; k < width; ++k) numbers[width * i + k] = list[k * column + row];
  });
  return numbers;
}
