import assert from 'node:assert/strict';
import test from 'node:test';
import {kGrids} from '../source/coarse.js';
import {Quality} from '../source/quality.js';

/** Bodies of 15,000 triangles, as many as the surface of their cells needs. */
const bodies = (count, pixels) => Array.from({length: count}, () => (
    {pixels, countAt: (level) => level >= kGrids.length ? 15000 : Math.min(15000, 3 * kGrids[level] ** 2)}));

test('light pictures are drawn whole, moving or not', () => {
  const quality = new Quality();
  assert.equal(quality.cell(bodies(20, 100), true), 0);
  assert.equal(quality.cell(bodies(20, 100), false), 0);
});

test('a heavy one is coarser while it moves, and hardly when it stands', () => {
  const quality = new Quality();
  const moving = quality.cell(bodies(200, 100), true), still = quality.cell(bodies(200, 100), false);
  assert.ok(moving >= 2 && still === 1, `${moving} ${still}`);
});

test('a slow machine draws less and less, down to a bound, and a quick one more again', () => {
  const quality = new Quality();
  const cells = [];
  for (let i = 0; i < 10; ++i) {
    cells.push(quality.cell(bodies(200, 100), true));
    quality.took(500);
  }
  assert.ok(cells.every((cell, i) => i === 0 || cell >= cells[i - 1]), cells.join());
  assert.ok(cells[9] > 2 * cells[0] && cells[9] <= 36);
  assert.equal(quality.resolution, 0.5);
  assert.ok(!quality.drawsAll(3e6), 'nor all once nothing moves');
  assert.ok(quality.cell(bodies(200, 100), false) < cells[9], 'but more than while it moved');
  for (let i = 0; i < 40; ++i) quality.took(10);
  assert.equal(quality.resolution, 1);
  assert.equal(quality.cell(bodies(200, 100), true), 2);
  assert.ok(quality.drawsAll(3e6));
});

test('what takes as long as it should changes nothing', () => {
  const quality = new Quality();
  for (let i = 0; i < 100; ++i) quality.took(33);
  assert.equal(quality.budget, new Quality().budget);
});
