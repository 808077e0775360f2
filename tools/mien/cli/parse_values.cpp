#include "tools/mien/cli/parse_values.h"

#include <mien/recipe.h>
#include "lib/base/nearest_name.h"
#include "lib/base/one_line.h"
#include "lib/picture/color_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>
#include "lib/base/from_chars.h"

namespace mien::command {
namespace {

Error refuse(std::string_view option, std::string_view text, std::string what) {
  return {fmt::format("{} {}", option, one_line(text, 60)), std::move(what)};
}

/// The whole text as a number, or nothing.
template <class Number>
std::optional<Number> number(std::string_view text) {
  Number value{};
  const char* const end = text.data() + text.size();
  const auto [at, failed] = from_chars(text.data(), end, value);
  if (failed != std::errc{} || at != end) return {};
  return value;
}

std::vector<std::string_view> split(std::string_view text, char at) {
  std::vector<std::string_view> parts;
  for (;;) {
    const std::size_t cut = text.find(at);
    parts.push_back(text.substr(0, cut));
    if (cut == std::string_view::npos) return parts;
    text.remove_prefix(cut + 1);
  }
}

bool is_side(std::optional<int> side) {
  return side && *side >= 1 && *side <= View::kMaxSide;
}

int side_beside(int longer, double ratio) {
  return int(std::clamp(std::lround(longer * ratio), 1L, long(View::kMaxSide)));
}

}  // namespace

Expected<Size> read_size(std::string_view text, double aspect) {
  const auto parts = split(text, 'x');
  const auto first = number<int>(parts[0]);
  if (parts.size() == 1 && is_side(first)) {
    return aspect >= 1 ? Size{*first, side_beside(*first, 1 / aspect)}
                       : Size{side_beside(*first, aspect), *first};
  }
  const auto second = parts.size() == 2 ? number<int>(parts[1]) : std::nullopt;
  if (is_side(first) && is_side(second)) return Size{*first, *second};
  return refuse(
      "--size", text,
      fmt::format("expected WxH, or the longer side; whole pixels from 1 to {}", View::kMaxSide));
}

Expected<PixelRect> read_region(std::string_view text, Size picture) {
  int n[4];
  const auto parts = split(text, ',');
  for (std::size_t i = 0; i < 4; ++i) {
    const auto value = parts.size() == 4 ? number<int>(parts[i]) : std::nullopt;
    if (!value) return refuse("--region", text, "expected X,Y,W,H in whole pixels");
    n[i] = *value;
  }
  const auto inside = [](int begin, int length, int side) {
    return begin >= 0 && length >= 1 && length <= side && begin <= side - length;
  };
  if (!inside(n[0], n[2], picture.width) || !inside(n[1], n[3], picture.height)) {
    return refuse(
        "--region", text,
        fmt::format("is not inside the picture of {} x {} pixels", picture.width, picture.height));
  }
  return PixelRect{n[0], n[1], n[2], n[3]};
}

Expected<Color> read_background(std::string_view text) {
  if (text == "transparent") return Color{0, 0, 0, 0};
  const std::string hashed = text.starts_with('#') ? std::string(text) : fmt::format("#{}", text);
  if (const auto color = color_from_text(hashed)) return *color;
  return refuse("--background", text, "expected #rrggbb, #rrggbbaa or transparent");
}

Expected<glm::dvec3> read_light(std::string_view text) {
  constexpr const char* kExpected = "expected X,Y,Z, the last more than 0: the lamp is before us";
  const auto parts = split(text, ',');
  glm::dvec3 to{0.0};
  for (int i = 0; i < 3; ++i) {
    const auto value = parts.size() == 3 ? number<double>(parts[std::size_t(i)]) : std::nullopt;
    if (!value || !std::isfinite(*value)) return refuse("--light", text, kExpected);
    to[i] = *value;
  }
  if (!(to.z > 0)) return refuse("--light", text, kExpected);
  return to;
}

Expected<double> read_share(std::string_view option, std::string_view text) {
  const auto value = number<double>(text);
  if (value && *value >= 0 && *value <= 1) return *value;
  return refuse(fmt::format("--{}", option), text, "expected a number from 0 to 1");
}

Expected<double> read_time(std::string_view text) {
  const auto value = number<double>(text);
  if (value && std::isfinite(*value)) return *value;
  return refuse("--time", text, "expected a finite number of seconds");
}

Expected<int> read_threads(std::string_view text) {
  const auto value = number<int>(text);
  if (value && *value >= 0 && *value <= kMostThreads) return *value;
  return refuse(
      "--threads", text,
      fmt::format("expected a whole number from 0 (as many as there are) to {}", kMostThreads));
}

Expected<int> read_repeat(std::string_view text) {
  const auto value = number<int>(text);
  if (value && *value >= 1 && *value <= kMostRepeats) return *value;
  return refuse("--repeat", text,
                fmt::format("expected a whole number from 1 to {}", kMostRepeats));
}

Expected<std::uint64_t> read_memory(std::string_view text) {
  constexpr std::string_view kUnits = "KMGT";
  std::string_view digits = text;
  int shift = 0;
  if (!digits.empty() && kUnits.find(digits.back()) != std::string_view::npos) {
    shift = 10 * int(kUnits.find(digits.back()) + 1);
    digits.remove_suffix(1);
  }
  const auto value = number<std::uint64_t>(digits);
  if (value && *value >= 1 && *value <= (std::uint64_t(1) << 62) >> shift) return *value << shift;
  return refuse("--memory", text, "expected a number of bytes, perhaps with K, M, G or T: 6G");
}

Expected<std::int64_t> read_most_steps(std::string_view text) {
  const auto value = number<std::int64_t>(text);
  if (value && *value >= 1) return *value;
  return refuse("--most-steps", text, "expected a whole number from 1 on");
}

Expected<int> read_choice(std::string_view option, std::string_view text,
                          std::string_view choices) {
  const auto words = split(choices, '|');
  const auto found = std::find(words.begin(), words.end(), text);
  if (found != words.end()) return int(found - words.begin());
  std::string known;
  for (std::size_t i = 0; i < words.size(); ++i) {
    known += fmt::format("{}{}", i == 0 ? "" : i + 1 == words.size() ? " or " : ", ", words[i]);
  }
  return refuse(option, text, "expected " + known);
}

Expected<long> read_whole(std::string_view option, std::string_view text, long least, long most) {
  const auto value = number<long>(text);
  if (value && *value >= least && *value <= most) return *value;
  return refuse(option, text, fmt::format("expected a whole number from {} to {}", least, most));
}

Expected<double> read_real(std::string_view option, std::string_view text, double least,
                           double most) {
  const auto value = number<double>(text);
  if (value && *value >= least && *value <= most) return *value;
  return refuse(option, text, fmt::format("expected a number from {} to {}", least, most));
}

Expected<FrameRange> read_frames(std::string_view text) {
  const std::size_t dash = text.find('-');
  const auto first = number<long>(text.substr(0, dash));
  const auto last = dash == std::string_view::npos ? first : number<long>(text.substr(dash + 1));
  if (first && last && *first >= 0 && *first <= *last && *last < kMostFrames)
    return FrameRange{*first, *last};
  return refuse("--frames", text,
                fmt::format("expected FIRST-LAST, whole numbers from 0 to {}, the first not above "
                            "the last",
                            kMostFrames - 1));
}

Expected<double> read_fps(std::string_view text) {
  const std::size_t slash = text.find('/');
  const auto over = number<double>(text.substr(0, slash));
  const auto under =
      slash == std::string_view::npos ? std::optional(1.0) : number<double>(text.substr(slash + 1));
  if (over && under && *under > 0 && *over / *under >= 0.01 && *over / *under <= 1000)
    return *over / *under;
  return refuse("--fps", text, "expected frames a second from 0.01 to 1000, perhaps as 30000/1001");
}

}  // namespace mien::command
