// The face on its stage: drawn at the display's pixels, turned by dragging, looking where the pointer is.

import { drawnPose } from './document.js';
import { Points } from './points.js';
import { Under } from './under.js';

const STILL = 160;       // [ms] without a change, after which a picture is drawn in full
const FLUENT = 45;       // [ms] a picture may take while something moves
const COARSEST = 0.25;
const LONG = 8000;       // [ms] after which a picture is given up for the next one

export class Stage {
  #studio; #canvas; #frame; #change; #busy = false; #asked = 0; #stale = false; #scale = 1; #moved = 0; #later = 0;
  #document = null; #opened = null; #look = null; #turn = null; #drawn; #clock = null;
  following = true;

  /** `change(key, values)` sets controls of the pose; `drawn(ms, refused)` hears of each picture. */
  constructor(studio, frame, { change, drawn }) {
    this.#studio = studio, this.#frame = frame, this.#canvas = frame.querySelector('canvas'), this.#change = change, this.#drawn = drawn;
    this.points = new Points(studio, frame, document.getElementById('feature'));
    new Under(studio, frame);
    new ResizeObserver(() => this.draw()).observe(frame.parentElement);
    this.#watchDisplay();
    this.#canvas.addEventListener('pointerdown', (event) => this.#press(event));
    window.addEventListener('pointermove', (event) => this.#move(event));
    for (const name of ['pointerup', 'pointercancel']) window.addEventListener(name, () => { this.#turn = null, this.#canvas.classList.remove('turning'); });
    document.documentElement.addEventListener('pointerleave', () => this.#lookAt(null));
    this.#canvas.addEventListener('keydown', (event) => this.#key(event));
  }
  show(document, opened) {
    if (this.#opened !== opened) this.points.leave(opened);
    this.#document = document, this.#opened = opened;
    this.points.show(document);
    this.#moved = performance.now();
    this.draw();
  }
  /** Draws picture after picture at what the clock says [s]; null: only what changes. */
  play(clock) {
    this.#clock = clock, this.#moved = performance.now();
    this.draw();
  }
  follow(on) {
    this.following = on;
    this.#look = null;
    this.draw();
  }
  /** The eyes no longer look at the pointer, until it moves. */
  lookAhead() { this.#lookAt(null); }
  /** Whether a picture takes so long that a change had better stop it. */
  get stuck() { return this.#busy && performance.now() - this.#asked > LONG; }
  /** Whether what is to be seen is not there yet. */
  busy(on) { this.#frame.setAttribute('aria-busy', on || this.#studio.opening); }
  control(name) { return this.#opened?.names.find((one) => one.name === name); }

  /** Draws anew, once the picture before is there. */
  draw() {
    if (!this.#document || !this.#opened) return;
    this.busy(true);
    if (this.#busy) return void (this.#stale = true);
    this.#busy = true, this.#asked = performance.now();
    requestAnimationFrame(() => this.#picture());
  }

  #watchDisplay() {
    matchMedia(`(resolution: ${devicePixelRatio}dppx)`).addEventListener('change', () => { this.draw(), this.#watchDisplay(); }, { once: true });
  }
  #size() {
    const { box: [x0, y0, x1, y1] } = this.#opened.canvas, aspect = (x1 - x0) / (y1 - y0);
    const { clientWidth, clientHeight } = this.#frame.parentElement;
    const style = getComputedStyle(this.#frame.parentElement);
    const room = [clientWidth - parseFloat(style.paddingLeft) - parseFloat(style.paddingRight), clientHeight - parseFloat(style.paddingTop) - parseFloat(style.paddingBottom)];
    const width = Math.max(48, Math.min(room[0], room[1] * aspect)), height = width / aspect;
    Object.assign(this.#frame.style, { width: `${width}px`, height: `${height}px` });
    return [width * devicePixelRatio, height * devicePixelRatio];
  }
  #moving() { return this.#clock || this.#turn || performance.now() - this.#moved < STILL; }
  async #picture() {
    const [width, height] = this.#size(), scale = this.#moving() ? this.#scale : 1;
    const size = { width: Math.max(1, Math.round(width * scale)), height: Math.max(1, Math.round(height * scale)) };
    const slow = setTimeout(() => this.#frame.classList.add('slow'), 400);
    this.#stale = false;
    try {
      const { pixels, ms } = await this.#studio.desk.ask('draw', { ...size, pose: this.#pose() });
      this.#put(pixels, size);
      this.#adapt(ms, scale);
      this.#drawn(ms);
    } catch (refused) {
      if (!refused.stopped) this.#drawn(NaN, refused);
    }
    clearTimeout(slow), this.#frame.classList.remove('slow');
    this.#busy = false;
    if (this.#stale || this.#clock) this.draw();
    else if (scale < 1) clearTimeout(this.#later), this.#later = setTimeout(() => this.draw(), STILL);
    else this.busy(false);
  }
  /** While something moves, pictures are as coarse as they must be to be fluent. */
  #adapt(ms, scale) {
    const wanted = scale * Math.sqrt(FLUENT / Math.max(ms, 1));
    this.#scale = Math.min(1, Math.max(COARSEST, 0.5 * this.#scale + 0.5 * wanted));
  }
  #put(pixels, { width, height }) {
    if (this.#canvas.width !== width || this.#canvas.height !== height) Object.assign(this.#canvas, { width, height });
    this.#canvas.getContext('2d').putImageData(new ImageData(pixels, width, height), 0, 0);
  }
  #pose() {
    const more = {};
    if (this.#look && this.following && !this.#document.pose.clip) more.lookAt = this.#look;  // a clip's glances are its own
    if (this.#clock) more.time = this.#clock();
    return drawnPose(this.#document, more);
  }

  #press(event) {
    if (event.button !== 0) return;
    if (this.points.on) return void this.points.pick(event);
    if (!this.control('yaw')) return;
    const { set } = this.#document.pose;
    this.#turn = { x: event.clientX, y: event.clientY, yaw: Number(set.yaw ?? 0), pitch: Number(set.pitch ?? 0) };
    this.#canvas.classList.add('turning');
    this.#canvas.focus({ preventScroll: true });
    event.preventDefault();
  }
  #move(event) {
    if (this.#turn) return this.#turnTo(event);
    if (event.pointerType === 'touch') return;
    this.#lookAt(event);
  }
  #turnTo({ clientX, clientY }) {
    const whole = this.#frame.clientWidth, degrees = 70;  // from edge to edge
    this.turn(this.#turn.yaw + (clientX - this.#turn.x) / whole * degrees, this.#turn.pitch - (clientY - this.#turn.y) / whole * degrees);
  }
  turn(yaw, pitch) {
    const values = {};
    for (const [name, value] of Object.entries({ yaw, pitch })) {
      const control = this.control(name);
      if (control) values[name] = Math.round(10 * Math.min(control.hi, Math.max(control.lo, value))) / 10;
    }
    this.#change('turn', values);
  }
  #key(event) {
    const { yaw = 0, pitch = 0 } = this.#document?.pose.set ?? {};
    const by = { ArrowLeft: [-3, 0], ArrowRight: [3, 0], ArrowUp: [0, 3], ArrowDown: [0, -3] }[event.key];
    if (by) this.turn(Number(yaw) + by[0], Number(pitch) + by[1]);
    else if (event.key === 'Home') this.turn(0, 0);
    else return;
    event.preventDefault();
  }
  /** What the eyes look at is in front of the face, where the pointer is. */
  #lookAt(event) {
    if (!this.following || !this.#opened || !this.control('gaze.x')) return;
    const at = event && !document.querySelector('dialog[open]') && this.#place(event);  // a dialog speaks of the picture as it is said
    this.#look = at;
    this.#moved = performance.now();
    this.draw();
  }
  #place({ clientX, clientY }) {
    const { box: [x0, y0, x1, y1], yUp } = this.#opened.canvas, area = this.#frame.getBoundingClientRect();
    const x = x0 + (clientX - area.left) / area.width * (x1 - x0), t = (clientY - area.top) / area.height;
    return [x, yUp ? y1 - t * (y1 - y0) : y0 + t * (y1 - y0), 0.9 * (x1 - x0)];
  }
}
