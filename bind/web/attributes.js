// What <mien-face> takes: its attributes, how their texts are read, and what a property writes into one. The types, the page
// of custom-elements.json and those of frameworks are made of this table (typed.mjs).

/** By attribute: `is`, the type of its property, and `says`, what it is. N: the names that the face knows. */
export const ATTRIBUTES = {
  code: { is: 'string', says: "a person's code" },
  seed: { is: 'string | number', says: 'or a word: the same word is the same person' },
  src: { is: 'string', says: "or a face file's address" },
  'face-style': { is: 'Style', says: "a person's paint, such as \"ink\"; `style` is CSS's, here as everywhere" },
  neutral: { is: 'boolean', says: 'the person without the smile and the mood that people rest in' },
  width: { is: 'number | string', says: "in CSS pixels (320); the picture has the display's own pixels" },
  height: { is: 'number | string', says: 'in CSS pixels (320)' },
  emotion: { is: "string | Weights<N['emotions']>", says: '"joy=0.8, left.surprise=0.3"' },
  muscle: { is: "string | Weights<N['muscles']>", says: '"jaw=0.3, left.zygomaticus=1"' },
  viseme: { is: "string | Weights<N['visemes']>", says: '"aa=0.7": a mouth\'s shape' },
  set: { is: "string | Values<N['set']>", says: '"gaze.x=0.04; palette/skin=#ffd94a"' },
  blink: { is: 'number | string', says: '0 to 1; without a number 1' },
  'look-at': { is: 'string | [number, number, number]', says: '"0.5, 0.3, 9": a point' },
  clip: { is: 'string | string[]', says: '"idle" (several: "idle, feelings=0.5")' },
  playing: { is: 'boolean', says: 'clips run; without it the face is at rest, or at `time` seconds' },
  pausable: { is: 'boolean', says: 'a click, Enter or the space bar lets its clips rest and run: it is a button then, which can be focused' },
  time: { is: 'number | string', says: 'seconds, at which clips and speech stand' },
  liveliness: { is: 'number | string', says: '0 to 2: how far clips move the face (1)' },
  speech: { is: 'string', says: 'the address of a track of speech or of a take: the face says it' },
  sound: { is: 'string', says: 'the id of the <audio> or <video> whose moment `speech` follows; none: it stands at `time`, or begins when it is set, as the face plays' },
  steady: { is: 'string | [number, number] | true', says: 'frames of follow() do not tremble; "1, 2": the filter\'s cutoff [Hz] and beta' },
  blend: { is: "'linear' | 'srgb'", says: '"linear" (default) or "srgb"' },
  fit: { is: "'meet' | 'slice'", says: '"meet" (default): all of the canvas; "slice": all of the picture' },
  legible: { is: 'number | string', says: '0 to 16: lines are at least so many pixels wide, in small pictures' },
  background: { is: 'string', says: '"#rrggbb", "#rrggbbaa"; none: the face\'s own' },
  alt: { is: 'string', says: 'what a screen reader says; none: what the face looks like; "": nothing, it decorates' },
  deadline: { is: 'number | string', says: 'the most milliseconds that a picture may take (10000)' },
};
export const NAMES = Object.keys(ATTRIBUTES);
/** Those that say who is drawn. */
export const SOURCES = ['src', 'code', 'seed', 'face-style', 'neutral'];

/** 'look-at' as 'lookAt'. */
export const propertyOf = (attribute) => attribute.replace(/-(.)/g, (_, letter) => letter.toUpperCase());

/** "a=1, b=2" as { a: '1', b: '2' }. */
function pairs(text, separator) {
  const found = {};
  for (const part of (text ?? '').split(separator)) {
    const [name, value] = part.split('=').map((word) => word.trim());
    if (name) found[name] = value ?? '1';
  }
  return found;
}

export const words = (text) => (text ?? '').split(',').map((word) => word.trim()).filter(Boolean);

/** The pose that attributes say on top of another one: `said(name)` is an attribute's text, or null. Clips and speech, which a page
 *  runs, are not in it but for `time`. */
export function poseOf(said, extra = {}) {
  const pose = { ...extra };
  for (const name of ['blend', 'background', 'fit']) if (said(name) !== null) pose[name] = said(name);
  for (const name of ['legible', 'liveliness', 'time']) if (said(name) !== null) pose[name] = Number(said(name) || NaN);
  if (said('look-at') !== null) pose.lookAt = said('look-at').split(',').map((one) => (one.trim() ? Number(one) : NaN));
  const blink = said('blink') === null ? {} : { blink: said('blink') || '1' };
  for (const [key, more] of [['emotions', pairs(said('emotion'), ',')], ['muscles', pairs(said('muscle'), ',')], ['visemes', pairs(said('viseme'), ',')], ['set', { ...pairs(said('set'), ';'), ...blink }]])
    if (Object.keys(more).length) pose[key] = { ...pose[key], ...more };
  const clips = words(said('clip'));
  if (clips.length) pose.clips = [...(pose.clips ?? []), ...clips];
  return pose;
}

/** A property's value as its attribute writes it. */
function written(value, separator) {
  if (Array.isArray(value)) return value.join(', ');
  if (typeof value !== 'object') return String(value);
  return Object.entries(value).map(([name, one]) => `${name}=${[one].flat().join(',')}`).join(separator);
}

/** Gives a class a property for each attribute: its text, or null where there is none, and null takes it away. */
export function defineProperties(prototype) {
  for (const name of NAMES) {
    Object.defineProperty(prototype, propertyOf(name), {
      configurable: true, enumerable: true,
      get() { return ATTRIBUTES[name].is === 'boolean' ? this.hasAttribute(name) : this.getAttribute(name); },
      set(value) {
        if (value == null || value === false) this.removeAttribute(name);
        else this.setAttribute(name, value === true ? '' : written(value, name === 'set' ? '; ' : ', '));
      },
    });
  }
}

/** How many letters must change to make one word of the other. */
function steps(one, other) {
  let row = Array.from({ length: other.length + 1 }, (_, i) => i);
  for (let i = 0; i < one.length; ++i) {
    const next = [i + 1];
    for (let j = 0; j < other.length; ++j) next.push(Math.min(row[j] + (one[i] === other[j] ? 0 : 1), row[j + 1] + 1, next[j] + 1));
    row = next;
  }
  return row.at(-1);
}

// Every element has these, and some are a letter away from one of ours.
const EVERYWHERE = ['title', 'style', 'class', 'slot', 'part', 'lang', 'dir', 'is', 'id', 'hidden', 'role', 'name', 'key', 'ref', 'inert', 'nonce', 'size'];

/** Which of ours an attribute was meant to be: one letter is wrong, or two of a long word. null: it is somebody else's. */
export function meant(name) {
  if (NAMES.includes(name) || EVERYWHERE.includes(name) || /^(data-|aria-|on|_|v-|x-|ng-|[@:*#.([])/.test(name)) return null;
  return NAMES.find((ours) => steps(name, ours) <= (ours.length < 6 ? 1 : 2)) ?? null;
}
