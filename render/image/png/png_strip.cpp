#include "render/image/png/png_strip.h"
#include "render/image/png/deflate_reader.h"

#include <libdeflate.h>

#include <cstring>
#include <new>
#include <span>
#include <stdexcept>

namespace mien {
namespace {

constexpr int kLevel = 5;  // of 12: the next one takes a tenth more time for a fortieth less
constexpr std::size_t kNoisy = 16;  // one in so many pixels differs from the one before it
enum Filter : unsigned char { kNone = 0, kSub = 1, kUp = 2 };

template <class Pixel>
Pixel pixel_at(const std::byte* row, std::size_t x) {
  Pixel pixel;
  std::memcpy(&pixel, row + sizeof(Pixel) * x, sizeof(Pixel));
  return pixel;
}

/// Pixels that differ from the one before them.
template <class Pixel>
std::size_t changes(const std::byte* row, std::size_t width) {
  std::size_t sum = 0;
  for (std::size_t begin = 1; begin < width;
       begin += 4096) {  // in short stretches: counts of 32 bits
    const std::size_t end = begin + 4096 < width ? begin + 4096 : width;
    std::uint32_t part = 0;
    for (std::size_t x = begin; x < end; ++x)
      part += pixel_at<Pixel>(row, x) != pixel_at<Pixel>(row, x - 1);
    sum += part;
  }
  return sum;
}

/// The first pixel from x on that is not like that at x.
template <class Pixel>
std::size_t run_end(const std::byte* row, std::size_t x, std::size_t width) {
  constexpr std::size_t kAtOnce = 16;
  const Pixel first = pixel_at<Pixel>(row, x++);
  if (x < width && pixel_at<Pixel>(row, x) != first) return x;
  for (; x + kAtOnce <= width; x += kAtOnce) {
    Pixel differs = 0;
    for (std::size_t k = 0; k < kAtOnce; ++k) differs |= pixel_at<Pixel>(row, x + k) ^ first;
    if (differs) break;
  }
  while (x < width && pixel_at<Pixel>(row, x) == first) ++x;
  return x;
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

/// As the file has it: 16 bits with the high byte first.
std::uint64_t stored(std::uint32_t pixel, std::uint64_t mask) {
  return pixel & mask;
}
std::uint64_t stored(std::uint64_t pixel, std::uint64_t mask) {
  constexpr std::uint64_t kLow = 0x00ff00ff00ff00ffu;
  return ((pixel & kLow) << 8 | (pixel >> 8 & kLow)) & mask;
}

}  // namespace

// Of n bytes d: low = 1 + Σ d, high = Σ over the bytes of low so far, both modulo a prime.
constexpr std::uint64_t kPrime = 65521;

Adler followed(const Adler& a, const Adler& b) {
  // Behind a, each of b's n lows is larger by a's low − 1.
  const std::uint64_t low_a = a.sum & 0xffff, low_b = b.sum & 0xffff;
  const std::uint64_t high_a = a.sum >> 16, high_b = b.sum >> 16;
  const std::uint64_t low = (low_a + low_b + kPrime - 1) % kPrime;
  const std::uint64_t high =
      (high_a + high_b + (b.length % kPrime) * ((low_a + kPrime - 1) % kPrime)) % kPrime;
  return {std::uint32_t(high << 16 | low), a.length + b.length};
}

Adler adler_of(std::uint64_t pixel, std::size_t bytes, std::size_t count) {
  // A pixel adds s to low, and h to high where low was 0; the k-th one finds low at 1 + k s.
  std::uint64_t s = 0, h = 0;
  for (std::size_t k = 0; k < bytes; ++k) {
    s += pixel >> 8 * k & 255;
    h += s;
  }
  const std::uint64_t n = count, pairs = n * (n - 1) / 2 % kPrime;
  const std::uint64_t low = (1 + n * s) % kPrime;
  const std::uint64_t high = (n * (h + bytes) + pairs * s * bytes) % kPrime;
  return {std::uint32_t(high << 16 | low), n * bytes};
}

struct PngStrip::Compressor {
  libdeflate_compressor* handle = libdeflate_alloc_compressor(kLevel);
  Compressor() {
    if (!handle) throw std::bad_alloc();
  }
  ~Compressor() { libdeflate_free_compressor(handle); }
};

PngStrip::PngStrip(const PngPixels& pixels) : pixels_(pixels), matcher_(pixels.pixel_bytes()) {}
PngStrip::~PngStrip() = default;

std::size_t PngStrip::memory(const PngPixels& pixels, int rows) {
  constexpr std::size_t kCompressor = std::size_t(1) << 20;  // libdeflate's own, at that level
  // Filtered, packed, and as runs, which are a sixteenth of the pixels; and a row on its way.
  return kCompressor + pixels.row_bytes() * (3 * std::size_t(rows) + 4);
}

void PngStrip::add_run(std::uint64_t pixel, std::size_t bytes, std::size_t count) {
  if (!noisy_) {
    matcher_.add(pixel, bytes * count);
    sum_ = followed(sum_, adler_of(pixel, bytes, count));
    return;
  }
  for (std::size_t i = 0; i < count; ++i, filled_ += bytes)
    std::memcpy(&bytes_[filled_], &pixel,
                sizeof pixel);  // the next one overwrites what is too much
}

void PngStrip::compress(std::vector<DeflateToken>& to) {
  if (!compressor_) compressor_ = std::make_unique<Compressor>();
  packed_.resize(libdeflate_deflate_compress_bound(compressor_->handle, filled_));
  const std::size_t packed = libdeflate_deflate_compress(compressor_->handle, bytes_.data(),
                                                         filled_, packed_.data(), packed_.size());
  if (!read_deflate(std::span(packed_).first(packed), to))
    throw std::runtime_error("the compressor does not keep to RFC 1951");
  sum_ = {libdeflate_adler32(1, bytes_.data(), filled_), filled_};
}

template <class Pixel>
void PngStrip::add_row(const std::byte* row, const std::byte* above) {
  const auto width = std::size_t(pixels_.width), size = sizeof(Pixel) * width,
             bytes = pixels_.pixel_bytes();
  if (above && std::memcmp(row, above, size) == 0) {
    add_run(kUp, 1, 1);
    return add_run(0, bytes, width);
  }
  Filter filter = kNone;
  const std::byte* from = row;
  if (4 * changes<Pixel>(row, width) > width) {
    filter = kSub;
    filtered_.resize(size), other_.resize(size);
    std::memcpy(filtered_.data(), row, sizeof(Pixel));
    const std::size_t sub =
        subtract(row + sizeof(Pixel), row, filtered_.data() + sizeof(Pixel), size - sizeof(Pixel));
    if (above && subtract(row, above, other_.data(), size) < sub) {
      filter = kUp;
      filtered_.swap(other_);
    }
    from = filtered_.data();
  }
  add_run(filter, 1, 1);
  const std::uint64_t mask = ~std::uint64_t(0) >> (64 - 8 * bytes);
  for (std::size_t x = 0, end; x < width; x = end) {
    end = noisy_ ? x + 1 : run_end<Pixel>(from, x, width);
    add_run(stored(pixel_at<Pixel>(from, x), mask), bytes, end - x);
  }
}

template <class Pixel>
void PngStrip::add_rows(const std::byte* rows, std::size_t stride, int count,
                        std::vector<DeflateToken>& to) {
  const auto width = std::size_t(pixels_.width);
  std::size_t changed = 0;
  for (int y = 0; y < count; ++y) changed += changes<Pixel>(rows + stride * std::size_t(y), width);
  noisy_ = kNoisy * changed > width * std::size_t(count);
  filled_ = 0, sum_ = {};
  if (noisy_)
    bytes_.resize(pixels_.row_bytes() * std::size_t(count) + sizeof(std::uint64_t));
  else
    matcher_.begin();
  for (int y = 0; y < count; ++y) {
    const std::byte* const row = rows + stride * std::size_t(y);
    add_row<Pixel>(row, y ? row - stride : nullptr);
    if (!noisy_) matcher_.end_row(to);
  }
  if (noisy_) compress(to);
}

Adler PngStrip::add(const std::byte* rows, std::size_t stride, int count,
                    std::vector<DeflateToken>& to) {
  pixels_.depth == Depth::u8 ? add_rows<std::uint32_t>(rows, stride, count, to)
                             : add_rows<std::uint64_t>(rows, stride, count, to);
  return sum_;
}

}  // namespace mien
