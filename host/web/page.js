// What all parts of the page need: its elements, what went wrong, times as text. Texts from printers
// and files only ever become text, never markup.
import {logIn} from '/assets/account.js';
import {Refused, ask} from '/assets/api.js';

export const $ = (id) => document.getElementById(id);

export function report(error) {
  $('fault-text').textContent = error ? error.message : '';
  $('fault').hidden = !error;
  if (error instanceof Refused && error.status === 401) logIn();
}

// Does it, and says what went wrong; what went wrong before stands until somebody does something.
export async function quietly(work) {
  try {
    return await work();
  } catch (error) {
    report(error);
    return null;
  }
}

// The same for what the user has asked for.
export function attempt(work) {
  report(null);
  return quietly(work);
}

// Whether the daemon did it.
export function tell(path, body) {
  return attempt(async () => {
    await ask('POST', path, body && JSON.stringify(body));
    return true;
  });
}

// Changes a text only where it is another: a screen reader says each change.
export function put(id, text) {
  if ($(id).textContent !== text) $(id).textContent = text;
}

export function element(tag, text, name) {
  const made = document.createElement(tag);
  made.textContent = text;
  if (name) made.className = name;
  return made;
}

export function button(text, label, act) {
  const made = element('button', text);
  made.type = 'button';
  made.setAttribute('aria-label', label);
  made.addEventListener('click', act);
  return made;
}

export function time(seconds) {
  const s = Math.round(seconds);
  const two = (n) => String(n).padStart(2, '0');
  return `${Math.floor(s / 3600)}:${two(Math.floor(s / 60) % 60)}:${two(s % 60)}`;
}

export function clock(date) {
  return date.toLocaleTimeString([], {hour: '2-digit', minute: '2-digit'});
}

// "today, 14:05" or "3 Nov, 14:05".
export function moment(unixSeconds) {
  const at = new Date(unixSeconds * 1000);
  const today = at.toDateString() === new Date().toDateString();
  return `${today ? 'today' : at.toLocaleDateString([], {day: 'numeric', month: 'short'})}, ${clock(at)}`;
}

document.getElementById('fault-close').addEventListener('click', () => report(null));
