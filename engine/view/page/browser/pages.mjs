// Pages that the graze command writes, in a headless Chromium whose WebGL is software, and what is seen on them. The
// program that imports it is called with GRAZE DATA.

import {execFileSync} from 'node:child_process';
import {mkdtempSync} from 'node:fs';
import {tmpdir} from 'node:os';
import {join, resolve} from 'node:path';
import {inflateSync} from 'node:zlib';
import {chromium} from 'playwright-core';

export const [graze, data] = process.argv.slice(2).map((path) => resolve(path));
export const folder = mkdtempSync(join(tmpdir(), 'graze-view-'));
const found = ['chromium', 'chromium-browser', 'google-chrome'].map((name) => {
  try {
    return execFileSync('sh', ['-c', `command -v ${name}`], {encoding: 'utf8'}).trim();
  } catch {
    return '';
  }
}).find(Boolean);
if (!found) throw new Error('no Chromium; .ci/setup view installs it');

export const kMarked = (r, g, b) => r > 150 && g < 90 && b < 110;
export const kBlue = (r, g, b) => b > r + 25 && b > 90 && g > r;
export const kSand = (r, g, b) => r > b + 30 && g > b + 15 && r > 100;
export const kGap = (r, g, b) => g > r + 60 && b > r + 40 && r < 60;

/** Rows of RGBA of a PNG as Chromium writes them: 8 bits, RGB or RGBA, not interlaced. */
function pixelsOf(png) {
  const width = png.readUInt32BE(16), height = png.readUInt32BE(20), channels = png[25] === 6 ? 4 : 3;
  const parts = [];
  for (let at = 8; at < png.length;) {
    const length = png.readUInt32BE(at);
    if (png.toString('latin1', at + 4, at + 8) === 'IDAT') parts.push(png.subarray(at + 8, at + 8 + length));
    at += length + 12;
  }
  const raw = inflateSync(Buffer.concat(parts)), stride = width * channels;
  const out = new Uint8Array(height * stride);
  for (let y = 0; y < height; ++y) {
    const filter = raw[y * (stride + 1)];
    for (let x = 0; x < stride; ++x) {
      const a = x < channels ? 0 : out[y * stride + x - channels], b = y === 0 ? 0 : out[(y - 1) * stride + x];
      const c = x < channels || y === 0 ? 0 : out[(y - 1) * stride + x - channels];
      const p = a + b - c, pa = Math.abs(p - a), pb = Math.abs(p - b), pc = Math.abs(p - c);
      const paeth = pa <= pb && pa <= pc ? a : pb <= pc ? b : c;
      out[y * stride + x] = raw[y * (stride + 1) + 1 + x] + [0, a, b, a + b >> 1, paeth][filter];
    }
  }
  return {out, channels};
}

/** The picture alone, without the words over it. */
export async function picture(page) {
  return pixelsOf(await page.locator('#canvas').screenshot({style: '#stage > :not(#canvas) {visibility: hidden !important}'}));
}

export async function count(page, isIt) {
  const {out, channels} = await picture(page);
  let found = 0;
  for (let i = 0; i < out.length; i += channels) if (isIt(out[i], out[i + 1], out[i + 2])) ++found;
  return found;
}

export function view(name, ...words) {
  const file = join(folder, `${name}.html`);
  execFileSync(graze, ['view', ...words, '-o', file], {cwd: data, stdio: ['ignore', 'ignore', 'inherit']});
  return file;
}

export const browser = await chromium.launch({
  executablePath: found,
  args: ['--no-sandbox', '--disable-dev-shm-usage', '--use-angle=swiftshader', '--enable-unsafe-swiftshader'],
});

/** Opens a page; whatever it says on the console, asks of a network, or throws is in `said`. */
export async function open(file, {width = 1400, height = 860, hash = '', args = {}, isReport = false} = {}) {
  const context = await browser.newContext({viewport: {width, height}, acceptDownloads: true, ...args});
  const page = await context.newPage(), said = [];
  page.on('console', (message) => { if (!/GPU stall|GL Driver/.test(message.text())) said.push(message.text()); });
  page.on('pageerror', (error) => said.push(String(error.stack)));
  page.on('request', (request) => { if (!/^(file|blob|about):/.test(request.url())) said.push(`asks for ${request.url()}`); });
  await page.goto(`file://${file}${hash}`);
  if (!isReport) await page.waitForFunction(() => document.documentElement.dataset.ready || document.querySelector('.refusal'), null,
                             {timeout: 60000});
  return {page, said, close: () => context.close()};
}

/** Two pictures later: what was asked for is drawn. */
export const settle = (page) => page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(() => setTimeout(done, 50)))));
