#pragma once
// Option values: from text to numbers, or to an error where they make no sense. Its `where` is the option
// with its value: "--size 0x5".

#include <mien/color.h>
#include <mien/expected.h>
#include <mien/view.h>

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace mien::command {

/// "1920x1080"; or "1920": the longer side, the other by `aspect` (width over height).
struct Size {
  int width, height;
};
Expected<Size> read_size(std::string_view text, double aspect);

/// "X,Y,W,H" in whole pixels, inside a picture of that size.
Expected<PixelRect> read_region(std::string_view text, Size picture);

/// "#rrggbb", "#rrggbbaa", the same without "#", or "transparent".
Expected<Color> read_background(std::string_view text);

/// "X,Y,Z": finite, Z > 0.
Expected<glm::dvec3> read_light(std::string_view text);

/// A number from 0 to 1, for an option of that name.
Expected<double> read_share(std::string_view option, std::string_view text);

/// Seconds: any finite number.
Expected<double> read_time(std::string_view text);

/// 0 (as many as there are) … kMostThreads.
inline constexpr int kMostThreads = 1024;
Expected<int> read_threads(std::string_view text);

/// 1 … kMostRepeats frames.
inline constexpr int kMostRepeats = 1'000'000;
Expected<int> read_repeat(std::string_view text);

/// A number of bytes, perhaps with K, M, G or T (powers of 1024).
Expected<std::uint64_t> read_memory(std::string_view text);

/// A number of steps of work.
Expected<std::int64_t> read_most_steps(std::string_view text);

/// The index of `text` among choices like "meet|slice".
Expected<int> read_choice(std::string_view option, std::string_view text, std::string_view choices);

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

/// Frames per second: a number, or a fraction as in television, "30000/1001".
Expected<double> read_fps(std::string_view text);

}  // namespace mien::command
