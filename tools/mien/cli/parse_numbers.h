#pragma once
// Values of the options of pca, morph and animate; errors as in values.h.

#include <mien/expected.h>

#include <string_view>

namespace mien::command {

/// A whole number from `least` to `most`.
Expected<long> read_whole(std::string_view option, std::string_view text, long least, long most);

/// A finite number from `least` to `most`.
Expected<double> read_real(std::string_view option, std::string_view text, double least,
                           double most);

/// "0-239" or "17": frames, counted from 0, both ends included.
struct FrameRange {
  long first = 0, last = 0;
  long count() const { return last - first + 1; }
};
inline constexpr long kMostFrames = 10'000'000;
Expected<FrameRange> read_frames(std::string_view text);

/// Frames a second: a number, or a fraction as television has them, "30000/1001".
Expected<double> read_fps(std::string_view text);

}  // namespace mien::command
