// What a user does with a model, from the file to the part; on a desktop by day and a phone by night.
import assert from 'node:assert/strict';
import {test} from 'node:test';

import {atWork, DESKTOP, PHONE} from './support/browser.js';
import {TILE, TOWER} from './support/models.js';

const LOOKS = {
  'a desktop, light': {...DESKTOP, colorScheme: 'light'},
  'a phone, dark': {...PHONE, colorScheme: 'dark'},
};

async function begin(page, name, text) {
  await page.drop(name, text);
  await page.press(`Queue ${name}`);
  await page.says(page.state, /printing/);
}

for (const [name, look] of Object.entries(LOOKS)) {
  test(`A dropped solid is previewed, queued from there, printed to its end and in the history (${name})`, () =>
    atWork({look}, async (page) => {
      await page.drop('tile.lua', TILE);
      await page.showLayers('tile.lua');
      assert.match(await page.page.locator('#layer-text').textContent(), /^1 of 5/);
      const blank = await page.drawn('#contours');
      await page.layer.fill('4');
      await page.says(page.page.locator('#layer-text'), /^5 of 5, 0\.90 mm/);
      assert.ok(await page.drawn('#contours') > 0.5, `drawn on ${blank}`);

      await page.press('Queue this');
      await page.says(page.state, /printing/);
      await page.says(page.page.locator('#figures'), /layer [1-5] of 5/);
      await page.says(page.job(1), /done/);

      await page.says(page.state, /connected/);
      await page.press('The bed is clear');
      await page.button('The bed is clear').waitFor({state: 'hidden'});
    }));

  test(`A print is watched, paused, resumed and cancelled (${name})`, () =>
    atWork({look}, async (page) => {
      await begin(page, 'tower.lua', TOWER);
      await page.until(() => document.querySelector('#progress').value > 0);

      await page.press('Pause');
      await page.says(page.state, /paused/);
      await page.press('Resume');
      await page.says(page.state, /printing/);
      await page.press('Cancel print');

      await page.says(page.job(1), /cancelled/);
      await page.says(page.page.locator('#job'), /Nothing is being printed/);
    }));

  test(`The emergency stop is in sight wherever the page is scrolled to, and stops (${name})`, () =>
    atWork({look}, async (page) => {
      await begin(page, 'tower.lua', TOWER);
      await page.page.locator('#log').scrollIntoViewIfNeeded();
      await page.page.evaluate(() => scrollTo(0, document.body.scrollHeight));
      const seen = await page.emergencyStop.evaluate((button) => {
        const {left, right, top, bottom} = button.getBoundingClientRect();
        return left >= 0 && top >= 0 && right <= innerWidth && bottom <= innerHeight &&
          document.elementFromPoint((left + right) / 2, (top + bottom) / 2) === button;
      });
      assert.ok(seen);

      await page.emergencyStop.click();

      await page.says(page.state, /stopped/);
      await page.says(page.job(1), /emergency stop/);
    }));
}
