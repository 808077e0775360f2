#pragma once
// What each standard name must do: standard_moves.json, compiled in.
//
//   {"landmarks": {"chin": "head/points/5", …},
//    "moves": {"arkit.jawOpen": {"says": "the jaw opens", "moves": {"chin": {"down": [0.06, 0.2]}}, "of": ["mouth", "jaw"]}, …}}
//
// A landmark is a point of a face of parts. At strength 1 each landmark of a row goes its ways by lengths within the ranges
// [face widths]: up, down, left and right (the subject's), out and in (from and to the axis); of a width or size: thick
// and thin, as factors. Landmarks of other kinds than the row is "of" stay where they are, bit for bit. A landmark's kind is
// its name's first word.

#include <string_view>

namespace mien {

/// The text of the file.
std::string_view standard_moves();

}  // namespace mien
