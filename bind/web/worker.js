// Draws faces away from the page's own thread. One worker serves all <mien-face> elements of a page.
//
// Messages in: { id, source?, width, height, pose, deadline } asks for a picture. `source` is { code }, { seed } or { text, name }, with
// a `style` or without; where it is missing the face is that of before. { id, free }: the element is no more.
// Messages out: { ready } once; then { pixels, width, height, ms }, { where, what } for what mien refused, or { late } where a
// drawing took longer than its deadline [ms], in the order in which was asked.

import { MienError, load } from './mien.js';

const MOST_FACES = 256;  // that stay read: a fifth of a megabyte each; others are read again, which takes some milliseconds

const mien = load();
mien.then(() => postMessage({ ready: true }), () => {});  // who asks is told
const known = new Map();  // by element: { source, face }, the one that was drawn last at the end

function read(loaded, { code, seed, text, name, style }) {
  if (text !== undefined) return loaded.face(style === undefined ? text : styled(text, name, style), name);
  if (code === undefined && seed === '') throw new MienError('seed', 'expected a word, got none');
  return loaded.person(code ?? loaded.code(seed), { style });
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
    of.face = face, of.source = source;
  }
  of.face ??= read(loaded, of.source);
  const held = [...known.values()].filter(({ face }) => face);
  for (const one of held.slice(0, -MOST_FACES)) one.face.free(), one.face = null;
  return of.face;
}

onmessage = async ({ data: { id, free, source, width, height, pose, deadline } }) => {
  try {
    const loaded = await mien, begin = performance.now();
    if (free) return known.get(id)?.face?.free(), void known.delete(id);
    if (!(deadline > 0)) throw new MienError('deadline', 'expected milliseconds above 0');
    const pixels = faceOf(loaded, id, source).draw(width, height, pose, { deadline }).slice();
    postMessage({ pixels, width, height, ms: performance.now() - begin }, [pixels.buffer]);
  } catch (error) {
    if (error.what === 'cancelled') postMessage({ late: true });
    else if (!free) postMessage({ where: error.where ?? '', what: error.what ?? String(error) });
  }
};
