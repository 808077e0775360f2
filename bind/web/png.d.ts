/** A picture as a PNG file. `strips` yields its rows from the top, as Face.strips does; `told` hears the share done, 0 to 1, and what
 *  it returns is waited for. */
export function png(
  width: number,
  height: number,
  strips: Iterable<{ y: number; rows: number; pixels: Uint8ClampedArray }>,
  told?: (done: number) => unknown,
): Promise<Blob>;
