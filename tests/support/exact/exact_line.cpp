// Along one line through a pixel: what is in view where, and the integral of its colour.
#include <algorithm>
#include <cmath>

#include "tests/support/exact/exact_roots.h"
#include "tests/support/exact/exact_truth.h"

namespace mien::test {
namespace {

constexpr double kGaussPlace[3] = {0.5 - 0.38729833462074170, 0.5, 0.5 + 0.38729833462074170};
constexpr double kGaussWeight[3] = {5.0 / 18, 8.0 / 18, 5.0 / 18};
constexpr double kShortestFine = 3e-5;  // [px] spans that a fine truth may miss
constexpr int kHalvings = 16;           // spans are halved so often
constexpr double kNothing = 1e-7;       // [px] shorter spans are where two ends meet

std::size_t followed_by(std::size_t order, std::size_t what) {
  return (order ^ what) * 0x9e3779b97f4a7c15u + (order >> 29);
}

}  // namespace

std::vector<LineEnd> ExactTruth::outline_ends(const Square& square, const FaceLine& line) const {
  std::vector<double> roots;
  for (const Seen& seen : square.seen) {
    if (seen.whole) continue;
    const Area area = scene_.layers()[std::size_t(seen.layer)].area;
    find_roots([&](double u) { return distance_(area, line(u)) / unit_; }, 1.0001, 0, 1,
               tolerance_ > kFine ? ExactPaint::kShortest : kShortestFine, roots);
  }
  std::vector<LineEnd> ends{{0, 0}, {1, 0}};
  for (const double root : roots) ends.push_back({root, 0});
  std::ranges::sort(ends, {}, &LineEnd::at);
  return ends;
}

/// Top to bottom until something hides the rest.
std::vector<int> ExactTruth::stack_at(const Square& square, glm::dvec2 p) const {
  std::vector<int> stack;
  for (std::size_t i = square.seen.size(); i-- > 0;) {
    const int layer = square.seen[i].layer;
    if (!square.seen[i].whole && !(distance_(scene_.layers()[std::size_t(layer)].area, p) <= 0))
      continue;
    stack.push_back(layer);
    if (paint_.hides(layer)) break;
  }
  std::ranges::reverse(stack);
  return stack;
}

/// Where a span's colour has kinks, jumps and ridges, in order, the span's ends among them.
std::vector<LineEnd> ExactTruth::kinks_in(const Square& square, const FaceLine& line,
                                          const Span& span) const {
  std::vector<LineEnd> kinks{{span.a, 0}, {span.b, 0}};
  const auto varying = [&](double a, double b, const auto& use) {
    for (const int layer : span.stack)
      if (std::ranges::find(square.seen, layer, &Seen::layer)->varies &&
          paint_.varies(layer, line(0.5 * (a + b)), 0.4999 * (b - a) * unit_))
        use(layer);
  };
  varying(span.a, span.b,
          [&](int layer) { paint_.find_kinks(layer, line, span.a, span.b, kinks); });
  std::erase_if(kinks, [&](const LineEnd& kink) {
    return kink.what > 0 && (kink.at - span.a < kNothing || span.b - kink.at < kNothing);
  });
  std::ranges::sort(kinks, {}, &LineEnd::at);
  for (std::size_t i = 1, count = kinks.size(); i < count; ++i) {
    const double a = kinks[i - 1].at, b = kinks[i].at;
    varying(a, b, [&](int layer) { paint_.find_ridges(layer, line, a, b, kinks); });
  }
  std::ranges::sort(kinks, {}, &LineEnd::at);
  return kinks;
}

void ExactTruth::add_between_kinks(const Square& square, const FaceLine& line, const Span& span,
                                   Spans& out) const {
  if (span.b - span.a < kNothing) return;
  for (const int layer : span.stack) out.order = followed_by(out.order, std::size_t(layer) + 7);
  const std::vector<LineEnd> kinks = kinks_in(square, line, span);
  for (std::size_t i = 1; i < kinks.size(); ++i) {
    Span part{kinks[i - 1].at, kinks[i].at, span.stack, false, false};
    if (kinks[i].what > 0) out.order = followed_by(out.order, kinks[i].what);
    const glm::dvec2 center = line(0.5 * (part.a + part.b));
    for (const int layer : span.stack) {
      part.varies |= paint_.varies(layer, center, 0.4999 * (part.b - part.a) * unit_);
      part.upright |= part.varies &&
                      (paint_.upright(layer, line(part.a)) || paint_.upright(layer, line(part.b)));
    }
    if (part.b > part.a) out.list.push_back(std::move(part));
  }
}

ExactTruth::Spans ExactTruth::spans(const Square& square, const FaceLine& line) const {
  const std::vector<LineEnd> ends = outline_ends(square, line);
  Spans out;
  Span open{0, 0, {}, false, false};
  for (std::size_t i = 1; i < ends.size(); ++i) {
    std::vector<int> stack;
    if (ends[i].at - ends[i - 1].at > kNothing)
      stack = stack_at(square, line(0.5 * (ends[i - 1].at + ends[i].at)));
    else
      stack = open.stack;
    if (open.b > 0 && stack != open.stack) {
      add_between_kinks(square, line, open, out);
      open.a = ends[i - 1].at;
    }
    open.b = ends[i].at;
    open.stack = std::move(stack);
  }
  add_between_kinks(square, line, open, out);
  return out;
}

/// Layers bottom to top; a group is collected by itself and then mixed with what was there.
Mixes ExactTruth::color(const std::vector<int>& stack, glm::dvec2 p) const {
  std::vector<Mixes> mixes{paint_.background()};
  std::vector<int> open;
  const auto chain = [&](int group) {
    std::vector<int> groups;
    for (; group >= 0; group = scene_.groups()[std::size_t(group)].parent)
      groups.insert(groups.begin(), group);
    return groups;
  };
  const auto close_to = [&](std::size_t depth) {
    while (open.size() > depth) {
      const Group& group = scene_.groups()[std::size_t(open.back())];
      const Mixes mix = group.opacity * mixes.back();
      mixes.pop_back();
      open.pop_back();
      mixes.back() = mixed_by(group.mix, mix, mixes.back());
    }
  };
  for (const int layer : stack) {
    const std::vector<int> wanted = chain(scene_.layers()[std::size_t(layer)].group);
    std::size_t same = 0;
    while (same < open.size() && same < wanted.size() && open[same] == wanted[same]) ++same;
    close_to(same);
    for (std::size_t i = same; i < wanted.size(); ++i)
      open.push_back(wanted[i]), mixes.emplace_back();
    mixes.back() = laid_over(paint_.at(layer, p), mixes.back());
  }
  close_to(0);
  return mixes.back();
}

Mixes ExactTruth::along(const Square& square, const FaceLine& line, const Spans& spans) const {
  Mixes sum;
  for (const Span& span : spans.list) {
    if (!span.varies)
      sum = sum + (span.b - span.a) * color(span.stack, line(0.5 * (span.a + span.b)));
    else
      sum = sum + refined_span(square, span, line, 0, 1, gauss(span, line, 0, 1), kHalvings);
  }
  return sum;
}

/// Where a surface stands upright at an end, colours begin like a square root: places crowd there, so that to
/// Gauss's rule they are smooth.
double ExactTruth::place(const Span& span, double share) {
  const double s = span.upright ? share * share * (3 - 2 * share) : share;
  return span.a + s * (span.b - span.a);
}

/// The integral over a share of a span.
Mixes ExactTruth::gauss(const Span& span, const FaceLine& line, double from, double to) const {
  Mixes sum;
  for (int k = 0; k < 3; ++k) {
    const double s = from + kGaussPlace[k] * (to - from);
    const double density = span.upright ? 6 * s * (1 - s) : 1;
    sum = sum + kGaussWeight[k] * (to - from) * density * (span.b - span.a) *
                    color(span.stack, line(place(span, s)));
  }
  return sum;
}

std::size_t ExactTruth::clamps_at(const Span& span, const FaceLine& line, double share) const {
  std::size_t all = 0;
  for (const int layer : span.stack)
    all = followed_by(all, paint_.clamps_at(layer, line(place(span, share))));
  return all;
}

/// Halves agree by chance where light's clamp begins beside all of their places. It shows at the ends.
Mixes ExactTruth::refined_span(const Square& square, const Span& span, const FaceLine& line,
                               double from, double to, const Mixes& coarse, int depth) const {
  constexpr double kInside = 1e-3;     // of a part: its ends are kinks of other kinds
  constexpr double kShort = 1.0 / 32;  // of a span: what is missed in less does not show
  const double m = 0.5 * (from + to);
  const Mixes left = gauss(span, line, from, m), right = gauss(span, line, m, to);
  const auto alike = [&] {
    const double by = kInside * (to - from);
    const std::size_t middle = clamps_at(span, line, m);
    return clamps_at(span, line, from + by) == middle && clamps_at(span, line, to - by) == middle;
  };
  if (depth == 0 ||
      (off(square, left + right - coarse) <= 2 * tolerance_ && (to - from <= kShort || alike())))
    return left + right;
  return refined_span(square, span, line, from, m, left, depth - 1) +
         refined_span(square, span, line, m, to, right, depth - 1);
}

}  // namespace mien::test
