// Files as they come, the wrong ones too.
import assert from 'node:assert/strict';
import {test} from 'node:test';

import {atWork} from './support/browser.js';
import {BROKEN, MOVES, TILE} from './support/models.js';

test('A G-code file is uploaded, printed to its end, and has no layers to show', () =>
  atWork({}, async (page) => {
    await page.put('moves.gcode', MOVES);
    assert.equal(await page.button('Show layers of moves.gcode').count(), 0);

    await page.press('Queue moves.gcode');

    await page.says(page.job(1), /done/);
  }));

test('A file of a kind that cannot be printed is refused with the kinds that can', () =>
  atWork({}, async (page, watch) => {
    watch.foresee(/photo\.jpg.* 400|status of 400/);

    await page.drop('photo.jpg', 'not a model');

    await page.says(page.fault, /photo\.jpg.*\.lua/s);
    assert.equal(await page.page.locator('#files').getByRole('listitem').count(), 0);
  }));

test('A script with a mistake is told with its line, and nothing is printed', () =>
  atWork({}, async (page, watch) => {
    watch.foresee(/broken\.lua.* 400|status of 400/);
    await page.put('broken.lua', BROKEN);

    await page.press('Show layers of broken.lua');
    await page.says(page.fault, /broken\.lua.*2/s);
    await page.press('Queue broken.lua');

    await page.says(page.job(1), /failed.*broken\.lua/s);
    await page.says(page.state, /^stopped$/);
    await page.says(page.page.locator('#message'), /broken\.lua/);
  }));

test('A deleted file is gone from the list; one of the same name replaces it', () =>
  atWork({}, async (page) => {
    await page.put('tile.lua', TILE);
    await page.pictured('tile.lua');
    await page.put('tile.lua', `${TILE}-- again\n`);
    assert.equal(await page.file('tile.lua').count(), 1);
    await page.pictured('tile.lua');

    await page.press('Delete tile.lua');

    await page.file('tile.lua').waitFor({state: 'detached'});
  }));

test('A name that is markup is shown as it is', () =>
  atWork({}, async (page) => {
    const name = '<img src=x onerror=alert(1)>.gcode';

    await page.put(name, MOVES);

    assert.equal(await page.page.locator('#files img').count(), 0);
  }));
