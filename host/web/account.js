// The card of the account: who is logged in, keys for programs, another password, logging out.
import {ask} from '/assets/api.js';

const $ = (id) => document.getElementById(id);

let report = () => {};

// Where somebody who is not known has to go.
export function logIn() {
  location.assign('/login');
}

function cell(text) {
  const made = document.createElement('td');
  made.textContent = text;
  return made;
}

function day(seconds) {
  return seconds === null ? 'never' : new Date(seconds * 1000).toISOString().slice(0, 10);
}

// Does it, and says what went wrong. Whether nothing did.
async function attempt(work) {
  try {
    await work();
    report(null);
    return true;
  } catch (error) {
    report(error);
    return false;
  }
}

function rowOf({id, name, scope, used}) {
  const row = document.createElement('tr');
  const remove = document.createElement('button');
  remove.textContent = 'Remove';
  remove.setAttribute('aria-label', `Remove the key ${name}`);
  remove.addEventListener('click', () => attempt(async () => {
    await ask('DELETE', `keys/${id}`);
    await showKeys();
  }));
  const last = document.createElement('td');
  last.append(remove);
  row.append(cell(name), cell(scope), cell(day(used)), last);
  return row;
}

async function showKeys() {
  const {keys} = await ask('GET', 'keys');
  $('keys').replaceChildren(...keys.map(rowOf));
}

async function makeKey() {
  const form = $('new-key-form');
  const wanted = {name: $('key-name').value, scope: $('key-scope').value, password: $('key-password').value.normalize('NFC')};
  await attempt(async () => {
    const {key} = await ask('POST', 'keys', JSON.stringify(wanted));
    form.reset();
    $('made-key').textContent = key;
    $('made-key-note').hidden = false;
    $('made-key').focus();
    await showKeys();
  });
}

async function changePassword() {
  const wanted = {old: $('old-password').value.normalize('NFC'), new: $('new-password').value.normalize('NFC')};
  const done = await attempt(() => ask('POST', 'password', JSON.stringify(wanted)));
  if (!done) return;
  $('password-form').reset();
  $('password-note').textContent = 'Changed. All other browsers are logged out.';
}

async function leave(path) {
  if (await attempt(() => ask('POST', path))) logIn();
}

function onSubmit(id, act) {
  $(id).addEventListener('submit', (event) => {
    event.preventDefault();
    act();
  });
}

// Shows the card. `tell` is called with what goes wrong, and with null when it goes right again.
export function start(tell) {
  report = tell;
  localStorage.removeItem('slipstick-key');  // where keys were kept before there were accounts
  onSubmit('new-key-form', makeKey);
  onSubmit('password-form', changePassword);
  $('logout').addEventListener('click', () => leave('logout'));
  $('logout-everywhere').addEventListener('click', () => leave('logout-everywhere'));
  return attempt(async () => {
    const {state, account} = await ask('GET', 'session');
    if (state === 'login' || state === 'setup') return logIn();
    $('no-account').hidden = state !== 'open';
    $('with-account').hidden = account === null;
    if (account === null) return undefined;
    $('account-name').textContent = account;
    return showKeys();
  });
}
