#pragma once
// Pictures beside each other in one.

#include <mien/image.h>

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace mien::command {

/// Opaque 8-bit pictures of one size in rows of `columns`, `gap` pixels apart and around, on
/// `color`.
Image contact_sheet(const std::vector<Image>& pictures, int columns, int gap,
                    std::array<std::uint8_t, 3> color = {24, 26, 32});

/// An opaque 8-bit picture with a strip below it that holds a word (sdf/from_face/caption.h).
Image captioned(const Image& picture, const std::string& word);

/// Where two opaque 8-bit pictures of one size differ: black where they are equal, then blue, green,
/// yellow, red up to `most` levels and beyond.
Image difference_picture(const Image& a, const Image& b, int most);

/// The largest difference of any channel, and the root mean square over all, in levels.
struct LevelDifference {
  int max = 0;
  double rms = 0;
};
LevelDifference level_difference(const Image& a, const Image& b);

}  // namespace mien::command
