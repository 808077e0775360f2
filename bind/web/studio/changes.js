// What has changed since a face was opened, or since a person was as their code says.

import { patchOf } from './patch.js';
import { spelled } from './words.js';

/** What of a pose is in no file: settings by their names, feelings, muscles, the moment of a clip. */
function posed({ emotions, muscles, clip, time }, names) {
  const all = [...Object.keys(emotions), ...Object.keys(muscles), ...names].map((name) => (name.includes('/') ? name : spelled(name)));
  return clip ? [...all, `${spelled(clip)} at ${time} s`] : all;
}

/** { text, patch, left, of, lost, full }: the file as it is now, with what the pose sets of it; the operations that make it, or
 *  a person's recipe; what those leave to the pose; what the patch is of, as a sentence goes on; what the file leaves to the
 *  pose; whether a person's file is in full now, since no recipe holds points and single colours. `desk`: of a worker that
 *  edits files. */
export async function changesOf({ face, pose }, opened, desk) {
  if (face) {
    const { text, left } = await desk.ask('textWith', { ...face, set: pose.set });
    return { text, patch: patchOf(JSON.parse(face.text), JSON.parse(text)), left: posed(pose, left), of: `${face.name} as it was opened`, lost: posed(pose, left), full: false };
  }
  const names = Object.keys(pose.set), full = names.some((name) => name.includes('/'));
  const { text, left } = full ? await desk.ask('inFullWith', { text: opened.text, set: pose.set, name: 'face' }) : { text: opened.text, left: names };
  return { text, patch: patchOf(opened.base, opened.recipe), left: posed(pose, names), of: `the recipe of ${opened.base.code}`, lost: posed(pose, left), full };
}
