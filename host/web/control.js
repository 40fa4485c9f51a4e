// Dials, in a print and between prints; moves only between prints.
import {$, tell} from '/assets/page.js';

const DIALS = {feed: 1, flow: 1, nozzle: 1, bed: 1, fan: 0.01};  // what the page shows in what the daemon takes
const SPEEDS = {X: 3000, Y: 3000, Z: 600, E: 300};  // mm/min

function adjust(change) {
  return tell('printer/adjust', change);
}

function say(...commands) {
  return tell('printer/commands', {commands});
}

async function set(event) {
  event.preventDefault();
  const input = event.target.querySelector('input');
  const {dial} = event.target.dataset;
  if (await adjust({[dial]: input.valueAsNumber * DIALS[dial]})) input.value = '';
}

function step() {
  return document.querySelector('input[name=step]:checked').value;
}

function jog({axis, way}) {
  say('G91', `G0 ${axis}${way}${step()} F${SPEEDS[axis]}`, 'G90');
}

function feed(way) {
  if ($('filament').reportValidity()) say('M83', `G1 E${way}${$('filament').value} F${SPEEDS.E}`, 'M82');
}

for (const form of document.querySelectorAll('form[data-dial]')) form.addEventListener('submit', set);
for (const off of document.querySelectorAll('button[data-off]')) {
  off.addEventListener('click', () => adjust({[off.dataset.off]: 0}));
}
for (const pressed of document.querySelectorAll('button[data-axis]')) {
  pressed.addEventListener('click', () => jog(pressed.dataset));
}
for (const pressed of document.querySelectorAll('button[data-say]')) {
  pressed.addEventListener('click', () => say(pressed.dataset.say));
}
$('lower').addEventListener('click', () => adjust({z: -0.02}));
$('higher').addEventListener('click', () => adjust({z: 0.02}));
$('extrude').addEventListener('click', () => feed(''));
$('retract').addEventListener('click', () => feed('-'));
