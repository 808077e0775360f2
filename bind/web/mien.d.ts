import type { Arkit, Azure, Clip, Emotion, Facs, Family, Muscle, NumberName, Setting, Style, Viseme, Vrm } from './names.js';

export type * from './names.js';

export class MienError extends Error {
  readonly where: string;
  readonly what: string;
  constructor(where: string, what: string);
}

/** What people's faces know by name. */
export interface Names {
  emotions: Emotion;
  muscles: Muscle;
  arkit: Arkit;
  facs: Facs;
  vrm: Vrm;
  visemes: Viseme;
  azure: Azure;
  clips: Clip;
  set: Setting;
}
/** What the faces of files may know: names of their own. */
export type AnyNames = { [set in keyof Names]: string };

export type Weights<K extends string> = { [name in K]?: number | string };
/** Values by name: of controls, and of a face's own points and colours, "brow.left/spine/1" or "palette/skin". */
export type Values<K extends string> = { [name in K]?: number | string } & { [name in `${string}/${string}`]?: number | string | number[] };

export interface Pose<N extends AnyNames = Names> {
  time?: number;
  set?: Values<N['set']>;
  emotions?: Weights<N['emotions']>;
  muscles?: Weights<N['muscles']>;
  arkit?: Weights<N['arkit']>;
  facs?: Weights<N['facs']>;
  vrm?: Weights<N['vrm']>;
  visemes?: Weights<N['visemes']>;
  azure?: Weights<N['azure']>;
  clips?: (N['clips'] | `${N['clips']}=${number}`)[];
  motions?: (Motion | string | { motion: Motion | string; weight?: number; begin?: number })[];
  frame?: Frame;
  steady?: { at: number; cutoff?: number; beta?: number };
  seed?: string | number;
  liveliness?: number;
  gestures?: number;
  lookAt?: [number, number, number];
  blend?: 'linear' | 'srgb';
  fit?: 'meet' | 'slice';
  legible?: number;
  background?: string | [number, number, number, number];
}

/** How long work may take. */
export interface Watch {
  /** [ms] from now, after which it ends. */
  deadline?: number;
  /** Called about every 10 ms with the share done; false ends it. */
  progress?: (done: number) => boolean | void;
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
  families: { name: Family; parts: string[] }[];
  numbers: { name: NumberName; lo: number; hi: number; rest: number }[];
  styles: Style[];
}

export class Face<N extends AnyNames = Names> {
  private constructor();
  readonly title: string;
  readonly credit: string;
  readonly clips: N['clips'][];
  readonly clipLengths: Record<N['clips'], number>;
  readonly names: Name[];
  readonly canvas: Canvas;
  draw(width: number, height: number, pose?: Pose<N>, how?: Watch): Uint8ClampedArray;
  strips(width: number, height: number, pose?: Pose<N>, most?: number): Generator<{ y: number; rows: number; pixels: Uint8ClampedArray }>;
  svg(width: number, height: number, pose?: Pose<N>, how?: Watch & { tolerance?: number; idPrefix?: string }): { text: string; simplified: string[] };
  vector(pose?: Pose<N>): number[];
  speak(width: number, height: number, track: Motion | string, time: number, pose?: Pose<N>): Uint8ClampedArray;
  follow(width: number, height: number, frame: Frame, pose?: Pose<N>): Uint8ClampedArray;
  unfollowed(motion: Motion): string[];
  featureAt(x: number, y: number): string | null;
  fromPixel(x: number, y: number): [number, number];
  toPixel(x: number, y: number): [number, number];
  free(): void;
}

export class Mien {
  private constructor();
  readonly version: string;
  face(text: string, name?: string): Face<AnyNames>;
  motion(text: string, name?: string): Motion;
  textWith(text: string, set: Values<string>, name?: string): { text: string; left: string[] };
  inFull(text: string, name?: string): string;
  pointers(text: string, name?: string): Record<string, string>;
  person(code: string, how?: { style?: Style }): Face;
  crowd(word: string, count: number): string[];
  recipe(code: string): string;
  code(word: string): string;
  held(code: string, what: string): string;
  neutral(code: string): string;
  between(one: string, other: string, at: number): string;
  near(code: string, by?: number, word?: string): string;
  parts(): Parts;
}

export type Source = BufferSource | URL | string | Response | Promise<Response> | WebAssembly.Module;
export function isSupported(): boolean;
export function compile(source?: Source): Promise<WebAssembly.Module>;
export function load(source?: Source): Promise<Mien>;
