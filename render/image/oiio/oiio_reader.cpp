#include "render/image/oiio/oiio_reader.h"

#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <cstring>
#include <utility>
#include <vector>

namespace mien {
namespace {

struct DepthInFile {
  OIIO::TypeDesc type;
  Depth depth;
};
const DepthInFile kDepthsInFiles[] = {{OIIO::TypeDesc::UINT8, Depth::u8},
                                      {OIIO::TypeDesc::UINT16, Depth::u16},
                                      {OIIO::TypeDesc::FLOAT, Depth::f32}};

const DepthInFile* depth_of(const OIIO::ImageSpec& spec) {
  const auto* const found = std::ranges::find(kDepthsInFiles, spec.format, &DepthInFile::type);
  return found == std::end(kDepthsInFiles) ? nullptr : found;
}

class OiioReader final : public PictureReader {
 public:
  OiioReader(std::unique_ptr<OIIO::ImageInput> in, const DepthInFile& depth)
      : in_(std::move(in)), spec_(in_->spec()), depth_(depth) {}

  int width() const override { return spec_.width; }
  int height() const override { return spec_.height; }
  Depth depth() const override { return depth_.depth; }
  bool opaque() const override { return spec_.nchannels == 3; }

  Expected<Done> next(int rows, std::byte* to, std::size_t stride, const AskStop& stop) override {
    for (int i = 0; i < rows; ++i, to += stride) {
      if (y_ == end_)
        if (auto done = read_band(stop); !done) return done;
      put_row(&band_[std::size_t(y_++ - begin_) * row_bytes()], to);
    }
    return Done{};
  }

 private:
  std::size_t channel() const { return bytes_per_channel(depth_.depth); }
  std::size_t row_bytes() const {
    return std::size_t(spec_.width) * std::size_t(spec_.nchannels) * channel();
  }

  /// A row of tiles, or some lines.
  Expected<Done> read_band(const AskStop& stop) {
    constexpr int kLinesAtOnce = 16, kTilesAtOnce = 8;
    const bool tiled = spec_.tile_width > 0;
    const int rows = std::min(tiled ? spec_.tile_height : kLinesAtOnce, spec_.height - end_);
    if (rows < 1) return Error{"", "has fewer rows than it should"};
    begin_ = end_, end_ += rows;
    band_.resize(row_bytes() * std::size_t(rows));
    const int step = tiled ? kTilesAtOnce * spec_.tile_width : spec_.width;
    for (int x = 0; x < spec_.width; x += step) {
      if (stop()) return Error{"", "cancelled"};
      if (!read_part(x, std::min(x + step, spec_.width)))
        return Error{"", "cannot be read: " + in_->geterror()};
    }
    return Done{};
  }

  /// The band's columns from x to `end`, which are all where there are no tiles.
  bool read_part(int x, int end) {
    const std::size_t pixel = std::size_t(spec_.nchannels) * channel();
    std::byte* const to = band_.data() + pixel * std::size_t(x);
    if (spec_.tile_width == 0)
      return in_->read_scanlines(0, 0, begin_, end_, 0, 0, spec_.nchannels, depth_.type, to);
    return in_->read_tiles(0, 0, x, end, begin_, end_, 0, 1, 0, spec_.nchannels, depth_.type, to,
                           OIIO::stride_t(pixel), OIIO::stride_t(row_bytes()));
  }

  void put_row(const std::byte* from, std::byte* to) const {
    const std::size_t four = 4 * channel(), three = 3 * channel();
    if (!opaque()) {
      std::memcpy(to, from, row_bytes());
      return;
    }
    for (int x = 0; x < spec_.width; ++x, from += three, to += four) {
      std::memcpy(to, from, three);
      put_full(to + three);
    }
  }
  void put_full(std::byte* to) const {
    const float one = 1;
    if (depth_.depth == Depth::f32)
      std::memcpy(to, &one, sizeof one);
    else
      std::memset(to, 0xff, channel());
  }

  std::unique_ptr<OIIO::ImageInput> in_;
  const OIIO::ImageSpec spec_;
  const DepthInFile& depth_;
  std::vector<std::byte> band_;
  int begin_ = 0, end_ = 0, y_ = 0;  ///< the band's rows, and the next one
};

}  // namespace

MadeReader oiio_reader(const std::filesystem::path& path) {
  OIIO::ImageSpec asked;
  asked.attribute("oiio:UnassociatedAlpha", 1);  // as it is stored
  auto in = OIIO::ImageInput::open(path.string(), &asked);
  if (!in) return Error{path.string(), "cannot be read: " + OIIO::geterror()};
  in->threads(1);
  const OIIO::ImageSpec& spec = in->spec();
  const DepthInFile* const depth = depth_of(spec);
  if (!depth || spec.nchannels < 3 || spec.nchannels > 4)
    return Error{path.string(), "is no picture of 3 or 4 channels of 8 or 16 bits or floats"};
  return std::unique_ptr<PictureReader>(std::make_unique<OiioReader>(std::move(in), *depth));
}

}  // namespace mien
