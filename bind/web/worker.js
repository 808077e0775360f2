// Draws faces away from the page's own thread. One worker serves all <mien-face> elements of a page.
//
// Messages in: { id, canvas?, text?, name?, code?, width?, height?, pose?, free? }; what is missing stays as it was.
// Messages out: { id, ms } for a picture that is on its canvas, { id, pixels, width, height, ms } where the page itself
// has to put it there, { id, where, what } for what mien refused.

import { load } from './mien.js';

const mien = load();
const shown = new Map();  // by element: { canvas, context, face, width, height, pose }

function take(of, message) {
  if (message.canvas) of.canvas = message.canvas, of.context = message.canvas.getContext('2d');
  if (message.width) of.width = message.width, of.height = message.height;
  if (message.pose) of.pose = message.pose;
}

function read(of, loaded, message) {
  if (message.text === undefined && message.code === undefined) return;
  const face = message.code === undefined ? loaded.face(message.text, message.name) : loaded.person(message.code);
  of.face?.free();  // the old face stays until the new one is there
  of.face = face;
}

function draw(of, id) {
  if (!of.face || !of.width) return;
  const begin = performance.now(), { width, height } = of;
  const pixels = of.face.draw(width, height, of.pose);
  const ms = performance.now() - begin;
  if (!of.context) return postMessage({ id, pixels: pixels.slice(), width, height, ms });
  if (of.canvas.width !== width || of.canvas.height !== height) of.canvas.width = width, of.canvas.height = height;
  of.context.putImageData(new ImageData(pixels, width, height), 0, 0);
  postMessage({ id, ms });
}

onmessage = async ({ data: message }) => {
  const { id } = message;
  if (message.free) return shown.get(id)?.face?.free(), void shown.delete(id);
  if (!shown.has(id)) shown.set(id, { pose: {} });
  const of = shown.get(id);
  take(of, message);
  try {
    const loaded = await mien;
    if (shown.get(id) !== of) return;  // it left the page meanwhile
    read(of, loaded, message);
    draw(of, id);
  } catch (error) {
    postMessage({ id, where: error.where ?? '', what: error.what ?? String(error) });
  }
};
