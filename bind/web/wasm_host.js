// What mien.wasm needs of JavaScript: its memory, and answers to what it asks of its host.

import { MienError } from './pose_keys.js';

/** The module's memory: numbers and texts in it. Views are made anew for each use, since memory grows. */
export class Memory {
  constructor(exports) {
    this.exports = exports;
    this.goesOn = () => true;
    this.decoder = new TextDecoder();
    this.encoder = new TextEncoder();
  }
  get view() { return new DataView(this.exports.memory.buffer); }
  get bytes() { return new Uint8Array(this.exports.memory.buffer); }
  take(size) {
    const at = this.exports.malloc(size);
    if (!at) throw new MienError('', 'there is not enough memory');
    return at;
  }
  /** Calls use(address, length) with a text in memory. */
  withText(text, use) {
    const bytes = this.encoder.encode(text), at = this.take(bytes.length + 1);
    this.bytes.set(bytes, at);
    this.bytes[at + bytes.length] = 0;
    try { return use(at, bytes.length); } finally { this.exports.free(at); }
  }
  /** Calls use(address) with a list of the addresses of texts, each of which ends with a NUL. */
  withTexts(texts, use) {
    const all = texts.map((text) => this.encoder.encode(`${text}\0`)), list = this.take(all.reduce((sum, { length }) => sum + length, 4 * all.length + 1));
    let at = list + 4 * all.length;
    for (const [i, bytes] of all.entries()) this.view.setUint32(list + 4 * i, at, true), this.bytes.set(bytes, at), at += bytes.length;
    try { return use(list); } finally { this.exports.free(list); }
  }
  text(at) {
    const bytes = this.bytes;
    return this.decoder.decode(bytes.slice(at, bytes.indexOf(0, at)));
  }
}

/** Ends a call into the module. C++ would catch what JavaScript throws; a trap it cannot. */
function trap() {
  // (module (func (export "f") unreachable))
  const bytes = new Uint8Array([0, 97, 115, 109, 1, 0, 0, 0, 1, 4, 1, 96, 0, 0, 3, 2, 1, 0, 7, 5, 1, 1, 102, 0, 0, 10, 5, 1, 3, 0, 0, 11]);
  new WebAssembly.Instance(new WebAssembly.Module(bytes)).exports.f();
}

/** The few things that the module asks of its host: the time; no files, no arguments, no way out. */
export function host(memory) {
  const zero = (...counts) => { for (const at of counts) memory().view.setUint32(at, 0, true); return 0; };
  const known = {
    clock_time_get(_clock, _precision, at) {
      memory().view.setBigUint64(at, BigInt(Math.round(1e6 * performance.now())), true);
      return 0;
    },
    proc_exit: trap,
    mien_asks_to_go_on: (done) => memory().goesOn(done) ? 1 : 0,
    environ_sizes_get: zero, environ_get: () => 0,
    fd_close: () => 0, fd_seek: () => 0, fd_read: () => 0,
    fd_write(_file, _parts, _count, written) { return zero(written); },
    emscripten_notify_memory_growth() {},
  };
  return (name) => known[name] ?? (() => -2);  // what is asked besides is not there: ENOENT
}

export async function compiled(source) {
  if (source instanceof WebAssembly.Module) return source;
  if (source instanceof ArrayBuffer || ArrayBuffer.isView(source)) return WebAssembly.compile(source);
  const response = await (source instanceof URL || typeof source === 'string' ? fetch(source) : source);
  if (!response.ok) throw new MienError(response.url, `cannot be fetched: ${response.status}`);
  const typed = (response.headers.get('Content-Type') ?? '').startsWith('application/wasm');
  return typed ? WebAssembly.compileStreaming(response) : WebAssembly.compile(await response.arrayBuffer());
}
