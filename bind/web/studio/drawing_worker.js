// Draws for the studio away from the page's own thread.
//
// The first message is { wasm }: mien.wasm's bytes, or nothing where it lies beside mien.js. Then { number, what, ...details };
// `what` is a name of `answers` below. Messages out: { number, value }, { number, error: { where, what } } for what mien
// refused, and { number, share } on the way.

import { load } from '../mien.js';
import { png } from '../png.js';
import { beginning, personOf, recipeOf, recipeText } from './person.js';

let loading;
let face = null, seen = { width: 1, height: 1 };
let small = { text: null, face: null };  // the face of the last small picture, for the next pose of it

const isPoint = ({ name, count }) => count === 2 && /^[^/]+\/(center|inner|upper|outer|lower|((points|spine)\/\d+)|((loops|patch)\/\d+\/\d+))$/.test(name);

/** What the page needs to know of a face. Points and widths are not among it: they are hundreds. `shaped`: the features that
 *  have points. */
function told(of, text) {
  const all = of.names, names = all.filter(({ name, isControl }) => isControl || name.startsWith('palette/'));
  const shaped = [...new Set(all.filter(isPoint).map(({ name }) => name.slice(0, name.indexOf('/'))))];
  return { title: of.title, credit: of.credit, clips: of.clips, clipLengths: of.clipLengths, canvas: of.canvas, names, shaped, text };
}

const answers = {
  parts: (mien) => mien.parts(),
  version: (mien) => mien.version,
  code: (mien, { word }) => mien.code(word),
  crowd: (mien, { word, count }) => mien.crowd(word, count),
  near: (mien, { code, by, word }) => mien.near(code, by, word),
  recipe: (mien, { code }) => JSON.parse(mien.recipe(code)),
  /** The person of a face file's text, if it is a recipe without parts of its own; null: it is another face. */
  person(mien, { text, name }) {
    mien.face(text, name).free();  // it is a face at all
    const read = JSON.parse(text);
    return read.format_version === 2 ? personOf(mien, read) : null;
  },

  /** Opens a person or the text of a face file; the face before stays if it is refused. */
  open(mien, { person, text, name }) {
    const { code = null, recipe = null } = person ? recipeOf(mien, person) : {}, base = person ? recipeOf(mien, beginning(person)).recipe : null, said = recipe ? recipeText(recipe) : text;
    const read = mien.face(said, name);
    face?.free();
    face = read;
    return { ...told(read, said), code, recipe, base };
  },
  /** The pixels of the open face. The page puts them on its canvas, so that this worker can be ended at any time. */
  draw(_mien, { width, height, pose }) {
    seen = { width, height };
    const begin = performance.now(), pixels = face.draw(width, height, pose);
    return { pixels, ms: performance.now() - begin };
  },
  /** The feature that is seen at a place, in shares of the picture drawn last; null: there is nothing. */
  feature: (_mien, { x, y }) => face.featureAt(x * seen.width, y * seen.height),
  /** A feature, or the one that is drawn at a place, in shares of the picture, and its points in a pose: { feature, points: [{ name, at,
   *  partner }] }; `partner` is the point of the other side, { name, at }, or null. */
  points(_mien, { x, y, pose, feature = face.featureAt(x * seen.width, y * seen.height) }) {
    if (!feature) return { feature, points: [] };
    const vector = face.vector(pose), isOne = (one) => isPoint(one) && one.name.startsWith(`${feature}/`);
    const { names } = face, told = (one) => (one ? { name: one.name, at: vector.slice(one.begin, one.begin + 2) } : null);
    const across = (name) => names.find((one) => one.name !== name && one.name === name.replace(/\.(left|right)(?=\/)/, (_, side) => (side === 'left' ? '.right' : '.left')));
    return { feature, points: names.filter(isOne).map((one) => ({ ...told(one), partner: told(across(one.name)) })) };
  },
  /** A small picture of any face. */
  small(mien, { text, name, width, height, pose }) {
    if (text !== small.text) {
      const read = mien.face(text, name);
      small.face?.free();
      small = { text, face: read };
    }
    return small.face.draw(width, height, pose);
  },
  /** A face file's text with what a pose sets of it: { text, left }. */
  textWith: (mien, { text, set, name }) => mien.textWith(text, set, name),
  /** The same of a recipe's face in full. */
  inFullWith: (mien, { text, set, name }) => mien.textWith(mien.inFull(text, name), set, name),
  /** An SVG file, and what it cannot say: { text, simplified }. */
  svg(mien, { text, name, width, height, pose }) {
    const drawn = mien.face(text, name);
    try { return drawn.svg(width, height, pose); } finally { drawn.free(); }
  },
  /** A PNG of any size, in strips. */
  async png(mien, { text, name, width, height, pose }, tell) {
    const drawn = mien.face(text, name);
    try { return await png(width, height, drawn.strips(width, height, pose), tell); } finally { drawn.free(); }
  },
};

/** What goes over to the page without a copy. */
function transferred(value) {
  const pixels = value?.pixels ?? value;
  return pixels instanceof Uint8ClampedArray ? [pixels.buffer] : [];
}

onmessage = async ({ data: { number, what, wasm, ...details } }) => {
  if (!loading) return void (loading = load(wasm));
  try {
    const value = await answers[what](await loading, details, (share) => postMessage({ number, share }));
    postMessage({ number, value }, transferred(value));
  } catch (error) {
    postMessage({ number, error: { where: error.where ?? '', what: error.what ?? String(error) } });
  }
};
