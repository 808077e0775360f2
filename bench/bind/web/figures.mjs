// node bench/bind/web/figures.mjs: what bind/web/README.md says of sizes and times, measured over the package that
// tools/portable web makes, in headless Chromium.
import { readdirSync, readFileSync } from 'node:fs';
import { loadavg } from 'node:os';
import { join } from 'node:path';
import { brotliCompressSync, gzipSync } from 'node:zlib';
import { browse } from '../../../tests/bind/web/chromium.mjs';
import { serve } from '../../../tests/bind/web/static_server.mjs';

const built = process.env.MIEN_WEB ?? `${process.cwd()}/build/web/bind/web/package`;
const root = new URL('../../../', import.meta.url);

function sizes(what, bytes) {
  console.log(`${what}: ${bytes.length} bytes, ${gzipSync(bytes, { level: 9 }).length} by gzip -9, ${brotliCompressSync(bytes).length} by brotli`);
}
sizes('mien.wasm', readFileSync(join(built, 'mien.wasm')));
const parts = readdirSync(new URL('parts', root), { recursive: true }).filter((name) => name.endsWith('.json'));
sizes('the parts in it', Buffer.from(parts.map((name) => readFileSync(new URL(`parts/${name}`, root), 'utf8')).join('')));
sizes('studio.html', readFileSync(join(built, 'studio.html')));

/** In the page: [ms] of frames of a face, no two alike. */
async function frames(text, width, height, count) {
  const begin = performance.now(), { load } = await import('./mien.js'), mien = await load(), loaded = performance.now();
  const face = mien.face(text), read = performance.now(), took = [];
  for (let i = 0; i < count; ++i) {
    const before = performance.now();
    face.draw(width, height, { time: i / 30 });
    took.push(performance.now() - before);
  }
  const sorted = took.slice(Math.floor(count / 2)).sort((a, b) => a - b);
  return { loaded: loaded - begin, read: read - loaded, first: took[0], best: sorted[0], median: sorted[Math.floor(sorted.length / 2)] };
}

const page = (body) => `<!doctype html><meta charset="utf-8">${body}`;
const element = '<mien-face code="A66CB-AA5S0-14" width="320" height="320"></mien-face>';
const CROWD = 200;
const avatars = Array.from({ length: CROWD }, (_, i) => `<mien-face seed="person ${i}" width="72" height="72"></mien-face>`).join('');
const server = await serve(built, {
  '/crowd.html': page(`<style>body { display: grid; grid-template-columns: repeat(auto-fill, 72px); gap: 4px }</style><script>
    window.told = [];
    addEventListener('mien-drawn', ({ target }) => told.push(performance.now()) && target === window.talker && talker.told.push(performance.now()));
  </script><script type="module" src="element.js"></script>${avatars}`),
  '/bare.html': page(''),
  '/face.html': page(`<script>addEventListener('mien-drawn', () => { window.drawn ??= performance.now(); })</script><script type="module" src="element.js"></script>${element}`),
});
const browser = await browse();
console.log(`${browser.version}; the machine's load ${loadavg()[0].toFixed(1)}`);
const rounded = (all) => Object.entries(all).map(([name, ms]) => `${name} ${ms.toFixed(1)}`).join(', ');
for (const [name, width, height] of [['toon', 640, 360], ['toon', 1920, 1080], ['bruno', 640, 360], ['clay', 640, 360]]) {
  const on = await browser.open(`${server.url}/bare.html`);
  const text = readFileSync(new URL(`faces/compat/${name}.face.json`, root), 'utf8');
  console.log(`${name} ${width} x ${height} [ms]: ${rounded(await on.run(frames, text, width, height, 400))}`);
}
const times = [];
for (let i = 0; i < 5; ++i) {
  const on = await browser.open(`${server.url}/face.html`);
  times.push(await on.until(() => window.drawn));
}
console.log(`the first picture of <mien-face> after the page was asked for [ms]: ${times.map((ms) => ms.toFixed(0)).join(', ')}`);
const crowd = await browser.open(`${server.url}/crowd.html`, { height: 1000 });
await crowd.until((count) => window.told.length >= count, CROWD);
const at = (await crowd.run(() => window.told)).map((ms) => ms.toFixed(0));
console.log(`${CROWD} avatars of 72 px, after the page was asked for [ms]: the first is seen at ${at[0]}, the twentieth at ${at[19]}, all at ${at.at(-1)}`);
/** Of the crowd, for so many seconds: pictures a second; how long the page takes to answer; and how often the one that talks is seen. */
const playing = (seconds) => crowd.run(async (time) => {
  const begin = performance.now(), before = told.length, late = [], since = window.talker?.told.length;
  while (performance.now() - begin < 1000 * time) {
    const asked = performance.now();
    await new Promise((done) => setTimeout(done, 0));
    late.push(performance.now() - asked);
  }
  const waits = window.talker?.told.slice(since).map((at, i, all) => at - all[i - 1]).slice(1).sort((a, b) => a - b) ?? [];
  return [(told.length - before) / time, late.sort((a, b) => a - b).at(-1), waits[Math.floor(0.5 * waits.length)] ?? 0, waits[Math.floor(0.9 * waits.length)] ?? 0];
}, seconds);
await crowd.run(() => { for (const face of document.querySelectorAll('mien-face')) Object.assign(face, { clip: ['idle'], playing: true }); });
await playing(5);  // the browser compiles for speed
const [rate, answer] = await playing(10);
console.log(`all play: ${rate.toFixed(0)} pictures a second; the page answers within ${answer.toFixed(0)} ms`);
await crowd.run((track) => { window.talker = document.querySelector('mien-face'), talker.told = [], talker.speech = URL.createObjectURL(new Blob([track])); },
  Array.from({ length: 300 }, (_, i) => `${i / 5}\t${['PP', 'aa', 'SS', 'O'][i % 4]}\n`).join('') + '60\tsil\n');
const [others, slowest, median, ninth] = await playing(10);
console.log(`one of them talks: it is seen every ${median.toFixed(0)} ms in the median, ${ninth.toFixed(0)} in nine of ten cases; ${others.toFixed(0)} pictures a second in all; the page answers within ${slowest.toFixed(0)} ms`);
await browser.close();
await server.close();

/** Memory and time of a crowd at rest, in node. */
const { instantiate } = WebAssembly;
let memory;  // the module's own
WebAssembly.instantiate = async (...given) => {
  const instance = await instantiate(...given);
  memory = instance.exports.memory;
  return instance;
};
const { load } = await import(`file://${built}/mien.js`), mien = await load(readFileSync(join(built, 'mien.wasm')));
const codes = mien.crowd('figures', 2 * CROWD), cpu = () => { const { user, system } = process.cpuUsage(); return (user + system) / 1000; }, began = cpu(), held = [], counted = [];
for (const half of [codes.slice(0, CROWD), codes.slice(CROWD)]) {
  for (const code of half) held.push(mien.person(code)), held.at(-1).draw(72, 72);
  counted.push(memory.buffer.byteLength);
}
const each = (bytes) => (bytes / CROWD / 1e6).toFixed(2);
console.log(`${CROWD} people at rest, drawn once at 72 px: ${each(counted[0])} MB of mien's memory each, all that it has counted; as many more ${each(counted[1] - counted[0])} MB each; ${((cpu() - began) / codes.length).toFixed(1)} ms of CPU each`);
