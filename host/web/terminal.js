// What the printer says, and what is said to it; arrow up brings back what was said before.
import {ask} from '/assets/api.js';
import {$, attempt, element, tell} from '/assets/page.js';

const LINES = 300;
const REMEMBERED = 100;

const said = [];
let at = 0;  // in `said`; its end: the line that is being written

export function show(text, who = 'printer') {
  const log = $('log');
  const atEnd = log.scrollTop + log.clientHeight >= log.scrollHeight - 4;
  log.append(element('div', text, who));
  while (log.childNodes.length > LINES) log.firstChild.remove();
  if (atEnd) log.scrollTop = log.scrollHeight;
}

function remember(line) {
  if (said.at(-1) !== line) said.push(line);
  if (said.length > REMEMBERED) said.shift();
  at = said.length;
}

async function say(event) {
  event.preventDefault();
  const line = $('say').value.trim();
  if (line === '') return;
  remember(line);
  show(line, 'user');
  if (await tell('printer/commands', {commands: [line]})) $('say').value = '';
}

function leaf(event) {
  const way = {ArrowUp: -1, ArrowDown: 1}[event.key];
  if (!way || said.length === 0) return;
  event.preventDefault();
  at = Math.min(Math.max(at + way, 0), said.length);
  $('say').value = said[at] ?? '';
}

// Who may not see it is not offered it.
export async function start() {
  try {
    $('wire-on').checked = (await ask('GET', 'printer/serial-log')).on;
    $('wire').hidden = false;
  } catch {
    $('wire').hidden = true;
  }
}

$('wire-on').addEventListener('change', ({target}) =>
  attempt(() => ask('PUT', 'printer/serial-log', JSON.stringify({on: target.checked}))));
$('say-form').addEventListener('submit', say);
$('say').addEventListener('keydown', leaf);
