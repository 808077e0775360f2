// What is under the pointer: its name while the pointer is there, and where it is changed when it is clicked on.

import { COLORS } from './panels/parts.js';
import { PART_FEATURES } from './part_features.js';
import { spelled } from './words.js';

const STILL = 5;  // [px] a click may move

/** The features that every person has, whatever the parts, by the family that shapes them. */
const OWN_FEATURES = {
  head: 'neck neck_shade neck_hatching cheek smile_fold frown_fold forehead_fold forehead_fold_low chin_shade',
  nose: 'nose_fold nose_fold_low',
  mouth: 'upper_edge lower_edge lip_upper lip_lower lip_light mouth tongue teeth teeth_low teeth_line teeth_edge upper_line lower_line',
  eyes: 'lid opening limbus pupil lid_shade lower_lid upper_lid crease bag crow_0 crow_1 crow_2',
  iris: 'iris',
  lashes: 'lash lash_b lash_c lash_d lash_low_0 lash_low_1 lash_low_2',
};
const FAMILY = new Map([OWN_FEATURES, PART_FEATURES].flatMap(Object.entries).flatMap(([family, names]) => names.split(' ').map((name) => [name, family])));

/** Where a person's feature is changed: { panel, family }; null: no part has it. */
export function placeOf(feature) {
  const family = FAMILY.get(feature.replace(/\.(left|right)$/, ''));
  return family ? { panel: COLORS.includes(family) ? 'Colours' : 'Parts', family } : null;
}

export class Under {
  #studio; #frame; #name; #asking = false; #next = null; #pressed = null;
  constructor(studio, frame) {
    this.#studio = studio, this.#frame = frame;
    this.#name = Object.assign(document.createElement('div'), { className: 'under', hidden: true });
    this.#name.setAttribute('aria-hidden', 'true');  // those who see no pointer have none
    frame.append(this.#name);
    const canvas = frame.querySelector('canvas');
    canvas.addEventListener('pointermove', (event) => event.pointerType !== 'touch' && !event.buttons && this.#hover(event));
    canvas.addEventListener('pointerleave', () => { this.#next = null, this.#name.hidden = true; });
    canvas.addEventListener('pointerdown', (event) => { this.#pressed = event.button === 0 ? [event.clientX, event.clientY] : null; });
    canvas.addEventListener('pointerup', (event) => this.#release(event));
  }
  /** One question at a time: the last place is the one that counts. */
  async #hover(event) {
    this.#next = event;
    if (this.#asking) return;
    this.#asking = true;
    while (this.#next) {
      const at = this.#next;
      const feature = await this.#feature(at);
      if (this.#next === at) this.#next = null, this.#show(feature);
    }
    this.#asking = false;
  }
  #show(feature) {
    this.#name.hidden = !feature;
    if (feature) this.#name.textContent = spelled(feature);
  }
  async #release(event) {
    const [x, y] = this.#pressed ?? [Infinity, 0];
    this.#pressed = null;
    if (this.#studio.shaping || Math.hypot(event.clientX - x, event.clientY - y) > STILL) return;
    const feature = await this.#feature(event);
    if (feature !== undefined) this.#studio.select(feature);
  }
  /** The name; null: there is nothing; undefined: it is not known yet. */
  #feature({ clientX, clientY }) {
    const area = this.#frame.getBoundingClientRect();
    return this.#studio.desk.ask('feature', { x: (clientX - area.left) / area.width, y: (clientY - area.top) / area.height }).catch(() => undefined);
  }
}
