// People: a code, what is held against it, a style, a name: { code, held: { hair: 'bob', age: 61 }, style, name, first }. What
// is not held follows the law: another age has other folds. `first` is the style that a file said. And recipes: all of that
// said in full, as a face file.

/** A number of a code is one of so many steps of its range. */
const STEPS = 1023;
const ROUNDS = 4;

/** The value at the nearest step, which a code can hold. */
export const stepped = ({ lo, hi }, value) => lo + Math.round((value - lo) / (hi - lo) * STEPS) / STEPS * (hi - lo);

/** The person as they were before anything was changed. */
export const beginning = ({ code, name, first = 'soft' }) => ({ code, held: {}, style: first, name });

export const holding = (person, name, value) => ({ ...person, held: { ...person.held, [name]: value } });

/** The part of a recipe's family: a name, "none", or undefined where the recipe says nothing. */
export function partOf(recipe, family) {
  const part = recipe.parts?.[family];
  return part === null ? 'none' : typeof part === 'object' ? part.part : part;
}

/** The recipe with another part, or another number. */
export const withPart = (recipe, family, part) => ({ ...recipe, parts: { ...recipe.parts, [family]: part === 'none' ? null : part } });
export const withNumber = (recipe, name, value) => ({ ...recipe, numbers: { ...recipe.numbers, [name]: value } });

/** A recipe as a face file: an entry a line, for people. */
export const recipeText = (recipe) => `${JSON.stringify(recipe, null, 1)}\n`;

/** { code, recipe } of a person: the code says all of it but the style and the name. */
export function recipeOf(mien, { code, held, style, name }) {
  const whole = Object.entries(held).reduce((now, [field, value]) => mien.held(now, `${field}=${value}`), code);
  const recipe = { ...JSON.parse(mien.recipe(whole)), style };
  return { code: whole, recipe: name ? { ...recipe, name } : recipe };
}

/** What a recipe says otherwise than another, as mien.held takes it. */
function differing(recipe, other, { families, numbers }) {
  const parts = families.map(({ name }) => [name, partOf(recipe, name)]).filter(([name, wanted]) => wanted !== undefined && wanted !== (partOf(other, name) ?? 'none'));
  // What follows from the law is at no step: a number that is the other's is as good as one at its step.
  const far = ({ name, lo, hi }) => recipe.numbers?.[name] !== undefined && [recipe.numbers[name], stepped({ lo, hi }, recipe.numbers[name])].every((one) => Math.abs(one - other.numbers[name]) > 1e-6 * (hi - lo));
  return [...parts.map(([name, part]) => `${name}=${part}`), ...numbers.filter(far).map(({ name }) => `${name}=${recipe.numbers[name]}`)];
}

/** The person of a recipe that came from a file: its code holds every difference, numbers at the nearest step. */
export function personOf(mien, recipe) {
  const lists = mien.parts();
  let code = recipe.code ?? mien.code(recipe.name ?? ''), left;
  // What is held can move what is not, so it may take more than one round.
  for (let round = 0; round < ROUNDS && (left = differing(recipe, JSON.parse(mien.recipe(code)), lists)).length; ++round)
    for (const one of left) code = mien.held(code, one);
  const { style = 'soft', name } = recipe;
  return { code, held: {}, style, name, first: style };
}
