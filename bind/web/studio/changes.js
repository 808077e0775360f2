// What has changed since a face was opened, or since a person was as their code says.

import { patchOf } from './patch.js';
import { spelled } from './words.js';

/** What of a pose is in no file: settings by their names, feelings, muscles, the moment of a clip. */
function posed({ emotions, muscles, clip, time }, names) {
  const all = [...Object.keys(emotions), ...Object.keys(muscles), ...names].map((name) => (name.includes('/') ? name : spelled(name)));
  return clip ? [...all, `${spelled(clip)} at ${time} s`] : all;
}

/** { text, patch, left, of }: the file as it is now, with what the pose sets of it; the operations that make it; what only
 *  the pose has; what the patch is of, as a sentence goes on. `desk`: of a worker that edits the file. */
export async function changesOf({ face, pose }, opened, desk) {
  if (!face) return { text: opened.text, patch: patchOf(opened.base, opened.recipe), left: posed(pose, Object.keys(pose.set)), of: `the recipe of ${opened.base.code}` };
  const { text, left } = await desk.ask('textWith', { ...face, set: pose.set });
  return { text, patch: patchOf(JSON.parse(face.text), JSON.parse(text)), left: posed(pose, left), of: `${face.name} as it was opened` };
}
