// The points of a feature, as handles on the stage: the pointer drags them, and the arrow keys move them.

import { drawnPose, withPose } from './document.js';

const STEP = 0.004;  // of the picture's width, by an arrow key

export class Points {
  #studio; #frame; #layer; #handles = new Map(); #feature = null; #dragged = null;
  on = false;
  constructor(studio, frame) {
    this.#studio = studio, this.#frame = frame;
    this.#layer = Object.assign(document.createElement('div'), { className: 'points' });
    frame.append(this.#layer);
    window.addEventListener('pointermove', (event) => this.#dragged && this.#move(this.#dragged, this.#place(event)));
    for (const name of ['pointerup', 'pointercancel']) window.addEventListener(name, () => { this.#dragged = null; });
  }
  turn(on) {
    this.on = on;
    if (on) this.#studio.say('Click on what you want to shape.');
    else this.#clear(), this.#studio.say('');
  }
  /** Takes the feature under the pointer. */
  async pick(event) {
    const area = this.#frame.getBoundingClientRect(), share = { x: (event.clientX - area.left) / area.width, y: (event.clientY - area.top) / area.height };
    const { feature, points } = await this.#studio.desk.ask('points', { ...share, pose: drawnPose(this.#studio.document) });
    this.#clear();
    if (!points.length) return this.#studio.say(feature ? `${feature} has no points of its own.` : 'There is nothing.');
    this.#feature = feature;
    this.#studio.say(`${feature}: ${points.length} points`);
    for (const { name, at } of points) this.#add(name, at);
  }
  /** Another document is shown: handles go to where its points are. */
  show({ pose }) {
    for (const [name, handle] of this.#handles) {
      handle.at = pose.set[name] ?? handle.rest;
      this.#put(handle);
    }
  }
  /** Another face is shown: its points are others. */
  leave() { this.#clear(); }

  #clear() {
    this.#layer.replaceChildren(), this.#handles.clear();
    this.#feature = this.#dragged = null;
  }
  #add(name, at) {
    const handle = Object.assign(document.createElement('button'), { type: 'button', title: name, at, rest: at });
    handle.setAttribute('aria-label', `${name}; arrow keys move it`);
    handle.onpointerdown = (event) => { event.stopPropagation(), this.#dragged = name; };
    handle.onkeydown = (event) => {
      const by = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] }[event.key];
      if (!by) return;
      event.preventDefault(), event.stopPropagation();
      const { box: [x0, , x1], yUp } = this.#studio.opened.canvas, step = STEP * (x1 - x0);
      this.#move(name, [handle.at[0] + by[0] * step, handle.at[1] + by[1] * step * (yUp ? 1 : -1)]);
    };
    this.#handles.set(name, handle);
    this.#layer.append(handle);
    this.#put(handle);
  }
  #move(name, at) {
    this.#studio.change((before) => withPose(before, 'set', name, at.map((one) => Number(one.toFixed(4)))), name);
  }
  #put(handle) {
    const { box: [x0, y0, x1, y1], yUp } = this.#studio.opened.canvas, [x, y] = handle.at, t = (y - y0) / (y1 - y0);
    Object.assign(handle.style, { left: `${100 * (x - x0) / (x1 - x0)}%`, top: `${100 * (yUp ? 1 - t : t)}%` });
  }
  /** Where the pointer is in the face. */
  #place({ clientX, clientY }) {
    const { box: [x0, y0, x1, y1], yUp } = this.#studio.opened.canvas, area = this.#frame.getBoundingClientRect();
    const t = (clientY - area.top) / area.height;
    return [x0 + (clientX - area.left) / area.width * (x1 - x0), yUp ? y1 - t * (y1 - y0) : y0 + t * (y1 - y0)];
  }
}
