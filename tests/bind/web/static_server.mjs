// Serves a folder on the loopback, as the simplest of servers would: files and their types, no headers besides.
import { readFile } from 'node:fs/promises';
import { createServer } from 'node:http';
import { extname, join, normalize } from 'node:path';

const TYPES = { '.html': 'text/html; charset=utf-8', '.js': 'text/javascript', '.mjs': 'text/javascript', '.css': 'text/css', '.json': 'application/json', '.wasm': 'application/wasm', '.svg': 'image/svg+xml' };

/** `changed`: by path, what is served instead of a file: a text, a function of the file's, or null for nothing. `headers` go with
 *  each answer. Returns { url, asked, close() }; `asked` are the paths that were asked for. */
export async function serve(folder, changed = {}, headers = {}) {
  const asked = [];
  const server = createServer(async (request, response) => {
    const path = normalize(new URL(request.url, 'http://localhost').pathname).replace(/\/$/, '/index.html');
    const instead = changed[path];
    asked.push(path);
    try {
      if (instead === null) throw new Error('it is not there');
      const found = typeof instead === 'string' ? instead : await readFile(join(folder, path));
      response.writeHead(200, { 'Content-Type': TYPES[extname(path)] ?? 'application/octet-stream', ...headers });
      response.end(typeof instead === 'function' ? instead(found.toString()) : found);
    } catch {
      response.writeHead(404, headers).end();
    }
  });
  await new Promise((done) => server.listen(0, '127.0.0.1', done));
  server.unref();  // a test that fails before it closes the server ends all the same
  return { url: `http://127.0.0.1:${server.address().port}`, asked, close: () => { server.closeAllConnections(); return new Promise((done) => server.close(done)); } };
}
