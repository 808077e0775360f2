// What has changed since a face was opened, or since a person was as their code says.

import { patchOf, withSettings } from './patch.js';
import { spelled } from './words.js';

/** What of a pose is in no file: settings by their names, feelings, muscles, the moment of a clip. */
function posed({ emotions, muscles, clip, time }, names) {
  const all = [...Object.keys(emotions), ...Object.keys(muscles), ...names].map((name) => (name.includes('/') ? name : spelled(name)));
  return clip ? [...all, `${spelled(clip)} at ${time} s`] : all;
}

/** { patch, left, of }: the operations; what only the pose has; what the patch is of, as a sentence goes on. */
export function changesOf({ face, pose }, opened) {
  if (!face) return { patch: patchOf(opened.base, opened.recipe), left: posed(pose, Object.keys(pose.set)), of: `the recipe of ${opened.base.code}` };
  const before = JSON.parse(face.text), { file, left } = withSettings(before, pose.set, opened.canvas.mirrorX);
  return { patch: patchOf(before, file), left: posed(pose, left), of: `${face.name} as it was opened` };
}
