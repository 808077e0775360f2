// Head, eyes and what else of a face can be moved; what has sides, either side by itself, too.

import { withPose } from '../document.js';
import { slider } from '../slider.js';
import { spelled } from '../words.js';
import { SideChips } from './sides.js';

const HEAD = ['yaw', 'pitch', 'roll'], EYES = ['gaze.x', 'gaze.y', 'blink', 'bias', 'dilation', 'iris_size', 'lid_slant'];

/** "gaze.x" as "gaze.left.x". */
const ofSide = (name, side) => (side ? name.replace(/^[^.]+/, (word) => `${word}.${side}`) : name);

/** With a control at a value; null: as it rests. Later ones win, so that of both sides takes back either side's. */
function withControl(document, name, side, value, rest) {
  const own = ofSide(name, side);
  if (side) return withPose(document, 'set', own, value === rest && document.pose.set[name] === undefined ? null : value);
  const alone = ['left', 'right'].reduce((now, one) => withPose(now, 'set', ofSide(name, one), null), document);
  return withPose(alone, 'set', name, value === rest ? null : value);
}

export class Pose {
  #studio; #chips; #place = document.createElement('div'); #rows = new Map(); #of = null;
  constructor(root, studio) {
    this.#studio = studio;
    this.#chips = new SideChips(() => studio.refresh());
    root.append(this.#chips.root, this.#place);
  }
  update({ pose }, { names }) {
    const { side } = this.#chips, all = new Set(names.map(({ name }) => name));
    const whole = names.filter(({ name, isControl, count, lo, hi }) => isControl && count === 1 && Number.isFinite(hi - lo) && !/^(emotion|muscle|arkit|facs|vrm|viseme)\.|\b(left|right)\b/.test(name));
    const sided = whole.filter(({ name }) => all.has(ofSide(name, 'left')) && all.has(ofSide(name, 'right')));
    this.#chips.root.hidden = !sided.length;
    const controls = side ? sided : whole, of = side + JSON.stringify(controls);
    if (this.#of !== of) this.#of = of, this.#build(controls);
    for (const [name, { set, rest }] of this.#rows) set(Number(pose.set[ofSide(name, side)] ?? pose.set[name] ?? rest));
  }
  #build(controls) {
    this.#rows.clear(), this.#place.replaceChildren();
    const of = (title, some) => {
      const found = controls.filter(some);
      if (found.length) this.#place.append(Object.assign(document.createElement('h3'), { textContent: title }), ...found.map((one) => this.#slider(one)));
    };
    of('Head', ({ name }) => HEAD.includes(name));
    of('Eyes', ({ name }) => EYES.includes(name));
    of('More', ({ name, isPose }) => !isPose && !HEAD.includes(name) && !EYES.includes(name));
    of('Poses', ({ isPose }) => isPose);
  }
  #slider({ name, lo, hi, values: [rest] }) {
    const { side } = this.#chips;
    const made = slider({ label: spelled(name), lo, hi, rest, changed: (value) => this.#studio.change((before) => withControl(before, name, side, value, rest), ofSide(name, side)) });
    this.#rows.set(name, { ...made, rest });
    return made.row;
  }
}
