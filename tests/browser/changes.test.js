// Settings changed while a model is printed.
import assert from 'node:assert/strict';
import {test} from 'node:test';

import {atWork, DESKTOP, PHONE} from './support/browser.js';
import {TOWER} from './support/models.js';

for (const [name, look] of Object.entries({'a desktop': DESKTOP, 'a phone': PHONE})) {
  test(`The infill of the layers to come is changed in a print (${name})`, () =>
    atWork({look}, async (page, watch, shop) => {
      await page.drop('tower.lua', TOWER);
      await page.press('Queue tower.lua');
      await page.page.getByText('Change the layers to come').click();

      await page.page.locator('#changes').getByLabel('Infill (%)').fill('40');
      await page.press('Change from the next layer on');

      const told = page.page.locator('#changes li');
      await page.says(told, /from layer \d+: infill 40 %/);
      const job = await (await page.page.request.get(`${shop.url}/api/v1/jobs/1`)).json();
      assert.deepEqual(job.changes.map(({settings}) => settings), [{infill_density: 0.4}]);
      await page.says(page.state, /printing/);

      await page.press('Cancel print');
      await page.says(page.job(1), /cancelled/);
      await page.page.locator('#changes').waitFor({state: 'hidden'});
    }));
}
