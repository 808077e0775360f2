import type { Pose } from './mien.js';

/** What a face looks like, in a sentence: of a recipe, as the text of its file or as what was read of that, in a pose. */
export function describe(recipe: string | object, pose?: Pick<Pose, 'emotions'>): string;
