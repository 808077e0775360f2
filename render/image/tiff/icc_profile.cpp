#include "render/image/tiff/icc_profile.h"

#include <cmath>
#include <string_view>
#include <utility>

namespace mien {
namespace {

using Bytes = std::vector<std::uint8_t>;

// Everything in a profile is big-endian; tags begin at multiples of four.
void put(Bytes& to, std::uint32_t value, int size) {
  for (int shift = 8 * (size - 1); shift >= 0; shift -= 8)
    to.push_back(std::uint8_t(value >> shift));
}
void put(Bytes& to, std::string_view text) {
  for (char c : text) to.push_back(std::uint8_t(c));
}
void put_fixed(Bytes& to, double value) {
  put(to, std::uint32_t(std::int32_t(std::lround(value * 65536))), 4);
}
void append(Bytes& to, const Bytes& more) {
  to.insert(to.end(), more.begin(), more.end());
}
void pad(Bytes& to) {
  while (to.size() % 4) to.push_back(0);
}

Bytes text_tag(std::string_view text) {
  Bytes tag;
  put(tag, "mluc");
  for (std::uint32_t value : {0u, 1u, 12u})
    put(tag, value, 4);  // reserved, one record of twelve bytes
  put(tag, "enUS");
  put(tag, std::uint32_t(2 * text.size()), 4);
  put(tag, 28, 4);
  for (char c : text) put(tag, std::uint8_t(c), 2);
  return tag;
}

Bytes numbers_tag(std::string_view type, std::initializer_list<double> numbers) {
  Bytes tag;
  put(tag, type);
  put(tag, 0, 4);
  for (double v : numbers) put_fixed(tag, v);
  return tag;
}

/// Encoded to linear: a power, or IEC 61966-2-1's line and power.
Bytes curve_tag(ToneCurve curve) {
  Bytes tag;
  put(tag, "para");
  put(tag, 0, 4);
  put(tag, curve == ToneCurve::linear ? 0 : 3, 2);
  put(tag, 0, 2);
  if (curve == ToneCurve::linear) {
    put_fixed(tag, 1.0);
  } else {
    for (double v : {2.4, 1 / 1.055, 0.055 / 1.055, 1 / 12.92, 0.04045}) put_fixed(tag, v);
  }
  return tag;
}

Bytes header(std::uint32_t size) {
  Bytes out;
  put(out, size, 4);
  put(out, 0, 4);            // no preferred colour engine
  put(out, 0x04300000u, 4);  // version 4.3
  put(out, "mntrRGB XYZ ");
  for (int part : {2020, 1, 1, 0, 0, 0})
    put(out, std::uint32_t(part), 2);  // of this description, not of a picture
  put(out, "acsp");
  for (int i = 0; i < 7; ++i)
    put(out, 0, 4);  // platform, flags, maker, model, attributes, perceptual intent
  for (double v : {0.9642, 1.0, 0.8249}) put_fixed(out, v);  // D50
  out.resize(128, 0);
  return out;
}

}  // namespace

Bytes icc_profile(ToneCurve curve) {
  const Bytes tone = curve_tag(curve);
  const std::pair<std::string_view, Bytes> tags[] = {
      {"desc", text_tag(curve == ToneCurve::srgb ? "sRGB" : "Linear light, sRGB primaries")},
      {"cprt", text_tag("No copyright, use freely")},
      {"wtpt", numbers_tag("XYZ ", {0.9642, 1.0, 0.8249})},
      {"chad", numbers_tag("sf32", {1.0478860, 0.0229188, -0.0502161, 0.0295818, 0.9904835,
                                    -0.0170787, -0.0092519, 0.0150726, 0.7516781})},
      {"rXYZ", numbers_tag("XYZ ", {0.4360413, 0.2224845, 0.0139202})},
      {"gXYZ", numbers_tag("XYZ ", {0.3851129, 0.7169051, 0.0970672})},
      {"bXYZ", numbers_tag("XYZ ", {0.1430458, 0.0606104, 0.7139126})},
      {"rTRC", tone},
      {"gTRC", tone},
      {"bTRC", tone}};

  Bytes table, data;
  const std::uint32_t begin = 128 + 4 + 12 * std::uint32_t(std::size(tags));
  put(table, std::uint32_t(std::size(tags)), 4);
  for (const auto& [name, tag] : tags) {
    put(table, name);
    put(table, begin + std::uint32_t(data.size()), 4);
    put(table, std::uint32_t(tag.size()), 4);
    append(data, tag);
    pad(data);
  }
  Bytes out = header(begin + std::uint32_t(data.size()));
  append(out, table);
  append(out, data);
  return out;
}

}  // namespace mien
