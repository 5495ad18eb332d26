import assert from 'node:assert/strict';
import test from 'node:test';
import {hexFloat, length, number, roundLength} from '../source/units.js';

test('numbers have as many digits as are asked for, and no zeros behind', () => {
  assert.equal(number(0), '0');
  assert.equal(number(0.1 + 0.2), '0.3');
  assert.equal(number(1234.56), '1235');
  assert.equal(number(-2.5e-7, 3), '-2.5e-7');
  assert.equal(number(1e300), '1e+300');
  assert.equal(number(Infinity), 'Infinity');
});

test('metres get the prefix that leaves one to three digits before the point', () => {
  assert.equal(length(0.000132, 'm'), '132 \u00b5m');
  assert.equal(length(0.0123456, 'm'), '12.35 mm');
  assert.equal(length(1, 'm'), '1 m');
  assert.equal(length(0.999, 'm'), '999 mm');
  assert.equal(length(15300, 'm'), '15.3 km');
  assert.equal(length(3e-9, 'm'), '3 nm');
  assert.equal(length(1e-300, 'm'), '1e-300 m');
  assert.equal(length(0, 'm'), '0 m');
  assert.equal(length(0.01, 'inch'), '0.01 inch');
});

test('the bar of a scale is round and no longer than its room', () => {
  for (const [most, expected] of [[1, 1], [1.99, 1], [2, 2], [4.9, 2], [5, 5], [9.99, 5], [0.0314, 0.02], [1e-7, 1e-7]])
    assert.ok(Math.abs(roundLength(most) / expected - 1) < 1e-12, `${most}`);
});

// As printf's %a writes them.
test('doubles are written in hexadecimal, to the last bit', () => {
  const known = [[1, '0x1p+0'], [-0.5, '-0x1p-1'], [0.1, '0x1.999999999999ap-4'], [0, '0x0p+0'], [-0, '-0x0p+0'],
                 [5e-324, '0x0.0000000000001p-1022'], [Number.MAX_VALUE, '0x1.fffffffffffffp+1023'],
                 [2.2250738585072014e-308, '0x1p-1022'], [1 + Number.EPSILON, '0x1.0000000000001p+0']];
  for (const [value, text] of known) assert.equal(hexFloat(value), text);
});
