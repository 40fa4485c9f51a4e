// The first run: an account, then what is known of the printer. What is chosen becomes lines for the
// file that tells the daemon; the page changes nothing by itself.
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

function showLines() {
  $('lines').textContent = `PRINTER=${$('port').value}\nMACHINE=${$('profile').value}`;
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
  showLines();
}

async function toPrinter() {
  $('account-step').hidden = true;
  $('printer-step').hidden = false;
  $('step').textContent = 'Step 2 of 2: the printer';
  $('printer-title').focus();
  await showPrinter();
}

async function look() {
  const {state, code} = await ask('GET', 'session');
  if (state === 'login') location.replace('/login');
  $('code-field').hidden = !code;
  $('code').required = code;
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
$('choice-form').addEventListener('submit', (event) => event.preventDefault());
$('refresh').addEventListener('click', () => showPrinter().catch(report));
for (const id of ['port', 'profile']) $(id).addEventListener('change', showLines);
look().catch(report);
