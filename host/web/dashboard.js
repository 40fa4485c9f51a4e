// What is being printed, how far it is, and what can be done about it.
import {$, clock, put, tell, time} from '/assets/page.js';
import * as live from '/assets/live.js';

let status = null;

function figures(job) {
  const layers = job.layers ? [`layer ${job.layer} of ${job.layers}`, `${job.height.toFixed(2)} mm`] : [];
  return [...layers, `${job.lines} lines`, `${time(job.seconds)} so far`].join(' · ');
}

function left(job) {
  if (job.seconds_left === null) return '';
  return `about ${time(job.seconds_left)} left, until ${clock(new Date(Date.now() + 1000 * job.seconds_left))}`;
}

function showJob(job) {
  const percent = job ? Math.floor(100 * job.completion) : 0;
  put('job', job ? job.file : 'Nothing is being printed.');
  $('progress').hidden = !job;
  $('progress').value = job ? job.completion : 0;
  $('percent').textContent = job ? `${percent} %` : '';
  $('figures').textContent = job ? figures(job) : '';
  $('left').textContent = job ? left(job) : '';
  document.title = job ? `${percent} % - slipstick` : 'slipstick';
}

function showState({state, connected, message}) {
  const word = state === 'idle' && connected ? 'connected' : state;
  put('state', word);
  $('state').dataset.state = word;
  put('message', message);
}

export function show(next) {
  status = next;
  const {state, job, bed_occupied: occupied, connected} = next;
  showState(next);
  showJob(job);
  live.show(job);
  $('pause').hidden = state === 'paused' || !job;
  $('pause').disabled = state !== 'printing';
  $('resume').hidden = state !== 'paused';
  $('cancel').hidden = !job;
  $('cancel').disabled = state === 'ending';
  $('bed').hidden = !!job || !(occupied || state === 'stopped');
  $('bed-note').hidden = !!job || !occupied;
  $('stopped-note').hidden = state !== 'stopped';
  $('control').hidden = !job && !connected;
  $('move').hidden = !!job;
}

// The daemon is out of reach.
export function lost() {
  put('state', 'not connected');
  $('state').dataset.state = 'lost';
}

function cancel() {
  const {id, file} = status.job;
  if (confirm(`Cancel the print of ${file}? It cannot be taken up again.`)) tell(`jobs/${id}/cancel`);
}

$('emergency').addEventListener('click', () => tell('printer/emergency-stop'));
$('pause').addEventListener('click', () => tell('printer/pause'));
$('resume').addEventListener('click', () => tell('printer/resume'));
$('bed').addEventListener('click', () => tell('printer/bed-cleared'));
$('cancel').addEventListener('click', cancel);
