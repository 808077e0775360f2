// The table of pictures' hashes that native programs are compared with (tests/portable), for JavaScript.
import { readFileSync } from 'node:fs';

/** { lines, told(subject, width, blend), of(bytes) }: hashes without fused multiply-adds, which WebAssembly has not. */
export function pictureHashes() {
  const text = readFileSync(new URL('../../portable/picture_hashes.txt', import.meta.url), 'utf8');
  const lines = text.trim().split('\n').map((line) => {
    const [subject, width, blend, , hash] = line.split(' ');
    return { subject, width: +width, blend, hash };
  });
  return {
    lines,
    told: (subject, width, blend) => lines.find((one) => one.subject === subject && one.width === width && one.blend === blend).hash,
    of: hashOf,
  };
}

/** The house's fingerprint of bytes, eight at a time (lib/base/fingerprint.h), in hexadecimal digits. */
function hashOf(bytes) {
  const words = new DataView(bytes.slice().buffer);
  let value = 0n;
  for (let i = 0; i < words.byteLength; i += 8) {
    value = BigInt.asUintN(64, (value ^ words.getBigUint64(i, true)) * 0x9e3779b97f4a7c15n);
    value ^= value >> 32n;
  }
  return value.toString(16).padStart(16, '0');
}
