/** @jsxImportSource solid-js */
import 'mien-face/solid';

export const good = <mien-face seed="ada" width={72} height={72} emotion={{ joy: 0.8 }} look-at="0, 0, 9" on:mien-drawn={({ detail }) => detail.ms.toFixed()} />;
// @ts-expect-error there is no such attribute
export const bad = <mien-face sead="ada" />;
