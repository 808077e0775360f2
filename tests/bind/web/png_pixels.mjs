// The pixels of a PNG of 8 bits with red, green and blue, with or without alpha: { width, height, pixels } as RGBA.
import { inflateSync } from 'node:zlib';

const FILTERS = [() => 0, (left) => left, (_, above) => above, (left, above) => (left + above) >> 1, (left, above, corner) => {
  const guess = left + above - corner, [a, b, c] = [left, above, corner].map((one) => Math.abs(guess - one));
  return a <= b && a <= c ? left : b <= c ? above : corner;
}];

export function pngPixels(file) {
  const view = new DataView(file.buffer, file.byteOffset, file.length), packed = [];
  const width = view.getUint32(16), height = view.getUint32(20), channels = { 2: 3, 6: 4 }[file[25]];
  if (!channels || file[24] !== 8 || file[28]) throw new Error(`a PNG of another kind: ${file.subarray(24, 29)}`);
  for (let at = 8; at < file.length; at += view.getUint32(at) + 12)
    if (file.toString('latin1', at + 4, at + 8) === 'IDAT') packed.push(file.subarray(at + 8, at + 8 + view.getUint32(at)));
  const bytes = inflateSync(Buffer.concat(packed)), row = width * channels, rows = new Uint8Array(row * height);
  for (let y = 0; y < height; ++y) {
    const predicted = FILTERS[bytes[y * (row + 1)]];
    for (let x = 0; x < row; ++x) {
      const at = y * row + x, left = x >= channels ? rows[at - channels] : 0, above = y ? rows[at - row] : 0, corner = y && x >= channels ? rows[at - row - channels] : 0;
      rows[at] = bytes[y * (row + 1) + 1 + x] + predicted(left, above, corner);
    }
  }
  if (channels === 4) return { width, height, pixels: rows };
  const pixels = new Uint8Array(width * height * 4).fill(255);
  for (let i = 0; i < width * height; ++i) pixels.set(rows.subarray(3 * i, 3 * i + 3), 4 * i);
  return { width, height, pixels };
}
