// Head, eyes and what else of a face can be moved.

import { withPose } from '../document.js';
import { slider } from '../slider.js';
import { spelled } from '../words.js';

const HEAD = ['yaw', 'pitch', 'roll'], EYES = ['gaze.x', 'gaze.y', 'blink', 'bias', 'dilation', 'iris_size', 'lid_slant'];

export class Pose {
  #studio; #root; #rows = new Map(); #of = null;
  constructor(root, studio) { this.#studio = studio, this.#root = root; }
  update({ pose }, { names }) {
    const controls = names.filter(({ name, isControl, count, lo, hi }) => isControl && count === 1 && Number.isFinite(hi - lo) && !/^(emotion|muscle|arkit|facs|vrm|viseme)\.|\b(left|right)\b/.test(name));
    const of = JSON.stringify(controls);
    if (this.#of !== of) this.#of = of, this.#build(controls);
    for (const [name, { set, rest }] of this.#rows) set(pose.set[name] === undefined ? rest : Number(pose.set[name]));
  }
  #build(controls) {
    this.#rows.clear(), this.#root.replaceChildren();
    const of = (title, some) => {
      const found = controls.filter(some);
      if (found.length) this.#root.append(Object.assign(document.createElement('h3'), { textContent: title }), ...found.map((one) => this.#slider(one)));
    };
    of('Head', ({ name }) => HEAD.includes(name));
    of('Eyes', ({ name }) => EYES.includes(name));
    of('More', ({ name, isPose }) => !isPose && !HEAD.includes(name) && !EYES.includes(name));
    of('Poses', ({ isPose }) => isPose);
  }
  #slider({ name, lo, hi, values: [rest] }) {
    const made = slider({ label: spelled(name), lo, hi, rest, changed: (value) => this.#studio.change((before) => withPose(before, 'set', name, value === rest ? null : value), name) });
    this.#rows.set(name, { ...made, rest });
    return made.row;
  }
}
