#pragma once
// The exact picture of any scene: what 8- and 16-bit pictures are judged by, in either blend.
//
// Along a line through a pixel every layer is a set of spans. Their ends are where the distance
// changes sign: found by halving, missing none longer than ExactPaint::kShortest (3e-5 px to a fine
// tolerance), since the
// distance is 1-Lipschitz (a stretch shorter than twice |d| at its middle has no end). Between two
// ends the visible colour is smooth, but for kinks of gradients and reliefs, which are found in the
// same way, and for ridges of reliefs, where the slope of a distance jumps, which are found by
// comparing slopes; there Gauss's rule integrates it. Across the lines the integral is adaptive, and finer where anything
// comes or goes: what is thinner than kThinnest and lies along the lines may fall between them.
// Lines run across the steepest outline.
//
// It shares no code with the renderer but the distances of the scene's single shapes, which have truths of their own
// in tests/sdf. Outlines of paths whose loops overlap are its own (exact_outline.h).

#include <mien/scene.h>
#include <mien/view.h>

#include <glm/vec4.hpp>
#include <map>
#include <unordered_map>
#include <utility>
#include <vector>

#include "tests/support/exact/exact_distance.h"
#include "tests/support/exact/exact_mix.h"
#include "tests/support/exact/exact_paint.h"

namespace mien::test {

/// Not for several threads: it remembers.
class ExactTruth {
 public:
  static constexpr double kThinnest = 1.0 / 32;  ///< [px] layers along the lines that may be missed
  static constexpr double kFine = 1e-6;          ///< a quarter of a thousandth of a level of 255
  static constexpr double kLit = 8e-5;           ///< 1/50 of a level of 255: for lit pictures

  /// `tolerance`: what a pixel's encoded mean may be off, of 1. The scene must outlive this.
  ExactTruth(const Scene& scene, const View& view, double tolerance = kFine);

  /// The means over pixel (x, y) in both blending spaces.
  Mixes means(int x, int y) const;
  /// The same to a fine tolerance, whatever this one's is: much slower.
  Mixes fine_means(int x, int y) const { return ExactTruth(scene_, view_).means(x, y); }
  /// That of the view's blend: premultiplied, in the blending space.
  glm::dvec4 pixel(int x, int y) const { return means(x, y).in(view_.blend); }
  /// The same in levels of `top`: encoded, straight, not rounded.
  glm::dvec4 levels(int x, int y, int top) const;
  /// The colour at a place [px], of no area.
  Mixes at(double x, double y) const;
  /// Whether these pixels all have one colour, proven; then means cost nothing.
  bool flat(const PixelRect& pixels) const;
  /// Whether light on a slope may be seen in the pixel.
  bool lit(int x, int y) const;

 private:
  static constexpr int kBlock = 16;  // [px]

  /// A layer that can be seen in a pixel; `whole`: it covers it.
  struct Seen {
    int layer;
    bool whole;
    bool varies;  ///< its colour
  };
  struct Square {
    std::vector<Seen> seen;                                  ///< bottom to top
    glm::dvec2 corner;                                       ///< its left and upper edge [px]
    bool upright = false;                                    ///< lines run from top to bottom
    double weight = 1;                                       ///< of errors in linear light
    mutable std::unordered_map<double, std::size_t> orders;  ///< of lines strips share
  };
  /// A stretch of a line with one stack of layers in view, between two kinks.
  struct Span {
    double a, b;
    std::vector<int> stack;  ///< bottom to top
    bool varies;             ///< a colour of the stack does
    bool upright;            ///< a surface stands upright at an end
  };
  struct Spans {
    std::vector<Span> list;
    std::size_t order =
        1;  ///< what begins and ends, as a number: most probably others have another
  };
  /// The integral over a strip by three lines, and whether all have one order.
  struct Rows {
    Mixes sum;
    std::size_t order = 0;
    bool alike = true;
  };

  // exact_truth.cpp: the pixel
  std::vector<Seen> seen_in(const PixelRect& pixels, const std::vector<Seen>& among) const;
  Square square(const PixelRect& pixels) const;
  static bool flat(const Square& square);
  bool crosses_upright(const Square& square) const;
  void weigh(Square& square) const;
  Rows rows(const Square& square, double top, double bottom) const;
  Mixes refined(const Square& square, double top, double bottom, const Rows& coarse,
                int depth) const;
  glm::dvec2 face(double x, double y) const;
  FaceLine line_at(const Square& square, double v) const;
  double off(const Square& square, const Mixes& difference) const;

  // exact_line.cpp: a line through it
  Spans spans(const Square& square, const FaceLine& line) const;
  std::vector<LineEnd> outline_ends(const Square& square, const FaceLine& line) const;
  std::vector<int> stack_at(const Square& square, glm::dvec2 p) const;
  std::vector<LineEnd> kinks_in(const Square& square, const FaceLine& line, const Span& span) const;
  void add_between_kinks(const Square& square, const FaceLine& line, const Span& span,
                         Spans& out) const;
  Mixes along(const Square& square, const FaceLine& line, const Spans& spans) const;
  Mixes color(const std::vector<int>& stack, glm::dvec2 p) const;
  Mixes gauss(const Span& span, const FaceLine& line, double from, double to) const;
  /// Where a share of a span lies on the line.
  static double place(const Span& span, double share);
  /// Which clamps of light hold there.
  std::size_t clamps_at(const Span& span, const FaceLine& line, double share) const;
  Mixes refined_span(const Square& square, const Span& span, const FaceLine& line, double from,
                     double to, const Mixes& coarse, int depth) const;

  const Scene& scene_;
  ExactDistance distance_;
  View view_;
  double tolerance_, unit_;  ///< [face units] per pixel
  ExactPaint paint_;
  std::vector<Seen> all_;
  mutable std::map<std::pair<int, int>, std::vector<Seen>> blocks_;
};

/// In levels of `top`: encoded, straight, not rounded.
glm::dvec4 levels_of(const Mixes& mixes, Blend blend, int top);

}  // namespace mien::test
