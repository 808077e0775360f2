// How much of a clip the time line shows, and times as people read them.

export const FRAMES = 30;  // a second: those that `mien animate` draws, too
const ENDLESS = 12;        // [s] shown of a clip that goes on and on

/** A time that all languages of Export can say. */
export const rounded = (time) => Math.round(1000 * time) / 1000;

/** The frame so many frames on. */
export const framesOn = (time, count) => rounded((Math.round(time * FRAMES) + count) / FRAMES);

/** [s] What is shown of a clip of a length; of none, too. */
export const shownOf = (length = Infinity) => (length > 0 && Number.isFinite(length) ? rounded(length) : ENDLESS);
