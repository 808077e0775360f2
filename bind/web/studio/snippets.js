// The same picture elsewhere: on the command line, in a page, in programs.
//
// What is drawn: { code, style, pose, background, width, height }. `code` is null for a face that is a file.

import { PACKAGE } from './package_name.js';

const FILE = 'face.face.json', PLAIN = 'soft';

const needsFile = ({ code, style }) => !code || style !== PLAIN;

/** A word of a shell, in quotes where it needs them. */
const shell = (word) => (/^[\w./=,:@+~-]+$/.test(word) && !word.startsWith('~') ? word : `'${word.replaceAll("'", "'\\''")}'`);
const short = (value) => (typeof value === 'number' ? Number(value.toPrecision(6)) : [value].flat().join(','));
const pairs = (all, between = '=') => Object.entries(all).map(([name, value]) => `${name}${between}${short(value)}`);

/** What may be set by name: emotions and muscles are controls, too. */
const settings = ({ emotions, muscles, set }) => [...pairs(emotions).map((one) => `emotion.${one}`), ...pairs(muscles).map((one) => `muscle.${one}`), ...pairs(set)];

export function command(of) {
  const { code, style, pose, background, width, height } = of;
  const words = ['mien', 'render', code ?? FILE];
  if (code && style !== PLAIN) words.push('--style', style);
  for (const one of pairs(pose.emotions)) words.push('--emotion', one);
  for (const one of pairs(pose.muscles)) words.push('--muscle', one);
  for (const one of pairs(pose.set)) words.push('--set', one);
  if (pose.clip) words.push('--clip', pose.clip, '--time', String(short(pose.time)));
  if (background) words.push('--background', background);
  words.push('--size', `${width}x${height}`, '-o', 'face.png');
  return words.map(shell).join(' ');
}

export function html(of) {
  const { code, pose, background, width, height } = of;
  const quoted = (text) => String(text).replaceAll('&', '&amp;').replaceAll('"', '&quot;');
  const attributes = [needsFile(of) ? ['src', FILE] : ['code', code]];
  const list = (name, values, between) => { if (values.length) attributes.push([name, values.join(between)]); };
  list('emotion', pairs(pose.emotions), ', ');
  list('muscle', pairs(pose.muscles), ', ');
  list('set', pairs(pose.set), '; ');
  if (pose.clip) attributes.push(['clip', pose.clip], ['time', short(pose.time)]);
  if (background) attributes.push(['background', background]);
  attributes.push(['width', width], ['height', height]);
  return `<script type="module" src="element.js"></script>\n<mien-face ${attributes.map(([name, value]) => `${name}="${quoted(value)}"`).join(' ')}></mien-face>`;
}

export function javascript(of) {
  const { code, pose, background, width, height } = of;
  const said = { emotions: pose.emotions, muscles: pose.muscles, set: pose.set, clips: pose.clip ? [pose.clip] : [], time: pose.clip ? pose.time : undefined, background: background ?? undefined };
  const kept = Object.fromEntries(Object.entries(said).filter(([, value]) => value !== undefined && Object.keys(Object(value)).length + (typeof value !== 'object') > 0));
  return `import { load } from '${PACKAGE}';

const mien = await load();
const face = ${needsFile(of) ? `mien.face(await (await fetch('${FILE}')).text())` : `mien.person('${code}')`};
const pixels = face.draw(${width}, ${height}, ${JSON.stringify(kept)});`;
}

export function python(of) {
  const { code, pose, background, width, height } = of;
  const dict = (all) => `{${Object.entries(all).map(([name, value]) => `"${name}": ${typeof value === 'number' ? short(value) : JSON.stringify(value)}`).join(', ')}}`;
  const takes = [];
  if (Object.keys(pose.emotions).length) takes.push(`emotions=${dict(pose.emotions)}`);
  if (Object.keys(pose.muscles).length) takes.push(`muscles=${dict(pose.muscles)}`);
  if (Object.keys(pose.set).length) takes.push(`set=${dict(pose.set)}`);
  if (pose.clip) takes.push(`clips=["${pose.clip}"]`, `time=${short(pose.time)}`);
  return `import mien

face = ${needsFile(of) ? `mien.read_face("${FILE}")` : `mien.from_code("${code}")`}
face.pose(${takes.join(', ')}).save("face.png", size=(${width}, ${height})${background ? `, background="${background}"` : ''})`;
}

/** "#rrggbb" or "#rrggbbaa" as linear light and opacity. */
function linear(hex) {
  const parts = hex.slice(1).match(/../g).map((two) => parseInt(two, 16) / 255);
  return [...parts.slice(0, 3).map((c) => (c <= 0.04045 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4)), parts[3] ?? 1].map(short);
}

export function cpp(of) {
  const { code, pose, background, width, height } = of;
  const said = settings(pose), fails = ['face'];
  const lines = ['#include <mien/composed_face.h>', '#include <mien/mien.h>', '#include <mien/write.h>', '', 'int main() {',
    `  const auto face = mien::${needsFile(of) ? `read_face("${FILE}")` : `face_from_code("${code}")`};`, '  if (!face) return 1;', '  mien::Pose pose;'];
  if (said.length) lines.push('  for (const char* text : {', ...said.map((one) => `           ${JSON.stringify(one)},`), '       }) {',
    '    const auto setting = mien::read_setting(*face, text);', '    if (!setting) return 1;', '    pose.settings.push_back(*setting);', '  }');
  if (pose.clip) lines.push(`  const auto clip = mien::read_clip_layer(*face, "${pose.clip}");`, '  if (!clip) return 1;', '  pose.clips = {*clip};', `  pose.time = ${short(pose.time)};`);
  lines.push(`  mien::View view{.width = ${width}, .height = ${height}};`);
  if (background) lines.push(`  view.background = mien::Color{${linear(background).join(', ')}};  // ${background}`);
  lines.push('  const auto image = mien::render(mien::scene_from_face(mien::pose_face(*face, pose)), view);', '  return image && mien::write_image(*image, "face.png") ? 0 : 1;', '}');
  return lines.join('\n');
}

export const LANGUAGES = { 'Command line': command, HTML: html, JavaScript: javascript, Python: python, 'C++': cpp };
export { FILE };
