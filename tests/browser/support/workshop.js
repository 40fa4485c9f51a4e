// A simulated printer behind a pseudo-terminal and a daemon that prints on it, with a folder of their own.
import assert from 'node:assert/strict';
import {once} from 'node:events';
import {mkdtemp, rm} from 'node:fs/promises';
import {createConnection} from 'node:net';
import {tmpdir} from 'node:os';
import {join} from 'node:path';

import {Process} from './processes.js';

const PROGRAM = process.env.SLIPSTICK ?? 'build/dev/slipstick';

const ANSWER_MS = 10_000;

export class Workshop {
  // `speed`: seconds of the printer in one of ours; `serve`: further options of the daemon.
  static async open({speed = 60, serve = [], listen = '127.0.0.1:0'} = {}) {
    const shop = new Workshop();
    shop.folder = await mkdtemp(join(tmpdir(), 'slipstick-browser-'));
    try {
      const pty = join(shop.folder, 'printer');
      shop.control = join(shop.folder, 'control');
      shop.printer = new Process(PROGRAM, ['sim', '--pty', pty, '--control', shop.control, '--speed', String(speed)]);
      await shop.printer.says(/(printer at .*)\n/);
      shop.options = ['--printer', `pty:${pty}`, '--data', join(shop.folder, 'data'), ...serve];
      await shop.serve(listen);
      return shop;
    } catch (error) {
      await shop.close();
      throw error;
    }
  }

  async serve(address) {
    this.daemon = new Process(PROGRAM, ['serve', '--listen', address, ...this.options]);
    this.url = await this.daemon.says(/listening on (http:\S+)\n/);
  }

  // Where the machine is and what it is at, by the simulator itself.
  async state() {
    const socket = createConnection(this.control).setEncoding('utf8').setTimeout(ANSWER_MS, () => socket.destroy());
    socket.write('state\n');
    const [line] = await once(socket, 'data');
    socket.destroy();
    return JSON.parse(line);
  }

  async close() {
    const ends = [await this.daemon?.stop(), await this.printer?.stop()];
    await rm(this.folder, {recursive: true, force: true});
    assert.deepEqual(ends.filter((end) => end !== undefined && end !== 0), [],
      `${this.daemon?.said}\n${this.printer?.said}`);
  }
}
