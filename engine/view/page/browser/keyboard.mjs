// All that a page can do, by keys alone: nothing here uses a pointer.

import assert from 'node:assert/strict';
import {readFileSync} from 'node:fs';
import {join} from 'node:path';
import {count, folder, kBlue, kSand, open, settle, view} from './pages.mjs';

/** Presses Tab until something has the focus, and says how it is seen that it has. */
async function tabTo(page, selector) {
  for (let i = 0; i < 200; ++i) {
    await page.keyboard.press('Tab');
    const {isThere, outline} = await page.evaluate((wanted) => {
      const focused = document.activeElement, style = focused && getComputedStyle(focused);
      return {isThere: focused?.matches(wanted) ?? false, outline: style ? `${style.outlineStyle} ${parseFloat(style.outlineWidth)}` : ''};
    }, selector);
    if (!isThere) continue;
    assert.match(outline, /^solid [2-9]/, `${selector} does not show that it has the focus`);
    return;
  }
  assert.fail(`no Tab leads to ${selector}`);
}

const sight = (page) => page.evaluate(() => window.grazePage.stage.sight());
const away = ([x, y, z, a, b, c]) => Math.hypot(x - a, y - b, z - c);

export const keyboard = {
  async 'keys alone turn, move, zoom, play, and go from change to change'() {
    const {page, said, close} = await open(view('keys', 'meshes/bolt.obj', 'meshes/nut.stl', '--poses', 'poses/bolt-nut.cross.txt'));
    await tabTo(page, '#canvas');
    const first = await sight(page);
    await page.keyboard.press('ArrowLeft');
    await page.keyboard.press('ArrowUp');
    const turned = await sight(page);
    assert.ok(Math.abs(away(turned) - away(first)) < 1e-6 * away(first), 'as far away');
    assert.ok([0, 1, 2].every((i) => Math.abs(turned[i] - first[i]) > 1e-4 * away(first)), 'from elsewhere');
    await page.keyboard.press('+');
    assert.ok(away(await sight(page)) < 0.9 * away(first), 'nearer');
    await page.keyboard.press('Shift+ArrowRight');
    assert.notDeepEqual((await sight(page)).slice(3), first.slice(3), 'it looks elsewhere');
    await page.keyboard.press('f');
    await page.keyboard.press(']');
    const change = await page.textContent('#count');
    assert.ok(!change.startsWith('1 / '));
    await page.keyboard.press('[');
    assert.ok((await page.textContent('#count')).startsWith('1 / '));
    await page.keyboard.press('.');
    await page.keyboard.press('.');
    await page.keyboard.press(',');
    assert.ok((await page.textContent('#count')).startsWith('2 / '));
    const speed = await page.inputValue('#speed');
    await page.keyboard.press('s');
    assert.notEqual(await page.inputValue('#speed'), speed);
    await page.keyboard.press('Shift+S');
    assert.equal(await page.inputValue('#speed'), speed);
    await page.keyboard.press('o');
    assert.equal(await page.isChecked('#loop'), false);
    await page.keyboard.press(' ');
    await page.waitForFunction(() => !document.querySelector('#count').textContent.startsWith('2 / '), null, {timeout: 20000});
    await page.keyboard.press(' ');
    assert.equal(await page.getAttribute('#play', 'aria-label'), 'Play');
    await tabTo(page, '#slider');
    const before = Number(await page.inputValue('#slider'));
    await page.keyboard.press('ArrowLeft');
    assert.equal(Number(await page.inputValue('#slider')), before - 1, 'the slider keeps its arrows');
    await tabTo(page, '#speed');
    await page.keyboard.press('1');
    assert.equal(await page.locator('#bodies input:checked').count(), 2, 'so does the list of speeds its digits');
    await page.keyboard.press('Escape');
    assert.equal(await page.evaluate(() => document.activeElement.id), 'canvas');
    assert.deepEqual(said, []);
    await close();
  },

  async 'keys alone hide, isolate, jump, cut, pick and save'() {
    const {page, said, close} = await open(join(folder, 'keys.html'));
    await page.keyboard.press('End');
    await page.keyboard.press('1');
    await settle(page);
    assert.ok(await count(page, kBlue) < 500, 'the bolt is hidden');
    await page.keyboard.press('1');
    await tabTo(page, '#bodies li:nth-child(2) .name');
    const far = await sight(page);
    await page.keyboard.press('Enter');
    assert.ok(away(await sight(page)) < 0.9 * away(far), 'near the nut');
    await tabTo(page, '#bodies li:nth-child(2) button:last-child');
    await page.keyboard.press('Enter');
    await settle(page);
    const whole = await count(page, kSand);
    assert.ok(whole > 20000 && await count(page, kBlue) < 500, 'the nut alone');
    await page.keyboard.press('Escape');
    await page.keyboard.press('z');
    await settle(page);
    assert.equal(await page.inputValue('#cut-at'), '0.5');
    for (let i = 0; i < 12; ++i) await page.keyboard.press('PageDown');
    assert.equal(await page.inputValue('#cut-at'), '0.26');
    for (let i = 0; i < 2; ++i) await page.keyboard.press('z');
    await page.keyboard.press('Shift+Digit1');
    await page.keyboard.press('f');
    await page.keyboard.press('i');
    assert.match(await page.textContent('#picked'), /^bolt\.obj\ntriangle \d+\n/, 'what is in the middle');
    await page.keyboard.press('h');
    assert.match(await page.textContent('#picked'), /0x1\.[\da-f]+p-\d+/);
    await page.keyboard.press('?');
    assert.ok(await page.locator('.keys').isVisible());
    await page.keyboard.press('Escape');
    const [download] = await Promise.all([page.waitForEvent('download'), page.keyboard.press('p')]);
    assert.equal(readFileSync(await download.path()).toString('latin1', 1, 4), 'PNG');
    await page.keyboard.press('l');
    await page.waitForFunction(() => /link/.test(document.querySelector('#word').textContent), null, {timeout: 20000});
    await page.waitForFunction(() => location.hash.includes('hide=1'), null, {timeout: 20000});
    const theme = await page.getAttribute('html', 'data-theme');
    await page.keyboard.press('t');
    assert.notEqual(await page.getAttribute('html', 'data-theme'), theme);
    assert.deepEqual(said, []);
    await close();
  },

  async 'on a narrow screen a key opens the lists'() {
    const {page, said, close} = await open(join(folder, 'keys.html'), {width: 400, height: 800});
    assert.equal(await page.locator('#panel').isVisible(), false);
    await page.keyboard.press('m');
    await tabTo(page, '#bodies li:nth-child(1) input');
    await page.keyboard.press(' ');
    assert.equal(await page.locator('#bodies input:checked').count(), 1);
    await page.keyboard.press('m');
    assert.equal(await page.locator('#panel').isVisible(), false);
    await page.keyboard.press('?');
    assert.ok(await page.locator('.keys').isVisible());
    assert.deepEqual(said, []);
    await close();
  },

};
