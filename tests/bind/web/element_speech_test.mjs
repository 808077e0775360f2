// node --test element_speech_test.mjs: <mien-face> that speak, in headless Chromium.
import assert from 'node:assert/strict';
import test from 'node:test';
import { ada, AT_AA, AT_END, AT_M, change, drawn, open, sentence, shown, shows, TRACK } from './element_pages.mjs';

test('a face that talks waits for no crowd', async () => {
  const on = await open('talk', { width: 1280, height: 1000 });
  await drawn(on);
  const waits = await on.run(async () => {
    const waits = [];
    for (let i = 0; i < 30; ++i) {
      const before = window.told.length, mine = count('it');
      it.pose = { visemes: { aa: (i % 10) / 10 } };
      while (count('it') === mine) await new Promise((done) => addEventListener('mien-drawn', done, { once: true }));
      waits.push(window.told.slice(before).findIndex(({ id }) => id === 'it'));
    }
    return waits.sort((a, b) => a - b);
  });
  // Several pictures may be shown by one frame: those count, too.
  assert.ok(waits[15] <= 6 && waits[29] <= 20, `it waited for ${waits} others`);
  const others = await on.run(() => window.told.filter(({ id }) => id !== 'it').length);
  assert.ok(others > 20, 'and the crowd does not stand still');
});

test('a track that runs goes before a crowd that plays, and no longer than it runs', async () => {
  const on = await open('talk', { width: 1280, height: 1000 });
  await drawn(on);
  const speak = async (track) => {
    const before = await on.run((speech) => (Object.assign(it, { clip: ['idle'], playing: true, speech }), count('it')), track);
    await drawn(on, 'it', before + 2);  // it has begun
  };
  /** Of the next sixty pictures. */
  const its = () => on.run(async () => {
    const before = window.told.length, mine = count('it');
    while (window.told.length < before + 60) await new Promise((done) => addEventListener('mien-drawn', done, { once: true }));
    return count('it') - mine;
  });
  await speak('long.tsv');
  const talking = await its();
  assert.ok(talking >= 15, `of 60 pictures ${talking} were its own`);
  await speak('hello.tsv');
  await on.run(() => new Promise((done) => setTimeout(done, 3000)));  // it ends long before
  const silent = await its();
  assert.ok(silent <= 4, `of 60 pictures after its track ${silent} were its own`);
  // While it talked, the other worker has read the crowd.
  const [both, first] = await on.run(() => [window.workers, window.askedOf.slice(-100).filter((which) => which === 0).length]);
  assert.ok(both === 1 || (first >= 20 && first <= 80), `of 100 pictures the first worker has drawn ${first}`);
});

test('who waits for the end of a track without a sound is told once', async () => {
  const on = await open('playing');
  await drawn(on);
  const ended = await on.run(async () => {
    const ended = [], begin = performance.now(), speak = async (speech) => {
      const before = count('it');
      it.speech = speech;
      while (count('it') < before + 2) await new Promise((done) => it.addEventListener('mien-drawn', done, { once: true }));
    };
    it.addEventListener('mien-ended', ({ detail }) => ended.push([detail.speech, performance.now() - begin]));
    await speak('long.tsv');  // another one takes its place, and nobody is told of it
    await speak('hello.tsv');
    await new Promise((done) => setTimeout(done, 2500));
    return ended;
  });
  assert.deepEqual(ended.map(([speech]) => speech), ['hello.tsv']);
  assert.ok(ended[0][1] > 1000 * AT_END, `after ${ended[0][1]} ms of a track of ${AT_END} s`);
});

test('a face that has talked has no turns to give back', async () => {
  const on = await open('talk', { width: 1280, height: 1000 });
  await on.until(() => new Set(window.told.map(({ id }) => id)).size > 120);  // both workers have read some
  const [talking, after] = await on.run(async () => {
    const wait = (ms) => new Promise((done) => setTimeout(done, ms)), before = count('it');
    Object.assign(it, { clip: ['idle'], playing: true, speech: 'long.tsv' });
    await wait(4000);
    it.speech = null;
    await wait(200);
    const then = count('it');
    await wait(2500);
    return [then - before, count('it') - then];
  });
  assert.ok(talking > 40 && after > 0, `of ${talking} pictures while it talked, ${after} came afterwards`);
});

test('a track rests with its face, and tells its end when it has been spoken', async () => {
  const on = await open('playing');
  await drawn(on, 'it', 2);
  const [resting, ended, of] = await on.run(async (track) => {
    const wait = (ms) => new Promise((done) => setTimeout(done, ms)), ended = [];
    it.addEventListener('mien-ended', ({ detail }) => ended.push([detail.speech, performance.now()]));
    it.speak(track);
    await wait(300);
    it.playing = false;
    await wait(1500);
    const resting = ended.length, again = performance.now();
    it.playing = true;
    await wait(1500);
    return [resting, ended.map(([, at]) => at - again), ended.map(([of]) => of)];
  }, TRACK);
  assert.equal(resting, 0);
  assert.deepEqual(of, [null]);
  assert.ok(ended[0] > 800 && ended[0] < 1450, `it ended ${ended[0]} ms after it went on`);
});

test('a track ends for those who want less motion, too', async () => {
  const on = await open('playing');
  await drawn(on);
  await on.send('Emulation.setEmulatedMedia', { features: [{ name: 'prefers-reduced-motion', value: 'reduce' }] });
  const [after, drawings] = await on.run(async (track) => {
    await new Promise((done) => setTimeout(done, 300));
    const begin = performance.now(), before = count('it');
    it.speak(track);
    await new Promise((done) => it.addEventListener('mien-ended', done, { once: true }));
    return [performance.now() - begin, count('it') - before];
  }, TRACK);
  assert.ok(after > 1000 && after < 4000, `it ended after ${after} ms`);
  assert.ok(drawings <= 2, `${drawings} pictures of a face at rest`);
});

test('a face that plays lives by its own clock while it speaks, and while its sound waits', async () => {
  const on = await open('speech');
  await on.run(() => { voice.currentTime = 0.2, it.clip = ['idle'], it.playing = true; });
  const moment = () => on.run(() => (window.posed.motions ? [window.posed.time, window.posed.time - window.posed.motions[0].begin] : null));
  await on.until(() => window.posed?.time > 0 && window.posed.motions);
  const [then, mouth] = await moment();
  await on.until((since) => window.posed.time > since + 0.5, then);
  const [, later] = await moment();
  assert.ok(Math.abs(mouth - 0.2) < 1e-9 && Math.abs(later - 0.2) < 1e-9, `the mouth is at ${mouth}, then at ${later}`);
  await on.run((track) => { it.sound = it.speech = null, it.speak(track, 0.4); }, TRACK);
  await on.until(() => Math.abs(window.posed.time - window.posed.motions?.[0].begin - 0.4) < 1e-9);
  await on.run(() => { it.speak(null), it.pose = { time: 7 }; });
  await on.until(() => window.posed.time === 7);  // who says the moment is heard, even of a face that plays
});

test('speech follows its sound, its time or a shape', async () => {
  const on = await open('speech');
  const at = (time) => ada({ motions: [TRACK], time });
  await drawn(on);
  for (const time of [AT_M, AT_AA]) {
    await on.run((to) => { voice.currentTime = to; }, time);
    await shows(on, at(time));
  }
  assert.notDeepEqual(at(AT_M), at(AT_AA));
  const before = await on.run(() => count('it'));
  await on.run(() => { voice.currentTime = 0; return voice.play(); });
  await drawn(on, 'it', before + 4);
  await on.until(() => voice.ended);
  await on.run(() => { it.sound = null, it.time = 0.5; });
  await shows(on, at(AT_AA));
  await on.run(() => { it.speech = null, it.time = null, it.viseme = { aa: 1, PP: 0.5 }; });
  await shows(on, ada({ visemes: { aa: 1, PP: 0.5 } }));
  await on.run(() => { refused.length = 0, it.speech = 'nothing.tsv'; });
  assert.deepEqual(await sentence(on), { id: 'it', where: 'nothing.tsv', what: 'cannot be fetched: 404' });
  await on.run(() => { refused.length = 0, it.sound = 'no one'; });
  assert.deepEqual(await sentence(on), { id: 'it', where: 'sound', what: 'nothing here has the id "no one"' });
});

test('without a sound speech begins when it is set, on a face that plays', async () => {
  const on = await open('playing'), begun = () => on.run(async () => {
    const before = count('it'), since = window.posed.time;
    it.speech = 'hello.tsv';
    while (count('it') < before + 3) await new Promise((done) => addEventListener('mien-drawn', done, { once: true }));
    return { since, begin: window.posed.motions?.[0].begin, time: window.posed.time };
  });
  await on.until(() => window.posed?.time > 0.6);
  const first = await begun();
  assert.ok(first.begin >= first.since && first.begin < first.time, `set at ${first.since}, it begins at ${first.begin} where ${first.time} is now`);
  await on.until((from) => window.posed.time > from + 0.6, first.begin);
  const again = await begun();
  assert.ok(again.begin >= again.since, 'again when it is set again');
  await on.run(() => { it.speech = null; });
  await on.until(() => window.posed.motions === undefined);
});

test('a face that speaks and follows by methods shows that', async () => {
  const on = await open('ada');
  await drawn(on);
  await change(on, (track) => it.speak(track, 0.2), TRACK);
  await shows(on, ada({ motions: [TRACK], time: AT_M }));
  const seen = { faceBlendshapes: [{ categories: [{ categoryName: '_neutral', score: 0.9 }, { categoryName: 'jawOpen', score: 0.7 }] }] };
  await change(on, (result) => it.follow(result), seen);
  await shows(on, ada({ arkit: { jawOpen: 0.7 } }));
  await change(on, () => it.follow(null));
  await shows(on, ada());
});
