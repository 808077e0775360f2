#include "render/image/png/png_encoder.h"
#include <mien/version.h>
#include "render/image/file/system_error.h"
#include "render/image/pixel_rows.h"
#include "render/image/png/png_chunks.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace mien {
namespace {

constexpr std::size_t kChunkBytes = std::size_t(1) << 16;  // all but the last
constexpr std::uint64_t kPieceBytes = std::uint64_t(4)
                                      << 20;  // of pixels: about what a core's cache holds

using Bytes = PngBytes;

class PngEncoder final : public PictureEncoder {
 public:
  PngEncoder(const EncoderRequest& request, int slots, int strip_rows, int piece_rows)
      : frame_(request.frame),
        out_(request.out),
        pixels_{frame_.width, stored(frame_.depth), frame_.opaque},
        rows_(frame_.depth, pixels_.depth),
        strip_rows_(strip_rows),
        piece_rows_(piece_rows),
        strips_(std::size_t(slots)) {
    begin(request.how.recipe, request.how.dpi);
  }

  static Depth stored(Depth depth) { return depth == Depth::u8 ? Depth::u8 : Depth::u16; }

  int slots() const override { return int(strips_.size()); }
  int pieces() const override { return (frame_.height + piece_rows_ - 1) / piece_rows_; }
  PixelRect piece(int i) const override {
    const int y = i * piece_rows_;
    return {0, y, frame_.width, std::min(piece_rows_, frame_.height - y)};
  }

  void prepare(int i, int slot, const PixelBuffer& pixels, PreparedPiece& to,
               const AskStop& stop) override {
    Slot& own = strips_[std::size_t(slot)];
    if (!own.strip) own.strip = std::make_unique<PngStrip>(pixels_);
    to.tokens.clear();
    Adler sum;
    const int height = piece(i).height;
    for (int y = 0; y < height && !stop(); y += strip_rows_) {
      const int count = std::min(strip_rows_, height - y);
      sum = followed(sum, add_strip(own, pixels, y, count, to.tokens));
    }
    to.note[0] = sum.sum;
    to.note[1] = sum.length;
  }

  Expected<Done> put(int, const PreparedPiece& piece) override {
    sum_ = followed(sum_, {std::uint32_t(piece.note[0]), piece.note[1]});
    stream_.add(piece.tokens);
    // Of one size, however pieces come.
    while (stream_.bytes().size() >= kChunkBytes)
      if (auto done = write_chunk(kChunkBytes); !done) return done;
    return Done{};
  }

  Expected<Done> finish() override {
    stream_.finish();
    add_png_number(stream_.bytes(), sum_.sum);
    if (auto done = write_chunk(stream_.bytes().size()); !done) return done;
    Bytes bytes;
    add_png_chunk(bytes, "IEND", {});
    return write(bytes);
  }

 private:
  struct Slot {
    std::unique_ptr<PngStrip> strip;
    Bytes rows;  // in the file's depth, where that is another
  };

  Adler add_strip(Slot& own, const PixelBuffer& pixels, int y, int count,
                  std::vector<DeflateToken>& to) {
    const auto* from = static_cast<const std::byte*>(pixels.data) + pixels.stride * std::size_t(y);
    if (pixels_.depth == frame_.depth) return own.strip->add(from, pixels.stride, count, to);
    const std::size_t row = std::size_t(frame_.width) * 4 * bytes_per_channel(pixels_.depth);
    own.rows.resize(row * std::size_t(count));
    for (std::size_t j = 0; j < std::size_t(count); ++j) {
      rows_.convert(from + pixels.stride * j, &own.rows[row * j], std::size_t(frame_.width));
    }
    return own.strip->add(own.rows.data(), row, count, to);
  }

  void begin(const std::string& recipe, double dpi) {
    add_png_head(head_, pixels_, frame_.height);
    if (dpi > 0) {
      constexpr double kMetre = 1 / 0.0254;  // [inches]
      const std::size_t size = begin_png_chunk(head_, "pHYs");
      for (int axis = 0; axis < 2; ++axis)
        add_png_number(head_,
                       std::uint32_t(std::lround(std::min(dpi, WriteOptions::kMostDpi) * kMetre)));
      head_.push_back(std::byte(1));  // pixels a metre
      end_png_chunk(head_, size);
    }
    add_png_text(head_, "Software", "mien " MIEN_VERSION_STRING);
    if (!recipe.empty()) add_png_text(head_, "Description", recipe);
    stream_.bytes().assign(std::begin(kZlibHead), std::end(kZlibHead));
  }

  Expected<Done> write_chunk(std::size_t size) {
    Bytes bytes;
    Bytes& made = stream_.bytes();
    const std::size_t chunk = begin_png_chunk(bytes, "IDAT");
    const auto end = made.begin() + std::ptrdiff_t(size);
    bytes.insert(bytes.end(), made.begin(), end);
    made.erase(made.begin(), end);
    end_png_chunk(bytes, chunk);
    return write(bytes);
  }

  Expected<Done> write(const Bytes& bytes) {
    if (!head_.empty()) out_.write(head_.data(), head_.size());
    head_.clear();
    if (out_.write(bytes.data(), bytes.size())) return Done{};
    return Error{"", "cannot be written: " + system_error(out_.failure())};
  }

  const PictureFrame frame_;
  FileOutput& out_;
  const PngPixels pixels_;
  const PixelRows rows_;
  const int strip_rows_, piece_rows_;
  std::vector<Slot> strips_;
  Bytes head_;
  DeflateWriter stream_;
  Adler sum_;
};

}  // namespace

MadeEncoder png_encoder(const EncoderRequest& request) {
  const PictureFrame& frame = request.frame;
  const PngPixels pixels{frame.width, PngEncoder::stored(frame.depth), frame.opaque};
  // How much is drawn at once does not change how the stream is cut.
  const int strip = png_strip_rows(pixels);
  const std::uint64_t row = std::uint64_t(frame.width) * 4 * bytes_per_channel(frame.depth);
  const std::uint64_t converted = frame.depth == Depth::f32 ? row / 2 * std::uint64_t(strip) : 0;
  const auto each = [&](int rows) {
    return row * std::uint64_t(rows) + converted + PngStrip::memory(pixels, strip) +
           sizeof(DeflateToken) * pixels.row_bytes() * std::uint64_t(rows);
  };
  const int slots = slots_within(request.budget, 0, each(strip));
  if (slots == 0) return too_little_memory(each(strip), request.budget.bytes);
  int rows = strip;
  while (2 * rows <= kMostPngStripRows && 2 * std::uint64_t(rows) * row <= kPieceBytes &&
         each(2 * rows) * std::uint64_t(slots) <= request.budget.bytes)
    rows *= 2;
  return std::unique_ptr<PictureEncoder>(new PngEncoder(request, slots, strip, rows));
}

}  // namespace mien
