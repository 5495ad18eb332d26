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

test('a slow machine draws fewer triangles, then fewer pixels, then still fewer triangles, and more again when it is quick', () => {
  const quality = new Quality();
  const cells = [], resolutions = [];
  for (let i = 0; i < 12; ++i) {
    cells.push(quality.cell(bodies(200, 100), true));
    resolutions.push(quality.resolution);
    if (quality.resolution < 1) assert.ok(quality.budget <= 100000, `${quality.budget}`);
    if (quality.budget < 100000) assert.equal(quality.resolution, 0.5);
    quality.took(500);
  }
  assert.ok(cells.every((cell, i) => i === 0 || cell >= cells[i - 1]), cells.join());
  assert.ok(cells[11] > 2 * cells[0] && cells[11] <= 36);
  assert.ok(resolutions.includes(0.75) && resolutions[11] === 0.5, resolutions.join());
  assert.equal(quality.cell(bodies(80, 100), false), 1, 'all that can be seen, once nothing moves');
  assert.ok(quality.cell(bodies(2000, 1000), false) > 1, 'but not of 30 million triangles');
  for (let i = 0; i < 40; ++i) quality.took(10);
  assert.equal(quality.resolution, 1);
  assert.equal(quality.cell(bodies(200, 100), true), 2);
});

test('thirty pictures a second are quick enough, and fewer are not', () => {
  for (const milliseconds of [21, 25, 33]) {
    const quality = new Quality();
    for (let i = 0; i < 100; ++i) quality.took(milliseconds);
    assert.deepEqual([quality.budget, quality.resolution], [new Quality().budget, 1]);
  }
  const quality = new Quality();
  quality.took(36);
  assert.ok(quality.budget < new Quality().budget);
});
