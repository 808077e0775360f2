import 'mien-face/react';

export const good = <mien-face seed="ada" width={72} height={72} emotion={{ joy: 0.8 }} lookAt={[0, 0, 9]} className="avatar" playing onmien-drawn={({ detail }) => detail.ms.toFixed()} />;
// @ts-expect-error there is no such attribute
export const bad = <mien-face sead="ada" />;
// @ts-expect-error there is no such feeling
export const worse = <mien-face seed="ada" emotion={{ joyy: 1 }} />;
