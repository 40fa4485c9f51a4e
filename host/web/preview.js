// Layers of a model that need not be printed for it: one by one by a slider, or stacked.
import {ask, specQuery} from '/assets/api.js';
import {colour, pen, redrawn, view} from '/assets/canvas.js';
import {$, quietly, tell} from '/assets/page.js';
import {drawStack} from '/assets/stack.js';

const STACKED = 60;  // layers of a stack, at most
const KEPT = 400;    // layers remembered

let file = null;
let about = null;
let layers = new Map();  // by number, as they were sliced for these settings
let edition = 0;         // of the settings: what was asked for others is not shown
let wanted = null;       // the layer to be shown next; one request at a time
let shown = null;
let asking = false;
let stacking = false;

function value(id) {
  const text = $(id).value;
  return text === '' ? undefined : Number(text);
}

export function spec() {
  const fit = value('fit');
  const settings = {
    layer_height: value('layer-height'),
    first_layer_height: value('layer-height'),
    infill_density: value('infill') / 100,
    perimeters: value('perimeters'),
  };
  return {settings, placement: fit ? {fit: [fit, fit, fit]} : {}};
}

const path = () => `files/${encodeURIComponent(file)}/layers`;

async function layer(number) {
  const asked = edition;
  if (!layers.has(number)) {
    const sliced = await ask('GET', `${path()}/${number}` + specQuery(spec()));
    if (asked !== edition) return null;
    layers.set(number, sliced);
    if (layers.size > KEPT) layers.delete(layers.keys().next().value);
  }
  return layers.get(number);
}

// The loops of one layer, even-odd: solid is filled.
function drawLayer() {
  const {context, width, height} = pen($('contours'), 0.9);
  const at = view(about, width, height);
  context.beginPath();
  for (const {points} of shown.loops) {
    points.forEach(([x, y], i) => context[i ? 'lineTo' : 'moveTo'](at.x(x), at.y(y)));
    context.closePath();
  }
  context.strokeStyle = context.fillStyle = colour('--accent');
  context.globalAlpha = 0.35;
  context.fill('evenodd');
  context.globalAlpha = 1;
  context.stroke();
}

function stack() {
  const top = Number($('layer').value);
  return [...layers].filter(([number]) => number <= top).sort(([a], [b]) => a - b).map(([, sliced]) => sliced);
}

function draw() {
  if (!about || !shown) return;
  if (!$('stacked').checked) return drawLayer();
  const upTo = stack();
  $('contours').dataset.stacked = upTo.length;
  drawStack($('contours'), upTo, about, {turn: Number($('turn').value), tilt: Number($('tilt').value)});
}

async function showWanted() {
  if (asking) return;
  asking = true;
  await quietly(async () => {
    while (wanted !== null) {
      const number = wanted;
      wanted = null;
      const sliced = await layer(number);
      if (!sliced) continue;
      shown = sliced;
      $('layer-text').textContent = `${number + 1} of ${about.layers}, ${sliced.z.toFixed(2)} mm`;
      $('contours').setAttribute('aria-label', `contours of layer ${number + 1} of ${file}`);
      draw();
    }
  });
  asking = false;
}

// Layers of the whole height, few at first and then those between.
async function fillStack() {
  if (stacking || !about) return;
  stacking = true;
  const asked = edition;
  const count = Math.min(about.layers, STACKED);
  const numbers = Array.from({length: count}, (_, i) => Math.floor((i + 0.5) * about.layers / count));
  const order = [4, 2, 1].flatMap((stride) => numbers.filter((_, i) => i % stride === 0));
  await quietly(async () => {
    for (const number of new Set(order)) {
      if (asked !== edition || !$('stacked').checked) return;
      await layer(number);
      draw();
    }
  });
  stacking = false;
  if (asked !== edition && $('stacked').checked) fillStack();
}

async function measure() {
  const asked = ++edition;
  layers = new Map();
  await quietly(async () => {
    const measured = await ask('GET', path() + specQuery(spec()));
    if (asked !== edition) return;
    about = measured;
    const size = [0, 1, 2].map((i) => (about.high[i] - about.low[i]).toFixed(1)).join(' x ');
    $('about').textContent = `${size} mm${about.warning ? `; ${about.warning}` : ''}`;
    $('layer').max = about.layers - 1;
    wanted = Math.min(Number($('layer').value), about.layers - 1);
    showMode();
    await showWanted();
  });
}

function showMode() {
  const stacked = $('stacked').checked;
  $('eye').hidden = !stacked;
  if (stacked) fillStack();
  draw();
}

export function open(name) {
  file = name;
  about = shown = null;
  $('preview').hidden = false;
  $('preview-title').textContent = `Layers of ${name}`;
  $('layer-text').textContent = $('about').textContent = '';
  $('layer').value = 0;
  pen($('contours'), 0.9);
  $('preview').scrollIntoView({block: 'nearest'});
  $('layer').focus({preventScroll: true});
  return measure();
}

// Turned by hand: a pixel is half a degree.
function drag(event) {
  if (!$('stacked').checked || !event.buttons) return;
  $('turn').value = (Number($('turn').value) + event.movementX / 2 + 360) % 360;
  $('tilt').value = Number($('tilt').value) + event.movementY / 2;
  draw();
}

$('layer').addEventListener('input', () => {
  wanted = Number($('layer').value);
  showWanted();
  if ($('stacked').checked) draw();
});
for (const id of ['turn', 'tilt']) $(id).addEventListener('input', draw);
for (const id of ['flat', 'stacked']) $(id).addEventListener('change', showMode);
for (const id of ['fit', 'layer-height']) $(id).addEventListener('change', measure);
$('contours').addEventListener('pointermove', drag);
$('settings-form').addEventListener('submit', (event) => {
  event.preventDefault();
  tell('jobs', {file, spec: spec()});
});
$('preview-close').addEventListener('click', () => {
  $('preview').hidden = true;
  ++edition;
});
redrawn($('contours'), draw);
