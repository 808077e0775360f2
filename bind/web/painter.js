// A worker that draws, as the page sees it: one picture at a time, within its deadline. The worker ends a drawing itself that
// takes longer; one that does not, because it is elsewhere at work, or whose memory is broken, is replaced.

const GRACE = 1000;  // [ms] for the worker to end a drawing after its deadline
const LONGEST = 2 ** 31 - 1;  // [ms] that a timer waits

/** [ms] What a face's picture counts for its turns: what it took, but four usual pictures at most. Else a slow face would stand still
 *  in a crowd, at times with its eyes shut. */
export const charge = (face) => Math.min(face.cost, MOST_CHARGED * usual);
const MOST_CHARGED = 4, REMEMBERED = 16;  // pictures
let usual = 5;  // [ms] what is charged, in the mean; at first what avatars take
function account(face, ms) {
  face.cost = ms, face.spent += charge(face);
  usual += (charge(face) - usual) / REMEMBERED;
}

/** The worker. Pages may start only workers of their own origin: of another one it is a worker of the page that imports it. */
function startWorker() {
  const here = import.meta.url, { protocol, origin } = new URL(here);
  // Bundlers know the worker by this expression, and some write an address of their own disk for import.meta.url.
  if (origin === location.origin || !protocol.startsWith('http')) return new Worker(new URL('./worker.js', import.meta.url), { type: 'module' });
  const there = new URL('./worker.js', here).href, own = new Blob([`import ${JSON.stringify(there)};`], { type: 'text/javascript' });
  return new Worker(URL.createObjectURL(own), { type: 'module' });
}

const CANNOT_START = 'the worker that draws cannot be started: it is not there, its server allows no other origin (CORS), or the page allows no such workers (worker-src of its content security policy)';

export class Painter {
  /** The face that it draws; the compiled module, once it has one. */
  drawing = null; module = null;
  /** For the queue: what the face was charged [ms] that was drawn least of those that it has read and that play. */
  clock = 0;
  #worker = null; #ready = false; #allowed = 0; #late = 0; #done; #failed;
  /** Calls done() when it is free again, and failed(painter, face, refused) when it cannot be started. */
  constructor(done, failed) { this.#done = done, this.#failed = failed; }

  /** Starts, with what another one has compiled. */
  start(module) {
    if (this.#worker) return;
    const worker = this.#worker = startWorker();
    worker.onmessage = ({ data }) => this.#hear(data);
    worker.onerror = (event) => {
      event.preventDefault?.();
      this.#fail({ where: new URL('./worker.js', String(import.meta.url)).href, what: event.message || CANNOT_START });
    };
    worker.postMessage({ begin: true, module: module ?? undefined });
  }
  draw(face) {
    const request = face.request(this.#worker);
    this.#worker.postMessage(request);
    this.drawing = face, this.#allowed = request.deadline;
    this.#expect();
  }
  forget(face) { this.#worker?.postMessage({ id: face.number, free: true }); }

  #hear(data) {
    if (data.ready) return this.#ready = true, this.module = data.module, this.#expect(), this.#done();
    if (data.broken && !this.#ready) return this.#fail(data);
    const face = this.drawing;
    this.drawing = null;
    clearTimeout(this.#late);
    if (data.broken) this.#end();
    if (data.ms) account(face, data.ms);
    face.answer(data.late ? this.#tooLong : data);
    this.#done();
  }
  get #tooLong() { return { where: 'deadline', what: `drawing took longer than ${this.#allowed} ms` }; }
  /** Waits for the worker's answer, from when it has loaded what it draws with. */
  #expect() {
    clearTimeout(this.#late);
    if (this.drawing && this.#ready && this.#allowed > 0) this.#late = setTimeout(() => this.#replace(), Math.min(this.#allowed + GRACE, LONGEST));
  }
  #replace() {
    const face = this.drawing;
    this.#end();
    face.refuse(this.#tooLong);
    this.#done();
  }
  #fail(refused) {
    const face = this.drawing;
    this.#end();
    this.#failed(this, face, refused);
  }
  #end() {
    this.#worker.terminate();
    clearTimeout(this.#late);
    this.#worker = this.drawing = null, this.#ready = false;
  }
}
