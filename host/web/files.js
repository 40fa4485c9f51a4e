// Files: brought by drag and drop or chosen, listed with a picture, queued, looked into, deleted.
import {ask, send} from '/assets/api.js';
import {$, attempt, button, element, moment, quietly, tell} from '/assets/page.js';
import * as preview from '/assets/preview.js';
import {picture} from '/assets/pictures.js';

const isGcode = (name) => /\.(gcode|gco|g)$/i.test(name);

function size(bytes) {
  if (bytes < 1024) return `${bytes} B`;
  return bytes < 1024 * 1024 ? `${(bytes / 1024).toFixed(0)} KiB` : `${(bytes / 1024 / 1024).toFixed(1)} MiB`;
}

function remove(name) {
  if (!confirm(`Delete ${name}?`)) return;
  attempt(() => ask('DELETE', `files/${encodeURIComponent(name)}`));
}

function item(file) {
  const {name} = file;
  const made = document.createElement('li');
  const about = document.createElement('div');
  about.append(element('strong', name), element('small', `${size(file.size)} · ${moment(file.created)}`));
  const buttons = element('div', '', 'buttons');
  buttons.append(button('Queue', `Queue ${name}`, () => tell('jobs', {file: name, spec: {}})));
  if (!isGcode(name)) buttons.append(button('Layers', `Show layers of ${name}`, () => preview.open(name)));
  buttons.append(button('Delete', `Delete ${name}`, () => remove(name)));
  made.append(isGcode(name) ? element('span', 'G-code', 'picture') : picture(file), about, buttons);
  return made;
}

export function show() {
  return quietly(async () => {
    const {files} = await ask('GET', 'files');
    $('files').replaceChildren(...files.map(item));
    $('no-files').hidden = files.length > 0;
  });
}

async function upload(files) {
  for (const file of files) {
    $('sending').textContent = `sending ${file.name}`;
    await attempt(() => send(file, (share) => {
      $('sending').textContent = `sending ${file.name}: ${Math.round(100 * share)} %`;
    }));
  }
  $('sending').textContent = '';
  $('upload').value = '';  // the same file may be chosen again
}

function over(event) {
  event.preventDefault();
  $('drop').classList.add('over');
}

$('upload').addEventListener('change', () => upload([...$('upload').files]));
$('drop').addEventListener('dragover', over);
$('drop').addEventListener('dragleave', () => $('drop').classList.remove('over'));
$('drop').addEventListener('drop', (event) => {
  event.preventDefault();
  $('drop').classList.remove('over');
  upload([...event.dataTransfer.files]);
});
