// Patterns of a face file: their few numbers become slices, what chance does to them does not.

#include "figure_reader_private.h"

#include <fmt/format.h>

#include <array>
#include <cmath>

namespace mien {

double FigureReader::number_between(std::string_view key, double lo, double hi) const {
  const Field f = field(key);
  if (!f.node) return 0;
  const double value = in_.number(*f.node);
  if (!(value >= lo && value <= hi))
    in_.refuse(*f.node, fmt::format("\"{}\" goes from {} to {}, got {}", key, lo, hi, value));
  return value;
}

bool FigureReader::flag(std::string_view key) const {
  const Field f = field(key);
  return f.node && in_.boolean(*f.node);
}

int FigureReader::count(const JsonNode& node) const {
  const double value = in_.number(node);
  if (!(value >= 1) || value != std::floor(value))
    in_.refuse(node, fmt::format("a count is a whole number from 1, got {}", value));
  if (value > kMostPatternFigures)
    in_.refuse(node,
               fmt::format("a pattern has at most {} figures, got {}", kMostPatternFigures, value));
  return int(value);
}

PatternPatch FigureReader::patch() {
  const Field rows = need("patch");
  const auto expect_two_or_three = [&](const JsonNode& list, std::string_view what) {
    in_.expect(list, JsonKind::array);
    if (list.count != 2 && list.count != 3)
      in_.refuse(list, fmt::format("expected 2 or 3 {}, got {}", what, list.count));
  };
  expect_two_or_three(*rows.node, "rows of points");
  PatternPatch made;
  made.points.reserve(9);
  made.columns = 0;
  in_.for_each(*rows.node, [&](const JsonNode& row, int r) {
    expect_two_or_three(row, "points in a row");
    if (made.columns != 0 && int(row.count) != made.columns)
      in_.refuse(row, fmt::format("all rows have as many points as the first, {}; got {}",
                                  made.columns, row.count));
    made.columns = int(row.count);
    in_.for_each(row, [&](const JsonNode& p, int c) {
      made.points.push_back(point(p, PartName(PartName("patch", r), c), rows.mirrored));
    });
  });
  return made;
}

PatternMark FigureReader::mark() {
  constexpr std::array<std::string_view, 3> kMarks{"disc", "ellipse", "stroke"};
  PatternMark made;
  made.kind = PatternMark::Kind(in_.word(*need("of").node, "figure of a pattern", kMarks));
  switch (made.kind) {
    case PatternMark::Kind::disc:
      made.size = slice("radius", SliceKind::length, 1);
      break;
    case PatternMark::Kind::ellipse:
      made.size = slice("radii", SliceKind::length, 2);
      break;
    case PatternMark::Kind::stroke:
      made.size = slice("length", SliceKind::length, 1);
      made.half_width = pen_width();
      break;
  }
  made.tilt = optional_tilt();
  return made;
}

PatternChance FigureReader::chance(bool sways) const {
  PatternChance made{.seed = 0,
                     .jitter = number_between("jitter", 0, 1),
                     .vary = number_between("vary", 0, 1),
                     .sway = sways ? number_between("sway", 0, 180) : 0,
                     .mirrored = mirrored_};
  if (const Field seed = field("seed"); seed.node) {
    constexpr double kMost = 4294967295;
    const double value = in_.number(*seed.node);
    if (!(value >= 0 && value <= kMost) || value != std::floor(value))
      in_.refuse(*seed.node,
                 fmt::format("a seed is a whole number from 0 to 4294967295, got {}", value));
    made.seed = std::uint32_t(value);
  }
  return made;
}

ScatterFigure FigureReader::scatter() {
  ScatterFigure made;
  const JsonNode& number = *need("count").node;
  if (number.kind == JsonKind::array) {
    if (number.count != 2)
      in_.refuse(number,
                 fmt::format("expected one count, or two: along and across; got {}", number.count));
    const JsonNode& along = *in_.tree.first(number);
    made.columns = count(along), made.rows = count(*in_.tree.next(along));
    if (double(made.columns) * made.rows > kMostPatternFigures)
      in_.refuse(number, fmt::format("a pattern has at most {} figures, got {} times {}",
                                     kMostPatternFigures, made.columns, made.rows));
  } else {
    made.columns = count(number);
  }
  made.patch = patch();
  made.stagger = flag("stagger"), made.round = flag("round");
  if (made.stagger && made.rows == 0)
    in_.refuse(*field("stagger").node, "only a lattice is staggered: a count of two numbers");
  if (made.round && made.rows > 0)
    in_.refuse(*field("round").node, "a lattice is not round: a count of one number is");
  made.mark = mark(), made.chance = chance(true);
  return made;
}

RepeatFigure FigureReader::repeat() {
  RepeatFigure made;
  made.count = count(*need("count").node);
  made.points = point_list(need("points"), "points", 2);
  made.smooth = flag("smooth");
  made.mark = mark(), made.chance = chance(true);
  return made;
}

StripesFigure FigureReader::stripes() {
  StripesFigure made;
  made.count = count(*need("count").node);
  made.patch = patch();
  made.half_width = pen_width();
  made.chance = chance(false);
  return made;
}

}  // namespace mien
