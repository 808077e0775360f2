#include "render/image/png/animated_png.h"
#include <mien/version.h>
#include "render/image/file/system_error.h"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <iterator>

namespace mien {
namespace {

/// Frames, and plays: 0 is without end.
void add_control(PngBytes& to, std::uint32_t frames) {
  add_png_chunk(to, "acTL", std::array{frames, 0u});
}

/// The rows of a part as one zlib stream.
PngBytes packed_rows(const PngPixels& pixels, int height, const std::byte* rows,
                     std::size_t stride) {
  PngStrip strip(pixels);
  DeflateWriter stream;
  stream.bytes().assign(std::begin(kZlibHead), std::end(kZlibHead));
  std::vector<DeflateToken> tokens;
  Adler sum;
  const int together = png_strip_rows(pixels);
  for (int y = 0; y < height; y += together) {
    tokens.clear();
    sum = followed(sum, strip.add(rows + stride * std::size_t(y), stride,
                                  std::min(together, height - y), tokens));
    stream.add(tokens);
  }
  stream.finish();
  add_png_number(stream.bytes(), sum.sum);
  return std::move(stream.bytes());
}

}  // namespace

AnimatedPng::AnimatedPng(FileOutput& out, const PngPixels& pixels, int height)
    : out_(out), pixels_(pixels) {
  add_png_head(bytes_, pixels_, height);
  control_at_ = bytes_.size();
  add_control(bytes_, 0);
  add_png_text(bytes_, "Software", "mien " MIEN_VERSION_STRING);
}

Expected<Done> AnimatedPng::add(const PixelRect& part, const std::byte* rows, std::size_t stride,
                                FrameDelay delay) {
  begin_frame(part, delay);
  PngPixels pixels = pixels_;
  pixels.width = part.width;
  add_data(packed_rows(pixels, part.height, rows, stride));
  ++frames_;
  return write();
}

void AnimatedPng::begin_frame(const PixelRect& part, FrameDelay delay) {
  const std::size_t control = begin_png_chunk(bytes_, "fcTL");
  for (const std::uint32_t n : {numbered_++, std::uint32_t(part.width), std::uint32_t(part.height),
                                std::uint32_t(part.x), std::uint32_t(part.y)})
    add_png_number(bytes_, n);
  add_png_short(bytes_, delay.ticks);
  add_png_short(bytes_, delay.ticks_a_second);
  // It stays, and takes the place of what was there, transparency too.
  bytes_.insert(bytes_.end(), 2, std::byte(0));
  end_png_chunk(bytes_, control);
}

void AnimatedPng::add_data(const PngBytes& stream) {
  constexpr std::size_t kChunkBytes = std::size_t(1) << 16;
  for (std::size_t at = 0; at < stream.size(); at += kChunkBytes) {
    const bool first = frames_ == 0;
    const std::size_t chunk = begin_png_chunk(bytes_, first ? "IDAT" : "fdAT");
    if (!first) add_png_number(bytes_, numbered_++);
    const auto begin = stream.begin() + std::ptrdiff_t(at);
    bytes_.insert(bytes_.end(), begin,
                  begin + std::ptrdiff_t(std::min(kChunkBytes, stream.size() - at)));
    end_png_chunk(bytes_, chunk);
  }
}

Expected<Done> AnimatedPng::write() {
  if (!out_.write(bytes_.data(), bytes_.size()))
    return Error{"", "cannot be written: " + system_error(out_.failure())};
  bytes_.clear();
  return Done{};
}

Expected<Done> AnimatedPng::finish() {
  add_png_chunk(bytes_, "IEND", {});
  if (auto done = write(); !done) return done;
  add_control(bytes_, frames_);
  for (std::size_t put = 0; put < bytes_.size();) {
    const ssize_t more =
        ::pwrite(out_.descriptor(), &bytes_[put], bytes_.size() - put, ::off_t(control_at_ + put));
    if (more < 0 && errno == EINTR) continue;
    if (more <= 0) return Error{"", "cannot be written: " + system_error(errno)};
    put += std::size_t(more);
  }
  return Done{};
}

}  // namespace mien
