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
#include <mien/parallel.h>
#include <mien/progress.h>
#include <mien/render_stats.h>
#include <mien/scene.h>
#include <mien/view.h>

#include <cstdint>
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
  Threads threads;               ///< they change no byte
  Progress progress;             ///< may cancel: then nothing is written
};

/// Writes to `path`; "-" is a PNG on standard output.
///
///   PNG   8 or 16 bits (f32 becomes 16), sRGB, straight alpha
///   TIFF  8, 16 or 32-bit float as the image is; tiled, zip, BigTIFF from 4 GiB of pixels on.
///         Float is linear and premultiplied
///   EXR   half or 32-bit float (u8 and u16 become linear), premultiplied, zip; tiled where it is
///         wider than 8192 pixels
///   JPEG  8 bits, sRGB, no subsampling. A picture that is not opaque is an error
///
/// Opaque pictures are stored as RGB, others as RGBA; the colour space is tagged (in TIFF by an ICC
/// profile); the recipe is the file's ImageDescription (in PNG the text "Description"; a JPEG
/// leaves out a recipe beyond 60 000 bytes).
///
/// The file is written beside its target under a name like ".mien-0123456789abcdef.part", flushed
/// to the disk and renamed: an error leaves the old file as it was and nothing else behind. A
/// temporary left by a killed run goes with the next write into that folder, unless a running
/// process holds its lock. Links are followed and stay links; permissions are as the umask says;
/// devices and pipes are written straight into.
MIEN_API Expected<Done> write_image(const Image& image, const std::filesystem::path& path,
                                    const WriteOptions& how = {});

struct PictureOptions {
  WriteOptions write;          ///< its threads draw, its progress is that of the whole
  std::optional<Depth> depth;  ///< what is drawn: u8, for EXR f32, unless said
  std::uint64_t memory = std::uint64_t(256) << 20;  ///< [bytes] most that is held at once
};

/// What a written picture took.
struct PictureStats {
  RenderStats render;
  double draw = 0, encode = 0, put = 0;  ///< [s] of all threads together: drawing, compressing,
                                         ///< handing to the file
};

/// write_image(render(scene, view), path) without ever holding the picture: threads draw and
/// compress pieces of it, and the file takes them in order. The bytes of the file are the same,
/// whatever the memory and the threads. Pictures of up to View::kMaxSide a side; PNG readers that
/// keep libpng's own limit refuse sides beyond 1 000 000. Errors, further to write_image's: `memory`
/// does not hold even the smallest piece.
MIEN_API Expected<PictureStats> write_picture(const Scene& scene, const View& view,
                                              const std::filesystem::path& path,
                                              const PictureOptions& how = {});

/// Whether write_image could begin there: the format is known, the folder exists and may be
/// written. For asking before a long render; changes nothing.
MIEN_API Expected<Done> check_output_path(const std::filesystem::path& path,
                                          const WriteOptions& how = {});

}  // namespace mien
