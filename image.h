#pragma once
// The writing verb: an Image becomes a file, whole or not at all.
//
//   if (auto done = mien::write_image(image, "face.png"); !done) complain(sentence(done.error()));

#include <mien/lib/base/api.h>
#include <mien/lib/base/expected.h>
#include <mien/lib/base/progress.h>
#include <mien/render/image.h>

#include <filesystem>
#include <optional>
#include <string>

namespace mien {

enum class FileType { png, tiff, exr, jpeg };

struct WriteOptions {
  std::optional<FileType> type;  ///< else by the extension: .png .tif .tiff .exr .jpg .jpeg
  bool half = true;              ///< EXR: half floats, else 32-bit
  int jpeg_quality = 95;         ///< 1 … 100
  std::string recipe;            ///< stored in the metadata: what made this picture
  Progress progress;             ///< may cancel: then nothing is written
};

/// Writes to `path`; "-" is a PNG on standard output. Opaque pictures are stored as RGB, others
/// with straight alpha where the format wants it; the colour space is tagged. The file is written
/// beside its target, flushed to the disk and renamed: an error leaves the old file as it was.
MIEN_API Expected<Done> write_image(const Image& image, const std::filesystem::path& path,
                                    const WriteOptions& how = {});

}  // namespace mien
