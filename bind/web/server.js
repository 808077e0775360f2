// Pictures by address: GET /svg?seed=ada&width=72&height=72&emotion=joy answers with an SVG file.
//
//   import { respond } from 'mien-face/server';
//   export const GET = respond;                    // where a framework has Requests and Responses
//
// As a program, `npx mien-face --port 6437` serves them, with node alone. Parameters are the element's attributes that a still
// picture can have; what is not known is refused in a sentence.

import { NAMES, poseOf } from './attributes.js';
import { MienError } from './mien.js';
import { loaded, svg } from './svg.js';

const MOVING = ['src', 'playing', 'pausable', 'speech', 'sound', 'steady', 'deadline'], KNOWN = NAMES.filter((name) => !MOVING.includes(name));
const LARGEST = 2048;  // [px]
const DAY = 86400;  // [s]
const DEADLINE = 5000;  // [ms] that one picture may take

function side(text, name) {
  const pixels = Number(text);
  if (!(Number.isInteger(pixels) && pixels > 0 && pixels <= LARGEST)) throw new MienError(name, `expected whole pixels, 1 to ${LARGEST}, got ${JSON.stringify(text.slice(0, 40))}`);
  return pixels;
}

async function picture(asked) {
  const mien = await loaded();
  mien.known('parameters', Object.fromEntries(asked), KNOWN, 'parameter');
  const said = (name) => asked.get(name), who = said('code') ?? { seed: said('seed') ?? '' };
  const size = Object.fromEntries(['width', 'height'].filter((name) => asked.has(name)).map((name) => [name, side(said(name), name)]));
  return svg(who, { ...size, style: said('face-style') ?? undefined, neutral: asked.has('neutral'), alt: said('alt') ?? undefined, pose: poseOf(said), deadline: DEADLINE });
}

/** The answer to a Request. */
export async function respond({ url, method = 'GET' }) {
  const answer = (status, type, text, more = {}) => new Response(text, { status, headers: { 'Content-Type': type, 'X-Content-Type-Options': 'nosniff', 'Access-Control-Allow-Origin': '*', ...more } });
  if (method !== 'GET' && method !== 'HEAD') return answer(405, 'text/plain; charset=utf-8', 'expected GET\n', { Allow: 'GET, HEAD' });
  try {
    const text = await picture(new URL(url).searchParams);
    return answer(200, 'image/svg+xml; charset=utf-8', text, { 'Cache-Control': `public, max-age=${DAY}`, 'Content-Security-Policy': "default-src 'none'; style-src 'unsafe-inline'" });
  } catch (error) {
    if (!(error instanceof MienError)) throw error;
    return answer(400, 'text/plain; charset=utf-8', `${error.message}\n`);
  }
}

/** Serves them to this machine alone. Returns node's server. */
export async function listen(port = 6437, host = '127.0.0.1') {
  const HTTP = 'node:http', { createServer } = await import(/* @vite-ignore */ /* webpackIgnore: true */ HTTP);
  const server = createServer(async ({ url, method }, out) => {
    const { pathname } = new URL(url, 'http://localhost');
    const answer = pathname === '/svg' ? await respond({ url: `http://localhost${url}`, method }).catch(() => new Response('it has failed\n', { status: 500 })) : new Response('expected /svg?seed=WORD or /svg?code=CODE\n', { status: 404 });
    out.writeHead(answer.status, Object.fromEntries(answer.headers)).end(method === 'HEAD' ? '' : await answer.text());
  });
  await new Promise((done, fail) => server.once('error', fail).listen(port, host, done));
  return server;
}
