// What is done to the layers of a print that are still to come: waits and objects left out.
import assert from 'node:assert/strict';
import {test} from 'node:test';

import {atWork, DESKTOP, PHONE} from './support/browser.js';
import {TOWERS} from './support/models.js';

const jobOf = async ({page}, shop) => (await page.request.get(`${shop.url}/api/v1/jobs/1`)).json();

// Prints the two towers and waits until a layer of them is shown.
async function begin(page) {
  await page.drop('towers.lua', TOWERS);
  await page.press('Queue towers.lua');
  await page.says(page.state, /printing/);
  await page.page.locator('#live').waitFor();
}

for (const [name, look] of Object.entries({'a desktop': DESKTOP, 'a phone': PHONE})) {
  test(`A print waits before the layer that is named, and goes on (${name})`, () =>
    atWork({look}, async (page, watch, shop) => {
      await begin(page);

      await page.field('Pause before layer').fill('12');
      await page.press('Pause there');
      await page.field('Pause before layer').fill('90');
      await page.press('Pause there');
      await page.press('Do not pause before layer 90');

      await page.says(page.state, /paused/);
      assert.match(await page.page.locator('#figures').textContent(), /layer 11 of/);
      assert.deepEqual((await jobOf(page, shop)).pauses, [11]);
      await page.press('Resume');
      await page.says(page.state, /printing/);
    }));

  test(`An object that is pointed at is left out of the layers to come (${name})`, () =>
    atWork({look}, async (page, watch, shop) => {
      await begin(page);
      const live = page.page.locator('#live');
      await page.until(() => document.getElementById('figures').textContent.includes('layer 2 '));
      const {width, height} = await live.boundingBox();

      // On the left tower, whether the picture has the skirt of the first layer in it or not.
      await live.click({position: {x: width / 2 - 0.35 * width, y: height / 2}});
      assert.ok(Number(await page.field('X (mm)').inputValue()) < 105);
      await page.press('Leave it out from the next layer on');

      await page.says(page.page.locator('#changes li'), /from layer \d+: without the object at/);
      const [{settings}] = (await jobOf(page, shop)).changes;
      assert.match(settings.cancel_object, /^\d+ /);
    }));
}
