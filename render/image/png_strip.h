#pragma once
// Rows of pixels to a stretch of PNG's one zlib stream.

#include <mien/render/image.h>

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

/// Filters and compresses strips of rows. Each strip stands for itself: it refers to nothing before
/// it, and ends at a whole byte with an empty stored block, not being the last of the stream. So
/// strips may be made anywhere in any order, and joined they are one stream, the same bytes always.
///
/// Filters, by row: a row like the one above is Up (zeros); one in which three of four pixels equal
/// their neighbour is None (flat art: the compressor finds runs in it, and the row above); others are
/// Sub or Up, whichever leaves the smaller sum, which is what gradients want.
class PngStrip {
 public:
  explicit PngStrip(const PngPixels& pixels);
  ~PngStrip();
  PngStrip(PngStrip&&) noexcept;

  /// Appends `count` rows, RGBA, as compressed bytes; gives the checksum of what they unpack to.
  Adler add(const std::byte* rows, std::size_t stride, int count, std::vector<std::byte>& to);

  /// Most bytes one of these holds while it works on so many rows.
  static std::size_t memory(const PngPixels& pixels, int rows);

 private:
  void filter(const std::byte* row, const std::byte* above, std::byte* to);
  struct Compressor;
  PngPixels pixels_;
  std::unique_ptr<Compressor> compressor_;
  std::vector<std::byte> packed_, above_, filtered_;
};

}  // namespace mien
