// Logging in. Where to go afterwards is no parameter of the address: it is always the page.
import {ask} from '/assets/api.js';

const $ = (id) => document.getElementById(id);

function report(error) {
  $('fault').textContent = error ? error.message : '';
  $('fault').hidden = !error;
}

// Whoever needs no login, or has no account yet, is elsewhere.
async function look() {
  const {state} = await ask('GET', 'session');
  if (state === 'setup') location.replace('/setup');
  if (state === 'in' || state === 'open') location.replace('/');
}

async function logIn() {
  const shown = {name: $('name').value, password: $('password').value.normalize('NFC')};
  $('log-in').disabled = true;
  try {
    await ask('POST', 'login', JSON.stringify(shown));
    location.replace('/');
  } catch (error) {
    report(error);
    $('password').value = '';
    $('password').focus();
  } finally {
    $('log-in').disabled = false;
  }
}

$('login-form').addEventListener('submit', (event) => {
  event.preventDefault();
  logIn();
});
look().catch(report);
