#pragma once
// One pixel, exactly: the mean of the picture over its square.
//
// A square whose outlines are all described well enough by their edges (proven by edges_near) is
// one closed form (a single edge) or one arrangement (several). Any other square is divided in four
// and each quarter resolved by itself, down to a depth where what is left unproven covers
// too little to matter: a corner or an end of a stroke is one cell of 1/64 px a level, and its
// description there is still the nearest outline's.

#include <mien/render/cover/arrangement.h>
#include <mien/render/render_stats.h>
#include <mien/render/tile/local_paint.h>
#include <mien/render/tile/scope.h>

#include <optional>
#include <vector>

namespace mien {

/// How well a pixel is resolved.
struct Fineness {
  double outline;  ///< [px] outlines may be off by this much where a square is not divided further
  double paint;    ///< the mean of what varies over a square may be off by this much, in the
                   ///< blending space
  int depth;       ///< divisions of a pixel where nothing is proven: cells of 2^−depth px a side
};

/// What a depth of colour asks for. 8 bits: outlines within 1/16 of a level. 16 bits and float: within 32 of 65535
/// levels, where linear light makes most of an error: the darkest colours change by 12.92 levels for a level.
constexpr Fineness fineness(Depth depth, Blend blend) {
  if (depth == Depth::u8) return {1.0 / 4096, 1.0 / 16384, 6};
  return blend == Blend::linear ? Fineness{0x1p-16, 0x1p-18, 9} : Fineness{0x1p-13, 0x1p-15, 8};
}

/// Resolves squares of one picture. One per thread.
class PixelResolver {
 public:
  /// Divisions of a pixel where a lit surface has a crease that no outline marks: cells of 1/8 px.
  static constexpr int kCreaseDepth = 3;

  PixelResolver(const Tape& tape, ScopeStack& scopes, RenderStats& stats,
                const Fineness& fine = fineness(Depth::u8, Blend::srgb))
      : tape_(tape), scopes_(scopes), stats_(stats), fine_(fine), sampler_(tape) {
    if (!tape.paints.empty()) scopes_.sampler = &sampler_;
  }
  PixelResolver(const PixelResolver&) = delete;
  PixelResolver& operator=(const PixelResolver&) = delete;

  /// The mean colour over the pixel around `center`, for a scope that covers it, and whether a
  /// paint that varies is part of it.
  Mix pixel(const Scope& scope, glm::dvec2 center);
  /// The same for a scope without outlines whose colours are gradients without a kink in the pixel:
  /// each is linear in a place that is bilinear, so its mean is the colour of the mean place. Nothing
  /// if that is not so, to within Fineness::paint.
  std::optional<Mix> gradient(const Scope& scope, glm::dvec2 center);
  bool was_varied() const { return varied_; }
  /// How far the last pixel's mean may be off, in the blending space.
  double error() const { return error_; }

 private:
  Mix varied_square(const Scope& scope, glm::dvec2 center, double side, int depth);
  Mix quarters(const Scope& scope, glm::dvec2 center, double side, int depth);
  bool describe_paints(const Scope& scope, glm::dvec2 center, double side, int depth);
  Mix resolve_varied(const Scope& scope, double side);
  Mix color_at(const Scope& scope, glm::dvec2 u);
  Mix mean_over(const Scope& scope, std::span<const glm::dvec2> corners);
  Mix square(const Scope& scope, glm::dvec2 center, double side, int depth);
  bool describe(const Scope& scope, glm::dvec2 center, double side);
  Mix resolve(const Scope& scope, double side);
  Mix at_center(const Scope& scope, glm::dvec2 center);
  void set_sides(const Scope& scope, std::uint32_t inside);

  const Tape& tape_;
  ScopeStack& scopes_;
  RenderStats& stats_;
  const Fineness fine_;
  Arrangement arrangement_;
  std::vector<Edge> edges_;
  std::vector<LocalOutline> locals_;
  std::vector<Cut> cuts_;
  PaintSampler sampler_;
  std::vector<LocalPaint> paints_;  ///< of the scope's layers that have one, in their order
  std::vector<int> paint_of_layer_;
  std::vector<Cut> paint_cuts_;
  bool varied_ = false;
  double square_error_ = 0;  ///< [px] of the outlines last described
  double paint_error_ = 0;   ///< of the paints last described
  double error_ = 0;
};

}  // namespace mien
