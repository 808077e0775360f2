// Names as people read them.

const SPELLED = { 'hair_color': 'Hair colour', 'cloth_color': 'Cloth colour', 'frame_color': 'Frame colour', 'ears': 'Ears', 'skin': 'Skin marks', 'aid': 'Aids', 'jewel': 'Jewellery', 'clothes': 'Clothes', 'gaze.x': 'Gaze, across', 'gaze.y': 'Gaze, up and down', 'yaw': 'Turn', 'pitch': 'Nod', 'roll': 'Tilt', 'bias': 'Where lids meet', 'skin.tone': 'Skin', 'v': 'V-neck', 'tank': 'Tank top', 'crew': 'Crew neck' };

/** "fringe_of_hair" as "Fringe of hair". */
export function spelled(name) {
  if (SPELLED[name]) return SPELLED[name];
  const words = name.replace(/^_/, '').replace(/[._/-]+/g, ' ').replace(/([a-z])([A-Z])/g, '$1 $2').toLowerCase().trim();
  return words.charAt(0).toUpperCase() + words.slice(1);
}

/** A number in as many digits as its range needs. */
export function digits(value, lo, hi) {
  const range = Number.isFinite(hi - lo) ? hi - lo : 1;
  const places = Math.max(0, Math.min(4, 2 - Math.floor(Math.log10(range || 1))));
  return Number(value.toFixed(places)).toString();
}

/** A linear component 0 to 1 as two hexadecimal digits of sRGB. */
const encoded = (c) => Math.round(255 * Math.min(1, Math.max(0, c <= 0.0031308 ? 12.92 * c : 1.055 * c ** (1 / 2.4) - 0.055)));
export const hexOf = (linear) => `#${linear.slice(0, 3).map((c) => encoded(c).toString(16).padStart(2, '0')).join('')}`;
