#include <mien/render/image/descriptor_proxy.h>
#include <mien/render/image/encode.h>
#include <mien/render/image/file_type.h>
#include <mien/render/image/icc_profile.h>
#include <mien/render/image/pixel_rows.h>
#include <mien/render/image/system_error.h>
#include <mien/version.h>

#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <cstring>
#include <vector>

namespace mien {
namespace {

constexpr int kTile = 256;  // [px] TIFF's tiles; zip finds little more in larger ones
constexpr int kBand = 256;  // rows handed over at once: whole tiles, whole EXR blocks of 16, seldom
                            // enough to ask the progress, often enough to be stopped soon
constexpr std::size_t kJpegText = 60'000;  // bytes; a JPEG marker holds 65533, with its Exif frame

OIIO::TypeDesc type_of(Depth depth) {
  switch (depth) {
    case Depth::u8:
      return OIIO::TypeDesc::UINT8;
    case Depth::u16:
      return OIIO::TypeDesc::UINT16;
    case Depth::f32:
      return OIIO::TypeDesc::FLOAT;
  }
  return OIIO::TypeDesc::UNKNOWN;
}

/// The depth nearest to the image's that the format holds.
Depth stored_depth(Depth depth, FileType type) {
  switch (type) {
    case FileType::png:
      return depth == Depth::f32 ? Depth::u16 : depth;
    case FileType::tiff:
      return depth;
    case FileType::exr:
      return Depth::f32;
    case FileType::jpeg:
      return Depth::u8;
  }
  return depth;
}

void set_png(OIIO::ImageSpec& spec) {
  // Filter "up" alone: as small as libpng's own choice among five for flat art, in half the time.
  spec.attribute("png:filter", 32);
  spec.attribute("png:compressionLevel", 6);
}

/// The colour space goes in as a profile, which programs that read TIFF look at; and with
/// oiio:ColorSpace set, the writer of OpenImageIO 2.4 makes a file that cannot be read when its
/// bytes go through a proxy.
void set_tiff(OIIO::ImageSpec& spec, Depth depth) {
  spec.erase_attribute("oiio:ColorSpace");
  const std::vector<std::uint8_t> profile =
      icc_profile(depth == Depth::f32 ? ToneCurve::linear : ToneCurve::srgb);
  spec.attribute("ICCProfile", OIIO::TypeDesc(OIIO::TypeDesc::UINT8, int(profile.size())),
                 profile.data());
  spec.tile_width = spec.tile_height = kTile;
  spec.tile_depth = 1;
  spec.attribute("compression", "zip");
}

void set_exr(OIIO::ImageSpec& spec, bool half) {
  spec.set_format(half ? OIIO::TypeDesc::HALF : OIIO::TypeDesc::FLOAT);
  spec.attribute("compression", "zip");
  // The primaries of sRGB and their white, as the format's own default has them.
  const float chromaticities[8] = {0.64f, 0.33f, 0.30f, 0.60f, 0.15f, 0.06f, 0.3127f, 0.3290f};
  spec.attribute("chromaticities", OIIO::TypeDesc(OIIO::TypeDesc::FLOAT, 8), chromaticities);
}

void set_jpeg(OIIO::ImageSpec& spec, int quality) {
  spec.attribute("CompressionQuality", std::clamp(quality, 1, 100));
  spec.attribute("jpeg:subsampling", "4:4:4");  // coloured outlines keep their edge
}

OIIO::ImageSpec spec_of(const Image& image, FileType type, const WriteOptions& how) {
  const Depth depth = stored_depth(image.depth, type);
  OIIO::ImageSpec spec(image.width, image.height, image.opaque ? 3 : 4, type_of(depth));
  spec.attribute("oiio:ColorSpace", depth == Depth::f32 ? "Linear" : "sRGB");
  if (!image.opaque && depth != Depth::f32) spec.attribute("oiio:UnassociatedAlpha", 1);
  spec.attribute("DateTime",
                 "");  // else some writers put the time in: the same picture is the same bytes
  spec.attribute("Software", "mien " MIEN_VERSION_STRING);
  if (!how.recipe.empty() && (type != FileType::jpeg || how.recipe.size() <= kJpegText)) {
    spec.attribute("ImageDescription", how.recipe);
  }
  switch (type) {
    case FileType::png:
      set_png(spec);
      break;
    case FileType::tiff:
      set_tiff(spec, depth);
      break;
    case FileType::exr:
      set_exr(spec, how.half);
      break;
    case FileType::jpeg:
      set_jpeg(spec, how.jpeg_quality);
      break;
  }
  return spec;
}

const char* writer_name(FileType type) {
  switch (type) {
    case FileType::png:
      return "png";
    case FileType::tiff:
      return "tiff";
    case FileType::exr:
      return "openexr";
    case FileType::jpeg:
      return "jpeg";
  }
  return "";
}

/// Why the writer stopped: the system's reason if there is one, else the writer's own words, on one
/// line.
Error failure(OIIO::ImageOutput& writer, const DescriptorProxy& out, FileType type) {
  std::string said = writer.geterror();
  if (out.failure()) return {"", "cannot be written: " + system_error(out.failure())};
  said.erase(0, said.find_first_not_of(" \n"));
  std::replace(said.begin(), said.end(), '\n', ' ');
  return {"", std::string("the ") + type_name(type) +
                  " writer failed: " + (said.empty() ? "no reason given" : said)};
}

/// Bands of rows for a tiled file: edge tiles are filled up with zeros here, because the writer
/// would fill them with whatever was in its memory, and the same picture would be other bytes each
/// time.
class WholeTiles {
 public:
  WholeTiles(int width, int tile, std::size_t pixel_bytes)
      : tile_(tile),
        width_(rounded(width, tile)),
        row_(std::size_t(width) * pixel_bytes),
        stride_(std::size_t(width_) * pixel_bytes) {}

  int width() const { return width_; }
  int end(int first, int last) const { return first + rounded(last - first, tile_); }
  std::size_t stride() const { return stride_; }

  const std::byte* filled_up(const std::byte* rows, int count) {
    band_.assign(stride_ * std::size_t(rounded(count, tile_)), std::byte{0});
    for (std::size_t y = 0; y < std::size_t(count); ++y)
      std::memcpy(&band_[y * stride_], rows + y * row_, row_);
    return band_.data();
  }

 private:
  static int rounded(int n, int tile) { return (n + tile - 1) / tile * tile; }

  int tile_, width_;
  std::size_t row_, stride_;  // [bytes]
  std::vector<std::byte> band_;
};

}  // namespace

Expected<Done> encode(const Image& image, FileType type, const WriteOptions& how,
                      DescriptorProxy& out) {
  const std::unique_ptr<OIIO::ImageOutput> writer = OIIO::ImageOutput::create(writer_name(type));
  if (!writer) {
    OIIO::geterror();
    return Error{"", std::string("this OpenImageIO has no writer for ") + type_name(type)};
  }
  const OIIO::ImageSpec spec = spec_of(image, type, how);
  const Depth depth = stored_depth(image.depth, type);
  const OIIO::stride_t pixel = OIIO::stride_t(4 * bytes_per_channel(depth)),
                       row = pixel * image.width;
  // The name is for the writer's messages only: bytes go through `out`.
  if (!writer->set_ioproxy(&out) || !writer->open(type_name(type), spec))
    return failure(*writer, out, type);

  PixelRows source(image, depth);
  WholeTiles tiles(image.width, kTile, std::size_t(pixel));
  for (int y = 0; y < image.height; y += kBand) {
    if (how.progress && !how.progress(double(y) / image.height)) return Error{"", "cancelled"};
    const int end = std::min(y + kBand, image.height);
    const std::byte* data = source.rows(y, end);
    const bool put = spec.tile_width
                         ? writer->write_tiles(0, tiles.width(), y, tiles.end(y, end), 0, 1,
                                               type_of(depth), tiles.filled_up(data, end - y),
                                               pixel, OIIO::stride_t(tiles.stride()))
                         : writer->write_scanlines(y, end, 0, type_of(depth), data, pixel, row);
    if (!put || out.failure()) return failure(*writer, out, type);
  }
  if (!writer->close() || out.failure()) return failure(*writer, out, type);
  if (how.progress && !how.progress(1.0)) return Error{"", "cancelled"};
  return Done{};
}

}  // namespace mien
