// What a person looks like, in a sentence for those who do not see her: "a smiling older person with round glasses and long
// black hair". It is told from the recipe and from what the pose feels. A recipe says nothing of being a man or a woman, and
// neither does the sentence; nor does it tell a skin's colour.
//
// A part that no table has is told by its name, so new parts are told, too.

/** Ages up to these [years]. */
const AGES = [[12, 'child'], [19, 'teenager'], [64, 'person'], [Infinity, 'older person']];
const SMILE = 0.3, MOOD = 0.1;  // from where a recipe's own mouth, and the light joy in which it rests, are seen to smile
const FELT = 0.3;  // from where a feeling of the pose is told
const FEELINGS = { joy: 'smiling', sadness: 'sad', anger: 'angry', disgust: 'disgusted', fear: 'frightened', surprise: 'surprised' };

/** Hair that is not "NAME hair": COLOUR stands for its colour. */
const HAIR = {
  afro: 'a COLOUR afro', afro_band: 'a COLOUR afro and a headband', bald: 'a bald head', bangs: 'COLOUR hair with bangs', bantu_knots: 'COLOUR bantu knots',
  bob: 'a COLOUR bob', bob_angled: 'an angled COLOUR bob', box_braids: 'COLOUR box braids', braid: 'a COLOUR braid', braids_two: 'two COLOUR braids',
  bun: 'COLOUR hair in a bun', bun_low: 'COLOUR hair in a low bun', buzz: 'a COLOUR buzz cut', coily_short: 'short coily COLOUR hair', cornrows: 'COLOUR cornrows',
  crop: 'cropped COLOUR hair', curly_long: 'long curly COLOUR hair', curly_short: 'short curly COLOUR hair', curtains: 'parted COLOUR hair', fade: 'a COLOUR fade',
  flat_top: 'a COLOUR flat top', fringe_of_hair: 'a fringe of COLOUR hair around a bald head', layered: 'layered COLOUR hair', locs_long: 'long COLOUR locs',
  locs_short: 'short COLOUR locs', long_side: 'long COLOUR hair over one shoulder', mohawk: 'a COLOUR mohawk', mop: 'a mop of COLOUR hair', mullet: 'a COLOUR mullet',
  pigtails: 'COLOUR pigtails', pixie: 'a COLOUR pixie cut', ponytail: 'a COLOUR ponytail', puffs: 'COLOUR hair in two puffs', quiff: 'a COLOUR quiff',
  receding: 'receding COLOUR hair', shag: 'shaggy COLOUR hair', side_part: 'COLOUR hair parted at the side', side_tail: 'a COLOUR side ponytail',
  slick_back: 'COLOUR hair combed back', spiky: 'spiky COLOUR hair', twists: 'COLOUR twists', undercut: 'a COLOUR undercut',
};
/** Other families: a part's words, or a rule for its name. */
const PARTS = {
  glasses: { big: 'big glasses', sun: 'sunglasses', cat: 'cat-eye glasses', half: 'half-rim glasses', aviator: 'aviator glasses', of: (name) => `${name} glasses` },
  beard: { stubble: 'stubble', shadow: 'a shadow of a beard', chinstrap: 'a chinstrap beard', goatee: 'a goatee', mutton: 'mutton chops', soul_patch: 'a soul patch', van_dyke: 'a van dyke beard', of: (name) => `${article(name)} ${name} beard` },
  moustache: { of: (name) => `${article(name)} ${name} moustache` },
  headwear: { cap_back: 'a cap worn backwards', bucket: 'a bucket hat', sunhat: 'a sun hat', hijab_loose: 'a loose hijab', headphones: 'headphones', of: (name) => `${article(name)} ${name}` },
  aid: { hearing_aid: 'a hearing aid', face_mask: 'a face mask', eye_patch: 'an eye patch', nasal_tube: 'a nasal tube', of: (name) => `${article(name)} ${name}` },
  skin: { acne: null, blush_marks: null, mole: 'a mole', beauty_mark: 'a beauty mark', freckles: 'freckles', scar_brow: 'a scar through a brow', scar_cheek: 'a scar on a cheek', vitiligo: 'vitiligo', vitiligo_mouth: 'vitiligo', of: (name) => `${article(name)} ${name}` },
};
/** Under these no hair is seen. */
const COVERING = ['hijab', 'turban', 'patka'];

const COLORS = { soft_black: 'black', iron: 'iron-grey', pepper: 'grey-flecked' };

const plain = (name) => name.replace(/\.part\.json$/, '').replaceAll('_', ' ');
function article(words) { return /^[aeiou]/.test(words) ? 'an' : 'a'; }

const there = (part) => part !== undefined && part !== null && part !== 'none';

function hairOf({ hair, hair_color, headwear }) {
  if (!there(hair) || COVERING.includes(headwear)) return null;
  const color = hair === 'bald' || !hair_color ? '' : COLORS[hair_color] ?? plain(hair_color);
  const words = (HAIR[hair] ?? `${plain(hair)} COLOUR hair`).replace('COLOUR', color).replace(/\s+/g, ' ').trim();
  return words.replace(/^an? (\w)/, (_, letter) => `${article(letter)} ${letter}`);
}

function partOf(family, name) {
  if (!there(name)) return null;
  const known = PARTS[family];
  return Object.hasOwn(known, name) ? known[name] : known.of(plain(name));
}

/** The strongest feeling of the pose, else the recipe's own. */
function feelingOf(numbers, { emotions }) {
  const felt = Object.entries(emotions ?? {}).map(([name, weight]) => [name.replace(/^(left|right)\./, ''), Number(weight)]);
  const [name, weight] = felt.reduce((most, one) => (one[1] > most[1] ? one : most), ['', 0]);
  if (weight >= FELT) return FEELINGS[name] ?? null;
  return (numbers.smile ?? 0) >= SMILE || (numbers.mood ?? 0) >= MOOD ? 'smiling' : null;
}

const listed = (all) => (all.length < 2 ? all.join('') : `${all.slice(0, -1).join(', ')} and ${all.at(-1)}`);

/** The sentence of a recipe, as JSON's text or what was read of it. Of a face that is no recipe, its name. */
export function describe(recipe, pose = {}) {
  const { format_version, name, title = name, parts = {}, numbers = {} } = typeof recipe === 'string' ? JSON.parse(recipe) : recipe;
  if (format_version !== 2) return title ? `${title}, a drawn face` : 'a drawn face';
  const age = numbers.age ?? 30, who = AGES.find(([most]) => age <= most)[1], feeling = feelingOf(numbers, pose);
  const seen = [partOf('glasses', parts.glasses), hairOf(parts), ...['beard', 'moustache', 'headwear', 'aid', 'skin'].map((family) => partOf(family, parts[family]))].filter(Boolean);
  const first = [feeling, who].filter(Boolean).join(' ');
  return `${article(first)} ${first}${seen.length ? ` with ${listed(seen)}` : ''}`;
}
