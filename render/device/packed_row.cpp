#include "render/device/packed_row.h"

#include "lib/picture/srgb.h"
#include "render/blend/blender.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>

namespace mien {
namespace {

constexpr double kMostLevel16 = 65535.0;

/// What is added to a level before it is rounded down, for the eight columns of a dither's period.
std::array<double, 8> carries(int y, bool dither) {
  std::array<double, 8> carry;
  for (int x = 0; x < 8; ++x) carry[std::size_t(x)] = dither ? dither_threshold(x, y) : 0.5;
  return carry;
}

/// Over black: alpha of 16 bits is straight.
unsigned packed_565(const std::uint16_t* rgba, double carry) {
  const double alpha = rgba[3] / kMostLevel16;
  const auto bits = [&](int channel, int top) {
    return unsigned(std::min(double(top), rgba[channel] / kMostLevel16 * alpha * top + carry));
  };
  return bits(0, 31) << 11 | bits(1, 63) << 5 | bits(2, 31);
}

void pack_565(const std::byte* from, int x, int y, int width, bool dither, bool swapped,
              std::byte* to) {
  const std::array<double, 8> carry = carries(y, dither);
  for (int i = 0; i < width; ++i) {
    std::uint16_t rgba[4];
    std::memcpy(rgba, from + 8 * i, sizeof rgba);
    const unsigned bits = packed_565(rgba, carry[std::size_t((x + i) & 7)]);
    const auto pixel = std::uint16_t(swapped ? (bits << 8 & 0xff00u) | bits >> 8 : bits);
    std::memcpy(to + 2 * i, &pixel, sizeof pixel);
  }
}

void pack_bgrx(const std::byte* from, int width, std::byte* to) {
  for (int i = 0; i < width; ++i, from += 4, to += 4) {
    const int alpha = std::to_integer<int>(from[3]);
    for (int channel = 0; channel < 3; ++channel)
      to[2 - channel] = std::byte((std::to_integer<int>(from[channel]) * alpha + 127) / 255);
    to[3] = std::byte{255};
  }
}

/// The luminance of linear light, by ITU-R BT.709: that of float pixels, which are premultiplied.
double luminance(const float* rgba) {
  return 0.2126 * double(rgba[0]) + 0.7152 * double(rgba[1]) + 0.0722 * double(rgba[2]);
}

void pack_mono(const std::byte* from, int x, int y, int width, bool dither, std::byte* to) {
  const std::array<double, 8> carry = carries(y, dither);
  std::fill_n(to, (width + 7) / 8, std::byte{0});
  for (int i = 0; i < width; ++i) {
    float rgba[4];
    std::memcpy(rgba, from + 16 * i, sizeof rgba);
    const double light = luminance(rgba);
    const bool white =
        dither ? light + carry[std::size_t((x + i) & 7)] >= 1.0 : light >= linear_from_srgb(0.5);
    if (white) to[i / 8] |= std::byte{0x80} >> (i % 8);
  }
}

}  // namespace

Depth depth_for(DeviceFormat format) {
  switch (format) {
    case DeviceFormat::bgrx:
      return Depth::u8;
    case DeviceFormat::mono:
      return Depth::f32;
    default:
      return Depth::u16;
  }
}

void pack_row(DeviceFormat format, const std::byte* from, int x, int y, int width, bool dither,
              std::byte* to) {
  switch (format) {
    case DeviceFormat::bgrx:
      return pack_bgrx(from, width, to);
    case DeviceFormat::mono:
      return pack_mono(from, x, y, width, dither, to);
    default:
      return pack_565(from, x, y, width, dither, format == DeviceFormat::rgb565_swapped, to);
  }
}

}  // namespace mien
