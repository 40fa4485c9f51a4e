// The queue and the history.
import {ask} from '/assets/api.js';
import {$, attempt, button, element, moment, quietly, tell, time} from '/assets/page.js';

const RECOVER = 'The printer was reset. Does the part still hold on the bed, and is the nozzle still at its height? ' +
  'It will heat up where it is, lift, home X and Y, and go on.';

function takeUp(id, recover) {
  if (!recover || confirm(RECOVER)) tell(`jobs/${id}/take-up`, {recover});
}

function buttonsOf({id, state, file, spec, can_be_taken_up: cutOff}) {
  if (state === 'queued') return [button('Cancel', `Cancel job ${id}`, () => tell(`jobs/${id}/cancel`))];
  if (state === 'printing') return [];
  const again = button('Again', `Queue ${file} again, as in job ${id}`, () => tell('jobs', {file, spec}));
  if (!cutOff) return [again];
  return [button('Take up', `Take up job ${id}`, () => takeUp(id, false)),
    button('After a reset', `Take up job ${id} after a reset of the printer`, () => takeUp(id, true)), again];
}

function when({created, started, ended}) {
  if (ended && started) return `${moment(ended)}, after ${time(ended - started)}`;
  return moment(ended || started || created);
}

function item(job) {
  const made = document.createElement('li');
  const about = document.createElement('div');
  const title = element('strong', job.file);
  title.prepend(element('span', String(job.id), 'number'), ' ');
  const state = element('span', job.state, 'chip');
  state.dataset.state = job.state;
  about.append(title, ' ', state, element('small', when(job)));
  if (job.message) about.append(element('p', job.message));
  const buttons = element('div', '', 'buttons');
  buttons.append(...buttonsOf(job));
  made.append(about, buttons);
  return made;
}

export function show() {
  return quietly(async () => {
    const {jobs} = await ask('GET', 'jobs');
    $('jobs').replaceChildren(...jobs.map(item));
    $('no-jobs').hidden = jobs.length > 0;
  });
}
