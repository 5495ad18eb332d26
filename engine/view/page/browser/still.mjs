// A picture of a page of the viewer: still.mjs PAGE OUT.png [WIDTH HEIGHT [KEY...]]. The keys are pressed first, by their
// names in playwright: End, c, ArrowLeft.

import {resolve} from 'node:path';
import {chromium} from 'playwright-core';

const [page, out, width = '1100', height = '680', ...keys] = process.argv.slice(2);
const browser = await chromium.launch({
  executablePath: process.env.CHROMIUM ?? '/usr/bin/chromium',
  args: ['--no-sandbox', '--disable-dev-shm-usage', '--use-angle=swiftshader', '--enable-unsafe-swiftshader'],
});
const context = await browser.newContext({viewport: {width: Number(width), height: Number(height)}});
const shown = await context.newPage();
await shown.goto(`file://${resolve(page)}`);
await shown.waitForFunction(() => document.documentElement.dataset.ready, null, {timeout: 60000});
for (const key of keys) await shown.keyboard.press(key);
// Finer, and with smooth borders, once nothing moves.
await shown.waitForTimeout(2000);
await shown.screenshot({path: out});
await browser.close();
