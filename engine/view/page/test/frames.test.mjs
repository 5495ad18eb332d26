import assert from 'node:assert/strict';
import test from 'node:test';
import {advance, chaptersOf, nextChange, placeIn, stretches} from '../source/frames.js';

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
