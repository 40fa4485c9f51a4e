// Small windows, colours and keys.
import assert from 'node:assert/strict';
import {test} from 'node:test';

import {atWork, DESKTOP, PHONE} from './support/browser.js';
import {faint, focused, narrow} from './support/looks.js';
import {MOVES, TILE, TOWER} from './support/models.js';

for (const [size, window] of Object.entries({desktop: DESKTOP, phone: PHONE})) {
  for (const colorScheme of ['light', 'dark']) {
    test(`All that is read has contrast, nothing is wider than the window (${size}, ${colorScheme})`, () =>
      atWork({look: {...window, colorScheme}}, async (page) => {
        await page.put('a-file-with-a-name-as-long-as-some-slicers-make-them_0.2mm_PLA_MK3S_2h13m.lua', TOWER);
        await page.put('tile.lua', TILE);
        await page.showLayers('tile.lua');
        await page.press('Queue tile.lua');
        await page.says(page.state, /printing/);

        assert.deepEqual(await page.page.evaluate(faint), []);
        assert.deepEqual(await page.page.evaluate(narrow), []);
      }));
  }
}

test('A print is begun, paused and cancelled by keys alone, and the focus is always seen', () =>
  atWork({}, async (page) => {
    const keys = page.page.keyboard;
    // Presses Tab until the focus is on what is called `name`.
    const tabTo = async (name) => {
      for (let i = 0; i < 80; ++i) {
        await keys.press('Tab');
        const at = await page.page.evaluate(focused);
        assert.deepEqual(at.faults, [], at.name);
        if (at.name === name) return;
      }
      assert.fail(`Tab does not lead to ${name}`);
    };

    // Long before the key: a browser under load opens its own dialog otherwise.
    page.page.once('filechooser', (chooser) =>
      chooser.setFiles({name: 'tower.lua', mimeType: 'text/plain', buffer: Buffer.from(TOWER)}));

    await tabTo('Drop models or G-code here, or choose:');
    await keys.press('Enter');
    await page.file('tower.lua').waitFor();
    await tabTo('Queue tower.lua');
    await keys.press('Enter');
    await page.says(page.state, /printing/);
    await tabTo('Pause');
    await keys.press('Space');
    await page.says(page.state, /paused/);
    await tabTo('Cancel print');
    await keys.press('Enter');

    await page.says(page.job(1), /cancelled/);
  }));

test('Nobody asks the page to be quiet: the state is told to screen readers, each picture has a name', () =>
  atWork({}, async (page) => {
    await page.put('moves.gcode', MOVES);

    assert.equal(await page.state.getAttribute('aria-live'), 'polite');
    const nameless = await page.page.evaluate(() =>
      [...document.querySelectorAll('canvas, img, input, select, button')]
        .filter(({ariaLabel, labels, textContent, alt}) => !(ariaLabel || labels?.length || textContent.trim() || alt))
        .map((element) => element.outerHTML));
    assert.deepEqual(nameless, []);
  }));
