// Requests to the daemon this page came from, and its stream of events.

export class Refused extends Error {
  constructor(status, message) {
    super(message);
    this.status = status;
  }
}

async function checked(response) {
  if (response.ok) return response;
  let message = `${response.status} ${response.statusText}`;
  try {
    message = (await response.json()).error;
  } catch { /* the status says it */ }
  throw new Refused(response.status, message);
}

// What is answered, or null if there is no body.
export async function ask(method, path, body) {
  const response = await checked(await fetch('/api/v1/' + path, {method, body}));
  return response.status === 204 ? null : response.json();
}

export async function askBlob(path) {
  return (await checked(await fetch('/api/v1/' + path))).blob();
}

// Stores a file under its name; `told(share)` as it goes out, which `fetch` does not tell.
export function send(file, told) {
  return new Promise((resolve, reject) => {
    const request = new XMLHttpRequest();
    request.open('PUT', '/api/v1/files/' + encodeURIComponent(file.name));
    request.responseType = 'json';
    request.upload.addEventListener('progress', ({loaded, total}) => total && told(loaded / total));
    request.addEventListener('error', () => reject(new Error(`${file.name}: the daemon cannot be reached`)));
    request.addEventListener('load', () => {
      if (request.status < 300) resolve(request.response);
      else reject(new Refused(request.status, `${file.name}: ${request.response?.error ?? request.statusText}`));
    });
    request.send(file);
  });
}

export function specQuery(spec) {
  return '?spec=' + encodeURIComponent(JSON.stringify(spec));
}

// Calls `on(type, data)` for each event until the stream ends.
export async function listen(on) {
  const response = await checked(await fetch('/api/v1/events'));
  const reader = response.body.pipeThrough(new TextDecoderStream()).getReader();
  let text = '';
  for (;;) {
    const {value, done} = await reader.read();
    if (done) return;
    text += value;
    const events = text.split('\n\n');
    text = events.pop();
    for (const event of events) {
      const type = /^event: (.*)$/m.exec(event);
      const data = /^data: (.*)$/m.exec(event);
      if (type && data) on(type[1], JSON.parse(data[1]));
    }
  }
}
