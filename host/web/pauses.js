// Layers before which a print waits for somebody: for inserts, or another colour.
import {ask} from '/assets/api.js';
import {attempt, button, element} from '/assets/page.js';

const form = document.createElement('form');
const told = document.createElement('ul');
let job = null;
let layers = [];

async function put(wanted) {
  ({layers} = await ask('PUT', `jobs/${job}/pauses`, JSON.stringify({layers: wanted})));
  showLayers();
}

function showLayers() {
  told.replaceChildren(...layers.map((layer) => {
    const item = element('li', `pauses before layer ${layer + 1} `);
    item.append(button('Remove', `Do not pause before layer ${layer + 1}`,
      () => attempt(() => put(layers.filter((each) => each !== layer)))));
    return item;
  }));
}

// Puts the form into the page.
export function start() {
  const label = Object.assign(element('label', 'Pause before layer'), {htmlFor: 'pause-layer'});
  const field = Object.assign(document.createElement('input'),
    {id: 'pause-layer', name: 'layer', type: 'number', min: 1, step: 1, required: true});
  form.append(label, field, element('button', 'Pause there'));
  told.setAttribute('role', 'status');
  form.addEventListener('submit', (event) => {
    event.preventDefault();
    attempt(async () => {
      await put([...layers, field.valueAsNumber - 1]);
      form.reset();
    });
  });
  document.getElementById('pauses').append(form, told);
}

// `printed` is the job under way, or null. G-code has its pauses in it.
export function show(printed) {
  const now = printed && printed.layers ? printed.id : null;
  if (now === job) return;
  job = now;
  document.getElementById('pauses').hidden = job === null;
  layers = [];
  showLayers();
  if (job !== null) refresh().catch(() => {}); // the next event tries again
}

// Something happened to jobs.
export async function refresh() {
  if (job === null) return;
  layers = (await ask('GET', `jobs/${job}`)).pauses;
  showLayers();
}
