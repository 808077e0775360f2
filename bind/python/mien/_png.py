"""PNG and APNG (W3C, Portable Network Graphics, third edition): written for notebooks and films, and read where the command wrote it."""
from __future__ import annotations

import struct
import zlib
from typing import Any, Iterable, Optional

import numpy
import numpy.typing

Bytes = numpy.typing.NDArray[numpy.uint8]
_SIGNATURE = b"\x89PNG\r\n\x1a\n"


def _chunk(kind: bytes, data: bytes) -> bytes:
    return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))


def _packed(array: Bytes) -> bytes:
    """Rows, each begun by its filter: 2, the difference to the row above."""
    height, width, _ = array.shape
    rows = numpy.zeros((height, 1 + width * 4), numpy.uint8)
    rows[:, 1:] = array.reshape(height, width * 4)
    rows[1:, 1:] -= array[:-1].reshape(height - 1, width * 4)
    rows[:, 0] = 2
    return zlib.compress(rows.tobytes(), 6)


def _head(array: Bytes) -> bytes:
    height, width, _ = array.shape
    return _SIGNATURE + _chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 6, 0, 0, 0))


def png(array: Bytes) -> bytes:
    """A PNG of RGBA pixels."""
    return _head(array) + _chunk(b"sRGB", b"\0") + _chunk(b"IDAT", _packed(array)) + _chunk(b"IEND", b"")


def apng(frames: Iterable[Bytes], fps: float) -> bytes:
    """An APNG that plays for ever. A frame has the rectangle that changed; one that is as the one before prolongs it."""
    first: Optional[Bytes] = None
    last: Optional[Bytes] = None
    shown: "list[list[Any]]" = []  # x, y, pixels packed, width, height, how many frames it stays
    for frame in frames:
        if first is None:
            first = frame.copy()
        changed = None if last is None else numpy.nonzero((frame != last).any(2))
        if changed is not None and not changed[0].size:
            shown[-1][5] += 1
            continue
        y0, y1, x0, x1 = (0, frame.shape[0], 0, frame.shape[1]) if changed is None else (
            int(changed[0].min()), int(changed[0].max()) + 1, int(changed[1].min()), int(changed[1].max()) + 1)
        shown.append([x0, y0, _packed(numpy.ascontiguousarray(frame[y0:y1, x0:x1])), x1 - x0, y1 - y0, 1])
        last = frame.copy()
    assert first is not None
    return _head(first) + _chunk(b"sRGB", b"\0") + _chunk(b"acTL", struct.pack(">II", len(shown), 0)) + _played(shown, fps) + _chunk(b"IEND", b"")


def _played(shown: "list[list[Any]]", fps: float) -> bytes:
    """The chunks of frames. Each ends at a whole millisecond, so times do not drift."""
    out, sequence, at = [], 0, 0
    for number, (x, y, packed, width, height, stay) in enumerate(shown):
        begin, at = round(1000 * at / fps), at + stay
        delay = min(round(1000 * at / fps) - begin, 65535)
        out.append(_chunk(b"fcTL", struct.pack(">IIIIIHHBB", sequence, width, height, x, y, delay, 1000, 0, 0)))
        sequence += 1
        if number == 0:
            out.append(_chunk(b"IDAT", packed))
        else:
            out.append(_chunk(b"fdAT", struct.pack(">I", sequence) + packed))
            sequence += 1
    return b"".join(out)


def pixels(raw: bytes) -> Bytes:
    """The RGBA pixels of a PNG of 8 bits, RGB or RGBA, as mien writes them."""
    at, packed = len(_SIGNATURE), b""
    width, height, depth, kind = struct.unpack(">IIBB", raw[16:26])
    while at < len(raw):
        size, name = struct.unpack(">I4s", raw[at:at + 8])
        packed += raw[at + 8:at + 8 + size] if name == b"IDAT" else b""
        at += 12 + size
    channels = {2: 3, 6: 4}[kind]
    assert depth == 8
    rows = numpy.frombuffer(zlib.decompress(packed), numpy.uint8).reshape(height, 1 + width * channels)
    found = _unfiltered(rows[:, 0], rows[:, 1:].reshape(height, width, channels))
    if channels == 4:
        return found
    return numpy.concatenate([found, numpy.full((height, width, 1), 255, numpy.uint8)], axis=2)


def _unfiltered(filters: Bytes, rows: Bytes) -> Bytes:
    """A pixel needs those to its left, above it, and above its left: so pixels whose x + y is equal are done at once."""
    height, width, channels = rows.shape
    out = numpy.zeros((height + 1, width + 1, channels), numpy.int16)  # with nothing above and to the left
    kinds = filters.astype(numpy.int16)[:, None]
    for diagonal in range(height + width - 1):
        y = numpy.arange(max(0, diagonal - width + 1), min(height, diagonal + 1))
        x = diagonal - y
        left, above, corner = out[y + 1, x], out[y, x + 1], out[y, x]
        guess = left + above - corner
        to_left, to_above, to_corner = abs(guess - left), abs(guess - above), abs(guess - corner)
        paeth = numpy.where((to_left <= to_above) & (to_left <= to_corner), left, numpy.where(to_above <= to_corner, above, corner))
        kind = kinds[y]
        add = numpy.select([kind == 1, kind == 2, kind == 3, kind == 4], [left, above, (left + above) >> 1, paeth], 0)
        out[y + 1, x + 1] = (rows[y, x] + add) & 255
    return out[1:, 1:].astype(numpy.uint8)
