// How long clips are, and times as people read them.

export const FRAMES = 30;  // a second: those that `mien animate` draws, too
const ENDLESS = 12;        // [s] of a clip that has no end, or whose curves nobody here knows

/** A time that all languages of Export can say. */
export const rounded = (time) => Math.round(1000 * time) / 1000;

/** The frame so many frames on. */
export const framesOn = (time, count) => rounded((Math.round(time * FRAMES) + count) / FRAMES);

/** [s] After which a curve has shown all it has; NaN: it goes on and on. */
function curveLength({ keys, period, jitter = 0 }) {
  if (!keys || jitter > 0) return NaN;
  return period ?? keys.at(-1)?.[0] ?? 0;
}

/** [s] After which a clip has shown all it has. `text`: the face's file; a recipe's clips are those of its edition. */
export function clipLength(text, clip) {
  const said = text.includes('"clips"') ? JSON.parse(text).clips?.[clip] : null;
  const curves = Object.values(said?.tracks ?? said ?? {}).filter((one) => one && typeof one === 'object');
  const length = Math.max(...curves.map(curveLength));
  return length > 0 && Number.isFinite(length) ? rounded(length) : ENDLESS;
}
