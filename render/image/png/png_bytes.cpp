#include "render/image/png/png_bytes.h"
#include "render/image/png/png_encoder.h"

#include <limits>

namespace mien {

std::vector<std::byte> png_bytes(const Image& image, const WriteOptions& how) {
  std::vector<std::byte> bytes;
  FileOutput out(bytes);
  const PictureFrame frame{image.width, image.height, image.depth, image.opaque};
  constexpr PieceBudget kOneAtATime{1, std::numeric_limits<std::int64_t>::max()};
  // Neither can fail: memory is not asked for, and takes every byte.
  const auto encoder = *png_encoder({frame, FileType::png, how, kOneAtATime, out});
  PreparedPiece prepared;
  for (int i = 0; i < encoder->pieces(); ++i) {
    const PixelRect piece = encoder->piece(i);
    // Encoders only read.
    const PixelBuffer pixels{
        const_cast<std::byte*>(image.bytes.data()) + image.stride() * std::size_t(piece.y),
        image.stride(), image.depth};
    encoder->prepare(i, 0, pixels, prepared, [] { return false; });
    (void)encoder->put(i, prepared);
  }
  (void)encoder->finish();
  return bytes;
}

}  // namespace mien
