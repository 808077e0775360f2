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
export const SETS = { emotions: 'emotion', muscles: 'muscle', arkit: 'arkit', facs: 'facs', vrm: 'vrm', visemes: 'viseme', azure: 'azure' };
export const isTable = (value) => value !== null && typeof value === 'object' && !Array.isArray(value);
const isWeights = { is: isTable, like: 'weights by name, such as { joy: 0.8 }' };
const oneOf = (...names) => ({ is: (value) => names.includes(value), like: names.map((name) => `'${name}'`).join(' or ') });
/** What the keys of a pose hold, beside null and undefined, which say nothing. */
const SHAPES = {
  time: { is: Number.isFinite, like: 'seconds' },
  set: { is: isTable, like: "values by name, such as { 'gaze.x': 0.1 }" },
  ...Object.fromEntries(Object.keys(SETS).map((key) => [key, isWeights])),
  seed: { is: (value) => typeof value === 'string' || Number.isFinite(value), like: 'a word' },
  liveliness: { is: Number.isFinite, like: 'a number, 0 to 2' },
  gestures: { is: Number.isFinite, like: 'a number, 0 to 2' },
  clips: { is: Array.isArray, like: "a list, such as ['idle']" },
  motions: { is: Array.isArray, like: 'a list of motions, such as [mien.motion(text)]' },
  frame: { is: (value) => typeof value === 'string' || typeof value === 'object', like: "shapes by name, such as { jawOpen: 0.5 }, or a result of MediaPipe" },
  steady: { is: (value) => isTable(value) && ['at', 'cutoff', 'beta'].every((key) => Number.isFinite(value[key] ?? (key === 'at' ? NaN : 0))), like: "a frame's moment, such as { at: 1.25 }" },
  lookAt: { is: (value) => value.length === 3 && [...value].every(Number.isFinite), like: '3 numbers, such as [0, 0, 9]' },
  blend: oneOf('linear', 'srgb'),
  fit: oneOf('meet', 'slice'),
  legible: { is: Number.isFinite, like: 'a number, 0 to 16' },
  background: { is: (value) => typeof value === 'string' || value.length === 4, like: "'#rrggbb', '#rrggbbaa' or [r, g, b, a]" },
};

export const POSE_KEYS = Object.keys(SHAPES);

export const said = (value) => String(typeof value === 'string' ? JSON.stringify(value) : Array.isArray(value) ? `a list of ${value.length}` : typeof value === 'object' ? 'an object' : value).slice(0, 60);

/** A pose is refused if a key of it holds something of another kind. */
export function refuseOtherKinds(pose) {
  for (const [key, { is, like }] of Object.entries(SHAPES))
    if (pose[key] != null && !is(pose[key])) throw new MienError(`pose.${key}`, `expected ${like}, got ${said(pose[key])}`);
}
