#pragma once
// The writing verbs: pixels become a file, whole or not at all.
//
//   if (auto done = mien::write_image(image, "face.png"); !done) complain(sentence(done.error()));
//
//   // Drawn and written piece by piece, at any size, in bounded memory:
//   mien::write_picture(scene, {.width = 32768, .height = 32768}, "face.tif");

#include <mien/api.h>
#include <mien/expected.h>
#include <mien/image.h>
#include <mien/limits.h>
#include <mien/parallel.h>
#include <mien/progress.h>
#include <mien/render_stats.h>
#include <mien/scene.h>
#include <mien/svg.h>
#include <mien/view.h>

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace mien {

enum class FileType { png, tiff, exr, jpeg };

struct WriteOptions {
  std::optional<FileType> type = {};  ///< else by the extension: .png .tif .tiff .exr .jpg .jpeg
  bool half = true;                   ///< EXR: half floats, else 32-bit
  int jpeg_quality = 95;              ///< 1 … 100
  double dpi =
      0;  ///< [pixels per inch] the size on paper, 1 … 100 000; 0: none, and in TIFF, which has one always, 72
  std::string recipe = {};  ///< stored in the metadata: what made this picture
  Threads threads = {};     ///< they change no byte
  Progress progress = {};   ///< may cancel: then nothing is written

  static constexpr double kMostDpi = 100'000;
};

/// Writes to `path`; "-" is a PNG on standard output.
///
///   PNG   8 or 16 bits (f32 becomes 16), sRGB, straight alpha
///   TIFF  8, 16 or 32-bit float as the image is; tiled, zip, BigTIFF from 4 GiB of pixels on.
///         Float is linear and premultiplied
///   EXR   half or 32-bit float (u8 and u16 become linear), premultiplied, zip; tiled where it is
///         wider than 8192 pixels
///   JPEG  8 bits, sRGB, no chroma subsampling. A picture that is not opaque is an error
///
/// Opaque pictures are stored as RGB, others as RGBA. The colour space is tagged (in TIFF by an ICC
/// profile). The recipe becomes the file's ImageDescription, or in PNG the text "Description"; JPEG
/// drops a recipe longer than 60 000 bytes.
///
/// The file is written beside its target under a name like ".mien-0123456789abcdef.part", flushed
/// to disk and renamed; that the folder cannot be flushed is no error. An error therefore leaves the old file untouched and nothing else behind. The
/// next write into the folder removes temporaries that killed runs left, unless a running process
/// holds their lock. Links are followed and stay links. Permissions follow the umask. Devices and
/// pipes are written to directly.
MIEN_API Expected<Done> write_image(const Image& image, const std::filesystem::path& path,
                                    const WriteOptions& how = {});

struct PictureOptions {
  WriteOptions write = {};  ///< its threads draw too; its progress covers drawing and writing
  std::optional<Depth> depth = {};  ///< drawn at; default u8, for EXR f32
  /// [bytes] Limit of what pieces of the picture hold at once.
  std::uint64_t memory = std::uint64_t(256) << 20;
  RenderLimits limits = {};  ///< of drawing: what else is held, and work
};

/// The time that writing a picture took.
struct PictureStats {
  RenderStats render;
  double draw = 0, encode = 0, put = 0;  ///< [s] of all threads together: drawing, compressing,
                                         ///< handing to the file
};

/// Does what write_image(render(scene, view), path) does without ever holding the whole picture:
/// threads draw and compress pieces, which are written in order. Memory and threads do not change a
/// byte of the file. Sides may be up to View::kMaxSide; PNG readers with libpng's default limit refuse
/// sides beyond 1 000 000. One error is added to those of write_image: `memory` does not hold even the
/// smallest piece.
MIEN_API Expected<PictureStats> write_picture(const Scene& scene, const View& view,
                                              const std::filesystem::path& path,
                                              const PictureOptions& how = {});

/// Writes svg_text(scene, options) to `path`, whatever its extension, as write_image writes its files; "-" is standard
/// output. Returns what was simplified: Svg::simplified.
MIEN_API Expected<std::vector<std::string>> write_svg(const Scene& scene,
                                                      const std::filesystem::path& path,
                                                      const SvgOptions& options = {});

/// Checks before a long render that write_image could begin: the format is known, and the folder
/// exists and is writable. Changes nothing.
MIEN_API Expected<Done> check_output_path(const std::filesystem::path& path,
                                          const WriteOptions& how = {});

}  // namespace mien
