// Programs under test: started, awaited by what they say, ended. Every wait is bounded.
import {spawn} from 'node:child_process';

const START_MS = 30_000;
const END_MS = 20_000;
const KEPT = 4000;  // characters of what one says, for the message of a test that fails

function within(ms, what, begin) {
  return new Promise((resolve, reject) => {
    const timer = setTimeout(() => reject(new Error(`${what}: not within ${ms} ms`)), ms);
    begin(
      (value) => { clearTimeout(timer); resolve(value); },
      (error) => { clearTimeout(timer); reject(error); });
  });
}

export class Process {
  constructor(program, args) {
    this.name = args[0];
    this.said = '';
    this.child = spawn(program, args, {stdio: ['ignore', 'pipe', 'pipe']});
    for (const stream of [this.child.stdout, this.child.stderr]) {
      stream.on('data', (text) => { this.said = (this.said + text).slice(-KEPT); });
    }
    this.ended = new Promise((resolve) => {
      this.child.once('exit', (code, signal) => resolve(signal ?? code));
      this.child.once('error', (error) => resolve(error.message));
    });
  }

  // What the group of `pattern` is, once a line of the output has it.
  says(pattern) {
    return within(START_MS, `${this.name}, saying ${pattern}`, (resolve, reject) => {
      const look = () => {
        const found = pattern.exec(this.said);
        if (found) resolve(found[1]);
      };
      this.child.stdout.on('data', look);
      this.ended.then((how) => reject(new Error(`${this.name} ended (${how}): ${this.said}`)));
      look();
    });
  }

  // Asks it to end; \return its exit status, or the signal that ended it.
  async stop(signal = 'SIGTERM') {
    this.child.kill(signal);
    try {
      return await within(END_MS, `end of ${this.name}`, (resolve) => this.ended.then(resolve));
    } catch (error) {
      this.child.kill('SIGKILL');
      throw error;
    }
  }
}
