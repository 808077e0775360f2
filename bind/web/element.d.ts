import type { MienFaceAttributes } from './attributes.js';
import type { AnyNames, Frame, Names, Pose } from './mien.js';

export type { MienFaceProps } from './attributes.js';

/** What `mien-refused` tells: a place and a sentence. */
export interface Refused {
  where: string;
  what: string;
}

/** What `mien-drawn` tells, once the picture is on the screen: how long drawing it took, without waiting [ms]. */
export interface Drawn {
  ms: number;
}

/** What `mien-ended` tells, once a track is over that the face has spoken without a sound: its address, or null where it was a text
 *  for speak(). */
export interface Ended {
  speech: string | null;
}

export interface MienFaceEvents {
  'mien-drawn': CustomEvent<Drawn>;
  'mien-ended': CustomEvent<Ended>;
  'mien-refused': CustomEvent<Refused>;
}

/** <mien-face>. A property is read as its attribute's text, null where there is none, and null takes it away. Of a file with
 *  names of its own it is a MienFace<AnyNames>. */
export class MienFace<N extends AnyNames = Names> extends MienFaceAttributes<N> {
  /** A pose of more than attributes can say; attributes come on top. With a `time` the page says the moment of clips, and `playing`
   *  does not. */
  get pose(): Pose<N>;
  set pose(pose: Pose<N> | null | undefined);
  /** A track of speech or a take: the text of its file. With a time the face is at that moment [s], and a page asks again for every
   *  one; without one it speaks as by `speech`. The clips of a face that plays go on by their own clock. null: no longer. */
  speak(track: string | null, time?: number): void;
  /** The face as a camera saw an actor's. null: no longer. */
  follow(frame: Frame | null): void;
  redraw(): void;
}

declare global {
  interface HTMLElementTagNameMap {
    'mien-face': MienFace;
  }
  interface HTMLElementEventMap extends MienFaceEvents {}
  /** They bubble: one listener hears all faces. */
  interface DocumentEventMap extends MienFaceEvents {}
  interface WindowEventMap extends MienFaceEvents {}
}
