#include <mien/render/image/deflate_end.h>
#include <mien/render/image/png_strip.h>

#include <libdeflate.h>

#include <cstdlib>
#include <cstring>
#include <new>
#include <span>
#include <utility>

namespace mien {
namespace {

constexpr int kLevel = 6;  // of 12: beyond it flat art takes twice the time for a twentieth less
enum Filter : unsigned char { kNone = 0, kSub = 1, kUp = 2 };

/// Pixels that differ from the one before them.
template <class Pixel>
std::size_t changes(const std::byte* row, int width) {
  std::size_t sum = 0;
  for (int begin = 1; begin < width; begin += 4096) {  // in short stretches: counts of 32 bits
    const int end = begin + 4096 < width ? begin + 4096 : width;
    std::uint32_t part = 0;
    for (int x = begin; x < end; ++x) {
      Pixel here, before;
      std::memcpy(&here, row + sizeof(Pixel) * std::size_t(x), sizeof(Pixel));
      std::memcpy(&before, row + sizeof(Pixel) * std::size_t(x - 1), sizeof(Pixel));
      part += here != before;
    }
    sum += part;
  }
  return sum;
}

/// RGBA to the file's channels, 16 bits with the high byte first.
void pack(const std::byte* from, std::byte* to, const PngPixels& pixels) {
  const int channels = pixels.opaque ? 3 : 4;
  if (pixels.depth == Depth::u8 && !pixels.opaque) {
    std::memcpy(to, from, std::size_t(pixels.width) * 4);
  } else if (pixels.depth == Depth::u8) {
    // Four bytes for three, the fourth overwritten by the next: `to` has a byte to spare.
    for (int x = 0; x < pixels.width; ++x, from += 4, to += 3) std::memcpy(to, from, 4);
  } else {
    for (int x = 0; x < pixels.width; ++x, from += 8) {
      for (int c = 0; c < channels; ++c, to += 2) {
        std::uint16_t value;
        std::memcpy(&value, from + 2 * c, 2);
        to[0] = std::byte(value >> 8);
        to[1] = std::byte(value & 255);
      }
    }
  }
}

/// The row minus another (or itself a pixel before), and the sum of what is left.
std::size_t subtract(const std::byte* row, const std::byte* other, std::byte* to,
                     std::size_t count) {
  std::size_t sum = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const auto left = std::int8_t(std::uint8_t(row[i]) - std::uint8_t(other[i]));
    to[i] = std::byte(left);
    sum += std::size_t(std::abs(int(left)));
  }
  return sum;
}

}  // namespace

Adler followed(const Adler& a, const Adler& b) {
  // Of n bytes d: low = 1 + Σ d, high = Σ over the bytes of low so far. Behind a, each of b's n lows
  // is larger by a's low − 1.
  constexpr std::uint64_t kPrime = 65521;
  const std::uint64_t low_a = a.sum & 0xffff, low_b = b.sum & 0xffff;
  const std::uint64_t high_a = a.sum >> 16, high_b = b.sum >> 16;
  const std::uint64_t low = (low_a + low_b + kPrime - 1) % kPrime;
  const std::uint64_t high =
      (high_a + high_b + (b.length % kPrime) * ((low_a + kPrime - 1) % kPrime)) % kPrime;
  return {std::uint32_t(high << 16 | low), a.length + b.length};
}

struct PngStrip::Compressor {
  libdeflate_compressor* handle = libdeflate_alloc_compressor(kLevel);
  Compressor() {
    if (!handle) throw std::bad_alloc();
  }
  ~Compressor() { libdeflate_free_compressor(handle); }
};

PngStrip::PngStrip(const PngPixels& pixels)
    : pixels_(pixels), compressor_(std::make_unique<Compressor>()) {}
PngStrip::~PngStrip() = default;
PngStrip::PngStrip(PngStrip&&) noexcept = default;

std::size_t PngStrip::memory(const PngPixels& pixels, int rows) {
  constexpr std::size_t kCompressor = std::size_t(1) << 20;  // libdeflate's own, at that level
  return kCompressor + pixels.row_bytes() * (std::size_t(rows) + 2);
}

void PngStrip::filter(const std::byte* row, const std::byte* above, std::byte* to) {
  const std::size_t size = pixels_.row_bytes() - 1, pixel = pixels_.pixel_bytes();
  const std::size_t source = std::size_t(pixels_.width) * 4 * bytes_per_channel(pixels_.depth);
  if (above && std::memcmp(row, above, source) == 0) {
    to[0] = std::byte(kUp);
    std::memset(to + 1, 0, size);
    return;
  }
  const std::size_t changed = pixels_.depth == Depth::u8
                                  ? changes<std::uint32_t>(row, pixels_.width)
                                  : changes<std::uint64_t>(row, pixels_.width);
  pack(row, packed_.data(), pixels_);
  to[0] = std::byte(kNone);
  std::memcpy(to + 1, packed_.data(), size);
  if (4 * changed <= std::size_t(pixels_.width)) return;

  std::vector<std::byte> other(size);
  to[0] = std::byte(kSub);
  const std::size_t sub =
      subtract(packed_.data() + pixel, packed_.data(), to + 1 + pixel, size - pixel);
  if (!above) return;
  above_.resize(size + 1);
  pack(above, above_.data(), pixels_);
  if (subtract(packed_.data(), above_.data(), other.data(), size) >= sub) return;
  to[0] = std::byte(kUp);
  std::memcpy(to + 1, other.data(), size);
}

Adler PngStrip::add(const std::byte* rows, std::size_t stride, int count,
                    std::vector<std::byte>& to) {
  const std::size_t row = pixels_.row_bytes(), size = row * std::size_t(count);
  packed_.resize(row);  // one more than the pixels: see pack
  filtered_.resize(size);
  for (int y = 0; y < count; ++y) {
    const std::byte* const at = rows + stride * std::size_t(y);
    filter(at, y ? at - stride : nullptr, &filtered_[row * std::size_t(y)]);
  }

  const std::size_t begin = to.size();
  to.resize(begin + libdeflate_deflate_compress_bound(compressor_->handle, size));
  const std::size_t packed = libdeflate_deflate_compress(
      compressor_->handle, filtered_.data(), size, to.data() + begin, to.size() - begin);
  const auto end = deflate_end(std::span(to).subspan(begin, packed));
  if (!end) std::abort();  // a compressor that does not keep to RFC 1951
  std::byte& flag = to[begin + end->last_block / 8];
  flag &= ~(std::byte(1) << end->last_block % 8);
  // An empty stored block: three zero bits, which the padding may hold, zeros up to a whole byte, and
  // its length, 0, twice. It leaves the stream at a whole byte.
  const std::size_t padding = 8 * packed - end->end;
  to.resize(begin + packed);
  if (padding < 3) to.push_back(std::byte(0));
  for (const int byte : {0, 0, 255, 255}) to.push_back(std::byte(byte));
  return {libdeflate_adler32(1, filtered_.data(), size), size};
}

}  // namespace mien
