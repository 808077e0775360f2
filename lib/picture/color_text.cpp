#include "lib/picture/color_text.h"

#include "lib/picture/srgb.h"

namespace mien {
namespace {

/// The value of a hexadecimal digit, or −1.
int digit(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  if (c >= 'A' && c <= 'F') return c - 'A' + 10;
  return -1;
}

}  // namespace

std::optional<Color> color_from_text(std::string_view text) {
  if ((text.size() != 7 && text.size() != 9) || text[0] != '#') return {};
  double channel[4] = {0, 0, 0, 255};
  for (std::size_t i = 1, c = 0; i < text.size(); i += 2, ++c) {
    const int high = digit(text[i]), low = digit(text[i + 1]);
    if (high < 0 || low < 0) return {};
    channel[c] = 16 * high + low;
  }
  return color_from_srgb255(channel[0], channel[1], channel[2], channel[3]);
}

}  // namespace mien
