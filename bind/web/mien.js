// mien in JavaScript: a face goes in, pixels come out. In browsers, workers and node, without dependencies.
//
//   import { load } from 'mien-face';
//   const mien = await load();                                  // mien.wasm, beside this file
//   const face = mien.person('A66CB-AA5S0-14');                 // or mien.face(textOfAFaceFile)
//   const pixels = face.draw(640, 360, { time: 1.25, emotions: { joy: 0.8 }, set: { 'gaze.x': 0.04 } });
//   context.putImageData(new ImageData(pixels, 640, 360), 0, 0);
//
// Pixels are red, green, blue, alpha in 8 bits, sRGB-encoded, not premultiplied: the bytes that mien draws on every
// machine without fused multiply-adds. What mien refuses is an Error whose `where` is the place and whose `what` is
// the sentence.

import { MienError, POSE_KEYS, SETS, isTable, refuseOtherKinds, said } from './pose_keys.js';
import { Memory, compiled, host } from './wasm_host.js';

export { MienError };

const VIEW = { bytes: 120, width: 4, height: 8, fit: 12, blend: 16, hasBackground: 24, background: 40, legible: 112 };
const PIXELS = { bytes: 20, data: 8, size: 12, stride: 16 };
const NAME = { bytes: 48, isControl: 4, isPose: 8, count: 12, begin: 16, name: 24, unit: 28, lo: 32, hi: 40 };
const CANVAS = { bytes: 56, yUp: 4, box: 8, mirrorX: 40, unit: 48 };
const MOST_DESKS = 8;
const MOST_MOTIONS = 8;
const NODE_FILES = 'node:fs/promises';  // under a name, so that bundlers for pages do not look for it

/** Whether this system runs mien: WebAssembly with 128-bit lanes. */
export function isSupported() {
  // A function that returns a vector: (module (func (result v128) i32.const 0 i8x16.splat))
  const probe = new Uint8Array([0, 97, 115, 109, 1, 0, 0, 0, 1, 5, 1, 96, 0, 1, 123, 3, 2, 1, 0, 10, 8, 1, 6, 0, 65, 0, 253, 15, 11]);
  return typeof WebAssembly === 'object' && WebAssembly.validate(probe);
}

/** What `load` loads, compiled: it can be posted to workers, which then need not compile it again. */
export async function compile(source = new URL('./mien.wasm', import.meta.url)) {
  if (!isSupported()) throw new MienError('', 'this system has no WebAssembly with 128-bit lanes (SIMD), which mien needs');
  const onDisk = source instanceof URL && source.protocol === 'file:';
  return compiled(onDisk ? await (await import(/* @vite-ignore */ /* webpackIgnore: true */ NODE_FILES)).readFile(source) : source);
}

/** Loads mien. `source`: bytes, a URL, a Response or a compiled module; by default mien.wasm beside this file. */
export async function load(source) {
  const module = await compile(source), imports = {};
  let memory;
  const answer = host(() => memory);
  for (const { module: from, name } of WebAssembly.Module.imports(module)) (imports[from] ??= {})[name] = answer(name);
  const instance = await WebAssembly.instantiate(module, imports).catch((error) => { throw new MienError('mien.wasm', `cannot be started: ${error.message}`); });
  memory = new Memory(instance.exports);
  instance.exports._initialize();
  return new Mien(memory);
}

export class Mien {
  #m; #slot; #desks = new Map(); #motions = new Map();
  constructor(memory) { this.#m = memory, this.#slot = memory.take(16); }

  /** Refuses keys that are not among the names, in a sentence with the nearest; `what` they are. */
  known(where, given, names, what = 'key') {
    if (!isTable(given)) throw new MienError(where, `expected an object, got ${said(given)}`);
    for (const key of Object.keys(given)) {
      if (names.includes(key)) continue;
      const word = key.slice(0, 40);
      const [sentence] = this.#m.withText(what, (w, l) => this.#m.withText(word, (k, n) => this.#m.withText(names.join('\n'), (t, m) => this.texts('mien_unknown_name', w, l, k, n, t, m))));
      throw new MienError(`${where}.${word}`, sentence);
    }
  }

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
  /** The person of a code. `style`: one of parts().styles, such as 'ink', instead of her own. */
  person(code, how = {}) {
    this.known('person', how, ['style']);
    if (how.style !== undefined) return this.face(JSON.stringify({ ...JSON.parse(this.recipe(code)), style: how.style }), code);
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
  /** The code of the same person without an expression: no smile, no mood, lips closed. */
  neutral(code) { return this.#m.withText(code, (t, n) => this.texts('mien_code_neutral', t, n)[0]); }
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
  /** A take or a track of speech from the text of its file, whatever program wrote it. */
  motion(text, name = 'motion') {
    return new Motion(this, this.#m, this.#m.withText(text, (t, n) => this.#m.withText(name, (w, k) => this.made('mien_motion_read_text', t, n, w, k))));
  }
  /** The motion of a text that poses say again and again; those said last stay read. For this file. */
  motionSaid(text) {
    const known = this.#motions.get(text) ?? this.motion(text);
    this.#motions.delete(text), this.#motions.set(text, known);
    for (const [old, motion] of this.#motions) if (this.#motions.size > MOST_MOTIONS) motion.free(), this.#motions.delete(old);
    return known;
  }
  /** What recipes choose from: { families: [{ name, parts }], numbers: [{ name,
   *  lo, hi, rest }], styles }. "none" is first among the parts of families that a face may do without. */
  parts() {
    return {
      families: this.texts('mien_part_families').map((name) => ({ name, parts: this.#m.withText(name, (t, n) => this.texts('mien_part_names', t, n)) })),
      numbers: this.texts('mien_part_numbers').map((name) => ({ name, ...this.#range(name) })),
      styles: this.texts('mien_part_styles'),
    };
  }
  #range(name) {
    const at = this.#m.take(24);
    try {
      this.#m.withText(name, (t, n) => this.done('mien_part_number', t, n, at));
      const [lo, hi, rest] = [0, 8, 16].map((offset) => this.#m.view.getFloat64(at + offset, true));
      return { lo, hi, rest };
    } finally { this.#m.exports.free(at); }
  }

  /** Where a face draws. The desk of a first picture goes when another face draws; one that has drawn before keeps its desk until
   *  it is among those that drew least lately. So faces at rest hold no drawing memory, and some that move have rows to copy.
   *  For this file. */
  desk(face, again) {
    const desk = this.#desks.get(face) ?? new Desk(this, this.#m);
    desk.stays ||= again;
    this.#desks.delete(face), this.#desks.set(face, desk);
    for (const [one, { stays }] of this.#desks) if (one !== face && (!stays || this.#desks.size > MOST_DESKS)) this.leave(one);
    return desk;
  }
  deskOf(face) { return this.#desks.get(face); }
  leave(face) {
    this.#desks.get(face)?.free();
    this.#desks.delete(face);
  }

  /** Calls a function whose last argument is an error; throws what it says. For this file. */
  done(name, ...args) {
    const { exports } = this.#m, error = this.#slot + 12;
    this.#m.view.setUint32(error, 0, true);
    let status;
    try { status = exports[name](...args, error); } catch (ended) { throw Object.assign(new MienError(name, `mien ended: ${ended.message}`), { broken: true }); }
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

/** What a face draws with, megabytes: a face without it takes a fifth of one. */
class Desk {
  #m; #room = 0;
  stays = false; scene = 0; data = 0;
  constructor(mien, memory) {
    this.#m = memory;
    this.renderer = mien.made('mien_renderer_new');
  }
  show(scene) {
    this.#m.exports.mien_scene_free(this.scene);
    this.scene = scene;
  }
  roomFor(bytes) {
    if (bytes <= this.#room) return;
    const data = this.#m.take(bytes);
    this.#m.exports.free(this.data);
    this.data = data, this.#room = bytes;
  }
  free() {
    const { exports } = this.#m;
    exports.mien_scene_free(this.scene), exports.mien_renderer_free(this.renderer), exports.free(this.data);
  }
}

/** A take of an actor, or a track of speech: numbers by name over time. */
export class Motion {
  #mien; #m;
  /** For this file. */
  handle;
  constructor(mien, memory, handle) { this.#mien = mien, this.#m = memory, this.handle = handle; }
  /** [s] Until its last moment. */
  get length() { return this.#m.exports.mien_motion_length(this.handle); }
  /** The controls that it moves: 'arkit.jawOpen', 'viseme.aa', 'yaw'. */
  get channels() {
    const { exports } = this.#m;
    return Array.from({ length: exports.mien_motion_channel_count(this.handle) }, (_, i) => this.#m.text(exports.mien_motion_channel_name(this.handle, i)));
  }
  /** What was odd in its text, a sentence each. */
  get told() { return this.#mien.texts('mien_motion_told', this.handle); }
  /** The value of a channel at a moment [s]. */
  value(channel, time) { return this.#m.exports.mien_motion_value(this.handle, this.channels.indexOf(channel), time); }
  /** Gives back its memory; nothing is asked of it afterwards. */
  free() {
    this.#m.exports.mien_motion_free(this.handle);
    this.handle = 0;
  }
}

/** A face, its pose, and how it was seen last. */
export class Face {
  #mien; #m; #face; #pose; #view; #pixels; #drew = false; #seen = false; #steady = null;
  constructor(mien, memory, face) {
    this.#mien = mien, this.#m = memory, this.#face = face;
    this.#pose = mien.made('mien_pose_new', face);
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

  /** Draws; the pixels are yours.
   *    pose.time      seconds, at which clips run; none: no clip runs
   *    pose.set       { 'gaze.x': 0.1, 'palette/skin': '#ffd94a', 'brow.left/spine/1': [0.1, 0.2] }
   *    pose.emotions  { joy: 0.8, 'left.surprise': 0.3 }, and likewise muscles, arkit, facs, vrm, visemes, azure
   *    pose.clips     ['idle', 'feelings=0.5']
   *    pose.motions   [mien.motion(text)] or [text]: takes and speech, or { motion, weight, begin }, on top of clips, at
   *                   pose.time
   *    pose.frame     what a camera saw: { jawOpen: 0.4 }, a result of MediaPipe's FaceLandmarker, or its JSON
   *    pose.steady    { at }, the frame's moment in seconds: frames that come live, kept quiet; { at, cutoff: 1, beta: 2 } (docs/motion.md)
   *    pose.seed      a word instead of the face's own code, recipe or text, for blinks and glances by chance
   *    pose.liveliness  0 to 2: how far clips move the face; 1 (default) as they say, 0 not at all
   *    pose.gestures  0 to 2: how far the head nods and brows rise with the stresses of speech; 0: the mouth alone speaks
   *    pose.lookAt    [x, y, z]
   *    pose.blend     'linear' (default) or 'srgb'
   *    pose.fit       'meet' (default): all of the canvas; 'slice': all of the picture
   *    pose.legible   0 to 16: lines are at least so many pixels wide, for small pictures; 0 (default): as they are
   *    pose.background  '#rrggbb' or '#rrggbbaa', or [r, g, b, a] in linear light, 0 to 1; none: the face's
   *  Long drawings can be ended, wherever they are; draw then throws a MienError that says "cancelled":
   *    how.deadline   milliseconds from now, after which it ends
   *    how.progress   called about every 10 ms with the share done, 0 to 1; false ends it. What it throws, draw throws */
  draw(width, height, pose = {}, how = {}) {
    this.#mien.known('draw', how, ['deadline', 'progress']);
    const desk = this.#poseFor(width, height, pose), bytes = width * height * 4;
    desk.roomFor(bytes);
    this.#into(desk.data, width, height);
    this.#asking(how, (options) =>
      this.#mien.done('mien_render', desk.renderer, desk.scene, this.#view, this.#pixels, options));
    this.#drew = true;
    return new Uint8ClampedArray(this.#m.exports.memory.buffer, desk.data, bytes).slice();
  }

  /** What work(options) returns, which may be ended as draw may. */
  #asking({ deadline = Infinity, progress = undefined }, work) {
    const until = performance.now() + deadline;
    let thrown;
    this.#m.goesOn = (done) => {
      if (performance.now() > until) return false;
      try { return progress?.(done) !== false; } catch (error) { thrown = { error }; return false; }
    };
    try {
      return work(this.#m.exports.mien_asking_options());
    } catch (error) {
      throw thrown ? thrown.error : error;
    } finally { this.#m.goesOn = () => true; }
  }

  /** The same picture from the top in strips of so many rows, in little memory: { y, rows, pixels }. A strip's pixels
   *  stay valid until the next is asked for. */
  *strips(width, height, pose = {}, most = Math.max(1, Math.floor((1 << 22) / width))) {
    const { scene } = this.#poseFor(width, height, pose), { exports } = this.#m, pieces = this.#mien.made('mien_pieces_new', scene, this.#view, 0, 0);
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
   *  `idPrefix` begins all ids, so that several pictures can stand in one page; without one it is made of the picture, so
   *  that only equal pictures share ids. `deadline` and `progress` are as for draw. */
  svg(width, height, pose = {}, how = {}) {
    this.#mien.known('svg', how, ['tolerance', 'idPrefix', 'deadline', 'progress']);
    const { tolerance = 0.006, idPrefix } = how;
    const { scene } = this.#poseFor(width, height, pose);
    const write = (t, n) => this.#asking(how, (options) =>
      this.#mien.texts('mien_svg', scene, this.#view, tolerance, t, n, options));
    const [text, ...simplified] = idPrefix === undefined ? write(0, 0) : this.#m.withText(idPrefix, write);
    return { text, simplified };
  }

  /** Of the picture drawn last: the name of the feature that is seen at a pixel, or null. */
  featureAt(x, y) {
    const at = this.#m.take(16), scene = this.#scene();
    try {
      this.#mien.done('mien_face_from_pixel', scene, this.#view, x, y, at);
      const v = this.#m.view, px = v.getFloat64(at, true), py = v.getFloat64(at + 8, true);
      return this.#mien.texts('mien_scene_feature_at', scene, px, py)[0] ?? null;
    } finally { this.#m.exports.free(at); }
  }
  /** Of the picture drawn last: where a pixel is, in face units, and back. */
  fromPixel(x, y) { return this.#place('mien_face_from_pixel', x, y); }
  toPixel(x, y) { return this.#place('mien_pixel_from_face', x, y); }
  #place(name, x, y) {
    const at = this.#m.take(16);
    try {
      this.#mien.done(name, this.#scene(), this.#view, x, y, at);
      return [this.#m.view.getFloat64(at, true), this.#m.view.getFloat64(at + 8, true)];
    } finally { this.#m.exports.free(at); }
  }

  /** The face at a moment of a track of speech or of a take, [s], such as an audio's currentTime; `pose` as for draw. */
  speak(width, height, track, time, pose = {}) {
    return this.draw(width, height, { clips: this.clips.slice(0, 1), ...pose, time, motions: [track] });
  }
  /** The face as a camera saw an actor's: ARKit's shapes by name, or a result of MediaPipe's FaceLandmarker. */
  follow(width, height, frame, pose = {}) { return this.draw(width, height, { ...pose, frame }); }
  /** The names of what moves in a motion and not in this face. */
  unfollowed(motion) { return this.#mien.texts('mien_motion_unfollowed', motion.handle, this.#face); }

  /** Gives back the face's memory; nothing is asked of it afterwards. */
  free() {
    const { exports } = this.#m;
    this.#mien.leave(this);
    exports.mien_steadier_free(this.#steady?.handle ?? 0);
    this.#steady = null;
    exports.mien_pose_free(this.#pose), exports.mien_face_free(this.#face);
    for (const at of [this.#view, this.#pixels]) exports.free(at);
    this.#pose = this.#face = this.#view = this.#pixels = 0;
  }

  #say(name, text, ...more) { this.#m.withText(text, (t, n) => this.#mien.done(name, this.#pose, t, n, ...more)); }
  #take(pose) {
    this.#mien.known('pose', pose, POSE_KEYS, 'key of a pose');
    refuseOtherKinds(pose);
    this.#mien.done('mien_pose_clear', this.#pose);
    if (pose.time !== undefined && pose.time !== null) this.#mien.done('mien_pose_time', this.#pose, pose.time);
    for (const clip of pose.clips ?? []) this.#say('mien_pose_clip', clip);
    for (const one of pose.motions ?? []) {
      if (one.motion !== undefined) this.#mien.known('pose.motions', one, ['motion', 'weight', 'begin']);
      const { motion, weight = 1, begin = 0 } = one.motion === undefined ? { motion: one } : one;
      const of = typeof motion === 'string' ? this.#mien.motionSaid(motion) : motion;
      this.#mien.done('mien_pose_motion', this.#pose, of.handle, weight, begin);
    }
    if (pose.frame != null) this.#follow(typeof pose.frame === 'string' ? pose.frame : JSON.stringify(pose.frame), pose.steady);
    if (pose.seed != null) this.#say('mien_pose_seed', String(pose.seed));
    if (pose.gestures != null) this.#mien.done('mien_pose_gestures', this.#pose, pose.gestures);
    if (pose.liveliness != null) this.#mien.done('mien_pose_liveliness', this.#pose, pose.liveliness);
    if (pose.lookAt) this.#mien.done('mien_pose_look_at', this.#pose, ...pose.lookAt);
    for (const [key, set] of Object.entries(SETS))
      for (const [name, weight] of Object.entries(pose[key] ?? {}))
        this.#m.withText(set, (s, k) => this.#m.withText(`${name}=${weight}`, (t, n) => this.#mien.done('mien_pose_express', this.#pose, s, k, t, n, 0)));
    for (const [name, value] of Object.entries(pose.set ?? {})) this.#say('mien_pose_set', `${name}=${[value].flat().join(',')}`);
  }
  #follow(frame, steady) {
    if (steady == null) return this.#say('mien_pose_follow', frame);
    this.#mien.known('pose.steady', steady, ['at', 'cutoff', 'beta']);
    const { at, cutoff = 1, beta = 2 } = steady;
    if (this.#steady?.cutoff !== cutoff || this.#steady.beta !== beta) {
      const handle = this.#mien.made('mien_steadier_new', cutoff, beta);
      this.#m.exports.mien_steadier_free(this.#steady?.handle ?? 0);
      this.#steady = { handle, cutoff, beta };
    }
    this.#m.withText(frame, (t, n) => this.#mien.done('mien_pose_follow_steadily', this.#pose, this.#steady.handle, at, t, n));
  }
  #look(width, height, pose) {
    for (const [name, side] of Object.entries({ width, height })) if (!Number.isInteger(side)) throw new MienError(name, `expected whole pixels, got ${said(side)}`);
    if (!(width * height * 4 <= 0x7fff0000)) throw new MienError('', `a picture of ${width * height * 4} bytes cannot be drawn here`);
    this.#m.exports.mien_view_init(this.#view, VIEW.bytes);
    this.#m.exports.mien_pixels_init(this.#pixels, PIXELS.bytes);
    const v = this.#m.view;
    v.setInt32(this.#view + VIEW.width, width, true);
    v.setInt32(this.#view + VIEW.height, height, true);
    v.setInt32(this.#view + VIEW.fit, pose.fit === 'slice' ? 1 : 0, true);
    v.setInt32(this.#view + VIEW.blend, pose.blend === 'srgb' ? 1 : 0, true);
    v.setFloat64(this.#view + VIEW.legible, pose.legible ?? 0, true);
    if (!pose.background) return;
    v.setInt32(this.#view + VIEW.hasBackground, 1, true);
    const at = this.#view + VIEW.background;
    if (typeof pose.background === 'string') this.#m.withText(pose.background, (t, n) => this.#mien.done('mien_color_from_text', t, n, at));
    else pose.background.forEach((c, i) => v.setFloat64(at + 8 * i, c, true));
  }
  #poseFor(width, height, pose) {
    this.#take(pose);
    this.#look(width, height, pose);
    return this.#see();
  }
  #into(data, width, rows) {
    const v = this.#m.view;
    v.setUint32(this.#pixels + PIXELS.data, data, true);
    v.setUint32(this.#pixels + PIXELS.size, width * rows * 4, true);
    v.setUint32(this.#pixels + PIXELS.stride, width * 4, true);
  }
  #see() {
    const scene = this.#mien.made('mien_scene_new', this.#pose);
    const desk = this.#mien.desk(this, this.#drew);
    desk.show(scene);
    this.#seen = true;
    return desk;
  }
  /** Of the picture drawn last; it is made once more where the desk was left. */
  #scene() { return this.#seen ? (this.#mien.deskOf(this) ?? this.#see()).scene : 0; }
}
