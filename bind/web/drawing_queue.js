// Which <mien-face> is drawn next. One worker draws one picture at a time, and the next is chosen when it is done: what is
// asked for meanwhile waits here, where each face waits at most once, so nothing stale is ever drawn.
//
// Three kinds of faces wait: those without a picture (`first`), those that the page has changed (`asked`), and those whose
// clips play (`playing`). They take turns. A face that talks, which is changed again and again, so gets every second turn,
// however many wait.
//
// A picture that takes longer than its face's deadline is refused. The worker ends such a drawing itself; one that does not,
// because it is elsewhere at work, is replaced.

const GRACE = 1000;  // [ms] for the worker to end a drawing after its deadline
const LONGEST = 2 ** 31 - 1;  // [ms] that a timer waits

/** The worker. Pages may start only workers of their own origin: of another one it is a worker of the page that imports it. */
function startWorker() {
  const here = import.meta.url, { protocol, origin } = new URL(here);
  // Bundlers know the worker by this expression, and some write an address of their own disk for import.meta.url.
  if (origin === location.origin || !protocol.startsWith('http')) return new Worker(new URL('./worker.js', import.meta.url), { type: 'module' });
  const there = new URL('./worker.js', here).href, own = new Blob([`import ${JSON.stringify(there)};`], { type: 'text/javascript' });
  return new Worker(URL.createObjectURL(own), { type: 'module' });
}

const lanes = { first: new Set(), asked: new Set(), playing: new Set() };
let newest = null;  // of those asked
let worker = null, ready = false, drawing = null, allowed = 0, late = 0, turn = 0, woken = false;

const oldest = (lane) => lane.values().next().value;
const TURNS = [
  () => (lanes.asked.has(newest) ? newest : oldest(lanes.asked)),
  nearest,
  () => oldest(lanes.asked),
  () => oldest(lanes.playing),
];

/** Of those without a picture: the first in view, else the one that is least far from the view. */
function nearest() {
  let found, least = Infinity;
  for (const face of lanes.first) {
    if (face.inView) return face;
    const { top, bottom, left, right } = face.getBoundingClientRect();
    const away = Math.max(top - innerHeight, -bottom, 0) + Math.max(left - innerWidth, -right, 0);
    if (away < least) found = face, least = away;
  }
  return found;
}

/** Lets a face wait for a picture; in which lane, says the face. */
export function wait(face, lane) {
  if (!lanes[lane].has(face)) leave(face), lanes[lane].add(face);
  if (lane === 'asked') newest = face;
  wake();
}

export function leave(face) {
  for (const lane of Object.values(lanes)) lane.delete(face);
  if (newest === face) newest = null;
}

/** The face is no more in the page: the worker forgets it. */
export function forget(face) {
  leave(face);
  worker?.postMessage({ id: face.number, free: true });
}

/** Draws what waits, once the page has changed all that it changes now. */
export function wake() {
  if (woken) return;
  woken = true;
  queueMicrotask(() => { woken = false, next(); });
}

function next() {
  while (!drawing && !document.hidden) {
    let face;
    for (let i = 0; i < TURNS.length && !face; ++i) face = TURNS[turn++ % TURNS.length]();
    if (!face) return;
    leave(face);
    draw(face);
  }
}

function draw(face) {
  try {
    if (!worker) listen(startWorker());
    const request = face.request(worker);
    worker.postMessage(request);
    drawing = face, allowed = request.deadline;
    expect();
  } catch (error) {
    drawing = null;
    face.refuse({ where: '', what: error.message });
  }
}

const tooLong = () => ({ where: 'deadline', what: `drawing took longer than ${allowed} ms` });

/** Waits for the worker's answer, from when it has loaded what it draws with. */
function expect() {
  clearTimeout(late);
  if (drawing && ready && allowed > 0) late = setTimeout(replace, Math.min(allowed + GRACE, LONGEST));
}

/** Another worker for one that does not answer. */
function replace() {
  const face = drawing;
  end();
  face.refuse(tooLong());
  wake();
}

function end() {
  worker.terminate();
  clearTimeout(late);
  worker = drawing = null, ready = false;
}

function listen(begun) {
  worker = begun;
  worker.onmessage = ({ data }) => {
    if (data.ready) return ready = true, expect();
    const face = drawing;
    drawing = null;
    clearTimeout(late);
    face.answer(data.late ? tooLong() : data);
    wake();
  };
  worker.onerror = (event) => {
    event.preventDefault?.();
    const waiting = [drawing, ...Object.values(lanes).flatMap((lane) => [...lane])].filter(Boolean);
    end();
    const where = new URL('./worker.js', String(import.meta.url)).href;
    const what = event.message || 'the worker that draws cannot be started: it is not there, its server allows no other origin (CORS), or the page allows no such workers (worker-src of its content security policy)';
    for (const face of waiting) leave(face), face.refuse({ where, what });
  };
}

if (globalThis.document) document.addEventListener('visibilitychange', wake);
