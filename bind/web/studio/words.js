// Names as people read them.

const SPELLED = { 'hair_color': 'Hair colour', 'cloth_color': 'Cloth colour', 'frame_color': 'Frame colour', 'ears': 'Ears', 'skin': 'Skin marks', 'aid': 'Aids', 'jewel': 'Jewellery', 'clothes': 'Clothes', 'gaze.x': 'Gaze, across', 'gaze.y': 'Gaze, up and down', 'yaw': 'Turn', 'pitch': 'Nod', 'roll': 'Tilt', 'bias': 'Where lids meet', 'skin.tone': 'Skin', 'part': 'Parting', 'lip_upper': 'Upper lip', 'lip_lower': 'Lower lip', 'braids_two': 'Two braids', 'bun_low': 'Low bun', 'bob_angled': 'Angled bob', 'v': 'V-neck', 'tank': 'Tank top', 'crew': 'Crew neck' };

/** "fringe_of_hair" as "Fringe of hair", "brow.left" as "Left brow". */
export function spelled(name) {
  if (SPELLED[name]) return SPELLED[name];
  const side = /\.(left|right)(?=\.|$)/.exec(name);
  if (side) return `${first(side[1])} ${first(spelled(name.replace(side[0], '')), 'toLowerCase')}`;
  const words = name.replace(/^_/, '').replace(/[._/-]+/g, ' ').replace(/([a-z])([A-Z])/g, '$1 $2').toLowerCase().trim();
  return first(words);
}
const first = (text, as = 'toUpperCase') => text.charAt(0)[as]() + text.slice(1);

/** Bytes, as people say how large a file is. */
export const fileSize = (bytes) => (bytes < 1e6 ? `${Math.max(1, Math.round(bytes / 1e3))} kB` : `${(bytes / 1e6).toFixed(1)} MB`);

/** A number in as many digits as its range needs. */
export function digits(value, lo, hi) {
  const range = Number.isFinite(hi - lo) ? hi - lo : 1;
  const places = Math.max(0, Math.min(4, 2 - Math.floor(Math.log10(range || 1))));
  return Number(value.toFixed(places)).toString();
}

/** A linear component 0 to 1 as two hexadecimal digits of sRGB. */
const encoded = (c) => Math.round(255 * Math.min(1, Math.max(0, c <= 0.0031308 ? 12.92 * c : 1.055 * c ** (1 / 2.4) - 0.055)));
export const hexOf = (linear) => `#${linear.slice(0, 3).map((c) => encoded(c).toString(16).padStart(2, '0')).join('')}`;
