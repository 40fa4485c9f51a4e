// The page: what the daemon tells is shown, what is pressed is asked of it. Each part is a module.
import * as account from '/assets/account.js';
import {Refused, listen} from '/assets/api.js';
import * as apps from '/assets/apps.js';
import * as camera from '/assets/camera.js';
import * as changes from '/assets/changes.js';
import '/assets/control.js';
import * as dashboard from '/assets/dashboard.js';
import * as files from '/assets/files.js';
import * as heat from '/assets/heat.js';
import * as jobs from '/assets/jobs.js';
import {attempt, quietly, report} from '/assets/page.js';
import * as pauses from '/assets/pauses.js';
import * as terminal from '/assets/terminal.js';

const RETRY_MS = 3000;
const LOST = 'The daemon cannot be reached; trying again.';

function onEvent(type, data) {
  if (type === 'state' || type === 'progress') {
    dashboard.show(data);
    changes.show(data.job);
    pauses.show(data.job);
  }
  if (type === 'state') jobs.show();
  if (type === 'temperatures') heat.show(data);
  if (type === 'log') terminal.show(data.text);
  if (type === 'files') files.show();
  if (type === 'apps') apps.refresh();
  if (type === 'jobs') {
    jobs.show();
    quietly(changes.refresh);
    quietly(pauses.refresh);
  }
}

// What events do not tell again; `state` is the first of them.
function begin(state, wasLost) {
  if (wasLost) report(null);
  heat.show(state.temperatures);
  files.show();
  camera.start();
  terminal.start();
  apps.refresh();
}

async function follow() {
  for (let lost = false;; lost = true) {
    let first = true;
    try {
      await listen((type, data) => {
        if (first) begin(data, lost);
        first = false;
        onEvent(type, data);
      });
      report(new Error(LOST));
    } catch (error) {
      report(error instanceof Refused ? error : new Error(LOST));
    }
    dashboard.lost();
    await new Promise((resolve) => setTimeout(resolve, RETRY_MS));
  }
}

changes.start(attempt);
pauses.start();
account.start(report);
follow();
