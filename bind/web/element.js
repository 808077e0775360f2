// <mien-face seed="ada" width="320" height="320" emotion="joy=0.8" playing></mien-face>
//
// Its attributes are told in attributes.js. Each is a property, too: `face.emotion = 'joy=1'` or `{ joy: 1 }`, `face.lookAt =
// [0, 0, 9]`, `face.faceStyle = 'ink'`; null takes it away. It talks and follows a camera by methods, too:
// face.speak(textOfATrack, audio.currentTime), face.follow(resultOfMediaPipe).
//
// Events: `mien-drawn` (detail.ms), once the picture is on the screen; `mien-ended` (detail.speech), once a track that runs by the
// face's own clock is over; and `mien-refused` (detail.where, detail.what: an error's place and sentence). The old picture stays;
// where there is none yet, what stands in the element stays: an <img> or <svg> that a server wrote. Where there is nothing, the
// sentence stands there.
//
// Drawn is what is seen: first pictures of faces in view, then those of faces less than half a view away from it. Nothing is
// drawn farther away, in a hidden element or in a page in the background. Clips run only in view, and not at all for people
// who want less motion (prefers-reduced-motion): they see the face at rest, or at `time`. With a sound it speaks to everybody.

import { NAMES, SOURCES, defineProperties, meant, poseOf, propertyOf, words } from './attributes.js';
import { forget, leave, wait } from './drawing_queue.js';

const STYLE = `:host { display: inline-block } :host([hidden]), [hidden] { display: none !important } canvas, ::slotted(*) { display: block; max-width: 100% }
  p:empty { display: none } p { margin: 0; font: 12px/1.3 system-ui, sans-serif; overflow: auto; overflow-wrap: anywhere }`;
/** When a sound has another moment. */
const MOMENTS = ['play', 'pause', 'seeked', 'ended'];
const INSIDE = '<slot></slot><canvas part="canvas"></canvas><p part="refused" role="status"></p>';
const EASED = 300, BLINK = 400;  // [ms] until a new emotion is there; that a blink takes
const LONGEST = 2 ** 31 - 1;  // [ms] that a timer waits
const UNKNOWN = 'a drawn face';  // until it is known what it looks like

/** What is there only in pages; servers import this file, too. */
const page = globalThis.HTMLElement && globalThis.document && {
  count: 0,
  inside: Object.assign(document.createElement('template'), { innerHTML: `<style>${STYLE}</style>${INSIDE}` }),
  stillness: globalThis.matchMedia?.('(prefers-reduced-motion: reduce)') ?? new EventTarget(),
  inView: watch((face, seen) => { face.inView = seen; }, '0px'),
  near: watch((face, seen) => { face.isNear = seen; }, '50%'),
};
function watch(tell, rootMargin) {
  if (!globalThis.IntersectionObserver) return { observe(face) { tell(face, true), face.queue(); }, unobserve() {} };
  return new IntersectionObserver((entries) => {
    for (const { target, isIntersecting } of entries) tell(target, isIntersecting), target.queue();
  }, { rootMargin });
}

/** Calls back once what the page shows now is on the screen. */
const shown = [];
function onceShown(tell) {
  if (shown.push(tell) > 1) return;
  requestAnimationFrame(() => {
    const all = shown.splice(0);  // what comes from now on is of the next frame
    setTimeout(() => { for (const one of all) one(); });
  });
}

/** Pictures of clips that are shown together. Each canvas is a layer of the page, and a frame in which one changes passes all of
 *  them on: shown one by one, two hundred faces at 72 px take the browser half of a core. */
const kept = [];
function showTogether(ms, show) {
  if (kept.push(show) === 1) setTimeout(() => { for (const one of kept.splice(0)) one(); }, ms);
}
const FRAME = 17, LONGEST_KEPT = 100;  // [ms]
const KEPT = 1 / 6;  // of the time between a face's pictures: who sees it twice a second sees it a twelfth of a second later

/** Strengths by name; a text that is no number stays what it is, to be refused. */
const numbersOf = (weights = {}) => Object.fromEntries(Object.entries(weights).map(([name, one]) => [name, Number.isNaN(Number(one)) ? one : Number(one)]));
function mixed(one, other, share) {
  const names = new Set([...Object.keys(one), ...Object.keys(other)]), part = (of, name) => (typeof of[name] === 'number' ? of[name] : 0);
  return Object.fromEntries([...names].map((name) => [name, typeof other[name] === 'string' ? other[name] : part(one, name) * (1 - share) + part(other, name) * share]));
}

/** The texts of files that are on their way, by address: faces of one file fetch it once. */
const fetched = new Map();
async function fetchText(address) {
  const response = await fetch(address);
  if (!response.ok) throw new Error(`cannot be fetched: ${response.status}`);
  return response.text();
}
function textOf(src) {
  const address = new URL(src, document.baseURI).href;
  if (!fetched.has(address)) fetched.set(address, fetchText(address).finally(() => fetched.delete(address)));
  return fetched.get(address);
}

class DrawnFace extends (globalThis.HTMLElement ?? class {}) {
  static observedAttributes = NAMES;
  /** For the queue: the element's number in its worker; whether it is in view, and whether at most half a view away; what its last
   *  picture took and what all were charged [ms]; whether its clips have run. */
  number = 0; inView = false; isNear = false; cost = 0; spent = 0; plays = false;
  #slot; #canvas; #said; #context; #heard; #seen = null; #drawn = false; #lane = null; #source = null; #before = null; #worker = null; #asked = null; #turned = false; #posed = null; #kept = null; #shown = 0; #framed = false; #wanted = false; #ran = 0; #since = 0; #over = 0; #complaint = ''; #felt = null; #extra = {}; #live = {}; #track = null; #sound = null;

  constructor() {
    super();
    this.attachShadow({ mode: 'open' }).append(page.inside.content.cloneNode(true));
    [this.#slot, this.#canvas, this.#said] = this.shadowRoot.querySelectorAll('slot, canvas, p');
    this.#slot.addEventListener('slotchange', () => this.#stand());
    this.addEventListener('click', () => this.#press());
    this.addEventListener('keydown', (event) => {
      if (!this.pausable || event.target !== this || ![' ', 'Enter'].includes(event.key)) return;
      event.preventDefault();
      if (!event.repeat) this.click();
    });
    this.#heard = 'role' in (globalThis.ElementInternals?.prototype ?? {}) ? this.attachInternals() : this.#canvas;  // old Firefox
  }

  connectedCallback() {
    if (this.number) return;  // it was moved
    this.number = ++page.count;
    this.#upgrade();
    this.#stand();
    queueMicrotask(() => { for (const { name } of this.attributes) this.#doubt(name); });  // who listens has been told of the element
    this.#open();
    this.#hear();
    this.#learn();
    for (const seen of [page.inView, page.near]) seen.observe(this);
    page.stillness.addEventListener('change', this.#redrawn);
  }
  disconnectedCallback() {
    queueMicrotask(() => {  // one that is moved is out of the page for a moment
      if (this.isConnected || !this.number) return;
      for (const seen of [page.inView, page.near]) seen.unobserve(this);
      page.stillness.removeEventListener('change', this.#redrawn);
      forget(this);
      this.number = 0, this.inView = this.isNear = false, this.#lane = this.#worker = this.#asked = null;
      this.#hear();
    });
  }
  // Attributes are told before an element is connected: until then there is nothing to draw on.
  attributeChangedCallback(name) {
    if (!this.number) return;
    if (name === 'alt' || name === 'pausable') return this.#describe();
    if (name === 'playing') this.#describe();
    if (name === 'sound') return this.#hear();
    if (name === 'speech') return void this.#learn();
    SOURCES.includes(name) ? this.#open() : this.redraw();
  }

  /** A pose of more than attributes can say, as Face.draw takes it (mien.js); attributes come on top. */
  set pose(pose) { this.#extra = pose ?? {}, this.redraw(); }
  get pose() { return this.#extra; }

  /** A track of speech or a take: the text of its file, of any kind that mien reads. With a time [s] the face is at that moment, and
   *  a page asks again for every one, such as its audio's currentTime; without one it speaks as by `speech`. null: no longer. */
  speak(track, time) {
    const whole = track !== null && time === undefined;
    if (whole || this.#track?.src === null) this.#track = whole ? { text: track, src: null } : null;
    this.#live = track === null || whole ? {} : { spoken: track, moment: time };
    this.redraw();
  }
  /** The face as a camera saw an actor's: { jawOpen: 0.4 }, or a result of MediaPipe's FaceLandmarker. null: no longer. */
  follow(frame) { this.#live = frame === null ? {} : { frame: JSON.stringify(frame), at: performance.now() / 1000 }, this.redraw(); }

  /** Draws once more. However often it is asked for, the next picture is that of the newest pose. */
  redraw() {
    this.#complaint = '';
    this.#wind();
    if (!this.number || !this.#source) return;
    this.#lane = this.#drawn ? 'asked' : 'first';
    this.queue();
  }
  #redrawn = () => this.redraw();

  /** For the queue: waits for a picture if one is wanted and would be seen. */
  queue() {
    const sees = this.#lane === 'playing' ? this.inView : this.isNear;
    if (!this.#lane || !sees || this.#asked) return leave(this);
    if (this.#source.src !== undefined && this.#source.text === undefined) return void this.#fetch();
    wait(this, this.#lane);
  }
  /** For the queue: what the worker is asked for. */
  request(worker) {
    this.#turned = this.#lane === 'playing', this.#lane = null;
    const request = { id: this.number, ...this.#size(), pose: this.#pose(), deadline: Number((this.getAttribute('deadline') ?? 10000) || NaN) };
    if (this.#worker !== worker) request.source = this.#source;
    this.#worker = worker, this.#asked = this.#source;
    return request;
  }
  /** For the queue: the worker's answer. What is of a face that it no longer is counts for nothing. */
  answer({ what, where, told = [], length, ...picture }) {
    const stale = this.#asked !== this.#source;
    for (const said of told) console.warn(`<mien-face>: speech: ${said}`);
    this.#asked = null;
    if (!this.number || stale) return this.queue();
    if (what !== undefined) return this.#refuse(where, what), this.queue();
    this.#before = this.#source, this.#kept = picture;
    if (this.#posed && this.#posed === this.#track && this.#posed.length === undefined) this.#posed.length = length, this.#awaitEnd();
    const show = (next) => { if (picture === this.#kept && this.number) this.#show(picture), this.#play(next); };
    const now = performance.now(), keep = this.#turned ? Math.min(KEPT * (now - this.#shown), LONGEST_KEPT) : 0;
    this.#shown = now;
    keep < FRAME ? show(requestAnimationFrame) : showTogether(keep, () => show((next) => next()));
    this.queue();
  }
  /** For the queue: what was asked for comes to nothing; it is asked for once more. */
  again() { this.#asked = null, this.redraw(); }
  /** For the queue: there will be no picture, and why. */
  refuse({ where, what }) {
    this.#lane = this.#asked = null;
    this.#refuse(where, what);
  }

  #refuse(where, what) {
    if (this.#turns) return this.#felt.at = -Infinity, this.redraw();  // what is wrong is told of the whole emotion
    if (!this.#drawn && !this.#standIn) this.#said.textContent = where ? `${where}: ${what}` : what;
    this.#stand();
    this.#complain(where, what);
  }
  /** Tells what is refused; who does not take care of it reads it in the console. */
  #complain(where, what) {
    const complaint = `${where}: ${what}`;
    this.#felt = null;
    if (complaint === this.#complaint) return;  // of a frame of clips that was asked for before
    this.#complaint = complaint;
    if (this.#tell('mien-refused', { where, what })) console.warn(`<mien-face>: ${where ? complaint : what}`);
  }
  /** An attribute that is nearly one of ours was meant to be. */
  #doubt(name) {
    const ours = meant(name);
    if (ours) this.#complain(name, `there is no such attribute; did you mean "${ours}"?`);
  }

  /** Properties that were set before the element was known hide those of its class. */
  #upgrade() {
    for (const name of [...NAMES.map(propertyOf), 'pose']) {
      if (!Object.hasOwn(this, name)) continue;
      const value = this[name];
      delete this[name];
      this[name] = value;
    }
  }
  #open() {
    const said = (name) => this.getAttribute(name) ?? undefined, style = said('face-style'), { neutral } = this;
    const [code, seed, src] = ['code', 'seed', 'src'].map(said);
    const none = code === undefined && seed === undefined && src === undefined;
    this.#kept = null;
    this.#source = none ? null : code !== undefined ? { code, style, neutral } : seed !== undefined ? { seed, style, neutral } : { src, name: src, style };
    this.#worker = null;
    if (none) this.#lane = null, leave(this);
    this.#size();
    this.redraw();
  }
  async #fetch() {
    const source = this.#source;
    if (source.fetching) return;
    source.fetching = true;
    try {
      source.text = await textOf(source.src);
    } catch (error) {
      if (source !== this.#source || !this.number) return;
      source.fetching = false;
      this.#source = this.#before ?? source;  // as for a file that is there and is refused: the old face stays
      return this.refuse({ where: source.src, what: error.message });
    }
    if (source === this.#source && this.number) this.queue();
  }
  /** The track of `speech`, from its file. */
  async #learn() {
    const src = this.getAttribute('speech'), track = src === null ? null : { src };
    this.#track = track;
    if (!track) return this.redraw();
    try {
      track.text = await textOf(src);
      if (track === this.#track) this.redraw();
    } catch (error) {
      if (track === this.#track && this.number) this.#refuse(src, error.message);
    }
  }
  /** Follows the sound of `sound`, and no other. */
  #hear() {
    for (const moment of MOMENTS) this.#sound?.removeEventListener(moment, this.#redrawn);
    const id = this.number ? this.getAttribute('sound') : null;
    this.#sound = id === null ? null : this.getRootNode().getElementById?.(id) ?? null;
    for (const moment of MOMENTS) this.#sound?.addEventListener(moment, this.#redrawn);
    if (id !== null && !this.#sound) this.#refuse('sound', `nothing here has the id "${id}"`);
    this.redraw();
  }
  #size() {
    const dots = globalThis.devicePixelRatio || 1, [width, height] = ['width', 'height'].map((name) => Number.parseFloat(this.getAttribute(name) ?? 320));
    this.#canvas.style.width = `${width}px`;
    this.#canvas.style.aspectRatio = `${width} / ${height}`;
    Object.assign(this.#said.style, { maxWidth: `${width}px`, maxHeight: `${height}px` });
    const size = { width: Math.round(width * dots), height: Math.round(height * dots) };
    if (!this.#drawn) Object.assign(this.#canvas, size);  // a picture of another size stays until the next is there
    return size;
  }
  /** [s] That its clips have run, or would have been seen to. */
  get #clock() { return this.#ran + (this.#since && (performance.now() - this.#since) / 1000); }
  /** The clock goes while clips run, and so does a track by that clock: its end comes for everybody. */
  #wind() {
    if (this.#runs === this.#since > 0) return;
    this.#ran = this.#clock, this.#since = this.#runs ? performance.now() : 0;
    this.#awaitEnd();
  }
  get #speaks() { return this.number !== 0 && this.#track?.text !== undefined && this.#sound?.paused === false; }
  /** Whether its clock goes; and whether what goes by it is seen, which it is not of people who want less motion. */
  get #runs() { return this.number !== 0 && this.playing && this.#extra.time === undefined; }
  get #plays() { return this.#runs && (this.#wanted || !page.stillness.matches); }
  /** Whether its mouth moves now: such faces go before others. */
  get #talks() {
    const track = this.#track;
    if (this.#sound || track?.text === undefined) return this.#speaks;
    return this.#plays && !(this.#clock - track.begin > track.length);
  }
  get #turns() { return this.#felt !== null && performance.now() - this.#felt.at < EASED; }
  /** Of a pausable face: its clips rest, or run again. Who asks for motion gets it. */
  #press() {
    if (!this.pausable) return;
    this.#wanted = !this.#plays;
    this.playing = this.#wanted;
    this.redraw();
  }
  /** The next picture of what runs. */
  #play(then) {
    if (this.#framed || !(this.#plays || this.#speaks)) return;
    this.#framed = true;
    then(() => {
      this.#framed = false;
      if ((this.#plays || this.#speaks) && !this.#lane && !this.#asked) this.#lane = (this.#talks || this.#turns) && this.inView ? 'asked' : 'playing', this.queue();
    });
  }
  #pose() {
    const said = (name) => this.getAttribute(name), pose = poseOf(said, this.#extra);
    const track = this.#posed = this.#track?.text === undefined ? null : this.#track;
    const plays = this.#plays, { at, spoken, moment, ...live } = this.#live;
    // The clips of a face that plays have a clock of their own, and the track begins where its moment wants it: so a face lives while
    // it talks, and before and after that. Without a clock everything is at the track's moment.
    const follow = (motion, time) => {
      if (!plays) pose.time = time;
      return { motion, begin: plays ? pose.time - time : 0 };
    };
    if (plays) pose.time = this.#clock, this.#ease(pose), this.#keepAwake(pose);
    else this.#felt = null;
    if (track && this.#runs && !this.#sound && track.begin === undefined) track.begin = this.#clock, this.#awaitEnd();  // it begins when it is set
    if (track) pose.motions = [...(pose.motions ?? []), this.#sound ? follow(track.text, this.#sound.currentTime) : { motion: track.text, begin: track.begin ?? 0 }];
    if (spoken !== undefined) pose.motions = [follow(spoken, moment)];
    if (at !== undefined && said('steady') !== null) {
      const [cutoff, beta] = words(said('steady')).map(Number);
      live.steady = { at, cutoff, beta };
    }
    return { ...pose, ...live };
  }
  /** A face that plays turns to another emotion in a moment, as faces do, not at once. */
  #ease(pose) {
    const now = performance.now(), to = numbersOf(pose.emotions), key = JSON.stringify(to);
    if (this.#felt?.key !== key) this.#felt = { key, to, from: this.#felt?.now ?? to, at: this.#felt ? now : -Infinity };
    const felt = this.#felt, share = Math.min((now - felt.at) / EASED, 1);
    felt.now = share < 1 ? mixed(felt.from, felt.to, share * share * (3 - 2 * share)) : felt.to;
    if (share < 1) pose.emotions = felt.now;
  }
  /** Where pictures are rare a blink would last until the next one, so the lids stay open. Faces of files may have no such number. */
  #keepAwake(pose) {
    if (this.#source.src === undefined && performance.now() - this.#shown + this.cost > BLINK) pose.set = { blink: 0, ...pose.set };
  }
  #show({ pixels, width, height, ms, seen }) {
    this.#said.textContent = '', this.#drawn = true;
    if (seen !== undefined || this.#canvas.hidden) this.#seen = seen ?? this.#seen, this.#stand();
    this.#context ??= this.#canvas.getContext('2d');
    if (this.#canvas.width !== width || this.#canvas.height !== height) this.#canvas.width = width, this.#canvas.height = height;
    this.#context.putImageData(new ImageData(pixels, width, height), 0, 0);
    onceShown(() => { if (this.number) this.#tell('mien-drawn', { ms }); });
  }
  /** Once a track that runs by the face's own clock is over, pages are told, as by a sound's `ended`. */
  #awaitEnd() {
    clearTimeout(this.#over);
    const track = this.#track;
    if (!this.#since || track?.begin === undefined || track.length === undefined || track.isOver) return;
    const over = () => {
      if (track !== this.#track) return;
      track.isOver = true;
      this.#tell('mien-ended', { speech: track.src });
    };
    this.#over = setTimeout(over, Math.min(1000 * (track.begin + track.length - this.#clock), LONGEST));
  }
  /** What stands in the element until the first picture. */
  get #standIn() { return this.#slot.assignedElements()[0]; }
  get hasStandIn() { return this.#standIn !== undefined; }
  /** Shows the picture, or what stands in for it, in one step: nothing flashes. */
  #stand() {
    this.#slot.hidden = this.#drawn, this.#canvas.hidden = !this.#drawn && (this.#standIn !== undefined || this.#said.textContent !== '');
    this.#describe();
  }
  /** The element is a picture for those who hear the page; a role or an aria-label of the page's own counts more. */
  #describe() {
    const alt = this.getAttribute('alt') ?? (this.#standIn?.getAttribute('alt') || this.#seen || UNKNOWN);
    const role = this.#said.textContent ? null : this.pausable ? 'button' : alt === '' ? 'presentation' : 'img';  // a sentence is heard itself
    Object.assign(this.#heard, { role, ariaLabel: role === 'presentation' ? null : alt, ariaPressed: role === 'button' ? String(this.#plays) : null });
    if (role === 'button' && !this.hasAttribute('tabindex')) this.tabIndex = 0;
  }
  #tell(name, detail) { return this.dispatchEvent(new CustomEvent(name, { detail, bubbles: true, cancelable: name === 'mien-refused' })); }
}

defineProperties(DrawnFace.prototype);

/** A page may import this file from two places: the first one counts. */
export const MienFace = globalThis.customElements?.get('mien-face') ?? DrawnFace;
if (page && MienFace === DrawnFace) customElements.define('mien-face', MienFace);
