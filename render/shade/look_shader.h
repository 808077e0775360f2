#pragma once
// The mean colour of a look over whole pixels of a row, or over a part of one.
//
// A region has no kink inside it (paint_table.h), so over a part of a pixel a ramp along t is its value
// at the part's mean t. For a linear gradient that is t at the centroid, exactly. For a radial one,
// t = |q| with q = U (p − center), the second moments count:
//
//     mean of t  =  sqrt(t² + (tr UᵀU − |∇t|²) v) + O(v²),   v = 1/12 per axis for a whole pixel,
//
// since ½ v Δt = v (tr UᵀU − |∇t|²) / (2t); a part of area A is taken for one of v = A/12. Left out is
// how t's own spread meets a translucent layer below that varies, too: a twelfth of the product of both
// slopes per pixel.

#include "render/shade/color_row.h"
#include "render/shade/looks.h"
#include "render/shade/ramp/planes.h"

#include <vector>

namespace mien {

/// Keeps its scratch; one per thread.
class LookShader {
 public:
  void begin(const Looks& looks) { looks_ = &looks; }

  /// Whole pixels of row y, `count` from x on, none beyond the next multiple of kBlock: floats are
  /// counted from there, so that a pixel does not depend on where a run begins.
  const ColorRow& pixels(int look, int x, int y, int count) {
    const int origin = x & ~(kBlock - 1);
    return places(look, {{origin + 0.5, y + 0.5}, x - origin, count, 1.0, nullptr});
  }
  static constexpr int kBlock = 64;
  /// A part of a pixel, by its centroid and area; of a look that asks for it, by its form.
  glm::vec4 part(int look, double x, double y, double area, const PartForm* form = nullptr) {
    if (looks_->plain(look)) return plain_part(look, x, y, area);
    const ColorRow& c = places(look, {{x, y}, 0, 1, area, form});
    return {c.r[0], c.g[0], c.b[0], c.a[0]};
  }

  /// The mean over a pixel or a part of one by side × side cells, which reduces what centroids neglect.
  /// `coarse`: within 1e-3 px² a cell, which 8 bits do not show.
  glm::vec4 by_cells(int look, int x, int y, const PartForm* form, int side, bool coarse);

  /// The feet that were looked for since it was last taken, and the time of means with them.
  LitPaint::Scratch::Work take_work() { return lit_scratch_.take_work(); }

  /// Columns that want the reference, since the caller emptied it.
  std::vector<int>& crowded() { return lit_scratch_.crowded(); }

 private:
  /// Centroids first + (from + i, 0), of whole pixels or of one part of a pixel.
  struct Places {
    glm::dvec2 first;
    int from, count;
    double area;
    const PartForm* form;
    const PartCells* cells = nullptr;  ///< of the pixel around `first`, instead of all of it
    LitPart part(int x, int y) const;  ///< of pixel (x, y)
  };
  const ColorRow& places(int look, const Places& at);
  glm::vec4 plain_part(int look, double x, double y, double area) const;
  void lay(const LookStep& step, const Places& at, ColorRow& to);
  void lay_lit(const LookStep& step, const Places& at, ColorRow& to);
  void lay_integral(const LookStep& step, const Places& at, ColorRow& to);
  const LitPaint* lit_of(const VariedPaint& varied) const {
    return varied.lit < 0 ? nullptr : &looks_->paints().lit[std::size_t(varied.lit)];
  }
  Mix ramp_mean_of(const VariedPaint& varied, int x, int y, const PartForm* form);
  void ramp_means_of_cells(const VariedPaint& varied, const Places& at);
  void along_distance(const VariedPaint& varied, const Places& at, float* t);
  void along_cells(const VariedPaint& varied, const Places& at, float* t);

  const Looks* looks_ = nullptr;
  std::vector<ColorRow> levels_;
  std::vector<float> t_;
  ColorRow lit_;
  PartCells cells_;
  RampPlanes planes_;
  std::vector<PartChord> chords_;
  bool each_ = false;  ///< cells of lit paints are looked at one by one
  LitPaint::Scratch lit_scratch_;
};

}  // namespace mien
