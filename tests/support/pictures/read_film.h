#pragma once
// Animated pictures as other programs show them: giflib, libwebp's decoder, and for APNG a PNG out of every frame.

#include <cstdint>
#include <filesystem>
#include <vector>

namespace mien::test {

struct ShownFrame {
  double seconds;                    ///< how long it is seen
  std::vector<std::uint8_t> pixels;  ///< RGBA
};

struct ReadFilm {
  int width = 0, height = 0;
  std::vector<ShownFrame> frames;
  bool endless = false;

  double seconds() const;
  /// What is seen at a moment.
  const ShownFrame& at(double moment) const;
};

/// By the extension. What is wrong with the file is a failure of the test.
ReadFilm read_film(const std::filesystem::path& path);

}  // namespace mien::test
