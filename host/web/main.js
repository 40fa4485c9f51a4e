// The page: what the daemon tells is shown, what is pressed is asked of it. Texts from printers and
// files only ever become text, never markup.
import {Refused, ask, listen, useKey} from '/assets/api.js';
import * as changes from '/assets/changes.js';
import {drawHeat} from '/assets/draw.js';
import * as preview from '/assets/preview.js';

const READINGS = 300;
const LOG_LINES = 200;
const RETRY_MS = 3000;

const $ = (id) => document.getElementById(id);
const readings = [];
let status = null;

function report(error) {
  $('fault').textContent = error ? error.message : '';
  $('fault').hidden = !error;
  if (error instanceof Refused && error.status === 403) $('ask-key').hidden = false;
}

// Does it, and says what went wrong.
async function attempt(work) {
  try {
    const done = await work();
    report(null);
    return done;
  } catch (error) {
    report(error);
    return null;
  }
}

function element(tag, text) {
  const made = document.createElement(tag);
  made.textContent = text;
  return made;
}

function button(text, label, act) {
  const made = element('button', text);
  made.setAttribute('aria-label', label);
  made.addEventListener('click', act);
  return made;
}

function row(cells, buttons) {
  const made = document.createElement('tr');
  for (const cell of cells) made.append(element('td', cell));
  const last = document.createElement('td');
  last.append(...buttons);
  made.append(last);
  return made;
}

function time(seconds) {
  const s = Math.round(seconds);
  const two = (n) => String(n).padStart(2, '0');
  return `${Math.floor(s / 3600)}:${two(Math.floor(s / 60) % 60)}:${two(s % 60)}`;
}

function showJob(job) {
  $('job').textContent = job ? job.file : 'Nothing is being printed.';
  $('progress').value = job ? job.completion : 0;
  if (!job) {
    $('figures').textContent = '';
    return;
  }
  const layers = job.layers ? `layer ${job.layer} of ${job.layers}, ${job.height.toFixed(2)} mm; ` : '';
  const left = job.completion > 0.02 ? `, about ${time(job.seconds * (1 - job.completion) / job.completion)} left` : '';
  $('figures').textContent = `${layers}${job.lines} lines; ${time(job.seconds)} so far${left}`;
}

function showStatus(next) {
  status = next;
  const state = next.state === 'idle' && next.connected ? 'connected' : next.state;
  $('state').textContent = next.message ? `${state}: ${next.message}` : state;
  document.title = next.job ? `${Math.round(100 * next.job.completion)} % - slipstick` : 'slipstick';
  showJob(next.job);
  changes.show(next.job);
  $('pause').disabled = next.state !== 'printing';
  $('resume').disabled = next.state !== 'paused';
  $('cancel').disabled = !next.job || next.state === 'ending';
  $('bed').disabled = !!next.job || !next.bed_occupied;
  $('bed-note').hidden = !!next.job || !next.bed_occupied;
  $('adjust-form').hidden = !next.job && !next.connected;
  $('say-form').hidden = !next.job && !next.connected;
  $('home').hidden = !!next.job;
}

function showHeat(heaters) {
  readings.push(heaters);
  if (readings.length > READINGS) readings.shift();
  const text = Object.entries(heaters).map(([name, {actual, target}]) =>
    `${name} ${actual === null ? '?' : actual.toFixed(1)} °C${target ? ` of ${target.toFixed(0)}` : ''}`);
  $('heat').textContent = text.join(', ') || 'not known yet';
  drawHeat($('chart'), readings);
}

function showLog(text) {
  const log = $('log');
  const atEnd = log.scrollTop + log.clientHeight >= log.scrollHeight - 4;
  log.append(text + '\n');
  while (log.childNodes.length > LOG_LINES) log.firstChild.remove();
  if (atEnd) log.scrollTop = log.scrollHeight;
}

async function showFiles() {
  const {files} = await ask('GET', 'files');
  $('files').replaceChildren(...files.map(({name, size}) => row(
    [name, size < 1024 ? `${size} B` : `${(size / 1024).toFixed(0)} KiB`],
    [
      button('Queue', `Queue ${name}`, () => queue(name, {})),
      ...(/\.(gcode|gco|g)$/i.test(name) ? [] :
        [button('Layers', `Show layers of ${name}`, () => preview.open(name, report))]),
      button('Delete', `Delete ${name}`, () => attempt(() => ask('DELETE', `files/${encodeURIComponent(name)}`))),
    ])));
}

const RECOVER = 'The printer was reset. Does the part still hold on the bed, and is the nozzle still at its height? ' +
  'It will heat up where it is, lift, home X and Y, and go on.';

function takeUp(id, recover) {
  if (recover && !confirm(RECOVER)) return null;
  return attempt(() => ask('POST', `jobs/${id}/take-up`, JSON.stringify({recover})));
}

function buttonsOf({id, state, can_be_taken_up: cutOff}) {
  if (state === 'queued') {
    return [button('Cancel', `Cancel job ${id}`, () => attempt(() => ask('POST', `jobs/${id}/cancel`)))];
  }
  if (!cutOff) return [];
  return [button('Take up', `Take up job ${id}`, () => takeUp(id, false)),
    button('After a reset', `Take up job ${id} after a reset of the printer`, () => takeUp(id, true))];
}

async function showJobs() {
  const {jobs} = await ask('GET', 'jobs');
  $('jobs').replaceChildren(...jobs.map((job) => row(
    [String(job.id), job.file, job.message ? `${job.state}: ${job.message}` : job.state], buttonsOf(job))));
}

function queue(file, spec) {
  return attempt(() => ask('POST', 'jobs', JSON.stringify({file, spec})));
}

async function upload(files) {
  for (const file of files) {
    $('sending').textContent = `sending ${file.name}`;
    await attempt(() => ask('PUT', `files/${encodeURIComponent(file.name)}`, file));
  }
  $('sending').textContent = '';
}

function onEvent(type, data) {
  if (type === 'state') {
    showStatus(data);
    attempt(showJobs);
  } else if (type === 'progress') {
    showStatus(data);
  } else if (type === 'temperatures') {
    showHeat(data);
  } else if (type === 'log') {
    showLog(data.text);
  } else if (type === 'files') {
    attempt(showFiles);
  } else if (type === 'jobs') {
    attempt(showJobs);
    attempt(changes.refresh);
  }
}

async function follow() {
  for (;;) {
    const done = await attempt(async () => {
      await showFiles();
      await listen(onEvent);
      return true;
    });
    if (done) report(new Error('The daemon ended; trying again.'));
    $('state').textContent = 'not connected';
    await new Promise((resolve) => setTimeout(resolve, RETRY_MS));
  }
}

const DIALS = {feed: ['feed', 1], flow: ['flow', 1], nozzle: ['nozzle', 1], 'bed-heat': ['bed', 1], fan: ['fan', 0.01]};

// Whether it was taken.
function adjust(change) {
  return attempt(async () => {
    await ask('POST', 'printer/adjust', JSON.stringify(change));
    return true;
  });
}

function say(commands) {
  return attempt(() => ask('POST', 'printer/commands', JSON.stringify({commands})));
}

// What was filled in; fields left empty change nothing.
async function adjustAll() {
  const change = {};
  for (const [id, [name, unit]] of Object.entries(DIALS)) {
    if ($(id).value !== '') change[name] = $(id).valueAsNumber * unit;
  }
  if (await adjust(change)) $('adjust-form').reset();
}

function press(id, path) {
  $(id).addEventListener('click', () => attempt(() => ask('POST', path())));
}

press('emergency', () => 'printer/emergency-stop');
press('pause', () => 'printer/pause');
press('resume', () => 'printer/resume');
press('cancel', () => `jobs/${status.job.id}/cancel`);
press('bed', () => 'printer/bed-cleared');
$('adjust-form').addEventListener('submit', (event) => {
  event.preventDefault();
  adjustAll();
});
$('say-form').addEventListener('submit', (event) => {
  event.preventDefault();
  say([$('say').value]);
  $('say').value = '';
});
$('home').addEventListener('click', () => say(['G28']));
$('lower').addEventListener('click', () => adjust({z: -0.02}));
$('higher').addEventListener('click', () => adjust({z: 0.02}));
$('upload').addEventListener('change', () => upload($('upload').files));
$('drop').addEventListener('dragover', (event) => {
  event.preventDefault();
  $('drop').classList.add('over');
});
$('drop').addEventListener('dragleave', () => $('drop').classList.remove('over'));
$('drop').addEventListener('drop', (event) => {
  event.preventDefault();
  $('drop').classList.remove('over');
  upload(event.dataTransfer.files);
});
$('key-form').addEventListener('submit', (event) => {
  event.preventDefault();
  useKey($('key').value);
  location.reload();
});
preview.start(report, queue);
changes.start(attempt);
follow();
