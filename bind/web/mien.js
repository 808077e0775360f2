// mien in JavaScript: a face goes in, pixels come out. In browsers, workers and node, without dependencies.
//
//   import { load } from 'mien';
//   const mien = await load();                                  // mien.wasm, beside this file
//   const face = mien.person('A66CB-AA5S0-14');                 // or mien.face(textOfAFaceFile)
//   const pixels = face.draw(640, 360, { time: 1.25, emotions: { joy: 0.8 }, set: { 'gaze.x': 0.04 } });
//   context.putImageData(new ImageData(pixels, 640, 360), 0, 0);
//
// Pixels are red, green, blue, alpha in 8 bits, sRGB-encoded, not premultiplied: the bytes that mien draws on every
// machine without fused multiply-adds. What mien refuses is an Error whose `where` is the place and whose `what` is
// the sentence.

/** What mien refused: `where` ("toon.face.json:12:7: /features/2") and `what` ("expected 2 numbers, got 3"). */
export class MienError extends Error {
  constructor(where, what) {
    super(where ? `${where}: ${what}` : what);
    this.name = 'MienError';
    this.where = where;
    this.what = what;
  }
}

const VIEW = { bytes: 112, width: 4, height: 8, fit: 12, blend: 16, hasBackground: 24, background: 40 };
const PIXELS = { bytes: 20, data: 8, size: 12, stride: 16 };
const NAME = { bytes: 48, isControl: 4, isPose: 8, count: 12, begin: 16, name: 24, unit: 28, lo: 32, hi: 40 };
const CANVAS = { bytes: 56, yUp: 4, box: 8, mirrorX: 40, unit: 48 };

/** The module's memory: numbers and texts in it. Views are made anew for each use, since memory grows. */
class Memory {
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
function host(memory) {
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

async function compiled(source) {
  if (source instanceof WebAssembly.Module) return source;
  if (source instanceof ArrayBuffer || ArrayBuffer.isView(source)) return WebAssembly.compile(source);
  const response = await (source instanceof URL || typeof source === 'string' ? fetch(source) : source);
  if (!response.ok) throw new MienError(response.url, `cannot be fetched: ${response.status}`);
  const typed = (response.headers.get('Content-Type') ?? '').startsWith('application/wasm');
  return typed ? WebAssembly.compileStreaming(response) : WebAssembly.compile(await response.arrayBuffer());
}

/** Whether this system runs mien: WebAssembly with 128-bit lanes. */
export function isSupported() {
  // A function that returns a vector: (module (func (result v128) i32.const 0 i8x16.splat))
  const probe = new Uint8Array([0, 97, 115, 109, 1, 0, 0, 0, 1, 5, 1, 96, 0, 1, 123, 3, 2, 1, 0, 10, 8, 1, 6, 0, 65, 0, 253, 15, 11]);
  return typeof WebAssembly === 'object' && WebAssembly.validate(probe);
}

/** Loads mien. `source`: bytes, a URL, a Response or a compiled module; by default mien.wasm beside this file. */
export async function load(source = new URL('./mien.wasm', import.meta.url)) {
  if (!isSupported()) throw new MienError('', 'this system has no WebAssembly with 128-bit lanes (SIMD), which mien needs');
  let bytes = source;
  if (source instanceof URL && source.protocol === 'file:') bytes = await (await import('node:fs/promises')).readFile(source);
  const module = await compiled(bytes), imports = {};
  let memory;
  const answer = host(() => memory);
  for (const { module: from, name } of WebAssembly.Module.imports(module)) (imports[from] ??= {})[name] = answer(name);
  const instance = await WebAssembly.instantiate(module, imports);
  memory = new Memory(instance.exports);
  instance.exports._initialize();
  return new Mien(memory);
}

export class Mien {
  #m; #slot;
  constructor(memory) { this.#m = memory, this.#slot = memory.take(16); }

  get version() { return this.#m.text(this.#m.exports.mien_version_text()); }

  /** A face out of the text of a face file; `name` stands for the file's in errors. */
  face(text, name = 'face') {
    return this.#m.withText(text, (t, n) => this.#m.withText(name, (f, k) =>
      new Face(this, this.#m, this.made('mien_face_read_text', t, n, f, k))));
  }
  /** The text of a face file with other values, `set` as a pose has them: { text, left }. All else keeps every byte; a
   *  side that differs from its mirror image gets an object of its own. `left`: names that the file cannot hold. */
  textWith(text, set, name = 'face') {
    const settings = Object.entries(set).map(([key, value]) => `${key}=${[value].flat().join(',')}`);
    const [made, ...left] = this.#m.withText(text, (t, n) => this.#m.withText(name, (f, k) =>
      this.#m.withTexts(settings, (at) => this.texts('mien_face_text_with', t, n, f, k, at, settings.length))));
    return { text: made, left };
  }
  /** The text of a recipe's face in full, in which every feature stands and nothing is of parts. */
  inFull(text, name = 'face') {
    return this.#m.withText(text, (t, n) => this.#m.withText(name, (f, k) => this.texts('mien_recipe_in_full', t, n, f, k)))[0];
  }
  /** Where a face file's text says its values: JSON pointers (RFC 6901) by the values' names. Names that the file does not
   *  hold are not among them. */
  pointers(text, name = 'face') {
    const face = this.face(text, name), names = face.names;
    face.free();
    const found = this.#m.withText(text, (t, n) => this.#m.withText(name, (f, k) => this.texts('mien_face_pointers', t, n, f, k)));
    return Object.fromEntries(names.map((one, i) => [one.name, found[i]]).filter(([, pointer]) => pointer));
  }
  /** The person of a code. */
  person(code) {
    return this.#m.withText(code, (t, n) => new Face(this, this.#m, this.made('mien_face_from_code', t, n)));
  }
  /** The codes of people, no two of whom look alike. */
  crowd(word, count) { return this.#m.withText(word, (t, n) => this.texts('mien_crowd', t, n, count)); }
  /** The recipe of a code: a face file of a few lines. */
  recipe(code) { return this.#m.withText(code, (t, n) => this.texts('mien_recipe_from_code', t, n)[0]); }
  /** The code of a word: the same word, the same person. */
  code(word) {
    this.#m.withText(word, (t, n) => this.done('mien_seed_from_word', t, n, this.#slot));
    return this.texts('mien_code_from_seed', this.#m.view.getBigUint64(this.#slot, true))[0];
  }
  /** The code with one thing held: held(code, 'hair=bob'). */
  held(code, what) {
    return this.#m.withText(code, (t, n) => this.#m.withText(what, (w, k) => this.texts('mien_code_hold', t, n, w, k, 0)[0]));
  }
  /** The code of somebody between two. */
  between(one, other, at) {
    return this.#m.withText(one, (t, n) => this.#m.withText(other, (w, k) => this.texts('mien_code_between', t, n, w, k, at)[0]));
  }

  /** Somebody like the person of a code: `by`, 0 to 1, is how far and how likely things change. */
  near(code, by = 0.3, word = '') {
    this.#m.withText(word, (t, n) => this.done('mien_seed_from_word', t, n, this.#slot));
    const seed = this.#m.view.getBigUint64(this.#slot, true);
    return this.#m.withText(code, (t, n) => this.texts('mien_code_near', t, n, by, seed)[0]);
  }
  /** What recipes of an edition, by default the newest, choose from: { families: [{ name, parts }], numbers: [{ name,
   *  lo, hi, rest }], styles }. "none" is first among the parts of families that a face may do without. */
  parts(edition = '') {
    return this.#m.withText(edition, (t, n) => ({
      families: this.texts('mien_part_families', t, n).map((name) => ({ name, parts: this.#m.withText(name, (f, k) => this.texts('mien_part_names', t, n, f, k)) })),
      numbers: this.texts('mien_part_numbers', t, n).map((name) => ({ name, ...this.#range(t, n, name) })),
      styles: this.texts('mien_part_styles', t, n),
    }));
  }
  #range(edition, length, name) {
    const at = this.#m.take(24);
    try {
      this.#m.withText(name, (t, n) => this.done('mien_part_number', edition, length, t, n, at));
      const [lo, hi, rest] = [0, 8, 16].map((offset) => this.#m.view.getFloat64(at + offset, true));
      return { lo, hi, rest };
    } finally { this.#m.exports.free(at); }
  }

  /** Calls a function whose last argument is an error; throws what it says. For this file. */
  done(name, ...args) {
    const { exports } = this.#m, error = this.#slot + 12;
    this.#m.view.setUint32(error, 0, true);
    let status;
    try { status = exports[name](...args, error); } catch (ended) { throw new MienError(name, `mien ended: ${ended.message}`); }
    if (status === 0) return;
    const at = this.#m.view.getUint32(error, true);
    const where = this.#m.text(exports.mien_error_where(at)), what = this.#m.text(exports.mien_error_what(at));
    exports.mien_error_free(at);
    throw new MienError(where, what);
  }
  /** The same where the argument before it is what is made: returns its handle. */
  made(name, ...args) {
    const out = this.#slot + 8;
    this.done(name, ...args, out);
    return this.#m.view.getUint32(out, true);
  }
  texts(name, ...args) {
    const { exports } = this.#m, list = this.made(name, ...args);
    const found = Array.from({ length: exports.mien_texts_count(list) }, (_, i) => this.#m.text(exports.mien_texts_at(list, i)));
    exports.mien_texts_free(list);
    return found;
  }
}

/** A face, and what is kept from one of its pictures to the next. */
export class Face {
  #mien; #m; #face; #pose; #renderer; #view; #pixels; #room = 0; #data = 0; #scene = 0;
  constructor(mien, memory, face) {
    this.#mien = mien, this.#m = memory, this.#face = face;
    this.#pose = mien.made('mien_pose_new', face);
    this.#renderer = mien.made('mien_renderer_new');
    this.#view = memory.take(VIEW.bytes), this.#pixels = memory.take(PIXELS.bytes);
  }

  get title() { return this.#m.text(this.#m.exports.mien_face_title(this.#face)); }
  get credit() { return this.#m.text(this.#m.exports.mien_face_credit(this.#face)); }
  get clips() {
    const { exports } = this.#m;
    return Array.from({ length: exports.mien_face_clip_count(this.#face) }, (_, i) => this.#m.text(exports.mien_face_clip_name(this.#face, i)));
  }
  /** [s] How long each clip is, by its name: from then on it repeats, or rests. Infinity: it never does, for chance moves
   *  it, or its curves do not come together again. */
  get clipLengths() {
    const { exports } = this.#m;
    return Object.fromEntries(this.clips.map((name, i) => [name, exports.mien_face_clip_length(this.#face, i)]));
  }
  /** What can be set: { name, unit, isControl, isPose, count, begin, lo, hi, values }, controls first. `begin` is a
   *  slice's place in vector(), -1 of a control; values are at rest. */
  get names() {
    const at = this.#m.take(NAME.bytes), count = this.#m.exports.mien_face_name_count(this.#face), found = [];
    for (let i = 0; i < count; ++i) {
      this.#m.view.setUint32(at, NAME.bytes, true);
      this.#mien.done('mien_face_name_at', this.#face, i, at);
      const v = this.#m.view, whole = (offset) => v.getInt32(at + offset, true), text = (offset) => this.#m.text(v.getUint32(at + offset, true));
      found.push({ name: text(NAME.name), unit: text(NAME.unit), isControl: whole(NAME.isControl) !== 0, isPose: whole(NAME.isPose) !== 0,
        count: whole(NAME.count), begin: whole(NAME.begin), lo: v.getFloat64(at + NAME.lo, true), hi: v.getFloat64(at + NAME.hi, true), values: this.#values(i, whole(NAME.count)) });
    }
    this.#m.exports.free(at);
    return found;
  }
  #values(index, count) {
    const at = this.#m.take(8 * count);
    try {
      this.#mien.done('mien_face_values_at', this.#face, index, at, count);
      return Array.from({ length: count }, (_, i) => this.#m.view.getFloat64(at + 8 * i, true));
    } finally { this.#m.exports.free(at); }
  }
  /** The numbers of the face in a pose. */
  vector(pose = {}) {
    this.#take(pose);
    const count = this.#m.exports.mien_face_vector_size(this.#face), at = this.#m.take(8 * count);
    try {
      this.#mien.done('mien_pose_vector', this.#pose, at, count);
      return Array.from({ length: count }, (_, i) => this.#m.view.getFloat64(at + 8 * i, true));
    } finally { this.#m.exports.free(at); }
  }
  /** What a picture of the face shows, in face units: { box: [x0, y0, x1, y1], yUp, mirrorX, unit }. */
  get canvas() {
    const at = this.#m.take(CANVAS.bytes);
    this.#m.view.setUint32(at, CANVAS.bytes, true);
    this.#mien.done('mien_face_canvas', this.#face, at);
    const v = this.#m.view, box = [0, 1, 2, 3].map((i) => v.getFloat64(at + CANVAS.box + 8 * i, true));
    const canvas = { box, yUp: v.getInt32(at + CANVAS.yUp, true) !== 0, mirrorX: v.getFloat64(at + CANVAS.mirrorX, true), unit: this.#m.text(v.getUint32(at + CANVAS.unit, true)) };
    this.#m.exports.free(at);
    return canvas;
  }

  /** Draws; pixels stay valid until anything else is asked of mien: copy them to keep them.
   *    pose.time      seconds, at which clips run; none: no clip runs
   *    pose.set       { 'gaze.x': 0.1, 'palette/skin': '#ffd94a', 'brow.left/spine/1': [0.1, 0.2] }
   *    pose.emotions  { joy: 0.8, 'left.surprise': 0.3 }, and likewise muscle, arkit, facs, vrm, viseme
   *    pose.clips     ['idle', 'feelings=0.5']
   *    pose.lookAt    [x, y, z]
   *    pose.blend     'linear' (default) or 'srgb'
   *    pose.fit       'meet' (default): all of the canvas; 'slice': all of the picture
   *    pose.background  '#rrggbb' or '#rrggbbaa', or [r, g, b, a] in linear light, 0 to 1; none: the face's
   *  Long drawings can be ended, wherever they are; draw then throws a MienError that says "cancelled":
   *    how.deadline   milliseconds from now, after which it ends
   *    how.progress   called about every 10 ms with the share done, 0 to 1; false ends it. What it throws, draw throws */
  draw(width, height, pose = {}, { deadline = Infinity, progress = undefined } = {}) {
    this.#poseFor(width, height, pose);
    this.#roomFor(width * height * 4);
    this.#into(this.#data, width, height);
    const until = performance.now() + deadline;
    let thrown;
    this.#m.goesOn = (done) => {
      if (performance.now() > until) return false;
      try { return progress?.(done) !== false; } catch (error) { thrown = { error }; return false; }
    };
    try {
      const options = this.#m.exports.mien_asking_options();
      this.#mien.done('mien_render', this.#renderer, this.#scene, this.#view, this.#pixels, options);
    } catch (error) {
      throw thrown ? thrown.error : error;
    } finally { this.#m.goesOn = () => true; }
    return new Uint8ClampedArray(this.#m.exports.memory.buffer, this.#data, width * height * 4);
  }

  /** The same picture from the top in strips of so many rows, in little memory: { y, rows, pixels }. A strip's pixels
   *  stay valid until the next is asked for. */
  *strips(width, height, pose = {}, most = Math.max(1, Math.floor((1 << 22) / width))) {
    this.#poseFor(width, height, pose);
    const { exports } = this.#m, pieces = this.#mien.made('mien_pieces_new', this.#scene, this.#view, 0);
    const piece = this.#m.take(16), data = this.#m.take(width * most * 4);
    try {
      for (let y = 0; y < height; y += most) {
        const rows = Math.min(most, height - y);
        [0, y, width, rows].forEach((number, i) => this.#m.view.setInt32(piece + 4 * i, number, true));
        this.#into(data, width, rows);
        this.#mien.done('mien_pieces_draw', pieces, piece, this.#pixels, 0, 0);
        yield { y, rows, pixels: new Uint8ClampedArray(exports.memory.buffer, data, width * rows * 4) };
      }
    } finally { exports.mien_pieces_free(pieces), exports.free(piece), exports.free(data); }
  }

  /** The same picture as an SVG file: { text, simplified }. Its paths leave the outlines by `tolerance` pixels at most,
   *  1e-4 to 1; `simplified` has a sentence for each thing that SVG cannot say. Colours are mixed as with blend 'srgb'.
   *  `idPrefix` begins all ids, so that several pictures can stand in one page. */
  svg(width, height, pose = {}, { tolerance = 0.01, idPrefix = '' } = {}) {
    this.#poseFor(width, height, pose);
    const [text, ...simplified] = this.#m.withText(idPrefix, (t, n) => this.#mien.texts('mien_svg', this.#scene, this.#view, tolerance, t, n));
    return { text, simplified };
  }

  /** Of the picture drawn last: the name of the feature that is seen at a pixel, or null. */
  featureAt(x, y) {
    const at = this.#m.take(16);
    try {
      this.#mien.done('mien_face_from_pixel', this.#scene, this.#view, x, y, at);
      const v = this.#m.view, px = v.getFloat64(at, true), py = v.getFloat64(at + 8, true);
      return this.#mien.texts('mien_scene_feature_at', this.#scene, px, py)[0] ?? null;
    } finally { this.#m.exports.free(at); }
  }
  /** Of the picture drawn last: where a pixel is, in face units, and back. */
  fromPixel(x, y) { return this.#place('mien_face_from_pixel', x, y); }
  toPixel(x, y) { return this.#place('mien_pixel_from_face', x, y); }
  #place(name, x, y) {
    const at = this.#m.take(16);
    try {
      this.#mien.done(name, this.#scene, this.#view, x, y, at);
      return [this.#m.view.getFloat64(at, true), this.#m.view.getFloat64(at + 8, true)];
    } finally { this.#m.exports.free(at); }
  }

  /** Gives back the face's memory; nothing is asked of it afterwards. */
  free() {
    const { exports } = this.#m;
    exports.mien_scene_free(this.#scene), exports.mien_renderer_free(this.#renderer), exports.mien_pose_free(this.#pose), exports.mien_face_free(this.#face);
    for (const at of [this.#view, this.#pixels, this.#data]) exports.free(at);
    this.#scene = this.#renderer = this.#pose = this.#face = this.#data = this.#room = 0;
  }

  #say(name, text, ...more) { this.#m.withText(text, (t, n) => this.#mien.done(name, this.#pose, t, n, ...more)); }
  #take(pose) {
    this.#mien.done('mien_pose_clear', this.#pose);
    this.#mien.done('mien_pose_time', this.#pose, pose.time ?? NaN);
    for (const clip of pose.clips ?? []) this.#say('mien_pose_clip', clip);
    if (pose.lookAt) this.#mien.done('mien_pose_look_at', this.#pose, ...pose.lookAt);
    for (const [set, given] of [['emotion', pose.emotions], ['muscle', pose.muscles], ['arkit', pose.arkit], ['facs', pose.facs], ['vrm', pose.vrm], ['viseme', pose.visemes]])
      for (const [name, weight] of Object.entries(given ?? {}))
        this.#m.withText(set, (s, k) => this.#m.withText(`${name}=${weight}`, (t, n) => this.#mien.done('mien_pose_express', this.#pose, s, k, t, n, 0)));
    for (const [name, value] of Object.entries(pose.set ?? {})) this.#say('mien_pose_set', `${name}=${[value].flat().join(',')}`);
  }
  #look(width, height, pose) {
    this.#m.exports.mien_view_init(this.#view, VIEW.bytes);
    this.#m.exports.mien_pixels_init(this.#pixels, PIXELS.bytes);
    const v = this.#m.view;
    v.setInt32(this.#view + VIEW.width, width, true);
    v.setInt32(this.#view + VIEW.height, height, true);
    v.setInt32(this.#view + VIEW.fit, pose.fit === 'slice' ? 1 : 0, true);
    v.setInt32(this.#view + VIEW.blend, pose.blend === 'srgb' ? 1 : 0, true);
    if (!pose.background) return;
    v.setInt32(this.#view + VIEW.hasBackground, 1, true);
    const at = this.#view + VIEW.background;
    if (typeof pose.background === 'string') this.#m.withText(pose.background, (t, n) => this.#mien.done('mien_color_from_text', t, n, at));
    else pose.background.forEach((c, i) => v.setFloat64(at + 8 * i, c, true));
  }
  #poseFor(width, height, pose) {
    this.#take(pose);
    this.#look(width, height, pose);
    this.#see();
  }
  #into(data, width, rows) {
    const v = this.#m.view;
    v.setUint32(this.#pixels + PIXELS.data, data, true);
    v.setUint32(this.#pixels + PIXELS.size, width * rows * 4, true);
    v.setUint32(this.#pixels + PIXELS.stride, width * 4, true);
  }
  #see() {
    const scene = this.#mien.made('mien_scene_new', this.#pose);
    this.#m.exports.mien_scene_free(this.#scene);
    this.#scene = scene;
  }
  #roomFor(bytes) {
    if (!(bytes > 0 && bytes <= 0x7fff0000)) throw new MienError('', `a picture of ${bytes} bytes cannot be drawn here`);
    if (bytes <= this.#room) return;
    const data = this.#m.take(bytes);
    this.#m.exports.free(this.#data);
    this.#data = data, this.#room = bytes;
  }
}
