// This looks at pages as people see them: look.mjs GRAZE DATA. The graze command writes them, and a headless Chromium
// whose WebGL is software opens them from a disk. Pixels, requests and the console are looked at. It fails with a
// sentence.

import assert from 'node:assert/strict';
import {execFileSync} from 'node:child_process';
import {readFileSync, rmSync, writeFileSync} from 'node:fs';
import {join} from 'node:path';
import {crowd} from './crowd.mjs';
import {keyboard} from './keyboard.mjs';
import {browser, count, data, folder, graze, kBlue, kGap, kMarked, kSand, open, picture, settle, view} from './pages.mjs';

const tests = {
  async 'intersecting triangles are red, and can be switched off'() {
    const file = view('deep', 'meshes/bolt.obj', 'meshes/nut.stl', '--pose-b', '1 0 0 0  0 1 0 0  0 0 1 0.002');
    const {page, said, close} = await open(file);
    assert.equal(await page.textContent('#state'), 'touching');
    const red = await count(page, kMarked);
    assert.ok(red > 500, `${red} red pixels`);
    assert.ok(await count(page, kBlue) > 20000, 'the bolt');
    assert.ok(await count(page, kSand) > 20000, 'the nut');
    await page.getByLabel('intersecting triangles').uncheck();
    await settle(page);
    assert.ok(await count(page, kMarked) < red / 10, 'without them');
    await page.keyboard.press('2');
    await settle(page);
    assert.ok(await count(page, kSand) < 500, 'the nut is hidden by its key');
    assert.deepEqual(said, []);
    await close();
  },

  async 'a slider of poses: keys go from change to change, and playing goes on by itself'() {
    const file = view('poses', 'meshes/bolt.obj', 'meshes/nut.stl', '--poses', 'poses/bolt-nut.cross.txt');
    const {page, said, close} = await open(file);
    const states = [];
    for (let i = 0; i < 3; ++i) {
      states.push(await page.textContent('#state'));
      const before = await page.textContent('#count');
      await page.keyboard.press(']');
      if (await page.textContent('#count') === before) break;
    }
    assert.ok(states.includes('touching') && states.includes('clear'), states.join());
    await page.keyboard.press('Home');
    assert.ok((await page.textContent('#count')).startsWith('1 / '));
    await page.selectOption('#speed', '30');
    await page.keyboard.press(' ');
    await page.waitForFunction(() => !document.querySelector('#count').textContent.startsWith('1 / '), null, {timeout: 10000});
    assert.deepEqual(said, []);
    await close();
  },

  async 'a gap is green and has its number'() {
    const file = view('apart', 'meshes/bolt.obj', 'meshes/nut.stl', '--pose-b', '1 0 0 0  0 1 0 0  0 0 1 0.04');
    const {page, said, close} = await open(file);
    assert.equal(await page.textContent('#state'), 'clear');
    assert.match(await page.textContent('#labels .gap'), /^\d+(\.\d+)? mm$/);
    assert.ok(await count(page, kGap) > 20);
    assert.deepEqual(said, []);
    await close();
  },

  async 'boxes of the tree come level by level, and corners in hexadecimal'() {
    const file = view('tree', 'meshes/bolt.obj', 'meshes/nut.stl', '--tree', 'obb');
    const {page, said, close} = await open(file);
    const kBox = (r, g, b) => r > 130 && g > 40 && g < 110 && b < 50;
    assert.ok(await count(page, kBox) < 20, 'none at first');
    for (const boxes of [2, 4, 8]) {
      await page.keyboard.press('b');
      await settle(page);
      assert.match(await page.textContent('#level-text'), new RegExp(`: ${boxes} boxes$`));
      assert.ok(await count(page, kBox) > 200, `${boxes} boxes`);
    }
    const {width, height} = await page.locator('#canvas').boundingBox();
    await page.mouse.click(width * 0.45, height * 0.5);
    assert.match(await page.textContent('#picked'), /corners in its own frame:\n-?\d/);
    await page.keyboard.press('h');
    assert.match(await page.textContent('#picked'), /frame:(\n*-?0x[01](\.[\da-f]+)?p[-+]\d+){9}$/);
    assert.ok(await page.evaluate(() => location.hash).then((hash) => hash === '' || hash.includes('level=2')));
    assert.deepEqual(said, []);
    await close();
  },

  async 'a plane keeps bodies apart, and pairs lead to where they begin'() {
    const apart = await open(join(folder, 'apart.html'));
    await apart.page.getByLabel('nearest points').uncheck();
    await settle(apart.page);
    const kPlane = (r, g, b) => g > r + 12 && Math.abs(g - b) < 8 && g > 180;
    assert.ok(await count(apart.page, kPlane) > 5000, 'the plane');
    await apart.page.getByLabel('separating planes').uncheck();
    await settle(apart.page);
    assert.ok(await count(apart.page, kPlane) < 500);
    assert.deepEqual(apart.said, []);
    await apart.close();
    const {page, said, close} = await open(view('parts', 'scenes/parts.json'));
    assert.match(await page.textContent('#pairs-head'), /^Pairs: \d+ of 3 touch$/);
    const later = page.locator('#pairs [data-state=clear]').first();
    await later.click();
    assert.ok(!(await page.textContent('#count')).startsWith('1 / '));
    await page.locator('#pairs').getByText('only').first().click();
    assert.equal(await page.locator('#bodies input:checked').count(), 2);
    assert.deepEqual(said, []);
    await close();
  },

  async 'a cut opens the nut, and what is under the pointer is named'() {
    const {page, said, close} = await open(join(folder, 'deep.html'));
    await page.keyboard.press('Shift+Digit2');
    await page.keyboard.press('y');
    await settle(page);
    assert.equal(await page.getAttribute('[data-axis=y]', 'aria-pressed'), 'true');
    const {width, height} = await page.locator('#canvas').boundingBox();
    let text = '';
    for (const [x, y] of [[0.4, 0.55], [0.6, 0.55], [0.37, 0.6], [0.63, 0.6]]) {
      await page.mouse.move(width * x, height * y);
      // Beside the body there is none.
      await page.locator('#tip').waitFor({state: 'visible', timeout: 3000}).catch(() => {});
      if (await page.locator('#tip').isVisible()) text = await page.textContent('#tip');
      if (text) break;
    }
    assert.match(text, /^nut\.stl\ntriangle \d+\n\(.*\) m$/);
    const point = text.match(/\(([^)]*)\)/)[1].split(',').map(Number);
    assert.ok(point.every((x) => Math.abs(x) < 0.05), `${point}`);
    assert.deepEqual(said, []);
    await close();
  },

  async 'a link carries the view'() {
    const {page, close} = await open(join(folder, 'poses.html'));
    await page.keyboard.press('.');
    for (const key of ['ArrowLeft', 'ArrowUp', '+', '1', 'x', 't']) await page.keyboard.press(key);
    await page.waitForFunction(() => location.hash.includes('theme=dark'), null, {timeout: 20000});
    const link = new URL(page.url()).hash;
    for (const word of ['frame=1', 'camera=', 'hide=0', 'cut=x,0.5', 'theme=dark']) assert.ok(link.includes(word), link);
    const other = await open(join(folder, 'poses.html'), {hash: link});
    await settle(other.page);
    await settle(page);
    // A link has five digits of the camera.
    const {out: first} = await picture(page), {out: second} = await picture(other.page);
    assert.equal(first.length, second.length);
    const others = first.filter((x, i) => Math.abs(x - second[i]) > 40).length;
    assert.ok(others < first.length / 500, `${others} of ${first.length} differ`);
    assert.ok(await count(other.page, (r, g, b) => r + g + b < 150) > first.length / 8, 'and dark');
    assert.deepEqual(other.said, []);
    await other.close();
    await close();
  },

  async 'a picture is saved'() {
    const {page, close} = await open(join(folder, 'deep.html'));
    const [download] = await Promise.all([page.waitForEvent('download'), page.keyboard.press('p')]);
    assert.match(download.suggestedFilename(), /\.png$/);
    const png = readFileSync(await download.path());
    assert.equal(png.toString('latin1', 1, 4), 'PNG');
    assert.ok(png.length > 20000);
    await close();
  },

  async 'cases: each a picture, on one page'() {
    const {page, said, close} = await open(view('cases', 'regressions'));
    for (let i = 0; i < 12; ++i) await page.keyboard.press(']');
    await page.keyboard.press('End');
    await page.getByRole('button', {name: 'by-hand-corners-meet-distance.json'}).click();
    await settle(page);
    assert.ok((await page.textContent('#title')).includes('by-hand-corners-meet-distance.json'));
    assert.ok(await count(page, kMarked) > 10000, 'the sides of two cubes whose corners meet');
    assert.ok(await count(page, kSand) + await count(page, kBlue) > 10000, 'and the other sides');
    assert.deepEqual(said, []);
    await close();
  },

  async 'names are text'() {
    const name = join(folder, '<img src=x onerror=alert(1)>.off');
    writeFileSync(name, 'OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n');
    const {page, said, close} = await open(view('names', name, name));
    assert.equal(await page.locator('img').count(), 0);
    assert.ok((await page.textContent('#bodies')).includes('<img src=x onerror=alert(1)>'));
    assert.deepEqual(said, []);
    await close();
  },

  async 'a page that was cut off or changed says so'() {
    const whole = readFileSync(join(folder, 'deep.html'), 'utf8');
    const from = whole.indexOf('octet-stream">') + 14, to = whole.indexOf('<', from);
    const damaged = {
      cut: whole.slice(0, (from + to) >> 1) + whole.slice(to),
      changed: `${whole.slice(0, from + 5000)}AAAA${whole.slice(from + 5004)}`,
      empty: whole.slice(0, from) + whole.slice(to),
    };
    for (const [what, text] of Object.entries(damaged)) {
      const file = join(folder, `${what}.html`);
      writeFileSync(file, text);
      const {page, close} = await open(file);
      assert.match(await page.textContent('.refusal'), /^Nothing can be shown: the data of this page /, what);
      assert.equal(await page.locator('#view').isVisible(), false);
      await close();
    }
  },

  async 'on a narrow screen nothing is cut off'() {
    for (const name of ['deep', 'poses', 'cases']) {
      const {page, said, close} = await open(join(folder, `${name}.html`), {width: 400, height: 800});
      const outside = await page.evaluate(() => [...document.querySelectorAll('#view button, #view input, h1, #state, #bar')]
        .filter((e) => e.getClientRects().length > 0)
        .filter((e) => { const r = e.getBoundingClientRect(); return r.left < 0 || r.right > innerWidth + 0.5 || r.bottom > innerHeight + 0.5; })
        .map((e) => e.id || e.tagName));
      assert.deepEqual(outside, [], name);
      await page.click('#open');
      assert.ok(await page.locator('#panel').isVisible());
      assert.deepEqual(said, []);
      await close();
    }
  },

  async 'a report shows its cases, sorts and filters its tables, and prints stills'() {
    const file = join(folder, 'report.html');
    execFileSync(graze, ['compare', 'regressions', '--engines', 'graze,fcl', '--keep', '6', '--cases', join(folder, 'cases'),
                         '--report', file], {cwd: data, stdio: ['ignore', 'ignore', 'inherit']});
    const {page, said, close} = await open(file, {isReport: true});
    await page.waitForSelector('body.has-picture', {timeout: 60000});
    assert.equal(await page.locator('.still:visible').count(), 0, 'stills give way to what can be turned');
    const viewer = page.frameLocator('#viewer');
    const before = await viewer.locator('#count').textContent();
    await page.locator('.turn').last().click();
    assert.notEqual(await viewer.locator('#count').textContent(), before);
    assert.equal(await page.locator('.case.shown').count(), 1);
    const firsts = () => page.locator('table.sorted').nth(1).locator('tr:visible td:first-child').allTextContents();
    const given = await firsts();
    await page.locator('table.sorted').nth(1).locator('th button').first().click();
    const sorted = await firsts();
    assert.deepEqual([...sorted].sort(), [...given].sort());
    assert.deepEqual(sorted, [...given].sort((a, b) => a.localeCompare(b, 'en', {numeric: true})));
    await page.locator('.filter').nth(1).fill(given[0]);
    const kept = await firsts();
    assert.ok(kept.length > 0 && kept.length < given.length && kept.every((text) => text.includes(given[0])), kept.join());
    await page.emulateMedia({media: 'print'});
    assert.ok(await page.locator('.still:visible').count() >= 4, 'printed are the stills');
    assert.equal(await page.locator('#viewer').isVisible(), false);
    assert.equal((await firsts()).length, given.length, 'and all lines');
    assert.deepEqual(said, []);
    await page.emulateMedia({media: 'screen'});
    await page.setViewportSize({width: 400, height: 800});
    assert.ok(await page.evaluate(() => { scrollTo(500, 0); return scrollX; }) === 0, 'a narrow screen need not be moved sideways');
    await page.addInitScript(() => { HTMLCanvasElement.prototype.getContext = () => null; });
    await page.reload();
    await viewer.locator('.refusal').waitFor();
    assert.ok(await page.locator('.still:visible').count() >= 4, 'stills where there is no WebGL');
    await close();
  },

  async 'many bodies of one mesh are one call, and each can be hidden, picked and cut'() {
    const file = join(folder, 'crowd.html'), built = readFileSync(new URL('../built/page.html', import.meta.url), 'utf8');
    writeFileSync(file, crowd(built, join(data, 'meshes/bolt.obj'), {bodies: 200, frames: 120}));
    const {page, said, close} = await open(file);
    await page.selectOption('#speed', '60');
    await page.keyboard.press(' ');
    await page.waitForTimeout(2500);
    const {calls, rate} = await page.evaluate(() => new Promise((done) => {
      const {stage} = window.grazePage, first = stage.renderer.info.render.frame, began = performance.now();
      setTimeout(() => {
        const {calls, frame} = stage.renderer.info.render;
        done({calls, rate: 1000 * (frame - first) / (performance.now() - began)});
      }, 3000);
    }));
    console.log(`        200 moving bodies of 15,928 triangles: ${rate.toFixed(1)} pictures a second, ${calls} calls`);
    assert.ok(calls < 20, `${calls} calls`);
    // Of a machine that does nothing else 30; here others may build beside it.
    assert.ok(rate > 3, `${rate} pictures a second`);
    await page.keyboard.press(' ');
    await page.keyboard.press('Home');
    const sand = await count(page, kSand);
    await page.evaluate(() => { for (let b = 1; b < 200; b += 2) window.grazePage.panel.hide(b, true); });
    await settle(page);
    assert.ok(sand > 3000 && await count(page, kSand) < 0.6 * sand, 'those of warm colours are gone');
    await page.evaluate(() => window.grazePage.panel.isolate([7]));
    await page.keyboard.press('f');
    await settle(page);
    const place = await page.evaluate(() => {
      const {stage} = window.grazePage, {clientWidth, clientHeight} = stage.canvas;
      for (let y = 0; y < clientHeight; y += 20)
        for (let x = 0; x < clientWidth; x += 20)
          if (stage.pick(x, y)) return {x, y, body: stage.pick(x, y).body};
      return null;
    });
    assert.equal(place?.body, 7, 'the body that is shown is the one that is picked');
    const whole = await count(page, kSand);
    for (const key of ['z', 'z']) await page.keyboard.press(key);
    await settle(page);
    assert.ok(whole > 1000 && await count(page, kSand) < 0.1 * whole, 'in the lower half, which is cut off');
    assert.deepEqual(said, []);
    await close();
  },

  async 'what holds others is seen through'() {
    const scene = join(folder, 'held.json');
    writeFileSync(scene, JSON.stringify({
      graze_scene: 1, units: {length: 'm', angle: 'turn'}, step: 1, steps: 1,
      shapes: [{name: 'crate', box: {half_extents: [2, 2, 2]}}, {name: 'ball', sphere: {radius: 1}},
               {name: 'pebble', sphere: {radius: 0.2}}],
      bodies: [['crate', [0, 0, 0]], ['ball', [0, 0, 0]], ['pebble', [1.5, 0, 0]], ['pebble', [0, 1.5, 0]]]
                  .map(([shape, position], i) => ({name: `${shape} ${i}`, shape, pose: {position}})),
    }));
    const {page, said, close} = await open(view('held', scene));
    await settle(page);
    const seen = await count(page, kSand);
    assert.ok(seen > 2000, `${seen}: the balls, or some`);
    await page.getByLabel('see into containers').uncheck();
    await settle(page);
    assert.ok(await count(page, kSand) < seen / 10, 'not within an opaque box');
    assert.deepEqual(said, []);
    await close();
  },

  async 'without WebGL there is a word'() {
    const {page, close} = await open(join(folder, 'deep.html'), {hash: ''});
    await page.addInitScript(() => { HTMLCanvasElement.prototype.getContext = () => null; });
    await page.reload();
    await page.waitForSelector('.refusal');
    assert.match(await page.textContent('.refusal'), /WebGL/);
    await close();
  },
};

let failed = 0;
const all = {...tests, ...keyboard};
for (const [name, run] of Object.entries(all)) {
  const began = Date.now();
  try {
    await run();
    console.log(`ok      ${name} (${((Date.now() - began) / 1000).toFixed(1)} s)`);
  } catch (error) {
    ++failed;
    console.log(`FAILED  ${name}\n${error.stack}`);
  }
}
await browser.close();
rmSync(folder, {recursive: true, force: true});
console.log(`${Object.keys(all).length - failed} passed, ${failed} failed`);
process.exitCode = failed > 0 ? 1 : 0;
