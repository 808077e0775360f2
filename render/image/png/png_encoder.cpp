#include "render/image/png/png_encoder.h"
#include <mien/version.h>
#include "render/image/file/system_error.h"
#include "render/image/pixel_rows.h"
#include "render/image/png/png_strip.h"

#include <libdeflate.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <string_view>

namespace mien {
namespace {

constexpr std::size_t kStripBytes = std::size_t(1)
                                    << 20;  // before compression: long enough that the
                                            // cuts cost nothing, short enough to stop soon
constexpr int kMostStripRows = 256;
constexpr std::size_t kChunkBytes = std::size_t(1) << 16;  // all but the last
constexpr std::uint64_t kPieceBytes = std::uint64_t(4)
                                      << 20;  // of pixels: about what a core's cache holds

using Bytes = std::vector<std::byte>;

void add_number(Bytes& to, std::uint32_t n) {
  for (int shift = 24; shift >= 0; shift -= 8) to.push_back(std::byte(n >> shift & 255));
}

/// A chunk's frame: its length and name, what is added behind it, then its check sum.
std::size_t begin_chunk(Bytes& to, const char* name) {
  const std::size_t begin = to.size();
  add_number(to, 0);
  for (int i = 0; i < 4; ++i) to.push_back(std::byte(name[i]));
  return begin;
}
void end_chunk(Bytes& to, std::size_t begin) {
  const std::size_t length = to.size() - begin - 8;
  for (std::size_t i = 0; i < 4; ++i) to[begin + i] = std::byte(length >> (24 - 8 * i) & 255);
  add_number(to, libdeflate_crc32(0, &to[begin + 4], length + 4));
}

void add_chunk(Bytes& to, const char* name, std::span<const std::uint32_t> numbers) {
  const std::size_t begin = begin_chunk(to, name);
  for (const std::uint32_t n : numbers) add_number(to, n);
  end_chunk(to, begin);
}

bool is_ascii(std::string_view text) {
  return std::all_of(text.begin(), text.end(), [](char c) { return c > 0 && c < 0x7f; });
}

/// tEXt is Latin-1; iTXt is UTF-8, with flags for compression and a language left empty.
void add_text(Bytes& to, std::string_view key, std::string_view text) {
  const bool ascii = is_ascii(text);
  const std::size_t begin = begin_chunk(to, ascii ? "tEXt" : "iTXt");
  const auto add = [&](std::string_view s) {
    for (const char c : s) to.push_back(std::byte(c));
  };
  add(key);
  to.insert(to.end(), ascii ? 1 : 5, std::byte(0));
  add(text);
  end_chunk(to, begin);
}

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
    add_number(stream_.bytes(), sum_.sum);
    if (auto done = write_chunk(stream_.bytes().size()); !done) return done;
    Bytes bytes;
    add_chunk(bytes, "IEND", {});
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
    for (const int byte : {0x89, 0x50, 0x4e, 0x47, 13, 10, 26, 10})
      head_.push_back(std::byte(byte));
    const std::size_t header = begin_chunk(head_, "IHDR");
    add_number(head_, std::uint32_t(frame_.width));
    add_number(head_, std::uint32_t(frame_.height));
    const int depth = pixels_.depth == Depth::u8 ? 8 : 16, color = pixels_.opaque ? 2 : 6;
    for (const int byte : {depth, color, 0, 0, 0}) head_.push_back(std::byte(byte));
    end_chunk(head_, header);
    // sRGB, and for readers that do not know it the nearest gamma and its primaries.
    add_chunk(head_, "gAMA", std::array{45455u});
    add_chunk(head_, "cHRM",
              std::array{31270u, 32900u, 64000u, 33000u, 30000u, 60000u, 15000u, 6000u});
    const std::size_t srgb = begin_chunk(head_, "sRGB");
    head_.push_back(std::byte(0));  // perceptual
    end_chunk(head_, srgb);
    if (dpi > 0) {
      constexpr double kMetre = 1 / 0.0254;  // [inches]
      const std::size_t size = begin_chunk(head_, "pHYs");
      for (int axis = 0; axis < 2; ++axis)
        add_number(head_,
                   std::uint32_t(std::lround(std::min(dpi, WriteOptions::kMostDpi) * kMetre)));
      head_.push_back(std::byte(1));  // pixels a metre
      end_chunk(head_, size);
    }
    add_text(head_, "Software", "mien " MIEN_VERSION_STRING);
    if (!recipe.empty()) add_text(head_, "Description", recipe);
    stream_.bytes() = {std::byte(0x78), std::byte(0x9c)};  // zlib's own
  }

  Expected<Done> write_chunk(std::size_t size) {
    Bytes bytes;
    Bytes& made = stream_.bytes();
    const std::size_t chunk = begin_chunk(bytes, "IDAT");
    const auto end = made.begin() + std::ptrdiff_t(size);
    bytes.insert(bytes.end(), made.begin(), end);
    made.erase(made.begin(), end);
    end_chunk(bytes, chunk);
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
  // How the stream is cut must follow from the picture alone; how much is drawn at once need not.
  const int strip = int(std::bit_floor(
      std::clamp<std::size_t>(kStripBytes / pixels.row_bytes(), 1, std::size_t(kMostStripRows))));
  const std::uint64_t row = std::uint64_t(frame.width) * 4 * bytes_per_channel(frame.depth);
  const std::uint64_t converted = frame.depth == Depth::f32 ? row / 2 * std::uint64_t(strip) : 0;
  const auto each = [&](int rows) {
    return row * std::uint64_t(rows) + converted + PngStrip::memory(pixels, strip) +
           sizeof(DeflateToken) * pixels.row_bytes() * std::uint64_t(rows);
  };
  const int slots = slots_within(request.budget, 0, each(strip));
  if (slots == 0) return too_little_memory(each(strip), request.budget.bytes);
  int rows = strip;
  while (2 * rows <= kMostStripRows && 2 * std::uint64_t(rows) * row <= kPieceBytes &&
         each(2 * rows) * std::uint64_t(slots) <= request.budget.bytes)
    rows *= 2;
  return std::unique_ptr<PictureEncoder>(new PngEncoder(request, slots, strip, rows));
}

}  // namespace mien
