// node --test package_test.mjs: what the package tells of itself: its name, its types' tables, words for faces, SVG in one call.
import assert from 'node:assert/strict';
import { readFileSync, readdirSync } from 'node:fs';
import test from 'node:test';

const built = new URL(`file://${process.env.MIEN_WEB ?? `${process.cwd()}/build/web/bind/web/package`}/`);
const root = new URL('../../../', import.meta.url);
const read = (name) => readFileSync(new URL(name, built), 'utf8');
const { ATTRIBUTES, meant, propertyOf } = await import(new URL('attributes.js', built));
const { describe } = await import(new URL('describe.js', built));
const { load } = await import(new URL('mien.js', built));
const { svg } = await import(new URL('svg.js', built)), { listen, respond } = await import(new URL('server.js', built));
const mien = await load(readFileSync(new URL('mien.wasm', built)));
const own = JSON.parse(read('package.json'));

test('the package has one name', () => {
  const pages = ['bind/web/README.md', 'bind/web/mien.js', 'bind/web/svg.js', 'README.md', ...readdirSync(new URL('docs', root)).filter((name) => name.endsWith('.md')).map((name) => `docs/${name}`)];
  let said = 0;
  for (const page of pages) {
    for (const [line, name] of readFileSync(new URL(page, root), 'utf8').matchAll(/(?:from|import) '(mien[\w-]*)[/']/g)) assert.equal(name, own.name, `${page}: ${line}`), ++said;
  }
  assert.ok(said > 5);
});

test('the package has every file that it names, and types of every script', () => {
  for (const [entry, to] of Object.entries(own.exports)) {
    for (const file of typeof to === 'string' ? [to] : Object.values(to)) assert.ok(read(file).length > 0, entry);
    if (typeof to !== 'string') assert.ok(to.types, entry);
  }
});

test('names are typed as they are known', () => {
  const names = read('names.d.ts'), listed = (type) => names.match(new RegExp(`type ${type} =([^;]*);`))[1].match(/"[^"]+"/g).map((one) => JSON.parse(one));
  assert.deepEqual(listed('Style'), mien.parts().styles);
  assert.deepEqual(listed('NumberName'), mien.parts().numbers.map(({ name }) => name));
  for (const { name, parts } of mien.parts().families) assert.ok(names.includes(`  "${name}": ${parts.map((part) => `"${part}"`).join(' | ')};\n`), name);
  const face = mien.person(mien.code('somebody else')), words = { Emotion: 'emotions', Muscle: 'muscles', Viseme: 'visemes', Arkit: 'arkit', Facs: 'facs', Vrm: 'vrm', Azure: 'azure' };
  for (const [type, key] of Object.entries(words)) {
    assert.ok(listed(type).length >= 6, type);
    face.vector({ [key]: Object.fromEntries(listed(type).map((name) => [name, 0])) });  // one that is not known is refused
  }
  assert.deepEqual(listed('Clip'), face.clips);
  face.free();
});

test('custom-elements.json has every attribute and its property', () => {
  const { modules: [{ declarations: [element] }] } = JSON.parse(read('custom-elements.json')), types = read('attributes.d.ts');
  assert.deepEqual(element.attributes.map(({ name }) => name), Object.keys(ATTRIBUTES));
  for (const name of Object.keys(ATTRIBUTES)) {
    assert.ok(element.members.some((one) => one.attribute === name && one.name === propertyOf(name)), name);
    assert.ok(types.includes(`set ${propertyOf(name)}(`), name);
  }
  assert.deepEqual(element.events.map(({ name }) => name), ['mien-drawn', 'mien-ended', 'mien-refused']);
});

test('an attribute that is nearly one of ours was meant to be', () => {
  for (const [said, ours] of [['emotoin', 'emotion'], ['emotions', 'emotion'], ['lookat', 'look-at'], ['facestyle', 'face-style'], ['sead', 'seed'], ['backgroud', 'background']]) assert.equal(meant(said), ours);
  for (const other of ['emotion', 'title', 'style', 'class', 'id', 'name', 'size', 'key', 'data-seed', 'aria-label', 'onclick', 'tabindex', 'draggable', 'translate', 'is', '@click', ':seed']) assert.equal(meant(other), null, other);
});

test('what a person looks like is told', () => {
  const parts = { hair: 'curly_long', hair_color: 'auburn', glasses: 'round', beard: null, headwear: 'none' };
  const told = (more = {}, numbers = {}, pose = {}) => describe({ format_version: 2, parts: { ...parts, ...more }, numbers: { age: 30, ...numbers } }, pose);
  assert.equal(told({}, { smile: 0.5 }), 'a smiling person with round glasses and long curly auburn hair');
  assert.equal(told({ glasses: null, hair: 'afro' }, { age: 70 }), 'an older person with an auburn afro');
  assert.equal(told({ glasses: 'sun', headwear: 'hijab' }, {}, { emotions: { anger: 0.9, joy: 0.1 } }), 'an angry person with sunglasses and a hijab');
  assert.equal(told({ hair: 'bald', beard: 'full', glasses: 'none' }, { age: 9 }), 'a child with a bald head and a full beard');
  assert.equal(told({ hair: 'some_new_part', beard: 'odd', glasses: 'none' }), 'a person with some new part auburn hair and an odd beard');
  assert.equal(describe({ format_version: 1, name: 'Toon' }), 'Toon, a drawn face');
  assert.equal(describe({ format_version: 1 }), 'a drawn face');
});

test('every part that may be seen has words, and no sentence has a gap', () => {
  const recipe = JSON.parse(mien.recipe(mien.code('hello'))), families = mien.parts().families;
  for (const { name, parts } of families) {
    for (const part of parts) {
      const said = describe({ ...recipe, parts: { ...recipe.parts, [name]: part } });
      assert.match(said, /^an? [a-z][^_]*[a-z]$/, `${name} ${part}: ${said}`);
      assert.doesNotMatch(said, /undefined|null|COLOUR| {2}|\ba [aeio]/, said);
    }
  }
});

test('a person is an SVG text in one call', async () => {
  const code = 'A66CB-AA5S0-14', text = await svg(code, { width: 72, height: 48 });
  assert.match(text, /^<svg role="img" aria-label="an? [^"]+" [^>]*width="72" height="48"/);
  assert.ok((await svg({ seed: 'ada' }, { width: 72, height: 72 })).length < 40_000);
  assert.notEqual(text, await svg(code, { width: 72, height: 48, pose: { emotions: { joy: 1 } } }));
  assert.notEqual(text, await svg(code, { width: 72, height: 48, style: 'ink' }));
  assert.equal(await svg({ seed: 'ada' }), await svg(mien.code('ada')));
  assert.match(await svg(code, { alt: '"A" & <B>' }), /aria-label="&quot;A&quot; &amp; &lt;B>"/);
  assert.match(await svg(code, { alt: '' }), /^<svg aria-hidden="true" (?!role)/);
  for (const [who, how, sentence] of [['nobody', {}, /nobody/], [code, { widht: 3 }, /did you mean "width"/], [{ sed: 'a' }, {}, /did you mean "seed"/], [{ seed: '' }, {}, /expected a word/], [code, { style: 'inkk' }, /did you mean "ink"/], [code, { pose: { emotion: {} } }, /did you mean "emotions"/]])
    await assert.rejects(svg(who, how), sentence);
});

test('a picture has an address', async () => {
  const server = await listen(0), at = `http://127.0.0.1:${server.address().port}`;
  const got = await fetch(`${at}/svg?seed=ada&width=72&height=72&emotion=joy%3D0.8&blink=0.5`);
  assert.deepEqual([got.status, got.headers.get('Content-Type')], [200, 'image/svg+xml; charset=utf-8']);
  assert.equal(await got.text(), await svg({ seed: 'ada' }, { width: 72, height: 72, pose: { emotions: { joy: '0.8' }, set: { blink: '0.5' } } }));
  for (const [asked, sentence] of [['sead=ada', /did you mean "seed"/], ['seed=ada&width=9999', /1 to 2048/], ['', /expected a word/], ['code=nobody', /nobody/], ['seed=ada&emotion=joyy', /did you mean "joy"/]]) {
    const refused = await fetch(`${at}/svg?${asked}`);
    assert.equal(refused.status, 400, asked);
    assert.match(await refused.text(), sentence);
  }
  assert.equal((await fetch(at)).status, 404);
  assert.equal((await respond({ url: 'http://a/svg?seed=ada', method: 'POST' })).status, 405);
  server.close();
});
