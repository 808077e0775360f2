// node --test tests/bind/web: the JavaScript door over mien.wasm, which tools/portable web makes.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import test from 'node:test';
import { pictureHashes } from './picture_hashes.mjs';
import { pngPixels } from './png_pixels.mjs';
import { spikyFace } from './spiky_face.mjs';

const built = new URL(`file://${process.env.MIEN_WEB ?? `${process.cwd()}/build/web/bind/web/package`}/`);
const { load, MienError, isSupported } = await import(new URL('mien.js', built));
const { png } = await import(new URL('png.js', built));
const { instantiate } = WebAssembly;
let memory;  // the module's own
WebAssembly.instantiate = async (...given) => {
  const instance = await instantiate(...given);
  memory = instance.exports.memory;
  return instance;
};
const mien = await load(readFileSync(new URL('mien.wasm', built)));
const text = (name) => readFileSync(new URL(`../../../faces/compat/${name}.face.json`, import.meta.url), 'utf8');

test('this system is supported', () => assert.ok(isSupported()));

test('mien.wasm is found beside mien.js', async () => assert.equal((await load()).version, mien.version));

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
  const smiling = mien.held(code, 'smile=0.9'), calm = mien.neutral(smiling);
  assert.notEqual(calm, smiling);
  assert.equal(mien.neutral(calm), calm);
  assert.doesNotMatch(mien.recipe(calm), /"smile": 0\.[1-9]/);
});

test('people have a time of their own, and without liveliness none', () => {
  const code = mien.code('hello'), face = mien.person(code), drawn = (pose) => Buffer.from(face.draw(64, 64, pose)).toString('hex');
  assert.equal(drawn({ time: 1.25 }), drawn({ time: 1.25, seed: code }));
  assert.notEqual(drawn({ time: 1.25 }), drawn({ time: 1.25, seed: 'hallo' }));
  assert.equal(drawn({ time: 1.25, seed: 7 }), drawn({ time: 1.25, seed: '7' }));
  assert.equal(drawn({}), drawn({ time: 1.25, liveliness: 0 }));
  assert.throws(() => drawn({ seed: '' }), /an empty word is no seed/);
  assert.throws(() => drawn({ liveliness: 3 }), /goes from 0 to 2, got 3/);
  face.free();
});

test('what recipes choose from is told', () => {
  const { families, numbers, styles } = mien.parts();
  assert.equal(families.find(({ name }) => name === 'glasses').parts[0], 'none');
  assert.ok(families.find(({ name }) => name === 'hair').parts.includes('bob'));
  assert.deepEqual(numbers.filter(({ lo, hi, rest }) => !(lo <= rest && rest <= hi && lo < hi)), []);
  assert.ok(styles.includes('ink'));
  const code = mien.code('hello');
  for (const { name, parts } of families) for (const part of parts) mien.held(code, `${name}=${part}`);
  assert.notEqual(mien.near(code, 0.3, 'a'), mien.near(code, 0.3, 'b'));
});

test('a picture in strips is the picture, and so is its PNG', async () => {
  const face = mien.person(mien.code('hello')), pose = { emotions: { joy: 1 }, background: '#ff000080', fit: 'slice' };
  const whole = face.draw(100, 77, pose), strips = new Uint8ClampedArray(100 * 77 * 4);
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
  const rest = face.draw(64, 64), joy = face.draw(64, 64, { emotions: { joy: 1 } });
  assert.notDeepEqual(joy, rest);
  assert.deepEqual(face.draw(64, 64), rest);
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
  assert.deepEqual(mien.face(full).draw(64, 64), mien.person('A66CB-AA5S0-14').draw(64, 64));
  assert.throws(() => mien.inFull(toon), (e) => e instanceof MienError && e.what.includes('in full'));
  assert.throws(() => mien.textWith(toon, { 'palette/skim': '#000000' }), (e) => e instanceof MienError && e.what.includes('palette/skin'));
  assert.throws(() => mien.textWith('{', {}, 'a.json'), (e) => e.where.startsWith('a.json:1'));
});

test('faces at rest hold no drawing memory', async () => {
  const fresh = await load(readFileSync(new URL('mien.wasm', built))), codes = fresh.crowd('memory', 150), each = () => memory.buffer.byteLength / codes.length;
  const faces = codes.map((code) => {
    const face = fresh.person(code);
    face.draw(72, 72);
    return face;
  });
  assert.ok(each() < 800_000, `${each()} bytes a face, all that mien holds counted`);
  for (const face of faces) face.draw(72, 72, { emotions: { joy: 1 } });
  assert.ok(each() < 1_500_000, `${each()} bytes a face that has moved`);
});

test('a long drawing ends at its deadline and when its progress asks for it, and others go on', () => {
  const spikes = mien.face(spikyFace()), ada = mien.person(mien.code('ada')), before = Buffer.from(ada.draw(72, 72)).toString('hex');
  for (const [size, how, wanted, most] of [[64, { deadline: 100 }, /cancelled/, 100], [256, { deadline: 1 }, /cancelled/, 1], [1024, { progress: () => false }, /cancelled/, 0],
    [256, { deadline: 1e6, progress() { throw new RangeError('enough'); } }, /enough/, 0]]) {
    const begun = performance.now();
    assert.throws(() => spikes.draw(size, size, {}, how), wanted);
    assert.ok(performance.now() - begun < most + 500, `${size}: ${performance.now() - begun} ms`);
  }
  let shares = [];
  ada.draw(300, 300, {}, { deadline: 1e5, progress: (done) => void shares.push(done) });
  assert.deepEqual(shares, [...shares].sort((a, b) => a - b));
  assert.equal(Buffer.from(ada.draw(72, 72)).toString('hex'), before);
  spikes.free(), ada.free();
});

test('what a face says of its last picture does not change when others draw', () => {
  const faces = mien.crowd('desk', 12).map((code) => mien.person(code)), alone = [];
  const told = (face) => [face.featureAt(40, 30), face.featureAt(32, 60), ...face.fromPixel(12, 34), ...face.toPixel(0, 0)];
  for (const [i, face] of faces.entries()) face.draw(64, 64, { set: { yaw: i } }), alone.push(told(face));
  assert.deepEqual(faces.map(told), alone);
  const again = faces.map((face, i) => face.draw(64, 64, { set: { yaw: -i }, time: 1, clips: ['idle'] }));
  faces.slice(0, 6).forEach((face) => face.free());
  for (const [i, face] of faces.entries()) if (i >= 6) assert.deepEqual(face.draw(64, 64, { set: { yaw: -i }, time: 1, clips: ['idle'] }), again[i]);
  faces.slice(6).forEach((face) => face.free());
});

test('a person has another style', () => {
  const code = mien.code('hello'), draw = (face) => { const pixels = face.draw(48, 48); face.free(); return pixels; };
  const own = draw(mien.person(code)), styles = mien.parts().styles.map((style) => draw(mien.person(code, { style })));
  assert.equal(styles.filter((one) => Buffer.compare(Buffer.from(one), Buffer.from(own)) === 0).length, 1);
  assert.throws(() => mien.person(code, { style: 'inkk' }), /did you mean "ink"/);
  assert.throws(() => mien.person(code, { stile: 'ink' }), (e) => e.where === 'person.stile' && e.what.includes('"style"'));
});

test('what a pose does not know is refused', () => {
  const face = mien.person(mien.code('hello'));
  const refused = (pose, where, what) => assert.throws(() => face.draw(48, 48, pose), (e) => e instanceof MienError && e.where === where && what.test(e.what), `${where}: ${what}`);
  refused({ emotion: { joy: 1 } }, 'pose.emotion', /did you mean "emotions"/);
  refused({ lookat: [0, 0, 9] }, 'pose.lookat', /did you mean "lookAt"/);
  refused({ viseme: { aa: 1 } }, 'pose.viseme', /did you mean "visemes"/);
  refused({ [`x${'y'.repeat(1e6)}`]: 1 }, `pose.x${'y'.repeat(39)}`, /^no key of a pose named/);
  refused({ emotions: 'joy' }, 'pose.emotions', /expected weights by name.*got "joy"/);
  refused({ clips: 'idle' }, 'pose.clips', /expected a list/);
  refused({ fit: 'Slice' }, 'pose.fit', /'meet' or 'slice'/);
  refused({ blend: 'sRGB' }, 'pose.blend', /'linear' or 'srgb'/);
  refused({ time: '1' }, 'pose.time', /expected seconds/);
  refused({ lookAt: [1, 2] }, 'pose.lookAt', /3 numbers/);
  refused({ background: [1, 0, 0] }, 'pose.background', /#rrggbb/);
  refused(null, 'pose', /expected an object/);
  assert.throws(() => face.draw('48px', 48), (e) => e.where === 'width' && /whole pixels, got "48px"/.test(e.what));
  assert.throws(() => face.svg(48, 48, {}, { tolerence: 0.1 }), /did you mean "tolerance"/);
  face.draw(48, 48, { emotions: null, time: undefined, lookAt: new Float32Array([0, 0, 9]) });
  face.free();
});

test('the element is imported where there is no page', async () => {
  const { MienFace } = await import(new URL('element.js', built));
  assert.equal(typeof MienFace, 'function');
  assert.ok(MienFace.observedAttributes.includes('face-style'));
});

test('clips have lengths', () => {
  const face = mien.person(mien.code('hello'));
  assert.deepEqual(Object.keys(face.clipLengths), face.clips);
  assert.deepEqual(face.clipLengths, { idle: Infinity, feelings: 12 });
  face.free();
});

const TRACK = '0\tsil\n0.2\tm\n0.4\tɑː\n0.8\t\n';

test('faces speak and follow', () => {
  const face = mien.person(mien.code('hello')), track = mien.motion(TRACK, 'track.tsv');
  assert.ok(track.length > 0.8 && track.channels.includes('viseme.PP'));
  assert.equal(track.value('viseme.PP', 0.3), 1);
  assert.deepEqual(track.told, []);
  assert.deepEqual(face.unfollowed(track), []);
  const rest = face.draw(32, 32, { time: 0.3 }), closed = face.speak(32, 32, track, 0.3), open = face.speak(32, 32, TRACK, 0.6);
  assert.notDeepEqual(closed, open);
  assert.notDeepEqual(rest, open);
  assert.deepEqual(face.draw(32, 32, { time: 0.6, clips: ['idle'], motions: [{ motion: track }] }), open);
  const result = { faceBlendshapes: [{ categories: [{ categoryName: '_neutral', score: 0.1 }, { categoryName: 'jawOpen', score: 0.5 }] }] };
  const followed = face.follow(32, 32, result).slice();
  assert.deepEqual(face.draw(32, 32, { arkit: { jawOpen: 0.5 } }), followed);
  const steady = (jaw, at, more) => face.follow(32, 32, { jawOpen: jaw }, { steady: { at, ...more } }).slice();
  assert.deepEqual(steady(0.5, 7), followed);
  assert.notDeepEqual(steady(0, 7.03), face.follow(32, 32, { jawOpen: 0 }).slice());
  assert.deepEqual(steady(0.5, 7.06, { cutoff: 3 }), followed, 'another filter begins again');
  assert.throws(() => steady(0, 8, { cutoff: -1 }), /cutoff/);
  assert.throws(() => face.draw(32, 32, { frame: {}, steady: {} }), /pose\.steady: expected a frame/);
  assert.throws(() => mien.motion('hello'), /motion:1: is no take/);
  assert.throws(() => face.draw(32, 32, { motions: 'a' }), /pose\.motions: expected a list/);
  track.free(), face.free();
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
  assert.throws(() => face.draw(64, 36, { yaw: 20 }), /did you mean "set: yaw"/);
  assert.throws(() => face.draw(64, 36, { nonsense: 1 }), (e) => e.what === 'no key of a pose named "nonsense"');
  assert.throws(() => face.draw(72.5, 72), /whole pixels, got 72.5/);
  assert.throws(() => face.draw(1 << 20, 1 << 20), MienError);
  assert.equal(face.draw(64, 36).length, 64 * 36 * 4);  // it still draws
  face.free();
});
