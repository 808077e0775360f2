// Draws faces away from the page's own thread; painter.js asks it.
//
// Messages in: { begin, module } first: what another worker has compiled, or nothing. { id, source?, width, height, pose,
// deadline } asks for a picture. `source` is { code } or { seed }, `neutral` or not, or { text, name }, with a `style` or without;
// where it is missing the face is that of before. { id, free }: the element is no more.
// Messages out: { ready, module } once; then, in the order in which was asked, { pixels, width, height, ms, seen?, told, length? },
// where `seen` tells what the face looks like, if that is new, `told` what is odd in new tracks, and `length` how long the last of
// the pose's tracks is [s]; { where, what } for what mien refused, `broken` with it if the
// worker is of no more use; or { late } where a drawing took longer than its deadline [ms].

import { describe } from './describe.js';
import { MienError, compile, load } from './mien.js';

const MOST_FACES = 256;  // that stay read: a fifth of a megabyte each; others are read again, which takes some milliseconds

const MOST_TRACKS = 64;  // of which is remembered that what is odd in them was told

let mien;
const heard = new Map();  // texts of tracks, and their lengths [s]
const known = new Map();  // by element: { source, face, recipe, seen }, the one that was drawn last at the end

async function begin(given) {
  const module = await compile(given), loaded = await load(module);
  postMessage({ ready: true, module });
  return loaded;
}

function read(loaded, source) {
  const { text, name, style } = source;
  if (text !== undefined) return loaded.face(style === undefined ? text : styled(text, name, style), name);
  return loaded.person(codeOf(loaded, source), { style });
}

function codeOf(loaded, { code, seed, neutral }) {
  if (code === undefined && seed === '') throw new MienError('seed', 'expected a word, got none');
  const whose = code ?? loaded.code(seed);
  return neutral ? loaded.neutral(whose) : whose;
}

/** What is said of the face, if it is not what was said before. */
function news(loaded, of, { emotions }) {
  of.recipe ??= JSON.parse(of.source.text ?? loaded.recipe(codeOf(loaded, of.source)));
  const now = describe(of.recipe, { emotions });
  if (now === of.seen) return {};
  of.seen = now;
  return { seen: now };
}

/** What is odd in tracks that are met for the first time, such as a sound that is in no table, and how long the last one is. */
function tracks(loaded, { motions = [] }) {
  const texts = motions.map(({ motion }) => motion).filter((text) => typeof text === 'string'), told = [];
  if (heard.size > MOST_TRACKS) heard.clear();
  for (const text of texts) {
    if (heard.has(text)) continue;
    const said = loaded.motionSaid(text);
    heard.set(text, said.length), told.push(...said.told);
  }
  return { told, length: heard.get(texts.at(-1)) };
}

/** A recipe's text with another style. */
function styled(text, name, style) {
  let recipe;
  try { recipe = JSON.parse(text); } catch { return text; }  // mien says what is wrong with it
  if (recipe?.format_version !== 2) throw new MienError(name, 'has no style: only recipes have, faces that are made of parts');
  return JSON.stringify({ ...recipe, style });
}

/** The element's face: of a new source if there is one, and if that is no face, still the old one the next time. */
function faceOf(loaded, id, source) {
  const of = known.get(id) ?? { source };
  known.delete(id), known.set(id, of);
  if (source && source !== of.source) {
    const face = read(loaded, source);
    of.face?.free();
    of.face = face, of.source = source, of.recipe = of.seen = undefined;
  }
  of.face ??= read(loaded, of.source);
  const held = [...known.values()].filter(({ face }) => face);
  for (const one of held.slice(0, -MOST_FACES)) one.face.free(), one.face = null;
  return of;
}

onmessage = async ({ data: { begin: begins, module, id, free, source, width, height, pose, deadline } }) => {
  if (begins) return void (mien = begin(module)).catch(() => {});  // who asks is told
  let loaded;
  try {
    loaded = await mien;
    const began = performance.now();
    if (free) return known.get(id)?.face?.free(), void known.delete(id);
    if (!(deadline > 0)) throw new MienError('deadline', 'expected milliseconds above 0');
    const of = faceOf(loaded, id, source), pixels = of.face.draw(width, height, pose, { deadline });
    postMessage({ pixels, width, height, ms: performance.now() - began, ...news(loaded, of, pose), ...tracks(loaded, pose) }, [pixels.buffer]);
  } catch (error) {
    if (error.what === 'cancelled') postMessage({ late: true });
    else if (!free) postMessage({ where: error.where ?? '', what: error.what ?? String(error), broken: error.broken || !loaded });
  }
};
