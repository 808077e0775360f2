#include "render/svg/path_data.h"
#include "lib/base/watch.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace mien {
namespace {

constexpr int kMostDecimals = 9;

/// A point in steps.
struct Steps {
  long long x, y;
  friend bool operator==(const Steps&, const Steps&) = default;
  friend Steps operator-(const Steps& a, const Steps& b) { return {a.x - b.x, a.y - b.y}; }
};

/// Adds a number of steps, apart from what stands before it.
void add_number(std::string& to, long long steps, int decimals) {
  std::string digits = std::to_string(std::llabs(steps));
  if (int(digits.size()) <= decimals)
    digits.insert(0, std::size_t(decimals) + 1 - digits.size(), '0');
  const std::size_t point = digits.size() - std::size_t(decimals);
  std::string fraction = digits.substr(point);
  while (!fraction.empty() && fraction.back() == '0') fraction.pop_back();
  std::string whole = digits.substr(0, point);
  if (whole == "0" && !fraction.empty()) whole.clear();
  const bool after_number =
      !to.empty() && ((to.back() >= '0' && to.back() <= '9') || to.back() == '.');
  if (steps < 0)
    to += '-';
  else if (after_number)
    to += ' ';
  to += whole;
  if (!fraction.empty()) to += '.' + fraction;
}

class PathWriter {
 public:
  explicit PathWriter(int decimals) : decimals_(decimals), scale_(std::pow(10.0, decimals)) {}

  void loop(const FragmentLoop& loop) {
    const std::size_t before = text.size();
    const Steps start = steps(loop.start);
    command_ = 'M', at_ = {0, 0};
    text += command_;
    point(start);
    at_ = start;
    int lines = 0, curves = 0;
    for (std::size_t i = 0; i < loop.sides.size(); ++i) {
      const LoopSide& side = loop.sides[i];
      const Steps end = steps(side.to);
      const bool last = i + 1 == loop.sides.size();
      if (side.straight ? end == at_ : end == at_ && steps(side.control) == at_) continue;
      if (side.straight ? ++lines : ++curves; side.straight && last && end == start) break;  // z
      command(side.straight ? 'l' : 'q');
      if (!side.straight) point(steps(side.control));
      point(end);
      at_ = end;
    }
    if (lines + 2 * curves < 3) return text.resize(before);
    text += 'z';
  }

  std::string text;

 private:
  Steps steps(glm::dvec2 p) const {
    return {std::llround(p.x * scale_), std::llround(p.y * scale_)};
  }
  void command(char letter) {
    if (letter != command_) text += letter;
    command_ = letter;
  }
  /// Seen from where the pen is.
  void point(const Steps& p) {
    const Steps way = p - at_;
    add_number(text, way.x, decimals_);
    add_number(text, way.y, decimals_);
  }

  int decimals_;
  double scale_;
  char command_ = 0;
  Steps at_{0, 0};
};

}  // namespace

int decimals_for(double error) {
  // Both coordinates are off by half a step at most.
  return std::clamp(int(std::ceil(-std::log10(std::sqrt(2.0) * error))), 0, kMostDecimals);
}

std::string short_decimal(double value, int decimals) {
  std::string text;
  add_number(text, std::llround(value * std::pow(10.0, decimals)), decimals);
  return text;
}

std::string path_data(std::span<const FragmentLoop> loops, int decimals) {
  PathWriter writer(decimals);
  for (const FragmentLoop& loop : loops) {
    worked(200 * std::int64_t(loop.sides.size()));
    writer.loop(loop);
  }
  return std::move(writer.text);
}

}  // namespace mien
