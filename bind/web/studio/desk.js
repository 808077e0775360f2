// A worker with mien in it, and what it is asked.

/** What mien refused. */
export class Refused extends Error {
  /** `stopped`: nobody refused; the desk was closed. */
  constructor({ where, what, stopped = false }) {
    super(where ? `${where}: ${what}` : what);
    this.name = 'Refused', this.stopped = stopped, this.where = where, this.what = what;
  }
}

export class Desk {
  #worker; #asked = new Map(); #count = 0;
  constructor() {
    this.#worker = new Worker(new URL('./drawing_worker.js', import.meta.url), { type: 'module' });
    this.#worker.onmessage = ({ data }) => this.#answer(data);
    this.#worker.postMessage({ wasm: globalThis.mienWasm });  // of a page that has it in itself
    this.#worker.onerror = (event) => this.#end(event.message || 'the worker cannot be loaded');
  }
  /** The answer to a question; `tell` hears the share that is done. */
  ask(what, details = {}, { given = [], tell } = {}) {
    const number = ++this.#count;
    this.#worker.postMessage({ number, what, ...details }, given);
    return new Promise((done, fail) => this.#asked.set(number, { done, fail, tell }));
  }
  close() {
    this.#worker.terminate();
    this.#end('stopped', true);
  }
  #answer({ number, value, error, share }) {
    const asked = this.#asked.get(number);
    if (share !== undefined) return asked?.tell?.(share);
    this.#asked.delete(number);
    error ? asked?.fail(new Refused(error)) : asked?.done(value);
  }
  #end(what, stopped) {
    for (const { fail } of this.#asked.values()) fail(new Refused({ where: '', what, stopped }));
    this.#asked.clear();
  }
}

/** Small pictures, one after the other, in a worker of their own. */
export class Gallery {
  #desk = new Desk(); #waiting = []; #busy = false;
  ask(...question) { return this.#desk.ask(...question); }
  /** Draws into a canvas when its turn comes. `group`: what forget() drops. */
  draw(canvas, group, details) {
    this.#waiting.push({ canvas, group, details });
    this.#next();
  }
  forget(group) { this.#waiting = this.#waiting.filter((one) => one.group !== group); }
  async #next() {
    if (this.#busy) return;
    this.#busy = true;
    for (let one; (one = this.#waiting.shift());) await this.#put(one);
    this.#busy = false;
  }
  async #put({ canvas, details }) {
    try {
      const { width, height } = details, pixels = await this.#desk.ask('small', details);
      canvas.width = width, canvas.height = height;
      canvas.getContext('2d').putImageData(new ImageData(pixels, width, height), 0, 0);
      canvas.dataset.drawn = '';
    } catch (refused) {
      canvas.dataset.refused = refused.message;
    }
  }
}
