// Takes the pictures of docs/pictures: the page while it prints, on a desktop and on a phone.
import {mkdir, readFile} from 'node:fs/promises';
import {join} from 'node:path';

import {atWork, DESKTOP, PHONE} from './support/browser.js';

const folder = process.argv[2];
const LOOKS = {
  'page-desktop.png': {...DESKTOP, viewport: {width: 1200, height: 1000}, colorScheme: 'light'},
  'page-phone.png': {...PHONE, viewport: {width: 360, height: 1100}, deviceScaleFactor: 1, colorScheme: 'dark'},
};

const SOLIDS = ['gyroid_sphere.lua', 'twisted_vase.lua'];
const PATIENCE_MS = 300_000;

// In the middle of a layer that shows something.
function midway() {
  const [, layer, share] = /^layer (\d+), (\d+)/.exec(document.querySelector('#live').ariaLabel) ?? [];
  return layer > 40 && share > 45 && share < 75;
}

await mkdir(folder, {recursive: true});
for (const [name, look] of Object.entries(LOOKS)) {
  await atWork({look, speed: 200}, async (page) => {
    for (const solid of SOLIDS) {
      await page.put(solid, await readFile(join('configs/solids', solid), 'utf8'));
    }
    await page.press('Queue gyroid_sphere.lua');
    for (const solid of SOLIDS) await page.pictured(solid);
    if (look.viewport.width > 1000) {
      await page.showLayers('twisted_vase.lua');
      await page.layer.fill('200');
      await page.field('All up to it').check();
    }
    await page.page.waitForFunction(midway, undefined, {timeout: PATIENCE_MS});
    await page.page.evaluate(() => scrollTo(0, 0));
    await page.page.mouse.move(0, 0);
    await page.page.screenshot({path: join(folder, name)});
  });
}
