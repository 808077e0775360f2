// node --test tests/bind/web: the JavaScript door over mien.wasm, which tools/portable web makes.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import test from 'node:test';

const built = new URL(`file://${process.env.MIEN_WEB ?? `${process.cwd()}/build/web/bind/web/package`}/`);
const { load, MienError, isSupported } = await import(new URL('mien.js', built));
const mien = await load(readFileSync(new URL('mien.wasm', built)));
const text = (name) => readFileSync(new URL(`../../../faces/compat/${name}.face.json`, import.meta.url), 'utf8');

/** The house's fingerprint of bytes, eight at a time (lib/base/fingerprint.h), in hexadecimal digits. */
function hashOf(bytes) {
  const words = new DataView(bytes.slice().buffer);
  let value = 0n;
  for (let i = 0; i < words.byteLength; i += 8) {
    value = BigInt.asUintN(64, (value ^ words.getBigUint64(i, true)) * 0x9e3779b97f4a7c15n);
    value ^= value >> 32n;
  }
  return value.toString(16).padStart(16, '0');
}

test('this system is supported', () => assert.ok(isSupported()));

test('pictures have the bytes of the table for machines without fused multiply-adds', () => {
  const table = readFileSync(new URL('../../portable/picture_hashes.txt', import.meta.url), 'utf8').trim().split('\n').map((line) => line.split(' '));
  assert.ok(table.length > 30);
  const faces = new Map();
  for (const [subject, width, blend, , unfused] of table) {
    if (!faces.has(subject)) faces.set(subject, subject.includes('-') ? mien.person(subject) : mien.face(text(subject), subject));
    const pixels = faces.get(subject).draw(+width, Math.floor(width * 9 / 16), { time: 1.25, blend });
    assert.equal(hashOf(pixels), unfused, `${subject} ${width} ${blend}`);
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

test('names, clips and the canvas are told', () => {
  const face = mien.face(text('toon'));
  assert.ok(face.names.some(({ name, isControl }) => name === 'gaze.x' && isControl));
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

test('what is refused is a sentence with an address', () => {
  assert.throws(() => mien.face('{"format": "mien-fac"}', 'a.json'), (e) => e instanceof MienError && e.where.startsWith('a.json:1') && e.what.length > 5);
  assert.throws(() => mien.person('ZZZZZ-ZZZZZ-ZZ'), MienError);
  const face = mien.face(text('seed0'));
  assert.throws(() => face.draw(64, 36, { set: { 'gaze.z': 1 } }), /did you mean "gaze\.[xy]"/);
  assert.throws(() => face.draw(0, 36), MienError);
  assert.throws(() => face.draw(1 << 20, 1 << 20), MienError);
  assert.equal(face.draw(64, 36).length, 64 * 36 * 4);  // it still draws
  face.free();
});
