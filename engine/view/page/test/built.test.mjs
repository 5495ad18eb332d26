// The page as it is built: its script begins, and says what is wrong with data that are none. What a bundler leaves out
// by mistake shows here, without a screen.

import assert from 'node:assert/strict';
import {readFile} from 'node:fs/promises';
import test from 'node:test';
import vm from 'node:vm';

const page = await readFile(new URL('../built/page.html', import.meta.url), 'utf8');

/** As much of a document as the page asks for before it draws. */
function pageWithData(data) {
  const words = [];
  const element = (id) => ({
    id, textContent: id === 'data' ? data : '', hidden: false, dataset: {}, style: {},
    setAttribute() {}, addEventListener() {}, append() {},
  });
  const document = {
    getElementById: element, documentElement: element(''), createElementNS: element, addEventListener() {},
    createElement: () => ({setAttribute() {}, set textContent(text) { words.push(text); }}),
    body: {append() {}},
  };
  const window = {addEventListener() {}, document, navigator: {userAgent: ''}};
  const script = page.slice(page.lastIndexOf('<script>') + 8, page.lastIndexOf('</script>'));
  const context = {document, window, self: window, navigator: window.navigator, atob, Blob, Response,
                   DecompressionStream, TextDecoder, console, performance, setTimeout, clearTimeout};
  vm.runInNewContext(script, context);
  return words;
}

test('its script begins, and refuses what is no page with a word', async () => {
  const words = pageWithData('!');
  await new Promise((done) => setTimeout(done, 50));
  assert.deepEqual(words, ['Nothing can be shown: the data of this page is not Base64: the file is cut off or was changed.']);
});

test('it has its places, and nothing of other hosts', () => {
  for (const place of ['{{title}}', '{{data}}']) assert.equal(page.split(place).length, 2);
  assert.doesNotMatch(page, /(src|href)="https?:/);
});
