// A person as the text of an SVG file, in one call: on servers, in static pages, where no canvas is.
//
//   import { svg } from 'mien-face/svg';
//   const text = await svg('A66CB-AA5S0-14', { width: 72, height: 72, pose: { emotions: { joy: 0.8 } } });
//   const hers = await svg({ seed: 'ada' });
//
// mien.wasm is loaded once, with the first picture.

import { describe } from './describe.js';
import { MienError, load } from './mien.js';

const KEYS = ['width', 'height', 'style', 'neutral', 'pose', 'alt', 'idPrefix', 'tolerance', 'deadline'], SIDE = 128, TOLERANCE = 0.1;
const quoted = (text) => text.replaceAll('&', '&amp;').replaceAll('<', '&lt;').replaceAll('"', '&quot;');
let loading;
/** mien, loaded once. */
export const loaded = () => (loading ??= load().catch((error) => { loading = undefined; throw error; }));

export async function svg(who, how = {}) {
  const mien = await loaded();
  mien.known('svg', how, KEYS);
  if (typeof who !== 'string') mien.known('svg', who, ['seed']);
  if (who.seed === '') throw new MienError('seed', 'expected a word, got none');
  const whose = typeof who === 'string' ? who : mien.code(String(who.seed)), code = how.neutral ? mien.neutral(whose) : whose;
  const { width = SIDE, height = SIDE, style, pose = {}, idPrefix, tolerance = TOLERANCE, deadline } = how;
  const alt = how.alt ?? describe(mien.recipe(code), pose), face = mien.person(code, { style });
  try {
    const { text } = face.svg(width, height, pose, { tolerance, idPrefix, deadline });
    return text.replace('<svg ', alt === '' ? '<svg aria-hidden="true" ' : `<svg role="img" aria-label="${quoted(alt)}" `);
  } finally { face.free(); }
}
