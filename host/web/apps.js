// Programs that ask for a key: who is logged in gives it, or not.
import {ask} from '/assets/api.js';
import {$, attempt, element} from '/assets/page.js';

function optionOf({id, app, from}) {
  return Object.assign(element('option', `${app}, from ${from}`), {value: id});
}

export async function refresh() {
  let requests = [];
  try {
    ({requests} = await ask('GET', 'app-requests'));
  } catch { /* who may not decide is not asked */ }
  $('apps').hidden = requests.length === 0;
  const chosen = $('app').value;
  $('app').replaceChildren(...requests.map(optionOf));
  if (requests.some(({id}) => String(id) === chosen)) $('app').value = chosen;
}

async function decide(method, body) {
  await attempt(() => ask(method, `app-requests/${$('app').value}`, body && JSON.stringify(body)));
  $('app-password').value = '';
  await refresh();
}

$('apps-form').addEventListener('submit', (event) => {
  event.preventDefault();
  decide('POST', {scope: $('app-scope').value, password: $('app-password').value.normalize('NFC')});
});
$('app-refuse').addEventListener('click', () => decide('DELETE'));
