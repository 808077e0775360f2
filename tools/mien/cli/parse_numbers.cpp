#include "tools/mien/cli/parse_numbers.h"
#include "lib/base/one_line.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <optional>

namespace mien::command {
namespace {

template <class Number>
std::optional<Number> number(std::string_view text) {
  Number value{};
  const char* const end = text.data() + text.size();
  const auto [at, failed] = std::from_chars(text.data(), end, value);
  if (failed != std::errc{} || at != end) return {};
  return value;
}

Error refuse(std::string_view option, std::string_view text, std::string what) {
  return {fmt::format("{} {}", option, one_line(text, 60)), std::move(what)};
}

}  // namespace

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
                fmt::format("expected FIRST-LAST, whole numbers from 0 to {}", kMostFrames - 1));
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
