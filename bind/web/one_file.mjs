// node one_file.mjs FOLDER: the package's studio as one page, FOLDER/studio.html, which a browser opens from a disk, where
// pages may load no modules, workers or WebAssembly. All files are in it; the page makes addresses of them when it opens.
import { readFileSync, writeFileSync } from 'node:fs';
import { dirname, join, normalize } from 'node:path/posix';
import { gzipSync } from 'node:zlib';

const folder = process.argv[2];
const FIRST = 'studio/studio.js';
const NAMED = /(?<=\bfrom |\bimport\(|\bnew URL\()'(\.\.?\/[^']+\.(?:js|json))'/g;  // './x.js' as modules name each other
const TYPES = { js: 'text/javascript', json: 'application/json' };

/** Files in an order in which each stands after those it names. */
const files = new Map();
function add(name) {
  if (files.has(name)) return;
  const type = TYPES[name.split('.').at(-1)], text = readFileSync(join(folder, name), 'utf8');
  const whole = (found) => normalize(join(dirname(name), found));
  if (type === TYPES.js) for (const found of text.matchAll(NAMED)) add(whole(found[1]));
  files.set(name, { type, text: type === TYPES.js ? text.replace(NAMED, (_, found) => `'file:${whole(found)}'`) : text });
}
add(FIRST);

/** Runs in the page: makes an address of each file, then loads the first one. Addresses hold the file itself (data:), since
 *  a worker of a page from a disk is a stranger to it and gets nothing else. mien.wasm is too long for an address: the
 *  studio hands it to its workers. */
async function begin(files, first, packed) {
  const addresses = {};
  const whole = (text) => text.replace(/'file:([^']+)'/g, (_, named) => `'${addresses[named]}'`);
  for (const [name, { type, text }] of files) addresses[name] = `data:${type},${encodeURIComponent(whole(text)).replaceAll("'", '%27')}`;
  const bytes = Uint8Array.from(atob(packed), (letter) => letter.charCodeAt(0));
  globalThis.mienWasm = await new Response(new Blob([bytes]).stream().pipeThrough(new DecompressionStream('gzip'))).arrayBuffer();
  await import(addresses[first]);
}

const inScript = (value) => JSON.stringify(value).replaceAll('<', '\\u003c');
const wasm = gzipSync(readFileSync(join(folder, 'mien.wasm')), { level: 9 }).toString('base64');
const page = readFileSync(join(folder, 'studio/index.html'), 'utf8')
  .replace(/<link rel="stylesheet" href="([^"]+)">/, (_, name) => `<style>\n${readFileSync(join(folder, 'studio', name), 'utf8')}</style>`)
  .replace(/<script type="module"[^>]*><\/script>/, () => `<script>\n(${begin})(${inScript([...files])}, ${inScript(FIRST)}, '${wasm}');\n</script>`);
if (!page.includes('mienWasm') || page.includes('studio.css')) throw new Error('studio/index.html is not as one_file.mjs knows it');
writeFileSync(join(folder, 'studio.html'), page);
