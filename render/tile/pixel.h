#pragma once
// One pixel, exactly: the mean of the picture over its square.
//
// A square whose outlines are all described well enough by their edges (proven by edges_near) is
// one closed form (a single edge) or one arrangement (several). Any other square is divided in four
// and each quarter resolved by itself, down to kDepth, where what is left unproven covers too
// little to matter: a corner or an end of a stroke is one cell of 1/64 px a level, and its
// description there is still the nearest outline's.

#include <mien/render/cover/arrangement.h>
#include <mien/render/render_stats.h>
#include <mien/render/tile/local_paint.h>
#include <mien/render/tile/scope.h>

#include <vector>

namespace mien {

/// Resolves squares of one picture. One per thread.
class PixelResolver {
 public:
  /// Outlines may be off by this much [px] where a square is not divided further: 1/16 of a level
  /// of 255.
  static constexpr double kOutlineError = 1.0 / 4096;
  /// Divisions of a pixel: 6 gives cells of 1/64 px, 1/4096 of the pixel's area.
  static constexpr int kDepth = 6;

  /// Where colours vary (gradients, light), the mean over a square may be off by this much in the
  /// blending space: in linear light the darkest colours change by 12.92 levels of 255 a level.
  static constexpr double kPaintError = 1.0 / 16384;
  /// Divisions of a pixel where a lit surface has a crease that no outline marks: cells of 1/8 px.
  static constexpr int kCreaseDepth = 3;

  PixelResolver(const Tape& tape, ScopeStack& scopes, RenderStats& stats)
      : tape_(tape), scopes_(scopes), stats_(stats), sampler_(tape) {
    if (!tape.paints.empty()) scopes_.sampler = &sampler_;
  }
  PixelResolver(const PixelResolver&) = delete;
  PixelResolver& operator=(const PixelResolver&) = delete;

  /// The mean colour over the pixel around `center`, for a scope that covers it, and whether a
  /// paint that varies is part of it.
  Mix pixel(const Scope& scope, glm::dvec2 center);
  bool was_varied() const { return varied_; }

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
  Arrangement arrangement_;
  std::vector<Edge> edges_;
  std::vector<LocalOutline> locals_;
  std::vector<Cut> cuts_;
  PaintSampler sampler_;
  std::vector<LocalPaint> paints_;  ///< of the scope's layers that have one, in their order
  std::vector<int> paint_of_layer_;
  std::vector<Cut> paint_cuts_;
  bool varied_ = false;
};

}  // namespace mien
