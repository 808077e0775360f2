// Drives headless Chromium over its debugging pipe: JSON texts that end with a NUL, on file descriptors 3 and 4. No
// package is needed.
import { spawn } from 'node:child_process';
import { existsSync, mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { delimiter, join } from 'node:path';

const PATIENCE = 120_000;  // [ms] until a page has done what is waited for

/** Where the browser is: MIEN_CHROMIUM, or in PATH; null: nowhere. */
export function chromiumPath() {
  if (process.env.MIEN_CHROMIUM) return process.env.MIEN_CHROMIUM;
  const places = (process.env.PATH ?? '').split(delimiter).flatMap((folder) => ['chromium', 'chromium-browser', 'google-chrome'].map((name) => join(folder, name)));
  return places.find((place) => existsSync(place)) ?? null;
}

/** The promise, or an error if nothing came of it. */
function inTime(promise, what) {
  let late;
  const ended = new Promise((_, fail) => { late = setTimeout(() => fail(new Error(`in ${PATIENCE / 1000} s there was no answer: ${what}`)), PATIENCE); });
  return Promise.race([promise, ended]).finally(() => clearTimeout(late));
}

/** Messages to the browser and back. */
class Wire {
  #pipe; #asked = new Map(); #count = 0; #rest = []; heard = new Map();
  constructor(to, from) {
    this.#pipe = to;
    to.on('error', () => {});  // it has ended: whoever waits is told below
    from.on('data', (bytes) => this.#read(bytes));
    from.on('close', () => { for (const { fail } of this.#asked.values()) fail(new Error('the browser has ended')); });
  }
  send(method, params = {}, sessionId = undefined) {
    const id = ++this.#count;
    this.#pipe.write(`${JSON.stringify({ id, method, params, sessionId })}\0`);
    return new Promise((done, fail) => this.#asked.set(id, { done, fail, method }));
  }
  #read(bytes) {
    for (let begin = 0; begin < bytes.length;) {
      const end = bytes.indexOf(0, begin);
      this.#rest.push(bytes.subarray(begin, end < 0 ? bytes.length : end));
      if (end < 0) return;
      this.#take(JSON.parse(Buffer.concat(this.#rest).toString()));
      this.#rest = [], begin = end + 1;
    }
  }
  #take({ id, sessionId, method, params, result, error }) {
    if (id === undefined) return this.heard.get(sessionId)?.(method, params);
    const asked = this.#asked.get(id);
    this.#asked.delete(id);
    error ? asked.fail(new Error(`${asked.method}: ${error.message}`)) : asked.done(result);
  }
}

/** One page. `faults` are its uncaught errors and what it wrote as errors. */
class Page {
  faults = [];
  #wire; #session; #target; #loaded;
  constructor(wire, session, target) {
    this.#wire = wire, this.#session = session, this.#target = target;
    wire.heard.set(session, (method, params) => this.#hear(method, params));
  }
  send(method, params) { return this.#wire.send(method, params, this.#session); }
  #hear(method, params) {
    if (method === 'Page.loadEventFired') this.#loaded?.();
    if (method === 'Runtime.exceptionThrown') this.faults.push(params.exceptionDetails.exception?.description ?? params.exceptionDetails.text);
    if (method === 'Runtime.consoleAPICalled' && params.type === 'error') this.faults.push(params.args.map((one) => one.value ?? one.description).join(' '));
  }
  async go(url) {
    const loaded = new Promise((done) => { this.#loaded = done; });
    await this.send('Page.navigate', { url });
    await inTime(loaded, url);
  }
  /** What a function of the page returns; it may be asynchronous. */
  async run(work, ...args) {
    const expression = `(${work})(...${JSON.stringify(args)})`;
    const asked = this.send('Runtime.evaluate', { expression, awaitPromise: true, returnByValue: true, userGesture: true });
    const { result, exceptionDetails } = await inTime(asked, String(work));
    if (exceptionDetails) throw new Error(exceptionDetails.exception?.description ?? exceptionDetails.text);
    return result.value;
  }
  /** Waits until a function of the page returns something true, and returns that. */
  async until(work, ...args) {
    for (const begin = Date.now(); Date.now() - begin < PATIENCE; await new Promise((done) => setTimeout(done, 50))) {
      const value = await this.run(work, ...args);
      if (value) return value;
    }
    throw new Error(`in ${PATIENCE / 1000} s it did not come true: ${work}`);
  }
  async press(key, code = key, modifiers = 0) {
    const text = key.length === 1 && !(modifiers & 6) ? key : key === 'Enter' ? '\r' : undefined;
    const named = { Tab: 9, Enter: 13, ' ': 32, Escape: 27, ArrowLeft: 37, ArrowUp: 38, ArrowRight: 39, ArrowDown: 40, Home: 36, End: 35 };
    const event = { key, code, modifiers, windowsVirtualKeyCode: named[key] ?? key.toUpperCase().charCodeAt(0) };
    await this.send('Input.dispatchKeyEvent', { type: 'keyDown', text, ...event });
    await this.send('Input.dispatchKeyEvent', { type: 'keyUp', ...event });
  }
  /** Moves the pointer along places, with the button down if `dragging`. */
  async move(places, dragging = false) {
    const tell = (type, [x, y], buttons) => this.send('Input.dispatchMouseEvent', { type, x, y, button: dragging ? 'left' : 'none', buttons, clickCount: dragging ? 1 : 0 });
    if (dragging) await tell('mousePressed', places[0], 1);
    for (const place of places) await tell('mouseMoved', place, dragging ? 1 : 0);
    if (dragging) await tell('mouseReleased', places.at(-1), 0);
  }
  async close() {
    this.#wire.heard.delete(this.#session);
    await this.#wire.send('Target.closeTarget', { targetId: this.#target });
  }
  async photograph(file) {
    const { data } = await this.send('Page.captureScreenshot', { format: 'png' });
    writeFileSync(file, Buffer.from(data, 'base64'));
  }
}

/** Starts the browser: { open(options), close() }. */
export async function browse(...flags) {
  const folder = mkdtempSync(join(tmpdir(), 'mien-browser-'));
  const browser = spawn(chromiumPath(), ['--headless=new', '--no-sandbox', '--disable-gpu', '--disable-dev-shm-usage', '--no-first-run', '--hide-scrollbars',
    '--force-color-profile=srgb', '--remote-debugging-pipe', `--user-data-dir=${folder}`, ...flags, 'about:blank'], { stdio: ['ignore', 'ignore', 'ignore', 'pipe', 'pipe'] });
  const ended = new Promise((done) => browser.on('exit', done));
  const wire = new Wire(browser.stdio[3], browser.stdio[4]);
  await wire.send('Browser.getVersion');
  const pages = new Set();
  return {
    version: (await wire.send('Browser.getVersion')).product,
    /** A page of that size [CSS px]; `first` is a script that runs before the page's own. */
    async open(url, { width = 1280, height = 800, dots = 1, dark = false, touch = false, first } = {}) {
      const { targetId } = await wire.send('Target.createTarget', { url: 'about:blank' });
      const { sessionId } = await wire.send('Target.attachToTarget', { targetId, flatten: true });
      const page = new Page(wire, sessionId, targetId);
      await Promise.all([page.send('Page.enable'), page.send('Runtime.enable'), page.send('DOM.enable')]);
      await page.send('Emulation.setDeviceMetricsOverride', { width, height, deviceScaleFactor: dots, mobile: touch });
      await page.send('Emulation.setEmulatedMedia', { features: [{ name: 'prefers-color-scheme', value: dark ? 'dark' : 'light' }] });
      if (first) await page.send('Page.addScriptToEvaluateOnNewDocument', { source: first });
      await page.send('Page.bringToFront');  // those behind draw no frames
      pages.add(page);
      await page.go(url);
      return page;
    },
    /** Closes all pages: their workers take time from those that come after them. */
    async closePages() {
      await Promise.all([...pages].map((page) => page.close()));
      pages.clear();
    },
    async close() {
      await wire.send('Browser.close').catch(() => {});
      const late = setTimeout(() => browser.kill('SIGKILL'), 5000);
      await ended;
      clearTimeout(late);
      rmSync(folder, { recursive: true, force: true, maxRetries: 5, retryDelay: 200 });
    },
  };
}
