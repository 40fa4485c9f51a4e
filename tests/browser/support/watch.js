// What a browser complains about while a test goes on: errors on its console, requests that failed,
// answers that are errors, requests to anywhere else. A test ends with none of these but what it
// said it would meet.
import assert from 'node:assert/strict';

export class Watch {
  constructor(context, url) {
    this.origin = new URL(url).origin;
    this.faults = [];
    this.foreseen = [];
    this.over = false;
    context.on('request', (request) => {
      const {protocol, origin} = new URL(request.url());
      if (protocol === 'data:' || origin === this.origin) return;
      this.fault(`request to elsewhere: ${request.url()}`);
    });
    const bodiless = new WeakSet();  // what is answered by 204, Chromium calls aborted
    context.on('requestfailed', (request) => {
      const why = request.failure()?.errorText;
      // A page that is loaded anew leaves its stream of events.
      const over = bodiless.has(request) || request.url().endsWith('/events');
      if (why !== 'net::ERR_ABORTED' || !over) this.fault(`${request.method()} ${request.url()}: ${why}`);
    });
    context.on('response', (response) => {
      if (response.status() === 204) bodiless.add(response.request());
      if (response.status() >= 400) {
        this.fault(`${response.request().method()} ${new URL(response.url()).pathname} ${response.status()}`);
      }
    });
    context.on('console', (message) => {
      if (['error', 'warning'].includes(message.type())) {
        this.fault(`console: ${message.text()} (${message.location().url})`);
      }
    });
    context.on('weberror', (error) => this.fault(`uncaught: ${error.error().stack}`));
  }

  // Faults that match are part of the test.
  foresee(pattern) {
    this.foreseen.push(pattern);
  }

  fault(text) {
    if (!this.over && !this.foreseen.some((pattern) => pattern.test(text))) this.faults.push(text);
  }

  // \pre before the pages are closed, which breaks off their stream of events.
  end() {
    this.over = true;
    assert.deepEqual(this.faults, []);
  }
}
