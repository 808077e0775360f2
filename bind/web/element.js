// <mien-face code="Z66CB-AA5S0-1B" width="320" height="320" emotion="joy=0.8" playing></mien-face>
//
//   src       a face file's address            code      or a person's code
//   width, height  in CSS pixels (320, 320); the picture has the display's own pixels
//   emotion   "joy=0.8, left.surprise=0.3"     set       "gaze.x=0.04; palette/skin=#ffd94a"
//   clip      "idle" (several: "idle, feelings=0.5")
//   playing   clips run; without it the face is at rest, or at `time` seconds
//   blend     "linear" (default) or "srgb"
//   label     what a screen reader says
//
// Events: `drawn` (detail.ms), `refused` (detail.where, detail.what: an error's place and sentence; the old picture
// stays). One module worker draws for all elements of a page, on OffscreenCanvas where there is one; no headers of the
// server are needed.

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
  static observedAttributes = ['src', 'code', 'width', 'height', 'emotion', 'set', 'clip', 'time', 'playing', 'blend', 'label'];
  #id = ++count; #canvas; #context; #begun = false; #asked = false; #stale = false; #started = 0; #extra = {};

  constructor() {
    super();
    this.attachShadow({ mode: 'open' }).innerHTML = '<style>:host{display:inline-block}:host([hidden]){display:none}canvas{display:block;max-width:100%}</style><canvas part="canvas" role="img"></canvas>';
    this.#canvas = this.shadowRoot.querySelector('canvas');
  }

  connectedCallback() {
    elements.set(this.#id, this);
    const canvas = this.#canvas.transferControlToOffscreen && !this.#begun ? this.#canvas.transferControlToOffscreen() : null;
    this.#begun = true;
    if (canvas) ask({ id: this.#id, canvas }, [canvas]);
    this.#describe();
    this.#open();
  }
  disconnectedCallback() {
    elements.delete(this.#id);
  }
  // Attributes are told before an element is connected: until then there is nothing to draw on.
  attributeChangedCallback(name) {
    if (!this.#begun) return;
    if (name === 'label') return this.#describe();
    if (name === 'src' || name === 'code') return this.#open();
    this.redraw();
  }

  /** A pose of more than attributes can say, as Face.draw takes it (mien.js); attributes come on top. */
  set pose(pose) { this.#extra = pose, this.redraw(); }
  get pose() { return this.#extra; }

  /** Draws anew, once the picture before is there. */
  redraw() {
    if (this.#asked) return void (this.#stale = true);
    this.#asked = true;
    ask({ id: this.#id, ...this.#size(), pose: this.#pose() });
  }
  answered(message) {
    this.#asked = false;
    if (message.what !== undefined) return this.#tell('refused', { where: message.where, what: message.what });
    if (message.pixels) this.#put(message);
    this.#tell('drawn', { ms: message.ms });
    if (this.#stale || this.hasAttribute('playing')) requestAnimationFrame(() => { this.#stale = false, this.isConnected && this.redraw(); });
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
    pose.set = { ...this.#extra.set, ...pairs(this.getAttribute('set'), ';') };
    pose.clips = [...(this.#extra.clips ?? []), ...words(this.getAttribute('clip'))];
    if (this.hasAttribute('playing')) pose.time = (performance.now() - (this.#started ||= performance.now())) / 1000;
    else if (this.hasAttribute('time')) pose.time = Number(this.getAttribute('time'));
    return pose;
  }
  #put({ pixels, width, height }) {
    this.#context ??= this.#canvas.getContext('2d');
    if (this.#canvas.width !== width || this.#canvas.height !== height) this.#canvas.width = width, this.#canvas.height = height;
    this.#context.putImageData(new ImageData(pixels, width, height), 0, 0);
  }
  #describe() { this.#canvas.setAttribute('aria-label', this.getAttribute('label') ?? 'a drawn face'); }
  #tell(name, detail) { this.dispatchEvent(new CustomEvent(name, { detail, bubbles: true })); }
}

customElements.define('mien-face', MienFace);
