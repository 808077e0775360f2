#pragma once
// Pictures from files again, row by row, by OpenImageIO: pieces that are to be one picture.

#include <mien/expected.h>
#include <mien/image.h>
#include "render/image/picture_encoder.h"

#include <filesystem>
#include <memory>

namespace mien {

/// A PNG or TIFF of 8 or 16 bits or floats that mien wrote, from the top down.
class PictureReader {
 public:
  virtual ~PictureReader() = default;

  virtual int width() const = 0;
  virtual int height() const = 0;
  virtual Depth depth() const = 0;
  /// Three channels in the file. The fourth, which is read all the same, is full.
  virtual bool opaque() const = 0;
  /// The next rows, of four channels, `stride` bytes apart. No more than a row of the file's tiles is held. The error's `where` is
  /// left empty. `stop`: asked every few milliseconds; after a true one the Error is `cancelled`.
  virtual Expected<Done> next(int rows, std::byte* to, std::size_t stride, const AskStop& stop) = 0;
};

using MadeReader = Expected<std::unique_ptr<PictureReader>>;

/// Errors, with the file's name: what is no such picture.
MadeReader oiio_reader(const std::filesystem::path& path);

}  // namespace mien
