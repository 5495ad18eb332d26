// Builds ../built/page.html: the page with its script, bundled and minified, and places for title and data.
// With a file's name it writes there instead. `check` runs it in a copy, beside what npm installs.

import {build} from 'esbuild';
import {readFile, writeFile} from 'node:fs/promises';
import {fileURLToPath} from 'node:url';

const here = (path) => fileURLToPath(new URL(path, import.meta.url));

async function bundled(entry, more) {
  const result = await build({
    entryPoints: [here(entry)], bundle: true, minify: true, write: false, charset: 'ascii', legalComments: 'none',
    target: ['chrome111', 'firefox115', 'safari16.4'], ...more,
  });
  return result.outputFiles[0].text.trim();
}

const licence = (await readFile(here('node_modules/three/LICENSE'), 'utf8')).trim().replaceAll('\u00a9', '(c)');
const version = JSON.parse(await readFile(here('node_modules/three/package.json'), 'utf8')).version;
// Minified JavaScript has no comments, but the shaders in it, which are text to it, have.
const whole = await bundled('source/main.js', {format: 'iife'});
const script = whole.replace(/[ \t]+\/\/[^\n`]*(?=[\n`])/g, '');
const quotes = (text) => text.split('`').length;
if (quotes(script) !== quotes(whole)) throw new Error('more than comments would be left out');
const style = await bundled('source/style.css', {});
if (/<\/(script|style)/i.test(script + style)) throw new Error('the script would end the page');
const parts = {style, script: `/* three.js ${version}\n\n${licence}\n*/\n${script}`};
const page = (await readFile(here('source/page.html'), 'utf8'))
                 .replace(/\{\{(style|script)\}\}/g, (_, name) => parts[name]);
if (/[^\x00-\x7f]/.test(page)) throw new Error('the page is not ASCII');
for (const place of ['{{title}}', '{{data}}'])
  if (page.split(place).length !== 2) throw new Error(`the page needs ${place} once`);
const out = process.argv[2] ?? here('built/page.html');
await writeFile(out, page);
console.log(`${out}: ${page.length} bytes`);
