// The first start on a network, and who may come in afterwards.
import assert from 'node:assert/strict';
import {readFile} from 'node:fs/promises';
import {join} from 'node:path';
import {test} from 'node:test';

import {DESKTOP, inWindow, PHONE} from './support/browser.js';
import {Workshop} from './support/workshop.js';

const PASSWORD = 'correct horse battery';

// The loopback under an address that is none for the daemon: nobody else can come, but an account is asked for.
const LIKE_A_NETWORK = '[::ffff:127.0.0.1]:0';

// What is asked before anybody is known, and a wrong password.
const FORESEEN = [/ 401$/, /status of 401/, / 403$/, /status of 403/];

async function firstStart(look, act) {
  const shop = await Workshop.open({listen: LIKE_A_NETWORK});
  const url = shop.url.replace('[::ffff:127.0.0.1]', '127.0.0.1');
  try {
    await inWindow(url, {foreseen: FORESEEN, ...look}, (window) => act(window, url, shop));
  } finally {
    await shop.close();
  }
}

async function setUp(window, url, shop) {
  await window.goto(url);
  await window.waitForURL(`${url}/setup`);
  await window.getByLabel(/^Code/).fill((await readFile(join(shop.folder, 'data', 'setup_code'), 'utf8')).trim());
  await window.getByLabel('Name').fill('ada');
  await window.getByLabel('Password (10 characters or more)').fill(PASSWORD);
  await window.getByLabel('The password again').fill(PASSWORD);
  await window.getByRole('button', {name: 'Make the account'}).click();
  await window.getByRole('heading', {name: 'The printer'}).waitFor();
}

async function connected(window) {
  await window.locator('#state').filter({hasText: /connected/}).waitFor();
  await window.locator('#account-name').filter({hasText: 'ada'}).waitFor();
}

for (const [name, look] of Object.entries({'a desktop': DESKTOP, 'a phone': PHONE})) {
  test(`The first start asks for an account, shows the printer, and then the page is there (${name})`, () =>
    firstStart(look, async (window, url, shop) => {
      await setUp(window, url, shop);
      assert.match(await window.locator('#printer').textContent(), /^pty:.*: it answers$/);
      await window.getByLabel('Printer profiles').selectOption('ender3');
      await window.getByRole('button', {name: 'Use these'}).click();
      await window.locator('#used').filter({hasText: /^Used from now on: pty:.*, ender3\.$/}).waitFor();

      await window.goto(url);

      await connected(window);
    }));
}

test('Who logs out comes back by the password only, and a key is shown once', () =>
  firstStart(DESKTOP, async (window, url, shop) => {
    await setUp(window, url, shop);
    await window.goto(url);
    await connected(window);

    await window.getByLabel('Name of a new key').fill('slicer');
    await window.locator('#new-key-form').getByLabel('Your password').fill(PASSWORD);
    await window.getByRole('button', {name: 'Make the key'}).click();
    await window.locator('#made-key').filter({hasText: /^[0-9a-f]{64}$/}).waitFor();
    const key = await window.locator('#made-key').textContent();
    const asked = () => window.request.get(`${url}/api/v1/printer`, {headers: {'X-Api-Key': key, Cookie: ''}});
    assert.equal((await asked()).status(), 200);
    await window.getByRole('button', {name: 'Remove the key slicer'}).click();
    await window.getByRole('button', {name: 'Remove the key slicer'}).waitFor({state: 'detached'});
    assert.equal((await asked()).status(), 401);

    await window.getByRole('button', {name: 'Log out', exact: true}).click();
    await window.waitForURL(`${url}/login`);
    await window.getByLabel('Name').fill('ada');
    await window.getByLabel('Password').fill('wrong horse');
    await window.getByRole('button', {name: 'Log in'}).click();
    await window.getByRole('alert').filter({hasText: /./}).waitFor();
    await window.getByLabel('Password').fill(PASSWORD);
    await window.getByRole('button', {name: 'Log in'}).click();

    await window.waitForURL(`${url}/`);
    await connected(window);
  }));

test('A program that asks gets a key when it is given one on the page, and no other', () =>
  firstStart(DESKTOP, async (window, url, shop) => {
    await setUp(window, url, shop);
    await window.goto(url);
    await connected(window);
    const nobody = {headers: {Cookie: ''}};
    const ask = () => window.request.post(`${url}/plugin/appkeys/request`, {data: {app: 'Cura'}, ...nobody});
    const answer = (token) => window.request.get(`${url}/plugin/appkeys/request/${token}`, nobody);
    const refused = (await (await ask()).json()).app_token;

    await window.getByRole('heading', {name: 'Programs ask for a key'}).waitFor();
    await window.getByRole('button', {name: 'Refuse it'}).click();
    await window.locator('#apps').waitFor({state: 'hidden'});
    const given = (await (await ask()).json()).app_token;
    await window.locator('#apps').waitFor();
    await window.locator('#app-password').fill(PASSWORD);
    await window.getByRole('button', {name: 'Give it a key'}).click();
    await window.locator('#apps').waitFor({state: 'hidden'});

    assert.equal((await answer(refused)).status(), 404);
    const {api_key: key} = await (await answer(given)).json();
    const state = await window.request.get(`${url}/api/job`, {headers: {'X-Api-Key': key, Cookie: ''}});
    assert.equal(state.status(), 200);
  }));
