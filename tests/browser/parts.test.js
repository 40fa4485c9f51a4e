// The parts of the page beside files and print: what they show and what they do to the printer.
import assert from 'node:assert/strict';
import {createServer} from 'node:http';
import {test} from 'node:test';

import {atWork, inBrowser, PHONE} from './support/browser.js';
import {BROKEN, MOVES, TILE, TOWER} from './support/models.js';
import {Workshop} from './support/workshop.js';

async function begin(page) {
  await page.put('tower.lua', TOWER);
  await page.press('Queue tower.lua');
}

test('The layer under way is drawn as it is laid, with the time that is left', () =>
  atWork({look: PHONE, speed: 100}, async (page) => {
    await begin(page);

    await page.until(() => /^layer [1-9]/.test(document.querySelector('#live').ariaLabel));
    await page.until(() => /^layer [2-9]\d*, [1-9]/.test(document.querySelector('#live').ariaLabel));
    assert.ok(await page.drawn('#live') > 0.05);
    await page.says(page.page.locator('#left'), /about 0:0\d:\d\d left/);
  }));

test('The layer is there again for whoever loads the page in the middle of a print', () =>
  atWork({speed: 100}, async (page) => {
    await begin(page);
    await page.until(() => document.querySelector('#progress').value > 0);
    await page.press('Pause');
    await page.says(page.state, /paused/);

    await page.again();

    await page.says(page.state, /paused/);
    await page.until(() => /^layer/.test(document.querySelector('#live').ariaLabel));
  }));

test('Temperatures are set and switched off between prints, told with what they are to be, and drawn', () =>
  atWork({speed: 100}, async (page) => {
    await page.dial('Nozzle (°C)').fill('90');
    await page.press('Set the nozzle');
    await page.says(page.page.locator('#heat'), /nozzle .* of 90 °C/);
    assert.ok(await page.drawn('#chart') > 0.005);
    assert.equal(await page.dial('Nozzle (°C)').inputValue(), '');

    await page.press('Nozzle off');

    await page.until(() => /nozzle [\d.]+ °C$/.test(document.querySelector('#heat').firstChild.textContent));
  }));

test('The nozzle is homed, and jogged by the chosen step', () =>
  atWork({speed: 200}, async (page, watch, workshop) => {
    await page.press('Home all axes');
    await page.field('50').check();
    await page.press('X up');
    await page.press('Z up');
    await page.field('1').check();
    await page.press('X down');
    await page.say('M400');
    await page.say('M118 E1 there');
    await page.says(page.page.locator('#log .printer'), /there/);

    const {x, y, z} = await workshop.state();
    assert.deepEqual([x, y, z], [49, 0, 50]);
  }));

test('Cold filament is not pushed: the printer says so, and the page what it said', () =>
  atWork({}, async (page) => {
    await page.press('Extrude');

    await page.says(page.page.locator('#log'), /cold extrusion prevented/i);
  }));

test('In a print nothing can be moved, but speed, flow, fan and height are changed', () =>
  atWork({}, async (page) => {
    await begin(page);
    await page.says(page.state, /printing/);
    await page.button('X up').waitFor({state: 'hidden'});
    await page.until(() => document.querySelector('#progress').value > 0);

    for (const [dial, value] of [['Speed', '150'], ['Flow', '95'], ['Fan', '40']]) {
      const field = page.dial(`${dial} (%)`);
      await field.fill(value);
      await page.press(`Set the ${dial.toLowerCase()}`);
      await page.until((id) => document.getElementById(id).value === '', await field.getAttribute('id'));
    }
    await page.press('Nozzle 0.02 mm lower');

    assert.equal(await page.fault.isVisible(), false);
  }));

test('Answers of the printer are shown, and what goes over the wire is written down when that is wanted', () =>
  atWork({speed: 200}, async (page, watch, workshop) => {
    await page.field('Write down all that goes over the wire').check();
    await page.say('G28');
    await page.say('G1 X7 F6000');
    await page.say('M114');
    await page.says(page.page.locator('#log .printer'), /X:7\.00 Y:0\.00 Z:0\.00/);

    const lines = await page.page.request.get(`${workshop.url}/api/v1/printer/serial-log/lines`);
    assert.match(await lines.text(), / > N\d+ M114\*\d+\n[^]* < X:7\.00 Y:0\.00 Z:0\.00 E:0\.00/);
  }));

test('What was said is brought back by arrow up, and what the printer does not know is told', () =>
  atWork({}, async (page) => {
    const line = page.page.locator('#say');
    await page.say('M117 first');
    await page.say('M9999');
    await page.says(page.page.locator('#log'), /Unknown command.*M9999/);

    await line.press('ArrowUp');
    assert.equal(await line.inputValue(), 'M9999');
    await line.press('ArrowUp');
    assert.equal(await line.inputValue(), 'M117 first');
    await line.press('ArrowDown');
    await line.press('ArrowDown');
    assert.equal(await line.inputValue(), '');
  }));

test('A line that may not be said is refused with the reason, and stays to be mended', () =>
  atWork({}, async (page, watch) => {
    watch.foresee(/commands.* 400|status of 400/);

    await page.say('M110 N5');

    await page.says(page.fault, /M110/);
    assert.equal(await page.page.locator('#say').inputValue(), 'M110 N5');
    await page.press('Close this message');
    await page.fault.waitFor({state: 'hidden'});
  }));

test('Models have pictures, G-code says what it is, what cannot be sliced stays blank', () =>
  atWork({}, async (page, watch) => {
    watch.foresee(/broken\.lua\/picture 400|status of 400/);
    for (const [name, content] of [['tower.lua', TOWER], ['moves.gcode', MOVES], ['broken.lua', BROKEN]]) {
      await page.put(name, content);
    }

    await page.pictured('tower.lua');
    await page.says(page.file('moves.gcode'), /G-code/);
  }));

test('All layers are stacked up to the slider, and turned', () =>
  atWork({}, async (page) => {
    await page.put('tower.lua', TOWER);
    await page.showLayers('tower.lua');
    await page.field('All up to it').check();
    await page.layer.fill('99');
    await page.says(page.page.locator('#layer-text'), /^100 of 100/);
    await page.until(() => document.querySelector('#contours').dataset.stacked === '60');
    const whole = await page.drawn('#contours');

    await page.layer.fill('20');
    await page.until(() => Number(document.querySelector('#contours').dataset.stacked) < 20);
    assert.ok(await page.drawn('#contours') < whole);
    const before = await page.pixels('#contours');
    await page.field('Turn').fill('80');

    assert.notEqual(await page.pixels('#contours'), before);
  }));

test('A finished job is queued again as it was', () =>
  atWork({speed: 200}, async (page) => {
    await page.put('tile.lua', TILE);
    await page.press('Queue tile.lua');
    await page.says(page.job(1), /done/);
    await page.press('The bed is clear');

    await page.press('Queue tile.lua again, as in job 1');

    await page.says(page.job(2), /done/);
  }));

test('A daemon that ends is said to be out of reach, and followed again when it is back', () =>
  atWork({}, async (page, watch, workshop) => {
    watch.foresee(/ERR_CONNECTION_REFUSED|ERR_INCOMPLETE_CHUNKED_ENCODING|ERR_CONNECTION_RESET/);
    await page.put('tile.lua', TILE);
    await page.pictured('tile.lua');

    await workshop.daemon.stop();
    await page.says(page.fault, /cannot be reached/);
    await page.says(page.state, /not connected/);
    await workshop.serve(new URL(workshop.url).host);

    await page.says(page.state, /^connected/);
    await page.fault.waitFor({state: 'hidden'});
    await page.file('tile.lua').waitFor();
  }));

test('The camera is shown from where the daemon was told it is, and a dead one says so', async () => {
  let works = true;
  const server = createServer((request, response) => {
    response.writeHead(works ? 200 : 500, {'Content-Type': 'image/svg+xml', 'Cache-Control': 'no-store'});
    response.end(works ? '<svg xmlns="http://www.w3.org/2000/svg" width="64" height="48"/>' : 'no picture');
  });
  await new Promise((resolve) => server.listen(0, '127.0.0.1', resolve));
  const camera = `http://127.0.0.1:${server.address().port}/picture`;
  const workshop = await Workshop.open({serve: ['--camera', camera]});
  try {
    const foreseen = [/127\.0\.0\.1:\d+\/picture|picture 500|status of 500/];
    await inBrowser(workshop.url, {foreseen}, async (page) => {
      await page.until(() => document.querySelector('#camera-picture').naturalWidth === 64);

      works = false;
      await page.again();

      await page.page.getByText('The camera gives no picture').waitFor();
      works = true;
      await page.press('Try again');
      await page.until(() => document.querySelector('#camera-picture').naturalWidth === 64);
    });
  } finally {
    server.close();
    server.closeAllConnections();
    await workshop.close();
  }
});
