// A picture as a PNG file of 8 bits, straight alpha, packed by the browser's own zlib: the bytes of the picture, which a
// canvas with transparency would not keep.
//
//   const blob = await png(640, 360, face.strips(640, 360, pose));

const SIGNATURE = [137, 80, 78, 71, 13, 10, 26, 10], RGBA = 6, UP = 2;

const TABLE = Uint32Array.from({ length: 256 }, (_, n) => {
  for (let k = 0; k < 8; ++k) n = n & 1 ? 0xedb88320 ^ (n >>> 1) : n >>> 1;
  return n;
});

function crc(bytes, from) {
  let c = 0xffffffff;
  for (let i = from; i < bytes.length; ++i) c = TABLE[(c ^ bytes[i]) & 255] ^ (c >>> 8);
  return ~c >>> 0;
}

/** Length, type, data, and a sum over the two. */
function chunk(type, data) {
  const bytes = new Uint8Array(data.length + 12), view = new DataView(bytes.buffer);
  view.setUint32(0, data.length);
  for (let i = 0; i < 4; ++i) bytes[4 + i] = type.charCodeAt(i);
  bytes.set(data, 8);
  view.setUint32(bytes.length - 4, crc(bytes.subarray(0, -4), 4));
  return bytes;
}

function header(width, height) {
  const data = new Uint8Array(13), view = new DataView(data.buffer);
  view.setUint32(0, width), view.setUint32(4, height);
  data[8] = 8, data[9] = RGBA;
  return chunk('IHDR', data);
}

/** Rows as the file has them: each with the difference to the row above. `above` is the last row of the strip before. */
function filtered(pixels, width, rows, above) {
  const bytes = width * 4, out = new Uint8Array((bytes + 1) * rows);
  for (let y = 0, to = 0; y < rows; ++y) {
    const from = y * bytes;
    out[to++] = UP;
    for (let x = 0; x < bytes; ++x) out[to++] = pixels[from + x] - (y ? pixels[from + x - bytes] : above[x]);
  }
  return out;
}

/** A Blob of type image/png. `strips` yields { y, rows, pixels } from the top, as Face.strips does; `told` hears the share
 *  that is done, 0 to 1, and what it returns is waited for. */
export async function png(width, height, strips, told = () => {}) {
  const packer = new CompressionStream('deflate'), writer = packer.writable.getWriter();
  const parts = [Uint8Array.from(SIGNATURE), header(width, height)];
  const packed = (async () => {
    for (const reader = packer.readable.getReader(); ;) {
      const { done, value } = await reader.read();
      if (done) return;
      parts.push(chunk('IDAT', value));
    }
  })();
  packed.catch(() => {});  // the writer hears of it, too
  let above = new Uint8Array(width * 4);
  for (const { y, rows, pixels } of strips) {
    const bytes = filtered(pixels, width, rows, above);
    above = pixels.slice((rows - 1) * width * 4);
    await writer.write(bytes);
    await told((y + rows) / height);
  }
  await writer.close();
  await packed;
  parts.push(chunk('IEND', new Uint8Array(0)));
  return new Blob(parts, { type: 'image/png' });
}
