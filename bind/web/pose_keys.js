// What a pose of mien.js may say, so that nothing is passed over in silence.

/** What mien refused: `where` ("toon.face.json:12:7: /features/2") and `what` ("expected 2 numbers, got 3"). */
export class MienError extends Error {
  constructor(where, what) {
    super(where ? `${where}: ${what}` : what);
    this.name = 'MienError';
    this.where = where;
    this.what = what;
  }
}

/** What a pose says of each set of expressions, and the set's name. */
export const SETS = { emotions: 'emotion', muscles: 'muscle', arkit: 'arkit', facs: 'facs', vrm: 'vrm', visemes: 'viseme' };
const isTable = (value) => value !== null && typeof value === 'object' && !Array.isArray(value);
const isWeights = { is: isTable, like: 'weights by name, such as { joy: 0.8 }' };
const oneOf = (...names) => ({ is: (value) => names.includes(value), like: names.map((name) => `'${name}'`).join(' or ') });
/** What the keys of a pose hold, beside null and undefined, which say nothing. */
const SHAPES = {
  time: { is: Number.isFinite, like: 'seconds' },
  set: { is: isTable, like: "values by name, such as { 'gaze.x': 0.1 }" },
  ...Object.fromEntries(Object.keys(SETS).map((key) => [key, isWeights])),
  clips: { is: Array.isArray, like: "a list, such as ['idle']" },
  lookAt: { is: (value) => value.length === 3 && [...value].every(Number.isFinite), like: '3 numbers, such as [0, 0, 9]' },
  blend: oneOf('linear', 'srgb'),
  fit: oneOf('meet', 'slice'),
  background: { is: (value) => typeof value === 'string' || value.length === 4, like: "'#rrggbb', '#rrggbbaa' or [r, g, b, a]" },
};

export const said = (value) => String(typeof value === 'string' ? JSON.stringify(value) : Array.isArray(value) ? `a list of ${value.length}` : typeof value === 'object' ? 'an object' : value).slice(0, 60);

/** How many signs are to be changed, put in or left out until one word is the other. */
function apart(one, other) {
  let row = Array.from({ length: other.length + 1 }, (_, i) => i);
  for (let i = 1; i <= one.length; ++i) {
    const next = [i];
    for (let k = 1; k <= other.length; ++k) next[k] = Math.min(row[k] + 1, next[k - 1] + 1, row[k - 1] + (one[i - 1] !== other[k - 1]));
    row = next;
  }
  return row.at(-1);
}

/** A misspelt key is not passed over in silence. */
export function refuseUnknown(where, given, known) {
  if (!isTable(given)) throw new MienError(where, `expected an object, got ${said(given)}`);
  for (const key of Object.keys(given)) {
    if (known.includes(key)) continue;
    const word = key.slice(0, 40), [near] = known.map((name) => ({ name, by: apart(word.toLowerCase(), name.toLowerCase()) })).sort((a, b) => a.by - b.by);
    const close = near.by <= Math.max(1, word.length / 3);
    throw new MienError(`${where}.${word}`, `there is no such key; ${close ? `did you mean "${near.name}"?` : `known are ${known.join(', ')}`}`);
  }
}

/** A pose is refused if a key of it is misspelt or holds something of another kind. */
export function refuseUnlikePose(pose) {
  refuseUnknown('pose', pose, Object.keys(SHAPES));
  for (const [key, { is, like }] of Object.entries(SHAPES))
    if (pose[key] != null && !is(pose[key])) throw new MienError(`pose.${key}`, `expected ${like}, got ${said(pose[key])}`);
}
