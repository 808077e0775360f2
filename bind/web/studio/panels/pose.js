// Head, eyes and what else of a face can be moved; clips.

import { withPose } from '../document.js';
import { slider } from '../slider.js';
import { spelled } from '../words.js';

const HEAD = ['yaw', 'pitch', 'roll'], EYES = ['gaze.x', 'gaze.y', 'blink', 'bias', 'dilation', 'iris_size', 'lid_slant'];
const LONGEST = 12;  // [s] of a clip that can be looked through

export class Pose {
  #studio; #root; #rows = new Map(); #of = null; #clip; #time;
  constructor(root, studio) { this.#studio = studio, this.#root = root; }
  update({ pose }, { names, clips }) {
    const controls = names.filter(({ name, isControl, count, lo, hi }) => isControl && count === 1 && Number.isFinite(hi - lo) && !/^(emotion|muscle|arkit|facs|vrm|viseme)\.|\b(left|right)\b/.test(name));
    const of = JSON.stringify([controls, clips]);
    if (this.#of !== of) this.#of = of, this.#build(controls, clips);
    for (const [name, { set, rest }] of this.#rows) set(pose.set[name] === undefined ? rest : Number(pose.set[name]));
    if (!this.#clip) return;
    this.#clip.value = pose.clip ?? '', this.#time.set(pose.time), this.#time.row.hidden = !pose.clip;
  }
  #build(controls, clips) {
    this.#rows.clear(), this.#root.replaceChildren(), this.#clip = null;
    const of = (title, some) => {
      const found = controls.filter(some);
      if (found.length) this.#root.append(Object.assign(document.createElement('h3'), { textContent: title }), ...found.map((one) => this.#slider(one)));
    };
    of('Head', ({ name }) => HEAD.includes(name));
    of('Eyes', ({ name }) => EYES.includes(name));
    of('More', ({ name, isPose }) => !isPose && !HEAD.includes(name) && !EYES.includes(name));
    of('Poses', ({ isPose }) => isPose);
    if (clips.length) this.#addClips(clips);
  }
  #slider({ name, lo, hi, values: [rest] }) {
    const made = slider({ label: spelled(name), lo, hi, rest, changed: (value) => this.#studio.change((before) => withPose(before, 'set', name, value === rest ? null : value), name) });
    this.#rows.set(name, { ...made, rest });
    return made.row;
  }
  #addClips(clips) {
    const label = document.createElement('label');
    label.className = 'choice';
    label.innerHTML = '<span>Clip</span><select><option value="">None</option></select>';
    this.#clip = label.querySelector('select');
    this.#clip.append(...clips.map((name) => new Option(spelled(name), name)));
    this.#clip.onchange = () => this.#studio.change((before) => ({ ...before, pose: { ...before.pose, clip: this.#clip.value || null } }));
    this.#time = slider({ label: 'Time, in seconds', lo: 0, hi: LONGEST, rest: 0, changed: (time) => this.#studio.change((before) => ({ ...before, pose: { ...before.pose, time } }), 'time') });
    this.#root.append(Object.assign(document.createElement('h3'), { textContent: 'Movement' }), label, this.#time.row);
  }
}
