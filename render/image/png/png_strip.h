#pragma once
// Rows of pixels to a stretch of PNG's one zlib stream.

#include <mien/image.h>
#include "render/image/png/run_matcher.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace mien {

/// How a PNG stores its pixels.
struct PngPixels {
  int width = 0;
  Depth depth = Depth::u8;  ///< u8 or u16
  bool opaque = true;       ///< RGB, else RGBA

  std::size_t pixel_bytes() const { return (opaque ? 3 : 4) * bytes_per_channel(depth); }
  /// Of one row as it is compressed: the filter's number and the pixels.
  std::size_t row_bytes() const { return 1 + std::size_t(width) * pixel_bytes(); }
};

/// Adler-32 of some bytes, and of a followed by b.
struct Adler {
  std::uint32_t sum = 1;
  std::uint64_t length = 0;  ///< [bytes]
};
Adler followed(const Adler& a, const Adler& b);
/// Of the lowest `bytes` of a pixel, `count` times one after the other.
Adler adler_of(std::uint64_t pixel, std::size_t bytes, std::size_t count);

/// Filters strips of rows and finds their tokens: by runs in flat art, by libdeflate in strips where more than
/// every 16th pixel differs from its neighbour. A strip refers to nothing before it. So strips may be made anywhere
/// in any order, and joined they are always the same stream.
///
/// Filters, by row: a row like the one above is Up (zeros); one in which three of four pixels equal
/// their neighbour is None (flat art: runs, and what the row above has); others are Sub or Up,
/// whichever leaves the smaller sum, which is what gradients want.
class PngStrip {
 public:
  explicit PngStrip(const PngPixels& pixels);
  ~PngStrip();

  /// Appends the tokens of `count` rows, RGBA; gives the checksum of what they unpack to.
  Adler add(const std::byte* rows, std::size_t stride, int count, std::vector<DeflateToken>& to);

  /// An upper bound of the bytes that one of these holds while it works on so many rows, tokens included.
  static std::size_t memory(const PngPixels& pixels, int rows);

 private:
  template <class Pixel>
  void add_rows(const std::byte* rows, std::size_t stride, int count,
                std::vector<DeflateToken>& to);
  template <class Pixel>
  void add_row(const std::byte* row, const std::byte* above);
  void add_run(std::uint64_t pixel, std::size_t bytes, std::size_t count);
  void compress(std::vector<DeflateToken>& to);

  struct Compressor;
  PngPixels pixels_;
  RunMatcher matcher_;
  std::unique_ptr<Compressor> compressor_;  // once it is needed
  bool noisy_ = false;                      // the strip at hand
  std::size_t filled_ = 0;
  Adler sum_;
  std::vector<std::byte> filtered_, other_, bytes_, packed_;
};

}  // namespace mien
