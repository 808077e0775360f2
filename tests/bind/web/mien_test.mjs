// node --test tests/bind/web: the JavaScript door over mien.wasm, which tools/portable web makes.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import test from 'node:test';
import { pictureHashes } from './picture_hashes.mjs';
import { pngPixels } from './png_pixels.mjs';

const built = new URL(`file://${process.env.MIEN_WEB ?? `${process.cwd()}/build/web/bind/web/package`}/`);
const { load, MienError, isSupported } = await import(new URL('mien.js', built));
const { png } = await import(new URL('png.js', built));
const mien = await load(readFileSync(new URL('mien.wasm', built)));
const text = (name) => readFileSync(new URL(`../../../faces/compat/${name}.face.json`, import.meta.url), 'utf8');

test('this system is supported', () => assert.ok(isSupported()));

test('pictures have the bytes of the table for machines without fused multiply-adds', () => {
  const { lines, of } = pictureHashes();
  assert.ok(lines.length > 30);
  const faces = new Map();
  for (const { subject, width, blend, hash } of lines) {
    if (!faces.has(subject)) faces.set(subject, subject.includes('-') ? mien.person(subject) : mien.face(text(subject), subject));
    const pixels = faces.get(subject).draw(width, Math.floor(width * 9 / 16), { time: 1.25, blend });
    assert.equal(of(pixels), hash, `${subject} ${width} ${blend}`);
  }
  faces.forEach((face) => face.free());
});

test('the same word is the same person, and a held part stays', () => {
  const code = mien.code('hello');
  assert.equal(mien.code('hello'), code);
  assert.notEqual(mien.code('hallo'), code);
  assert.match(mien.recipe(mien.held(code, 'hair=bob')), /"hair": *"bob"/);
  assert.equal(new Set(mien.crowd('x', 5)).size, 5);
});

test('what recipes choose from is told', () => {
  const { families, numbers, styles } = mien.parts();
  assert.equal(families.find(({ name }) => name === 'glasses').parts[0], 'none');
  assert.ok(families.find(({ name }) => name === 'hair').parts.includes('bob'));
  assert.deepEqual(numbers.filter(({ lo, hi, rest }) => !(lo <= rest && rest <= hi && lo < hi)), []);
  assert.ok(styles.includes('ink'));
  assert.throws(() => mien.parts('?'), /edition/);
  const code = mien.code('hello');
  for (const { name, parts } of families) for (const part of parts) mien.held(code, `${name}=${part}`);
  assert.notEqual(mien.near(code, 0.3, 'a'), mien.near(code, 0.3, 'b'));
});

test('a picture in strips is the picture, and so is its PNG', async () => {
  const face = mien.person(mien.code('hello')), pose = { emotions: { joy: 1 }, background: '#ff000080', fit: 'slice' };
  const whole = face.draw(100, 77, pose).slice(), strips = new Uint8ClampedArray(100 * 77 * 4);
  let rows = 0;
  for (const strip of face.strips(100, 77, pose, 10)) strips.set(strip.pixels, strip.y * 400), rows += strip.rows;
  assert.equal(rows, 77);
  assert.deepEqual(strips, whole);
  const file = await png(100, 77, face.strips(100, 77, pose, 10)), read = pngPixels(Buffer.from(await file.arrayBuffer()));
  assert.deepEqual([read.width, read.height], [100, 77]);
  assert.equal(Buffer.compare(Buffer.from(read.pixels), Buffer.from(whole)), 0);
  assert.throws(() => face.draw(100, 77, { background: '#ff' }), MienError);
  assert.deepEqual(face.toPixel(...face.fromPixel(12, 34)).map(Math.round), [12, 34]);
  face.free();
});

test('names, clips and the canvas are told', () => {
  const face = mien.face(text('toon'));
  assert.ok(face.names.some(({ name, isControl }) => name === 'gaze.x' && isControl));
  assert.ok(face.names.every(({ count, values }) => values.length === count));
  const { begin, values } = face.names.find(({ name, isControl }) => !isControl && name.startsWith('palette/'));
  assert.deepEqual(face.vector().slice(begin, begin + values.length), values);
  assert.notDeepEqual(face.vector({ set: { yaw: 20 } }), face.vector());
  assert.ok(face.clips.length > 0);
  assert.equal(face.canvas.box.length, 4);
  face.free();
});

test('poses move the picture, and rest is rest again', () => {
  const face = mien.person(mien.code('hello'));
  const rest = face.draw(64, 64).slice(), joy = face.draw(64, 64, { emotions: { joy: 1 } }).slice();
  assert.notDeepEqual(joy, rest);
  assert.deepEqual(face.draw(64, 64).slice(), rest);
  assert.equal(typeof face.featureAt(32, 32), 'string');
  assert.equal(face.fromPixel(32, 32).length, 2);
  face.free();
});

test('a file is edited in place, and says where its values stand', () => {
  const toon = text('toon'), set = { 'palette/skin': '#88aa66', 'brow.right/spine/0': [-0.1, 0.36], 'gaze.x': 0.01 };
  assert.deepEqual(mien.textWith(toon, {}), { text: toon, left: [] });
  const { text: edited, left } = mien.textWith(toon, set, 'toon.face.json');
  assert.deepEqual(left, ['gaze.x']);
  assert.ok(edited.includes('"#88aa66"'));
  const face = mien.face(edited), { begin } = face.names.find(({ name }) => name === 'brow.right/spine/0');
  assert.deepEqual(face.vector().slice(begin, begin + 2), [-0.1, 0.36]);
  face.free();
  const at = mien.pointers(toon), value = at['head/points/3'].split('/').slice(1).reduce((now, key) => now[key], JSON.parse(toon));
  assert.ok(Array.isArray(value) && !('gaze.x' in at) && at['palette/skin'] === '/palette/skin');
  const full = mien.inFull(mien.recipe('A66CB-AA5S0-14'));
  assert.equal(JSON.parse(full).format_version, 1);
  assert.deepEqual(mien.face(full).draw(64, 64).slice(), mien.person('A66CB-AA5S0-14').draw(64, 64).slice());
  assert.throws(() => mien.inFull(toon), (e) => e instanceof MienError && e.what.includes('in full'));
  assert.throws(() => mien.textWith(toon, { 'palette/skim': '#000000' }), (e) => e instanceof MienError && e.what.includes('palette/skin'));
  assert.throws(() => mien.textWith('{', {}, 'a.json'), (e) => e.where.startsWith('a.json:1'));
});

test('clips have lengths', () => {
  const face = mien.person(mien.code('hello'));
  assert.deepEqual(Object.keys(face.clipLengths), face.clips);
  assert.deepEqual(face.clipLengths, { idle: Infinity, feelings: 12 });
  face.free();
});

test('a face is an SVG file', () => {
  const face = mien.person(mien.code('hello'));
  const { text, simplified } = face.svg(300, 200, { background: '#102030' }, { idPrefix: 'a-' });
  assert.ok(text.startsWith('<svg xmlns="http://www.w3.org/2000/svg" width="300" height="200"') && text.endsWith('</svg>\n'));
  assert.ok(text.includes('<path id="a-') && text.includes('#102030'));
  assert.match(face.svg(30, 20).text, /<path id="m[0-9a-f]{8,10}-/);
  assert.notEqual(face.svg(30, 20).text.match(/id="m\w+-/)[0], face.svg(31, 20).text.match(/id="m\w+-/)[0]);
  assert.ok(simplified.every((one) => one.startsWith('layer "')));
  assert.throws(() => face.svg(300, 200, {}, { tolerance: 7 }), MienError);
  face.free();
});

test('what is refused is a sentence with an address', () => {
  assert.throws(() => mien.face('{"format": "mien-fac"}', 'a.json'), (e) => e instanceof MienError && e.where.startsWith('a.json:1') && e.what.length > 5);
  assert.throws(() => mien.person('ZZZZZ-ZZZZZ-ZZ'), MienError);
  const face = mien.face(text('seed0'));
  assert.throws(() => face.draw(64, 36, { set: { 'gaze.z': 1 } }), /did you mean "gaze\.[xy]"/);
  assert.throws(() => face.draw(0, 36), MienError);
  assert.throws(() => face.draw(64, 36, { emotion: { joy: 1 } }), /no key of a pose named "emotion"; did you mean "emotions"/);
  assert.throws(() => face.draw(64, 36, { yaw: 20 }), /did you mean "set: yaw"/);
  assert.throws(() => face.draw(64, 36, { nonsense: 1 }), (e) => e.what === 'no key of a pose named "nonsense"');
  assert.throws(() => face.draw(64, 36, { fit: 'slize' }), /did you mean "slice"/);
  assert.throws(() => face.draw('72px', 72), /expected a whole number of pixels, got "72px"/);
  assert.throws(() => face.draw(72.5, 72), /whole number of pixels, got 72.5/);
  assert.throws(() => face.draw(1 << 20, 1 << 20), MienError);
  assert.equal(face.draw(64, 36).length, 64 * 36 * 4);  // it still draws
  face.free();
});
