import type { Pose, Style } from './mien.js';

export interface Picture {
  /** Its sides in pixels (128). */
  width?: number;
  height?: number;
  style?: Style;
  /** Without the smile and the mood that people rest in. */
  neutral?: boolean;
  pose?: Pose;
  /** What a screen reader says; none: what the face looks like; "": nothing, it decorates. */
  alt?: string;
  /** Begins all ids; without one it is made of the picture. */
  idPrefix?: string;
  /** How far, in pixels, paths may leave the outlines: 1e-4 to 1 (0.1). */
  tolerance?: number;
  /** [ms] from now, after which it is refused. */
  deadline?: number;
}

/** The text of an SVG file of a code's person, or of a word's: svg({ seed: 'ada' }). */
export function svg(who: string | { seed: string | number }, how?: Picture): Promise<string>;
