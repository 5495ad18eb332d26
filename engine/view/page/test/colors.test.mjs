import assert from 'node:assert/strict';
import {readFileSync} from 'node:fs';
import test from 'node:test';
import {kBrightness, kMarked, kMarks, kPalette} from '../source/colors.js';

/** The sights of the three kinds of dichromats: Machado, Oliveira and Fernandes, "A physiologically-based model for simulation
 * of color vision deficiency", 2009, at full severity, on linear RGB. */
const kSights = {
  everybody: [[1, 0, 0], [0, 1, 0], [0, 0, 1]],
  protanopia: [[0.152286, 1.052583, -0.204868], [0.114503, 0.786281, 0.099216], [-0.003882, -0.048116, 1.051998]],
  deuteranopia: [[0.367322, 0.860646, -0.227968], [0.280085, 0.672501, 0.047413], [-0.011820, 0.042940, 0.968881]],
  tritanopia: [[1.255528, -0.076749, -0.178779], [-0.078411, 0.930809, 0.147602], [0.004733, 0.691367, 0.303900]],
};
const kXyz = [[0.4124564, 0.3575761, 0.1804375], [0.2126729, 0.7151522, 0.0721750], [0.0193339, 0.1191920, 0.9503041]];
const kWhite = [0.95047, 1, 1.08883];

const times = (matrix, vector) => matrix.map((row) => row.reduce((sum, x, i) => sum + x * vector[i], 0));
const linear = (x) => (x <= 0.04045 ? x / 12.92 : ((x + 0.055) / 1.055) ** 2.4);
const screen = (color, brightness = 1) => [1, 3, 5].map((i) => parseInt(color.slice(i, i + 2), 16) / 255 * brightness);

/** CIELAB, 1976. */
function lab(numbers, sight) {
  const seen = times(kSights[sight], numbers.map(linear)).map((x) => Math.min(1, Math.max(0, x)));
  const [x, y, z] = times(kXyz, seen).map((value, i) => value / kWhite[i])
                        .map((t) => (t > 216 / 24389 ? Math.cbrt(t) : (24389 / 27 * t + 16) / 116));
  return [116 * y - 16, 500 * (x - y), 200 * (y - z)];
}

function away(a, b, sight) {
  const [p, q] = [lab(a, sight), lab(b, sight)];
  return Math.hypot(...p.map((x, i) => x - q[i]));
}

/** Fails where anybody sees two of these as nearer than `least`: about 2 can just be told apart side by side. */
function tellApart(colors, least) {
  const names = Object.keys(colors);
  names.forEach((a, i) => names.slice(0, i).forEach((b) => {
    for (const sight of Object.keys(kSights)) {
      const distance = away(colors[a], colors[b], sight);
      assert.ok(distance >= least, `${a} and ${b} with ${sight}: ${distance.toFixed(1)}`);
    }
  }));
}

test('the distance is that of CIELAB: black and white are 100 apart, grey is grey for all', () => {
  for (const sight of Object.keys(kSights)) assert.ok(Math.abs(away([0, 0, 0], [1, 1, 1], sight) - 100) < 0.1);
  // That red and this green are what most of the colour-blind take for each other.
  assert.ok(away(screen('#a33a00'), screen('#5f5f00'), 'deuteranopia') < 0.4 * away(screen('#a33a00'), screen('#5f5f00'), 'everybody'));
});

test('bodies are told apart by all', () => {
  tellApart(Object.fromEntries(kPalette.map((color) => [color, screen(color)])), 14);
});

for (const theme of ['light', 'dark']) {
  const marks = {triangle: kMarked, ...kMarks[theme]};
  test(`${theme}: marks are told from each other`, () => {
    const {line, box, ...main} = marks;
    tellApart(Object.fromEntries(Object.entries(main).map(([name, color]) => [name, screen(color)])), 20);
  });

  test(`${theme}: marks are told from every body, as it is lit`, () => {
    for (const color of kPalette)
      for (const [name, mark] of Object.entries(marks))
        tellApart({[name]: screen(mark), [color]: screen(color, kBrightness[theme])}, name === 'line' || name === 'box' ? 12 : 16);
  });

  test(`${theme}: states on the slider are told from each other and from the ground`, () => {
    const css = readFileSync(new URL('../source/style.css', import.meta.url), 'utf8');
    const block = css.match(theme === 'light' ? /:root \{([^}]*)\}/ : /\[data-theme="dark"\] \{([^}]*)\}/)[1];
    const of = (name) => screen(block.match(new RegExp(`--${name}: (#[\\da-f]{6})`))[1]);
    tellApart({touching: of('touch'), clear: of('clear'), unknown: of('unknown'), ground: of('ground')}, 20);
  });
}
