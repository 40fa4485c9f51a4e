// A slider through the layers of a model that need not be printed for it.
import {ask, specQuery} from '/assets/api.js';
import {drawLayer} from '/assets/draw.js';

const $ = (id) => document.getElementById(id);

let file = null;
let about = null;
let wanted = null;  // the layer to be shown next; one request at a time
let asking = false;

function value(id) {
  const text = $(id).value;
  return text === '' ? undefined : Number(text);
}

export function spec() {
  const fit = value('fit');
  const settings = {
    layer_height: value('layer-height'),
    first_layer_height: value('layer-height'),
    infill_density: value('infill'),
    perimeters: value('perimeters'),
  };
  return {settings, placement: fit ? {fit: [fit, fit, fit]} : {}};
}

async function showWanted(report) {
  if (asking) return;
  asking = true;
  try {
    while (wanted !== null) {
      const layer = wanted;
      wanted = null;
      const path = `files/${encodeURIComponent(file)}/layers/${layer}`;
      const contours = await ask('GET', path + specQuery(spec()));
      $('layer-text').textContent = `${layer + 1} of ${about.layers}, ${contours.z.toFixed(2)} mm`;
      drawLayer($('contours'), contours, about);
    }
  } catch (error) {
    report(error);
  } finally {
    asking = false;
  }
}

async function measure(report) {
  try {
    about = await ask('GET', `files/${encodeURIComponent(file)}/layers` + specQuery(spec()));
    $('layer').max = about.layers - 1;
    wanted = Math.min(Number($('layer').value), about.layers - 1);
    await showWanted(report);
  } catch (error) {
    report(error);
  }
}

export function open(name, report) {
  file = name;
  $('preview').hidden = false;
  $('preview-title').textContent = `Layers of ${name}`;
  $('layer').value = 0;
  $('layer').focus();
  return measure(report);
}

export function start(report, queue) {
  $('layer').addEventListener('input', () => {
    wanted = Number($('layer').value);
    showWanted(report);
  });
  for (const id of ['fit', 'layer-height']) $(id).addEventListener('change', () => measure(report));
  $('settings-form').addEventListener('submit', (event) => {
    event.preventDefault();
    queue(file, spec());
  });
}
