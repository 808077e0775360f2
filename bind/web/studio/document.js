// What is being drawn: { person } (person.js) or { face: { name, text } }, and { pose, background }. A document is never changed: each
// of these functions makes another.
//
//   pose        { emotions: { joy: 0.8 }, muscles: { jaw: 0.3 }, set: { 'gaze.x': 0.02, 'palette/skin': '#ffd94a' }, clip, time }
//   background  null: the face's own; '#rrggbb' or '#rrggbbaa'

export const REST = { emotions: {}, muscles: {}, set: {}, clip: null, time: 0 };

export const ofPerson = (person, before = {}) => ({ person, face: null, pose: poseFor(before), background: before.background ?? null });
export const ofFace = (name, text, before = {}) => ({ person: null, face: { name, text }, pose: REST, background: before.background ?? null });

/** What carries over to another person: everything but colours, points and a file's own clips. */
function poseFor({ pose = REST, person }) {
  const kept = { ...pose, set: Object.fromEntries(Object.entries(pose.set).filter(([name]) => !name.includes('/'))) };
  return person ? kept : { ...kept, clip: null, time: 0 };
}

/** With a value in a group of the pose; null takes it out. */
export function withPose(document, group, name, value) {
  const all = { ...document.pose[group] };
  if (value === null) delete all[name];
  else all[name] = value;
  return { ...document, pose: { ...document.pose, [group]: all } };
}

/** The pose as Face.draw takes it. */
export function drawnPose({ pose, background }, more = {}) {
  const { emotions, muscles, set, clip, time } = pose;
  const drawn = { emotions, muscles, set };
  if (clip) drawn.clips = [clip], drawn.time = time;
  if (background) drawn.background = background;
  return { ...drawn, ...more };
}

/** Whether nothing of the pose differs from rest. */
export const isAtRest = ({ pose }) => !pose.clip && ['emotions', 'muscles', 'set'].every((group) => Object.keys(pose[group]).length === 0);
