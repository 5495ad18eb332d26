import assert from 'node:assert/strict';
import test from 'node:test';
import {advance, chaptersOf, nextBegin, nextChange, pairsOf, placeIn, stretches} from '../source/frames.js';

const frames = (text) => [...text].map((c) => ({state: {t: 'touching', c: 'clear', u: 'unknown'}[c]}));

test('a frame is found among those of a body, or not', () => {
  const of = new Uint32Array([2, 3, 7]);
  assert.deepEqual([0, 2, 3, 5, 7, 8].map((f) => placeIn(of, f)), [-1, 0, 1, -1, 2, -1]);
  assert.equal(placeIn(new Uint32Array(), 0), -1);
});

test('changes are where the state is another than before', () => {
  const all = frames('ccttcu');
  assert.deepEqual([0, 1, 2, 3, 4, 5].map((f) => nextChange(all, f, 1)), [2, 2, 4, 4, 5, null]);
  assert.deepEqual([0, 1, 2, 3, 5].map((f) => nextChange(all, f, -1)), [null, 0, 0, 2, 4]);
  assert.equal(nextChange(frames('tttt'), 0, 1), null);
  const marked = frames('tttt').map((frame, f) => ({...frame, change: f === 2}));
  assert.deepEqual([nextChange(marked, 0, 1), nextChange(marked, 3, -1), nextChange(marked, 2, 1)], [2, 2, null]);
});

test('stretches cover all frames once', () => {
  assert.deepEqual(stretches(frames('ccttc')).map(({first, count}) => [first, count]), [[0, 2], [2, 2], [4, 1]]);
});

test('a player goes on by whole frames, and loops or ends', () => {
  assert.deepEqual(advance(2, 1.25, 10, true), {frame: 3, left: 0.25, isEnd: false});
  assert.deepEqual(advance(8, 3, 10, true), {frame: 1, left: 0, isEnd: false});
  assert.deepEqual(advance(8, 3, 10, false), {frame: 9, left: 0, isEnd: true});
});

test('frames of one place are a chapter, which touches if one of them does', () => {
  const all = frames('cctct').map((frame, i) => ({...frame, place: [0, 0, 0, 1, 2][i]}));
  assert.deepEqual(chaptersOf(all), [{state: 'touching', first: 0, count: 3}, {state: 'clear', first: 3, count: 1},
                                     {state: 'touching', first: 4, count: 1}]);
});

test('pairs come in the order in which they first touch, with all their frames', () => {
  const found = pairsOf([0, 0, 2, 3, 3, 4], [1, 2, 0, 3, 1, 2, 1, 2]);
  assert.deepEqual(found, [{a: 1, b: 2, frames: [1, 2, 4]}, {a: 0, b: 3, frames: [1]}]);
  assert.deepEqual(pairsOf([0], []), []);
});

test('a pair begins where it did not touch in the frame before, and after the last time anew', () => {
  const frames = [1, 2, 5, 6, 9];
  assert.deepEqual([0, 1, 2, 4, 5, 8, 9].map((from) => nextBegin(frames, from)), [1, 5, 5, 5, 9, 9, 1]);
});
