// The points of a feature, as handles on the stage: the pointer drags them, and the arrow keys move them. What is dragged
// snaps to lines (snapping.js), unless Alt is down; arrow keys do not snap.

import { drawnPose, withPose } from './document.js';
import { Guides, heldBy } from './guides.js';
import { linesFor, snapped } from './snapping.js';
import { spelled } from './words.js';

const STEP = 0.004;  // of the picture's width, by an arrow key
const NEAR = 6;      // [CSS px] within which a point snaps
const SAME = 0.01;   // of the picture's width, within which points are each other's mirror image

export class Points {
  #studio; #frame; #chosen; #layer; #guides; #handles = new Map(); #dragged = null;
  on = false; snapping = true;
  /** `chosen`: a select of the features that have points, for those who do not click on the picture. */
  constructor(studio, frame, chosen) {
    this.#studio = studio, this.#frame = frame, this.#chosen = chosen;
    chosen.onkeydown = (event) => { if (event.key === 'Enter') event.preventDefault(), this.#layer.querySelector('button')?.focus(); };
    chosen.onchange = () => (chosen.value ? this.#take({ feature: chosen.value }) : this.#clear());
    this.#layer = Object.assign(document.createElement('div'), { className: 'points' });
    this.#layer.setAttribute('role', 'group'), this.#layer.setAttribute('aria-label', 'Points');
    frame.append(this.#layer);
    this.#guides = new Guides(this.#layer);
    window.addEventListener('pointermove', (event) => this.#dragged && this.#drag(event));
    for (const name of ['pointerup', 'pointercancel']) window.addEventListener(name, () => this.#drop());
    for (const name of ['keydown', 'keyup']) window.addEventListener(name, (event) => this.#alt(event));
  }
  turn(on) {
    this.on = on, this.#chosen.hidden = !on;
    if (on) this.#studio.say('Click on what you want to shape, then drag its points.');
    else this.#clear(), this.#studio.say('');
  }
  /** Takes the feature under the pointer. */
  pick(event) {
    const area = this.#frame.getBoundingClientRect();
    return this.#take({ x: (event.clientX - area.left) / area.width, y: (event.clientY - area.top) / area.height });
  }
  async #take(where) {
    const { feature, points } = await this.#studio.desk.ask('points', { ...where, pose: drawnPose(this.#studio.document) });
    this.#clear();
    this.#chosen.value = points.length ? feature : '';
    if (!points.length) return this.#studio.say(feature ? `${spelled(feature)} has no points of its own.` : 'There is nothing.');
    this.#studio.say(`${spelled(feature)}: drag its ${points.length === 1 ? 'point' : `${points.length} points`}.`);
    for (const point of points) this.#add(point);
  }
  /** Another document is shown: handles go to where its points are. */
  show({ pose }) {
    for (const [name, handle] of this.#handles) {
      handle.at = pose.set[name] ?? handle.rest;
      this.#put(handle);
    }
  }
  /** Another face is shown: its points are others. */
  leave({ shaped }) {
    this.#clear();
    this.#chosen.replaceChildren(new Option('Which feature?', ''), ...shaped.map((name) => new Option(spelled(name), name)));
  }

  get #canvas() { return this.#studio.opened.canvas; }
  #clear() {
    for (const { button } of this.#handles.values()) button.remove();
    this.#handles.clear();
    this.#drop();
  }
  #add({ name, at, partner }) {
    const button = Object.assign(document.createElement('button'), { type: 'button', title: name });
    button.setAttribute('aria-label', `${name}; arrow keys move it, Escape leaves it`);
    button.onpointerdown = (event) => { event.stopPropagation(), this.#dragged = { name, event, lines: this.#lines(name) }; };
    button.onkeydown = (event) => this.#key(event, name);
    const handle = { name, button, at, rest: at, partner };
    this.#handles.set(name, handle);
    this.#layer.append(button);
    this.#put(handle);
  }
  #key(event, name) {
    if (event.key === 'Escape') return event.stopPropagation(), this.#chosen.focus();
    const by = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] }[event.key];
    if (!by) return;
    event.preventDefault(), event.stopPropagation();
    const { box: [x0, , x1], yUp } = this.#canvas, step = STEP * (x1 - x0), { at } = this.#handles.get(name);
    this.#move(name, [at[0] + by[0] * step, at[1] + by[1] * step * (yUp ? 1 : -1)]);
    this.#studio.say(`${name}: ${this.#studio.document.pose.set[name].join(', ')}`);
  }

  #drag(event) {
    const { name, lines } = this.#dragged, place = this.#place(event);
    this.#dragged.event = event;
    const { box: [x0, , x1] } = this.#canvas, reach = NEAR * (x1 - x0) / this.#frame.clientWidth;
    const { place: to, held } = this.snapping && !event.altKey ? snapped(place, lines, reach) : { place, held: [] };
    this.#move(name, to);
    this.#guides.show(held, (at) => this.#share(at));
    if (held.length) this.#studio.say(`${name} is held by ${heldBy(held)}.`);
  }
  #drop() {
    this.#dragged = null;
    this.#guides.clear();
  }
  /** Alt that goes down or up while a point is dragged counts at once. */
  #alt(event) {
    if (event.key !== 'Alt' || !this.#dragged) return;
    event.preventDefault();
    const { clientX, clientY } = this.#dragged.event;
    this.#drag({ clientX, clientY, altKey: event.type === 'keydown' });
  }
  /** What a point can snap to, where all others are now. */
  #lines(name) {
    const { partner, at } = this.#handles.get(name), { mirrorX: axis, box: [x0, , x1] } = this.#canvas;
    const list = (of) => of.slice(0, of.lastIndexOf('/')), others = [...this.#handles.values()].filter((one) => one.name !== name);
    const row = [...this.#handles.values()].filter((one) => list(one.name) === list(name));
    const isMirror = (one) => Math.hypot(2 * axis - one.rest[0] - at[0], one.rest[1] - at[1]) < SAME * (x1 - x0);
    const inFeature = others.find(isMirror)?.at, named = partner && (this.#studio.document.pose.set[partner.name] ?? partner.at);
    return linesFor({ axis, partner: named ?? inFeature ?? null, row: row.map((one) => one.at), at: row.findIndex((one) => one.name === name), others: others.map((one) => one.at) });
  }
  #move(name, at) {
    this.#studio.change((before) => withPose(before, 'set', name, at.map((one) => Number(one.toFixed(4)))), name);
  }
  #put({ button, at }) {
    const [x, y] = this.#share(at);
    Object.assign(button.style, { left: `${100 * x}%`, top: `${100 * y}%` });
  }
  /** Where in the picture a place of the face is, from 0 to 1. */
  #share([x, y]) {
    const { box: [x0, y0, x1, y1], yUp } = this.#canvas, t = (y - y0) / (y1 - y0);
    return [(x - x0) / (x1 - x0), yUp ? 1 - t : t];
  }
  /** Where the pointer is in the face. */
  #place({ clientX, clientY }) {
    const { box: [x0, y0, x1, y1], yUp } = this.#canvas, area = this.#frame.getBoundingClientRect();
    const t = (clientY - area.top) / area.height;
    return [x0 + (clientX - area.left) / area.width * (x1 - x0), yUp ? y1 - t * (y1 - y0) : y0 + t * (y1 - y0)];
  }
}
