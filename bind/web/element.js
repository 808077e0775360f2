// <mien-face code="A66CB-AA5S0-14" width="320" height="320" emotion="joy=0.8" playing></mien-face>
//
//   src       a face file's address            code      or a person's code
//   width, height  in CSS pixels (320, 320); the picture has the display's own pixels
//   emotion   "joy=0.8, left.surprise=0.3"     set       "gaze.x=0.04; palette/skin=#ffd94a"
//   muscle    "jaw=0.3, left.zygomaticus=1"
//   clip      "idle" (several: "idle, feelings=0.5")
//   playing   clips run; without it the face is at rest, or at `time` seconds
//   blend     "linear" (default) or "srgb"   background  "#rrggbb", "#rrggbbaa"; none: the face's own
//   label     what a screen reader says
//
// Events: `drawn` (detail.ms), `refused` (detail.where, detail.what: an error's place and sentence). The old picture
// stays; where there is none yet, the sentence stands in its place. One module worker draws for all elements of a page,
// on OffscreenCanvas where there is one; no headers of the server are needed.

let worker, count = 0;
const elements = new Map();

function ask(message, given = []) {
  if (!worker) {
    worker = new Worker(new URL('./worker.js', import.meta.url), { type: 'module' });
    worker.onmessage = ({ data }) => elements.get(data.id)?.answered(data);
    worker.onerror = (event) => elements.forEach((element) => element.answered({ where: '', what: event.message || 'the worker cannot be loaded' }));
  }
  worker.postMessage(message, given);
}

/** "a=1, b=2" as { a: '1', b: '2' }. */
function pairs(text, separator) {
  const found = {};
  for (const part of (text ?? '').split(separator)) {
    const [name, value] = part.split('=').map((word) => word.trim());
    if (name) found[name] = value ?? '1';
  }
  return found;
}

const words = (text) => (text ?? '').split(',').map((word) => word.trim()).filter(Boolean);

export class MienFace extends HTMLElement {
  static observedAttributes = ['src', 'code', 'width', 'height', 'emotion', 'muscle', 'set', 'clip', 'time', 'playing', 'blend', 'background', 'label'];
  #id = 0; #canvas; #said; #context; #asked = false; #stale = false; #drawn = false; #given = false; #started = 0; #extra = {};

  constructor() {
    super();
    this.attachShadow({ mode: 'open' }).innerHTML = `<style>
      :host { display: inline-block } :host([hidden]) { display: none } canvas { display: block; max-width: 100% } canvas[hidden] { display: none }
      p { margin: 0; font: 14px/1.4 system-ui, sans-serif; max-width: 20rem; overflow-wrap: anywhere }
    </style><canvas part="canvas" role="img"></canvas><p part="refused" role="status"></p>`;
    [this.#canvas, this.#said] = this.shadowRoot.querySelectorAll('canvas, p');
  }

  connectedCallback() {
    if (!this.#id) this.#enter();
    this.#describe();
    this.#open();
  }
  disconnectedCallback() {
    queueMicrotask(() => {  // one that is moved is out of the page for a moment
      if (this.isConnected || !this.#id) return;
      ask({ id: this.#id, free: true });
      elements.delete(this.#id);
      this.#id = 0, this.#asked = this.#stale = false;
    });
  }
  // Attributes are told before an element is connected: until then there is nothing to draw on.
  attributeChangedCallback(name) {
    if (!this.#id) return;
    if (name === 'label') return this.#describe();
    if (name === 'src' || name === 'code') return this.#open();
    this.redraw();
  }

  /** A pose of more than attributes can say, as Face.draw takes it (mien.js); attributes come on top. */
  set pose(pose) { this.#extra = pose, this.redraw(); }
  get pose() { return this.#extra; }

  /** Draws anew, once the picture before is there. */
  redraw() {
    if (!this.#id || !(this.hasAttribute('code') || this.hasAttribute('src'))) return;
    if (this.#asked) return void (this.#stale = true);
    this.#asked = true;
    ask({ id: this.#id, ...this.#size(), pose: this.#pose() });
  }
  answered(message) {
    this.#asked = false;
    const refused = message.what !== undefined;
    refused ? this.#refuse(message) : this.#show(message);
    if (this.#stale || !refused && this.hasAttribute('playing')) requestAnimationFrame(() => { this.#stale = false, this.isConnected && this.redraw(); });
  }

  #enter() {
    this.#id = ++count;
    elements.set(this.#id, this);
    if (this.#given) {  // the canvas of before went with the worker's picture
      const fresh = this.#canvas.cloneNode();
      this.#canvas.replaceWith(fresh);
      this.#canvas = fresh, this.#drawn = false;
    }
    this.#given = 'transferControlToOffscreen' in this.#canvas;
    if (!this.#given) return;
    const canvas = this.#canvas.transferControlToOffscreen();
    ask({ id: this.#id, canvas }, [canvas]);
  }
  async #open() {
    const code = this.getAttribute('code'), src = this.getAttribute('src');
    if (code === null && src === null) return;
    this.#asked = true;
    const what = { id: this.#id, ...this.#size(), pose: this.#pose() };
    if (code !== null) return ask({ ...what, code });
    try {
      const response = await fetch(src);
      if (!response.ok) throw new Error(`cannot be fetched: ${response.status}`);
      const text = await response.text();
      if (src === this.getAttribute('src')) ask({ ...what, text, name: src });
    } catch (error) {
      this.answered({ where: src, what: error.message });
    }
  }
  #size() {
    const dots = globalThis.devicePixelRatio || 1, css = (name) => Number(this.getAttribute(name) ?? 320) || 320;
    this.#canvas.style.width = `${css('width')}px`;
    this.#canvas.style.aspectRatio = `${css('width')} / ${css('height')}`;
    return { width: Math.round(css('width') * dots), height: Math.round(css('height') * dots) };
  }
  #pose() {
    const pose = { ...this.#extra, blend: this.getAttribute('blend') ?? 'linear' };
    pose.emotions = { ...this.#extra.emotions, ...pairs(this.getAttribute('emotion'), ',') };
    pose.muscles = { ...this.#extra.muscles, ...pairs(this.getAttribute('muscle'), ',') };
    if (this.hasAttribute('background')) pose.background = this.getAttribute('background');
    pose.set = { ...this.#extra.set, ...pairs(this.getAttribute('set'), ';') };
    pose.clips = [...(this.#extra.clips ?? []), ...words(this.getAttribute('clip'))];
    if (this.hasAttribute('playing')) pose.time = (performance.now() - (this.#started ||= performance.now())) / 1000;
    else if (this.hasAttribute('time')) pose.time = Number(this.getAttribute('time'));
    return pose;
  }
  #show({ pixels, width, height, ms }) {
    this.#canvas.hidden = false, this.#said.textContent = '', this.#drawn = true;
    if (pixels) this.#put(pixels, width, height);
    this.#tell('drawn', { ms });
  }
  #put(pixels, width, height) {
    this.#context ??= this.#canvas.getContext('2d');
    if (this.#canvas.width !== width || this.#canvas.height !== height) this.#canvas.width = width, this.#canvas.height = height;
    this.#context.putImageData(new ImageData(pixels, width, height), 0, 0);
  }
  #refuse({ where, what }) {
    if (!this.#drawn) this.#canvas.hidden = true, this.#said.textContent = where ? `${where}: ${what}` : what;
    this.#tell('refused', { where, what });
  }
  #describe() { this.#canvas.setAttribute('aria-label', this.getAttribute('label') ?? 'a drawn face'); }
  #tell(name, detail) { this.dispatchEvent(new CustomEvent(name, { detail, bubbles: true })); }
}

customElements.define('mien-face', MienFace);
