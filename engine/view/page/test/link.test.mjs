import assert from 'node:assert/strict';
import test from 'node:test';
import {fromHash, toHash} from '../source/link.js';

test('a link says the view, and is read back', () => {
  const view = {
    frame: 12, camera: [1, -2.5, 0.25, 0, 0, 1e-7], hidden: [1, 3], cut: {axis: 'y', at: 0.25, isFlipped: true},
    off: ['edges', 'labels'], level: 0, theme: 'dark',
  };
  assert.deepEqual(fromHash(`#${toHash(view)}`), view);
});

test('nothing is written for what is as at first', () => {
  assert.equal(toHash({frame: 0, hidden: [], off: []}), '');
  assert.deepEqual(fromHash(''), {});
});

test('what cannot be understood is as if it were not there', () => {
  for (const bad of ['frame=-1', 'frame=x', 'camera=1,2,3', 'camera=1,2,3,4,5,NaN', 'hide=a', 'hide=-1', 'cut=w,1',
                     'cut=x,2', 'cut=x,nan', 'theme=pink', 'level=-1', 'level=100', 'level=x', 'off=%3Cscript%3E', '=', '&&', 'constructor=1'])
    assert.deepEqual(Object.entries(fromHash(bad)).filter(([, value]) => value.length !== 0), [], bad);
});
