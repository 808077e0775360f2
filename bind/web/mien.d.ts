export class MienError extends Error {
  readonly where: string;
  readonly what: string;
  constructor(where: string, what: string);
}

export interface Pose {
  time?: number;
  set?: Record<string, number | string | number[]>;
  emotions?: Record<string, number | string>;
  muscles?: Record<string, number | string>;
  arkit?: Record<string, number | string>;
  facs?: Record<string, number | string>;
  vrm?: Record<string, number | string>;
  visemes?: Record<string, number | string>;
  azure?: Record<string, number | string>;
  clips?: string[];
  motions?: (Motion | string | { motion: Motion | string; weight?: number; begin?: number })[];
  frame?: Frame;
  steady?: { at: number; cutoff?: number; beta?: number };
  seed?: string | number;
  liveliness?: number;
  gestures?: number;
  lookAt?: [number, number, number];
  blend?: 'linear' | 'srgb';
  fit?: 'meet' | 'slice';
  background?: string | [number, number, number, number];
}

/** What a camera saw: shapes by name, a result of MediaPipe's FaceLandmarker, or JSON of either. */
export type Frame = string | object;

export class Motion {
  private constructor();
  readonly length: number;
  readonly channels: string[];
  readonly told: string[];
  value(channel: string, time: number): number;
  free(): void;
}

export interface Name {
  name: string;
  unit: string;
  isControl: boolean;
  isPose: boolean;
  count: number;
  begin: number;
  lo: number;
  hi: number;
  values: number[];
}

export interface Canvas {
  box: [number, number, number, number];
  yUp: boolean;
  mirrorX: number;
  unit: string;
}

export interface Parts {
  families: { name: string; parts: string[] }[];
  numbers: { name: string; lo: number; hi: number; rest: number }[];
  styles: string[];
}

export class Face {
  private constructor();
  readonly title: string;
  readonly credit: string;
  readonly clips: string[];
  readonly clipLengths: Record<string, number>;
  readonly names: Name[];
  readonly canvas: Canvas;
  draw(width: number, height: number, pose?: Pose, how?: { deadline?: number; progress?: (done: number) => boolean | void }): Uint8ClampedArray;
  strips(width: number, height: number, pose?: Pose, most?: number): Generator<{ y: number; rows: number; pixels: Uint8ClampedArray }>;
  svg(width: number, height: number, pose?: Pose, how?: { tolerance?: number; idPrefix?: string; deadline?: number; progress?: (done: number) => boolean | void }): { text: string; simplified: string[] };
  vector(pose?: Pose): number[];
  speak(width: number, height: number, track: Motion | string, time: number, pose?: Pose): Uint8ClampedArray;
  follow(width: number, height: number, frame: Frame, pose?: Pose): Uint8ClampedArray;
  unfollowed(motion: Motion): string[];
  featureAt(x: number, y: number): string | null;
  fromPixel(x: number, y: number): [number, number];
  toPixel(x: number, y: number): [number, number];
  free(): void;
}

export class Mien {
  private constructor();
  readonly version: string;
  face(text: string, name?: string): Face;
  motion(text: string, name?: string): Motion;
  textWith(text: string, set: NonNullable<Pose['set']>, name?: string): { text: string; left: string[] };
  inFull(text: string, name?: string): string;
  pointers(text: string, name?: string): Record<string, string>;
  person(code: string, how?: { style?: string }): Face;
  crowd(word: string, count: number): string[];
  recipe(code: string): string;
  code(word: string): string;
  held(code: string, what: string): string;
  between(one: string, other: string, at: number): string;
  near(code: string, by?: number, word?: string): string;
  parts(): Parts;
}

export function isSupported(): boolean;
export function load(source?: BufferSource | URL | string | Response | Promise<Response> | WebAssembly.Module): Promise<Mien>;
