// Temperatures of the last minutes, and what they are to be.
import {$} from '/assets/page.js';
import {colour, pen, redrawn} from '/assets/canvas.js';

const SPAN_MS = 10 * 60_000;
const SPAN_MIN_MS = 60_000;
const READINGS = 2400;  // four a second for as long
const CURVES = {nozzle: '--nozzle', bed: '--accent', chamber: '--chamber'};
const GAP = 34;  // pixels for the scale

const readings = [];

function scaleOf(shown) {
  let most = 60;
  for (const {heaters} of shown) {
    for (const {actual, target} of Object.values(heaters)) most = Math.max(most, actual ?? 0, target ?? 0);
  }
  return Math.ceil(most * 1.1 / 50) * 50;
}

function curve(context, points, style, dashes) {
  context.strokeStyle = style;
  context.setLineDash(dashes);
  context.lineWidth = dashes.length ? 1 : 2;
  context.beginPath();
  let open = false;
  for (const [x, y] of points) {
    if (y === null) {
      open = false;
    } else {
      open ? context.lineTo(x, y) : context.moveTo(x, y);
      open = true;
    }
  }
  context.stroke();
  context.setLineDash([]);
}

function draw() {
  const {context, width, height} = pen($('chart'), 0.4);
  const now = readings.at(-1)?.at ?? 0;
  const most = scaleOf(readings);
  const span = Math.max(now - (readings[0]?.at ?? now), SPAN_MIN_MS);
  const x = (at) => GAP + (width - GAP) * (1 - (now - at) / span);
  const y = (celsius) => (height - 4) * (1 - celsius / most) + 2;
  context.font = '12px system-ui, sans-serif';
  for (let celsius = 0; celsius < most; celsius += most > 150 ? 100 : 25) {
    context.fillStyle = colour('--ink');
    context.fillText(`${celsius}`, 2, y(celsius) - 2);
    context.fillStyle = colour('--line');
    context.fillRect(GAP, y(celsius), width, 1);
  }
  for (const [heater, name] of Object.entries(CURVES)) {
    const points = (kind) => readings.map(({at, heaters}) => {
      const value = heaters[heater]?.[kind];
      return [x(at), value === undefined || value === null ? null : y(value)];
    });
    curve(context, points('target'), colour(name), [5, 4]);
    curve(context, points('actual'), colour(name), []);
  }
}

function text(name, {actual, target}) {
  const now = actual === null ? 'no reading' : `${actual.toFixed(1)} °C`;
  return target ? `${name} ${now} of ${target.toFixed(0)} °C` : `${name} ${now}`;
}

export function show(heaters) {
  if (Object.keys(heaters).length === 0) return;
  const at = Date.now();
  readings.push({at, heaters});
  while (readings.length > READINGS || readings[0].at < at - SPAN_MS) readings.shift();
  $('heat').replaceChildren(...Object.entries(heaters).map(([name, heater]) => {
    const item = document.createElement('li');
    item.className = name;
    item.textContent = text(name, heater);
    return item;
  }));
  draw();
}

redrawn($('chart'), draw);
