// One test: a workshop, a browser's window and the page in it; what all of them left is looked at
// and cleared away afterwards.
import {readFile} from 'node:fs/promises';
import {basename, join} from 'node:path';

import {chromium} from 'playwright-core';

import {PrinterPage} from './printer_page.js';
import {Watch} from './watch.js';
import {Workshop} from './workshop.js';

const CHROMIUM = process.env.CHROMIUM ?? '/usr/bin/chromium';
const WEB = process.env.WEB;
const PATIENCE_MS = 30_000;

export const DESKTOP = {viewport: {width: 1280, height: 900}};
export const PHONE = {viewport: {width: 360, height: 740}, hasTouch: true, isMobile: true, deviceScaleFactor: 2};

// While the page is worked on: its files from this folder, without building the daemon anew.
async function serveFrom(folder, context) {
  await context.route('**/assets/*', (route) => route.fulfill({path: join(folder, basename(route.request().url()))}));
  await context.route((url) => url.pathname === '/', async (route) => {
    const response = await route.fetch();
    await route.fulfill({response, body: await readFile(join(folder, 'index.html'))});
  });
}

// Opens an empty window of a browser that is to stay at `url` and calls `act(window, watch)`.
export async function inWindow(url, {foreseen = [], ...look}, act) {
  const browser = await chromium.launch({executablePath: CHROMIUM, args: ['--disable-gpu']});
  try {
    const context = await browser.newContext({...DESKTOP, ...look});
    context.setDefaultTimeout(PATIENCE_MS);
    if (WEB) await serveFrom(WEB, context);
    const watch = new Watch(context, url);
    for (const pattern of foreseen) watch.foresee(pattern);
    await act(await context.newPage(), watch);
    watch.end();
  } finally {
    await browser.close();
  }
}

// The same with the page in it: `act(page, watch)`. `foreseen`: what the page meets as it opens.
export function inBrowser(url, look, act) {
  return inWindow(url, look, async (window, watch) => act(await PrinterPage.open(window, url), watch));
}

// The same with a daemon of its own.
export async function atWork({look = DESKTOP, ...shop}, act) {
  const workshop = await Workshop.open(shop);
  try {
    await inBrowser(workshop.url, look, (page, watch) => act(page, watch, workshop));
  } finally {
    await workshop.close();
  }
}
