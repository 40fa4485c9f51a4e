// The first run: an account, then which printer there is.
import {ask} from '/assets/api.js';

const $ = (id) => document.getElementById(id);

function report(error) {
  $('fault').textContent = error ? error.message : '';
  $('fault').hidden = !error;
}

function option(value, text, chosen) {
  const made = document.createElement('option');
  made.value = value;
  made.textContent = text;
  made.selected = value === chosen;
  return made;
}

async function showPrinter() {
  const about = await ask('GET', 'machine');
  $('printer').textContent = about.connected ? `${about.printer}: it answers` : `${about.printer}: no answer yet`;
  $('firmware').textContent = about.firmware || 'not known yet';
  $('machine').textContent = about.machine;
  const others = about.ports.filter(({path}) => path !== about.printer);
  $('port').replaceChildren(option(about.printer, `${about.printer} (now)`, about.printer),
    ...others.map(({path, product, usb}) => option(path, [path, product, usb].filter(Boolean).join(' '), '')));
  $('profile').replaceChildren(...about.machines.map((name) => option(name, name, about.machine)));
  report(about.fault ? new Error(about.fault) : null);
}

async function toPrinter() {
  $('account-step').hidden = true;
  $('printer-step').hidden = false;
  $('step').textContent = 'Step 2 of 2: the printer';
  $('printer-title').focus();
  await showPrinter();
}

async function use() {
  const {value: printer} = $('port');
  await ask('PUT', 'machine', JSON.stringify({printer, machine: $('profile').value}));
  await showPrinter();
  $('used').textContent = `Used from now on: ${printer}, ${$('machine').textContent}.`;
}

async function look() {
  const {state, code} = await ask('GET', 'session');
  if (state === 'login') location.replace('/login');
  $('code-field').hidden = !code;
  $('code').required = code;
  $('alone').hidden = state !== 'open';
  if (state === 'in') await toPrinter();
}

async function make() {
  if ($('password').value !== $('again').value) {
    report(new Error('The two passwords differ.'));
    $('again').focus();
    return;
  }
  const wanted = {name: $('name').value, password: $('password').value.normalize('NFC')};
  if (!$('code-field').hidden) wanted.code = $('code').value;
  $('make').disabled = true;
  try {
    await ask('POST', 'setup', JSON.stringify(wanted));
    await toPrinter();
  } catch (error) {
    report(error);
  } finally {
    $('make').disabled = false;
  }
}

$('account-form').addEventListener('submit', (event) => {
  event.preventDefault();
  make();
});
$('choice-form').addEventListener('submit', (event) => {
  event.preventDefault();
  report(null);
  use().catch(report);
});
$('refresh').addEventListener('click', () => showPrinter().catch(report));
$('skip').addEventListener('click', () => toPrinter().catch(report));
look().catch(report);
