import type { Frame, Pose } from './mien.js';

/** What `refused` tells: a place and a sentence. */
export interface Refused {
  where: string;
  what: string;
}

/** What `drawn` tells, once the picture is on the screen: how long drawing took [ms]. */
export interface Drawn {
  ms: number;
}

/** <mien-face>. Each property is the attribute of its name (`faceStyle` of `face-style`, `lookAt` of `look-at`): it is read as the
 *  attribute's text, null where there is none, and null takes it away. */
export class MienFace extends HTMLElement {
  get code(): string | null;
  set code(code: string | null | undefined);
  get seed(): string | null;
  set seed(word: string | number | null | undefined);
  get src(): string | null;
  set src(address: string | null | undefined);
  get faceStyle(): string | null;
  set faceStyle(style: string | null | undefined);
  get width(): string | null;
  set width(pixels: number | string | null | undefined);
  get height(): string | null;
  set height(pixels: number | string | null | undefined);
  get emotion(): string | null;
  set emotion(weights: string | Record<string, number> | null | undefined);
  get muscle(): string | null;
  set muscle(weights: string | Record<string, number> | null | undefined);
  get set(): string | null;
  set set(values: string | Record<string, number | string | number[]> | null | undefined);
  get blink(): string | null;
  set blink(share: number | string | null | undefined);
  get lookAt(): string | null;
  set lookAt(point: string | [number, number, number] | null | undefined);
  get clip(): string | null;
  set clip(clips: string | string[] | null | undefined);
  get viseme(): string | null;
  set viseme(weights: string | Record<string, number> | null | undefined);
  get speech(): string | null;
  set speech(address: string | null | undefined);
  get sound(): string | null;
  set sound(id: string | null | undefined);
  get steady(): string | null;
  set steady(filter: string | [number, number] | true | null | undefined);
  get time(): string | null;
  set time(seconds: number | string | null | undefined);
  get playing(): boolean;
  set playing(plays: boolean | null | undefined);
  get blend(): string | null;
  set blend(blend: 'linear' | 'srgb' | null | undefined);
  get background(): string | null;
  set background(color: string | null | undefined);
  get label(): string | null;
  set label(words: string | null | undefined);
  get deadline(): string | null;
  set deadline(milliseconds: number | string | null | undefined);
  /** A pose of more than attributes can say; attributes come on top. */
  get pose(): Pose;
  set pose(pose: Pose | null | undefined);
  speak(track: string | null, time?: number): void;
  follow(frame: Frame | null): void;
  redraw(): void;
}

declare global {
  interface HTMLElementTagNameMap {
    'mien-face': MienFace;
  }
  interface HTMLElementEventMap {
    drawn: CustomEvent<Drawn>;
    refused: CustomEvent<Refused>;
  }
}
