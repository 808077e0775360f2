#include "render/image/oiio/oiio_encoder.h"
#include <mien/version.h>
#include "render/image/file/system_error.h"
#include "render/image/file_type.h"
#include "render/image/oiio/descriptor_proxy.h"
#include "render/image/pixel_rows.h"

#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <vector>

namespace mien {
namespace {

constexpr int kTile = 256;          // [px]
constexpr int kWidestLines = 8192;  // [px] EXR compresses 16 lines at once: 2 MiB of them at most
constexpr int kLines = 16;          // EXR's blocks; JPEG's are as high
constexpr int kMostRows = 128;
constexpr std::uint64_t kPieceBytes = std::uint64_t(4) << 20;
constexpr std::size_t kJpegText = 60'000;  // bytes; a JPEG marker holds 65533, with its Exif frame

Depth stored_depth(FileType type) {
  return type == FileType::jpeg ? Depth::u8 : Depth::f32;
}
OIIO::TypeDesc type_of(Depth depth) {
  return depth == Depth::u8 ? OIIO::TypeDesc::UINT8 : OIIO::TypeDesc::FLOAT;
}

void set_exr(OIIO::ImageSpec& spec, bool half) {
  spec.set_format(half ? OIIO::TypeDesc::HALF : OIIO::TypeDesc::FLOAT);
  spec.attribute("compression", "zip");
  // The primaries of sRGB and their white, as the format's own default has them.
  const float chromaticities[8] = {0.64f, 0.33f, 0.30f, 0.60f, 0.15f, 0.06f, 0.3127f, 0.3290f};
  spec.attribute("chromaticities", OIIO::TypeDesc(OIIO::TypeDesc::FLOAT, 8), chromaticities);
  if (spec.width > kWidestLines) {
    spec.tile_width = spec.tile_height = kTile;
    spec.tile_depth = 1;
  }
}

void set_jpeg(OIIO::ImageSpec& spec, int quality) {
  spec.attribute("CompressionQuality", std::clamp(quality, 1, 100));
  spec.attribute("jpeg:subsampling", "4:4:4");  // coloured outlines keep their edge
}

OIIO::ImageSpec spec_of(const PictureFrame& frame, FileType type, const WriteOptions& how) {
  const Depth depth = stored_depth(type);
  OIIO::ImageSpec spec(frame.width, frame.height, frame.opaque ? 3 : 4, type_of(depth));
  spec.attribute("oiio:ColorSpace", depth == Depth::f32 ? "Linear" : "sRGB");
  spec.attribute("DateTime",
                 "");  // else some writers put the time in: the same picture is the same bytes
  spec.attribute("Software", "mien " MIEN_VERSION_STRING);
  if (!how.recipe.empty() && (type != FileType::jpeg || how.recipe.size() <= kJpegText)) {
    spec.attribute("ImageDescription", how.recipe);
  }
  if (how.dpi > 0) {
    spec.attribute("XResolution", float(how.dpi));
    spec.attribute("YResolution", float(how.dpi));
    spec.attribute("ResolutionUnit", "in");
  }
  if (type == FileType::exr) set_exr(spec, how.half);
  if (type == FileType::jpeg) set_jpeg(spec, how.jpeg_quality);
  return spec;
}

class OiioEncoder final : public PictureEncoder {
 public:
  OiioEncoder(const EncoderRequest& request, std::unique_ptr<OIIO::ImageOutput> writer,
              OIIO::ImageSpec spec, int slots, int rows, int columns)
      : frame_(request.frame),
        type_(request.type),
        rows_(frame_.depth, stored_depth(type_)),
        proxy_(request.out.descriptor(), request.out.stream()),
        writer_(std::move(writer)),
        spec_(std::move(spec)),
        slots_(slots),
        piece_rows_(rows),
        piece_columns_(columns) {}

  Expected<Done> open() {
    // The name is for the writer's messages only: bytes go through the proxy.
    if (!writer_->set_ioproxy(&proxy_) || !writer_->open(format_of(type_).name, spec_))
      return failure();
    return Done{};
  }

  int slots() const override { return slots_; }
  int pieces() const override {
    return across() * ((frame_.height + piece_rows_ - 1) / piece_rows_);
  }
  PixelRect piece(int i) const override {
    const int x = i % across() * piece_columns_, y = i / across() * piece_rows_;
    return {x, y, std::min(piece_columns_, frame_.width - x),
            std::min(piece_rows_, frame_.height - y)};
  }

  void prepare(int i, int, const PixelBuffer& pixels, PreparedPiece& to,
               const AskStop& stop) override {
    const PixelRect rect = piece(i);
    const std::size_t row = pixel_bytes() * std::size_t(rect.width);
    to.bytes.resize(row * std::size_t(rect.height));
    for (std::size_t y = 0; y < std::size_t(rect.height) && !stop(); ++y) {
      rows_.convert(static_cast<const std::byte*>(pixels.data) + pixels.stride * y,
                    &to.bytes[row * y], std::size_t(rect.width));
    }
  }

  Expected<Done> put(int i, const PreparedPiece& made) override {
    const PixelRect r = piece(i);
    const auto pixel = OIIO::stride_t(pixel_bytes()), row = pixel * r.width;
    const OIIO::TypeDesc type = type_of(stored_depth(type_));
    const bool put =
        spec_.tile_width
            ? writer_->write_tiles(r.x, r.x + r.width, r.y, r.y + r.height, 0, 1, type,
                                   made.bytes.data(), pixel, row)
            : writer_->write_scanlines(r.y, r.y + r.height, 0, type, made.bytes.data(), pixel, row);
    return put && !proxy_.failure() ? Expected<Done>(Done{}) : failure();
  }

  Expected<Done> finish() override {
    return writer_->close() && !proxy_.failure() ? Expected<Done>(Done{}) : failure();
  }

 private:
  int across() const { return (frame_.width + piece_columns_ - 1) / piece_columns_; }
  std::size_t pixel_bytes() const { return 4 * bytes_per_channel(stored_depth(type_)); }

  /// Why the writer stopped: the system's reason if there is one, else the writer's own words, on one
  /// line.
  Error failure() {
    std::string said = writer_->geterror();
    if (proxy_.failure()) return {"", "cannot be written: " + system_error(proxy_.failure())};
    said.erase(0, said.find_first_not_of(" \n"));
    std::replace(said.begin(), said.end(), '\n', ' ');
    return {"", std::string("the ") + format_of(type_).name +
                    " writer failed: " + (said.empty() ? "no reason given" : said)};
  }

  const PictureFrame frame_;
  const FileType type_;
  const PixelRows rows_;
  DescriptorProxy proxy_;  // outlives the writer
  std::unique_ptr<OIIO::ImageOutput> writer_;
  const OIIO::ImageSpec spec_;
  const int slots_, piece_rows_, piece_columns_;
};

}  // namespace

MadeEncoder oiio_encoder(const EncoderRequest& request) {
  std::unique_ptr<OIIO::ImageOutput> writer =
      OIIO::ImageOutput::create(request.type == FileType::exr ? "openexr" : "jpeg");
  if (!writer) {
    OIIO::geterror();
    return Error{"",
                 std::string("this OpenImageIO has no writer for ") + format_of(request.type).name};
  }
  const PictureFrame& frame = request.frame;
  OIIO::ImageSpec spec = spec_of(frame, request.type, request.how);
  const bool tiled = spec.tile_width > 0;
  const std::uint64_t pixel =
      4 * (bytes_per_channel(frame.depth) + bytes_per_channel(stored_depth(request.type)));
  int rows = tiled ? kTile : kLines, columns = tiled ? kTile : frame.width;
  const auto each = [&] { return pixel * std::uint64_t(rows) * std::uint64_t(columns); };
  const int slots = slots_within(request.budget, 0, each());
  if (slots == 0) return too_little_memory(each(), request.budget.bytes);
  int& grown = tiled ? columns : rows;
  const int most = tiled ? frame.width : kMostRows;
  const std::uint64_t piece = std::min(kPieceBytes, request.budget.bytes / std::uint64_t(slots));
  while (grown < most && 2 * each() <= piece) grown *= 2;
  auto encoder = std::make_unique<OiioEncoder>(request, std::move(writer), std::move(spec), slots,
                                               rows, columns);
  if (auto opened = encoder->open(); !opened) return opened.error();
  return std::unique_ptr<PictureEncoder>(std::move(encoder));
}

}  // namespace mien
