// Which <mien-face> is drawn next, and by which worker. A worker draws one picture at a time, and its next is chosen when it is
// done: what is asked for meanwhile waits here, where each face waits at most once, so nothing stale is ever drawn.
//
// Three kinds of faces wait: those without a picture (`first`), those that the page has changed (`asked`), and those whose
// clips play (`playing`). They take turns. A face that talks, which is changed again and again, or whose track runs, so gets
// every second turn of its worker, however many wait. While faces lack pictures, those that play have few turns.
//
// A page has as many workers as it has cores, four at most, and starts another only when all are at work. A face stays
// with the worker that has read it, unless far more wait there than for another. Clips share the time, not the turns: a face of
// a hundred braids, which takes forty times as long as others, is charged for four of theirs. First pictures and such faces
// keep away from the worker of a face that talks, where there is another one.

import { Painter, charge } from './painter.js';

let most = Math.max(1, Math.min(4, globalThis.navigator?.hardwareConcurrency ?? 1));
const TALKS = 500;  // [ms] A face that was asked for twice within this time talks
const SEVERAL = 8;  // Faces of another painter are read again, which takes as long as a picture, for so many
const SLOW = 30;  // [ms] A face that takes longer than this is not drawn beside one that talks

const lanes = { first: new Set(), asked: new Set(), playing: new Set() };
const painters = [], painterOf = new WeakMap(), askedAt = new WeakMap(), turns = new WeakMap();
let newest = null;  // of those asked
let talker = null, woken = false;

/** The first of a lane that the painter may draw. */
function oldest(lane, painter) {
  for (const face of lane) if (mayDraw(painter, face)) return face;
}
/** Who has read the face. */
function reader(face) {
  const painter = painterOf.get(face);
  return painters.includes(painter) ? painter : undefined;
}
const mayDraw = (painter, face) => (reader(face) ?? painter) === painter;
const newestAsked = (painter) => (lanes.asked.has(newest) && mayDraw(painter, newest) ? newest : oldest(lanes.asked, painter));
const oldestAsked = (painter) => oldest(lanes.asked, painter);
const TURNS = [newestAsked, nearest, oldestAsked, nearest, newestAsked, nearest, oldestAsked, leastDrawn];

/** Of those that play: the one that has had the least time. */
function leastDrawn(painter) {
  const quiet = quietPainter(), waiting = new Map(painters.map((one) => [one, []]));
  for (const face of lanes.playing) {
    const slow = quiet && face.cost > SLOW, own = reader(face) ?? painter;
    if (slow && own === quiet) painter !== quiet && waiting.get(painter).push(face);
    else waiting.get(own).push(face);
  }
  const own = waiting.get(painter);
  // A painter may have read most of a crowd while the other had a face that talks: it gives of them where twice as many wait.
  const [most] = [...waiting.values()].sort((one, other) => other.length - one.length);
  const found = leastOf(painter !== quiet && most.length > 2 * own.length + SEVERAL ? most : own);
  if (found) painter.clock = Math.max(painter.clock, found.spent);
  return found;
}
const leastOf = (faces) => faces.reduce((least, face) => (face.spent < least?.spent ? face : least), faces[0]);

/** Of those without a picture: the first in view, before those where something else stands, else the one that is least far from
 *  the view. */
function nearest(painter) {
  const quiet = painter === quietPainter();
  let found, standing, least = Infinity;
  for (const face of lanes.first) {
    if (quiet ? reader(face) !== painter : !mayDraw(painter, face)) continue;
    if (face.inView && !face.hasStandIn) return face;
    if (face.inView) standing ??= face;
    const { top, bottom, left, right } = face.getBoundingClientRect();
    const away = Math.max(top - innerHeight, -bottom, 0) + Math.max(left - innerWidth, -right, 0);
    if (away < least) found = face, least = away;
  }
  return standing ?? found;
}

/** The worker that draws no first pictures now, since a face that talks is its own and others can draw them. */
function quietPainter() {
  if (painters.length < 2 || !talker || performance.now() - askedAt.get(talker) > TALKS) return null;
  return reader(talker) ?? null;
}

/** Lets a face wait for a picture; in which lane, says the face. */
export function wait(face, lane) {
  if (!lanes[lane].has(face)) leave(face), lanes[lane].add(face);
  if (lane === 'playing') takeItsPlace(face);
  if (lane === 'asked') {
    const now = performance.now();
    if (now - (askedAt.get(face) ?? -Infinity) < TALKS) talker = face;
    askedAt.set(face, now), newest = face;
  }
  wake();
}

/** Among those that play. Who comes new has had its first picture, which counts: else faces would stand still until the page is
 *  full. Who has rested or talked has no more to catch up on, and no more to wait for, than a picture or two. */
function takeItsPlace(face) {
  const clock = reader(face)?.clock ?? 0, least = face.plays ? clock : clock + charge(face);
  face.spent = Math.min(Math.max(face.spent, least), clock + 2 * charge(face)), face.plays = true;
}

export function leave(face) {
  for (const lane of Object.values(lanes)) lane.delete(face);
  if (newest === face) newest = null;
}

/** The face is no more in the page: its worker forgets it. */
export function forget(face) {
  leave(face);
  reader(face)?.forget(face);
  painterOf.delete(face);
  if (talker === face) talker = null;
}

/** Draws what waits, once the page has changed all that it changes now. */
export function wake() {
  if (woken) return;
  woken = true;
  queueMicrotask(() => { woken = false, next(); });
}

const waiting = () => lanes.first.size + lanes.asked.size + lanes.playing.size;

function next() {
  if (globalThis.document.hidden) return;
  for (const painter of painters) give(painter);
  // Another one can draw what none of those at work has read; it begins with what the first has compiled.
  if (painters.length && !painters[0].module || painters.length >= most || painters.some(({ drawing }) => !drawing)) return;
  for (const face of lanes.first) if (!reader(face)) return painters.push(new Painter(wake, fail)), next();
}

/** A free painter's next face. */
function give(painter) {
  while (!painter.drawing && waiting()) {
    let face, turn = turns.get(painter) ?? 0;
    for (let i = 0; i < TURNS.length && !face; ++i) face = TURNS[turn++ % TURNS.length](painter);
    turns.set(painter, turn);
    if (!face) return;
    leave(face);
    try {
      painter.start(painters[0].module);
      if (reader(face) !== painter) reader(face)?.forget(face), painterOf.set(face, painter);
      painter.draw(face);
    } catch (error) {
      painter.drawing = null;
      face.refuse({ where: '', what: error.message });
    }
  }
}

/** A worker cannot be started. If it is the first, all that wait are told so, and the next that is asked for tries again; without
 *  another one the page does, as where memory is refused. */
function fail(painter, drawing, refused) {
  if (painter !== painters[0]) {
    painters.splice(painters.indexOf(painter), 1), most = painters.length;
    return drawing.again();
  }
  for (const face of [drawing, ...Object.values(lanes).flatMap((lane) => [...lane])].filter(Boolean)) leave(face), face.refuse(refused);
}

if (globalThis.document) document.addEventListener('visibilitychange', wake);
