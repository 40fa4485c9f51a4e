// Settings changed while a model is printed: they hold from the first layer that is not made yet.
import {ask} from '/assets/api.js';

// What of a setting stands in a field: so many times its value.
const FIELDS = [
  {key: 'infill_density', name: 'Infill', unit: '%', times: 100, min: 0, max: 100, step: 1},
  {key: 'perimeters', name: 'Perimeters', unit: '', times: 1, min: 1, max: 20, step: 1},
  {key: 'outer_perimeter_speed', name: 'Outer perimeters', unit: 'mm/s', times: 1, min: 1, max: 1000, step: 'any'},
  {key: 'perimeter_speed', name: 'Inner perimeters', unit: 'mm/s', times: 1, min: 1, max: 1000, step: 'any'},
  {key: 'infill_speed', name: 'Infill speed', unit: 'mm/s', times: 1, min: 1, max: 1000, step: 'any'},
  {key: 'flow', name: 'Flow', unit: '%', times: 100, min: 50, max: 150, step: 1},
  {key: 'nozzle_celsius', name: 'Nozzle', unit: '°C', times: 1, min: 170, max: 320, step: 1},
  {key: 'bed_celsius', name: 'Bed', unit: '°C', times: 1, min: 0, max: 150, step: 1},
  {key: 'fan', name: 'Fan', unit: '%', times: 100, min: 0, max: 100, step: 1},
];

const form = document.createElement('form');
const told = document.createElement('ul');
let job = null;

function element(tag, members) {
  return Object.assign(document.createElement(tag), members);
}

function fieldOf({key, name, unit, min, max, step}) {
  const id = `change-${key}`;
  return [
    element('label', {htmlFor: id, textContent: unit ? `${name} (${unit})` : name}),
    element('input', {id, name: key, type: 'number', min, max, step}),
  ];
}

function text([key, value]) {
  if (key === 'cancel_object') return `without the object at ${value.split(' ').slice(1).map((mm) => Number(mm).toFixed(1)).join(', ')}`;
  const field = FIELDS.find((each) => each.key === key);
  if (!field) return `${key} ${value}`;
  return `${field.name.toLowerCase()} ${Number((value * field.times).toFixed(6))} ${field.unit}`.trim();
}

function showChanges(changes) {
  told.replaceChildren(...changes.map(({from_layer: layer, settings}) =>
    element('li', {textContent: `from layer ${layer + 1}: ${Object.entries(settings).map(text).join(', ')}`})));
}

// What was filled in; fields left empty change nothing.
function wanted() {
  const settings = {};
  for (const {key, times} of FIELDS) {
    const field = form.elements[key];
    if (field.value !== '') settings[key] = field.valueAsNumber / times;
  }
  return settings;
}

// Puts the form into the page. `attempt` does things and shows what went wrong.
export function start(attempt) {
  form.append(...FIELDS.flatMap(fieldOf), element('button', {textContent: 'Change from the next layer on'}));
  told.setAttribute('role', 'status');
  form.addEventListener('submit', (event) => {
    event.preventDefault();
    attempt(async () => {
      await ask('POST', `jobs/${job}/settings`, JSON.stringify(wanted()));
      form.reset();
    });
  });
  const folded = document.createElement('details');
  folded.append(element('summary', {id: 'changes-title', textContent: 'Change the layers to come'}), form);
  document.getElementById('changes').append(folded, told);
}

// `printed` is the job under way, or null. G-code has no layers that could change.
export function show(printed) {
  const now = printed && printed.layers ? printed.id : null;
  if (now === job) return;
  job = now;
  document.getElementById('changes').hidden = job === null;
  showChanges([]);
  if (job !== null) refresh().catch(() => {}); // the next event tries again
}

// Something happened to jobs.
export async function refresh() {
  if (job !== null) showChanges((await ask('GET', `jobs/${job}`)).changes);
}
