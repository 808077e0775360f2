// node --test studio_test.mjs: the studio in headless Chromium, over the package that tools/portable web makes.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { resolve } from 'node:path';
import test, { after, afterEach } from 'node:test';
import { built, click, code, CODE, drop, nameless, picture, root, show, slide, studioPages } from './studio_page.mjs';

const { browser, open, close } = await studioPages();
afterEach(() => browser.closePages());
after(close);

test('somebody by the code of the address is shown at the pixels of the display', async () => {
  const on = await open({ dots: 2 });
  assert.equal(await code(on), CODE);
  await picture(on);
  const [shown, room] = await on.run(() => { const canvas = document.querySelector('.frame canvas'); return [canvas.width, canvas.clientWidth]; });
  assert.ok(Math.abs(shown - 2 * room) <= 2, `${shown} ${room}`);
  assert.deepEqual(on.faults, []);
});

test('a wrong code of the address is said, and somebody is there all the same', async () => {
  const on = await open({}, 'AF5C2-938BM-JY');
  assert.match(await on.until(() => document.getElementById('said').textContent), /AF5C2-938BM-JY/);
  assert.ok(await picture(on));
});

test('parts change the face and its code; undo and redo go back and forth', async () => {
  const on = await open();
  const before = await picture(on);
  await show(on, 'Parts');
  await on.run(() => [...document.querySelectorAll('.parts .chip')].find((one) => one.textContent === 'Glasses').click());
  await on.until(() => document.querySelectorAll('.parts .thumb').length > 3);
  await on.run(() => [...document.querySelectorAll('.parts .thumb')].find((one) => one.title === 'Cat').click());
  const after = await picture(on);
  assert.notEqual(after, before);
  assert.match(await code(on), /^AF5C2-938BM-..~/);
  assert.equal(await on.run(() => document.querySelector('.parts .thumb[aria-pressed=true]').title), 'Cat');
  await on.press('z', 'KeyZ', 2);
  assert.equal(await picture(on), before);
  assert.equal(await code(on), CODE);
  await on.press('z', 'KeyZ', 2 | 8);
  assert.equal(await picture(on), after);
  assert.deepEqual(on.faults, []);
});

test('a slider that is dragged is one step, and its code says the face', async () => {
  const on = await open();
  const before = await picture(on);
  await show(on, 'Shape');
  for (const age of [40, 60, 80]) await slide(on, 'shape', 'Age', age);
  const old = await picture(on);
  assert.notEqual(old, before);
  const held = await code(on);
  await click(on, '#undo');
  assert.equal(await picture(on), before);
  const other = await open({}, held);
  assert.equal(await picture(other), old);
});

test('feelings, muscles and the pose move the face; at rest it is as before', async () => {
  const on = await open();
  const rest = await picture(on);
  const seen = new Set([rest]);
  const moves = [['Feelings', 'feelings', 'Joy', 1], ['Muscles', 'muscles', 'Jaw', 1], ['Pose', 'pose', 'Turn', 20], ['Pose', 'pose', 'Blink', 1]];
  for (const [tab, panel, label, value] of moves) {
    await show(on, tab);
    await slide(on, panel, label, value);
    seen.add(await picture(on));
  }
  assert.equal(seen.size, moves.length + 1);
  await click(on, '#rest');
  assert.equal(await picture(on), rest);
  assert.deepEqual(on.faults, []);
});

test('either eye winks, and both sides are set together again', async () => {
  const on = await open(), seen = new Set([await picture(on)]);
  const side = (name) => on.run((which) => document.querySelector(`.pose .chip[data-side="${which}"]`).click(), name);
  const blink = () => on.run(() => [...document.querySelectorAll('.pose .slider')].find((one) => one.querySelector('label').textContent === 'Blink').querySelector('.field').value);
  await show(on, 'Pose');
  for (const [which, value] of [['left', 1], ['right', 1], ['', 0.4], ['left', 0]]) {
    await side(which);
    await slide(on, 'pose', 'Blink', value);
    seen.add(await picture(on));
  }
  assert.equal(seen.size, 5);
  for (const [which, value] of [['left', '0'], ['right', '0.4'], ['', '0.4']]) {
    await side(which);
    assert.equal(await blink(), value, which);
  }
  await slide(on, 'pose', 'Blink', 0);
  assert.ok(await on.run(() => document.getElementById('rest').disabled));
  assert.deepEqual(on.faults, []);
});

test('what is chosen is seen: in rows of colours, and on a chip under the pointer', async () => {
  const on = await open({}, 'A66CB-AA5S0-14');
  await show(on, 'Colours');
  const hidden = await on.run(() => [...document.querySelectorAll('.colours .row')].filter((row) => {
    const { left, right } = row.getBoundingClientRect(), one = row.querySelector('[aria-pressed=true]')?.getBoundingClientRect();
    return one && (one.left < left || one.right > right);
  }).map((row) => row.getAttribute('aria-label')));
  assert.deepEqual(hidden, []);
  await show(on, 'Parts');
  const chip = () => on.run(() => { const one = document.querySelector('.parts .chip[aria-pressed=true]'), { x, y, width, height } = one.getBoundingClientRect(), { color, backgroundColor } = getComputedStyle(one); return { at: [x + width / 2, y + height / 2], look: [color, backgroundColor], over: one.matches(':hover') }; });
  const { at, look } = await chip();
  await on.move([at, [at[0] + 1, at[1]]]);
  const { look: under, over } = await chip();
  assert.ok(over);
  assert.deepEqual(under, look);
});

test('names are as people say them', async () => {
  const { fileSize, spelled } = await import(new URL('bind/web/studio/words.js', root));
  for (const [name, said] of [['fringe_of_hair', 'Fringe of hair'], ['brow.left', 'Left brow'], ['gaze.right.x', 'Right gaze, across'], ['left.joy', 'Left joy'], ['lip_upper.right', 'Right upper lip'], ['palette', 'Palette']]) assert.equal(spelled(name), said);
  assert.deepEqual([12, 46_340, 999_999, 1_250_000].map(fileSize), ['1 kB', '46 kB', '1000 kB', '1.3 MB']);
});

test('the head is turned by dragging and by the arrow keys', async () => {
  const on = await open();
  const rest = await picture(on);
  const middle = await on.run(() => { const { x, y, width, height } = document.querySelector('.frame').getBoundingClientRect(); return [x + width / 2, y + height / 2]; });
  await on.move([middle, [middle[0] + 60, middle[1]], [middle[0] + 120, middle[1]]], true);
  await on.run(() => document.getElementById('follow').click());  // the eyes would be on the pointer
  const turned = await picture(on);
  assert.notEqual(turned, rest);
  await on.run(() => document.querySelector('.frame canvas').focus());
  await on.press('Home');
  assert.equal(await picture(on), rest);
  await on.press('ArrowLeft');
  assert.notEqual(await picture(on), rest);
});

test('the eyes follow the pointer', async () => {
  const on = await open();
  const rest = await picture(on);
  await on.move([[40, 200], [30, 200]]);
  const left = await picture(on);
  assert.notEqual(left, rest);
  await on.move([[1200, 200], [1210, 700]]);
  assert.notEqual(await picture(on), left);
  await click(on, '#follow');
  assert.equal(await picture(on), rest);
});

test('a clip has its own glances, wherever the pointer is', async () => {
  const on = await open();
  await on.run(() => { const clip = document.querySelector('[data-for=clip]'); clip.value = 'idle', clip.dispatchEvent(new Event('change')); });
  const seen = await picture(on);
  await on.move([[40, 200], [30, 200]]);
  assert.equal(await picture(on), seen);
  await click(on, '#rest');
  assert.notEqual(await picture(on), seen);
});

test('points of a feature are dragged, and go by the arrow keys', async () => {
  const on = await open();
  await click(on, '#follow');  // the eyes would be on the pointer
  const rest = await picture(on);
  await click(on, '#points');
  const middle = await on.run(() => { const { x, y, width, height } = document.querySelector('.frame').getBoundingClientRect(); return [x + width / 2, y + height * 0.5]; });
  await on.move([middle], true);
  await on.until(() => document.querySelectorAll('.points button').length > 2);
  const [name, from] = await on.run(() => { const one = [...document.querySelectorAll('.points button')].sort((a, b) => parseFloat(b.style.top) - parseFloat(a.style.top))[0], { x, y } = one.getBoundingClientRect(); return [one.title, [x + 7, y + 7]]; });
  await on.move([from, [from[0] + 25, from[1] + 15]], true);
  const dragged = await picture(on);
  assert.notEqual(dragged, rest);
  await on.run((title) => [...document.querySelectorAll('.points button')].find((one) => one.title === title).focus(), name);
  await on.press('ArrowDown');
  assert.notEqual(await picture(on), dragged);
  await on.run(() => { document.getElementById('points').click(), document.getElementById('rest').click(); });
  assert.equal(await on.run(() => document.querySelectorAll('.points button').length), 0);
  assert.equal(await picture(on), rest);
  assert.deepEqual(on.faults, []);
});

test('what is under the pointer is named, and a click shows where it is changed', async () => {
  const on = await open();
  await click(on, '#follow');  // nothing but the pointer moves
  await picture(on);
  const frame = await on.run(() => { const { x, y, width, height } = document.querySelector('.frame').getBoundingClientRect(); return [x, y, width, height]; });
  const at = (x, y) => [frame[0] + frame[2] * x, frame[1] + frame[3] * y];
  const under = () => on.run(() => { const { hidden, textContent } = document.querySelector('.under'); return hidden ? '' : textContent; });
  const named = new Map();
  for (let y = 0.3; y < 0.8; y += 0.02) {
    await on.move([at(0.5, y)]);
    await on.run(() => new Promise((done) => setTimeout(done, 60)));
    named.set(await under(), at(0.5, y));
  }
  const mouth = [...named.keys()].find((name) => /^(Mouth|(Left |Right )?(upper|lower) lip|Upper line|Lower line|Teeth|Upper edge|Lower edge)/i.test(name));
  assert.ok(mouth, [...named.keys()].join());
  await on.move([named.get(mouth)], true);
  assert.match(await on.until(() => document.getElementById('said').textContent), new RegExp(`^${mouth}: Parts, Mouth$`));
  assert.equal(await on.run(() => document.querySelector('[role=tab][aria-selected=true]').textContent), 'Parts');
  assert.equal(await on.run(() => document.querySelector('.parts .chip[aria-pressed=true]').textContent), 'Mouth');
  await on.move([[5, 5]]);
  await on.until(() => document.querySelector('.under').hidden);
  assert.equal(await code(on), CODE, 'a click changes nothing');
  assert.deepEqual(on.faults, []);
});

test('a word is a person, and the same word the same one', async () => {
  const on = await open();
  await on.run(() => { document.querySelector('.people input').value = 'hello', document.querySelector('.people form').requestSubmit(); });
  await on.until((before) => document.getElementById('code').value !== before, CODE);
  assert.match(await code(on), /^A/);
  assert.equal(await on.run(() => location.hash.slice(1)), await code(on));
  await on.until(() => document.querySelectorAll('.people canvas[data-drawn]').length >= 12 + 4 + 5);
  assert.equal(await on.run(() => document.querySelectorAll('.people canvas[data-refused]').length), 0);
});

test('a file of one\'s own is opened; a broken one is a sentence with its place, and the face stays', async () => {
  const on = await open();
  const before = await picture(on);
  await drop(on, 'mine.face.json', '{"format": "mien-face",\n "format_version": 1, "canvas": 3}');
  assert.match(await on.until(() => document.getElementById('said').textContent), /mine\.face\.json:2/);
  assert.equal(await picture(on), before);
  await drop(on, 'toon.face.json', readFileSync(new URL('faces/compat/toon.face.json', root), 'utf8'));
  await on.until((code) => document.getElementById('code').value !== code, CODE);
  assert.notEqual(await picture(on), before);
  await drop(on, 'otto.face.json', JSON.stringify({ format: 'mien-face', format_version: 2, name: 'otto', parts: { hair: 'bob', glasses: 'round' }, numbers: { age: 76.123 }, style: 'ink' }));
  await on.until(() => document.getElementById('code').value.startsWith('A'));
  await show(on, 'Parts');
  await on.run(() => [...document.querySelectorAll('.parts .chip')].find((one) => one.textContent === 'Hair').click());
  assert.equal(await on.run(() => document.querySelector('.parts .thumb[aria-pressed=true]').title), 'Bob');
  await drop(on, 'toon.face.json', readFileSync(new URL('faces/compat/toon.face.json', root), 'utf8'));
  await on.until(() => !document.getElementById('code').value.startsWith('A'));
  await picture(on);
  const wide = await on.run(() => { const canvas = document.querySelector('.frame canvas'); return canvas.width / canvas.height; });
  assert.ok(Math.abs(wide - 16 / 9) < 0.02, `${wide}`);
  for (const tab of ['Parts', 'Shape', 'Colours', 'Feelings', 'Muscles', 'Pose']) await show(on, tab);
  assert.deepEqual(on.faults, []);
});

test('tabs take the arrow keys, and every control has a name', async () => {
  const on = await open();
  await on.run(() => document.getElementById('tab-People').focus());
  await on.press('ArrowRight');
  assert.equal(await on.run(() => document.activeElement.id), 'tab-Parts');
  await on.press('ArrowLeft'), await on.press('ArrowLeft');
  assert.equal(await on.run(() => document.querySelector('[role=tab][aria-selected=true]').textContent), 'Pose');
  for (const tab of ['People', 'Parts', 'Shape', 'Colours', 'Feelings', 'Muscles', 'Pose']) await show(on, tab);
  assert.ok(await on.run(() => document.querySelectorAll('button, input, select').length) > 30);
  assert.deepEqual(await nameless(on), []);
});

test('the studio in one page opens from a disk', async () => {
  const on = await browser.open(`file://${resolve(built)}/studio.html#${CODE}`);
  await on.until(() => document.documentElement.dataset.ready === '');
  const other = await open();
  assert.equal(await code(on), CODE);
  assert.equal(await picture(other), await (await on.send('Page.bringToFront'), picture(on)));
  await on.until(() => document.querySelectorAll('.people canvas[data-drawn]').length >= 12 + 4 + 5);
  assert.deepEqual(on.faults, []);
});

test('nothing is wider than the page, at any width', async () => {
  for (const [width, height] of [[1440, 900], [1024, 700], [390, 844], [320, 568]]) {
    const on = await open({ width, height });
    for (const tab of ['People', 'Parts', 'Shape', 'Colours', 'Feelings', 'Pose']) {
      await show(on, tab);
      assert.deepEqual(await on.run(() => [document.documentElement.scrollWidth <= innerWidth, document.documentElement.scrollHeight <= innerHeight]), [true, true], `${tab} at ${width}`);
    }
  }
});
